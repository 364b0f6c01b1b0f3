# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The droplet among the grains and its vapour, and its history (snapshots/)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle

WIDTH, HEIGHT, DEPTH = 0.01, 0.03, 0.0015  # [m]
RADIUS, BED = 1.25e-3, 0.0225  # of the droplet at the start; height of the bed [m]
HOT = 400.0  # of the bed [degrees C]
LATENT, GRAVITY = 2.26e6, 9.81  # [J/kg], [m/s^2]
CONDUCTIVITY = 0.026  # of the gas [W/m/K]


def book():
    return np.genfromtxt("postProcessing/droplets/0/droplets.csv", delimiter=",", names=True)


def sheet(times):
    mesh = grainplot.read_mesh(".")
    history = book()
    figure, row = plt.subplots(
        1, len(times), figsize=(2.3 * len(times), 6.4), sharey=True, layout="constrained"
    )
    for ax, time in zip(np.atleast_1d(row), times, strict=True):
        psi = grainplot.read_field(".", time, "psi", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, psi, lines=False, cmap="Greys", clim=(0, 1.5))
        grains = grainplot.read_grains(".", time)
        drawn = grainplot.draw_grains(
            ax, grains, grains["temperature"].ravel() - 273.15,
            clim=(100, HOT), cmap="inferno", linewidths=0,
        )
        now = history[np.argmin(np.abs(history["time"] - float(time)))]
        ax.add_patch(Circle((now["x"], now["y"]), now["radius"], fc="tab:blue", alpha=0.5))
        ax.set(title=f"t = {time} s", xlim=(0, WIDTH), ylim=(0, HEIGHT), aspect="equal")
    figure.colorbar(drawn, ax=row, label="temperature of the grains [C]", shrink=0.6)
    figure.savefig("snapshots/droplet.png", dpi=110)
    plt.close(figure)


def curves():
    """In the scales of Henry 2025, fig. 4.14 to 4.19."""
    t = book()
    step = np.diff(t["time"], prepend=0)
    time = t["time"] / np.sqrt(2 * RADIUS / GRAVITY)
    window = np.ones(min(100, len(time))) / min(100, len(time))

    def mean(values):
        return np.convolve(values, window, "same") / np.convolve(np.ones(len(time)), window, "same")

    # Conduction over a radius at the start
    scale = CONDUCTIVITY * (HOT - 100) / RADIUS * 2 * np.pi * RADIUS * DEPTH
    figure, axes = plt.subplots(2, 2, figsize=(9, 6), sharex=True, layout="constrained")
    (depth, liquid), (heat, force) = axes
    depth.plot(time, (BED - t["y"]) / (2 * RADIUS))
    depth.set(ylabel="depth of the centre / diameter")
    liquid.plot(time, t["liquid"] / t["liquid"][0], label="liquid, of the first")
    volume = np.pi * t["radius"] ** 2 * DEPTH
    liquid.plot(time, t["inside"] / volume, label="grains, of the volume")
    liquid.legend()
    for name, label in (("fromFluid", "through the surface"), ("fromGrains", "from grains")):
        heat.plot(time, mean(t[name] / step) / scale, label=label)
    heat.set(ylabel="heat / first conduction, mean of 100 steps", yscale="log")
    heat.legend()
    force.plot(time, mean(t["fy"]) / t["weight"][0], label="of gas and grains")
    force.plot(time, -t["weight"] / t["weight"][0], label="weight")
    force.set(ylabel="force / first weight, mean of 100 steps")
    force.legend()
    for ax in (heat, force):
        ax.set(xlabel="time / free fall of a radius")
    figure.savefig("snapshots/history.png", dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    Path("snapshots").mkdir(exist_ok=True)
    written = grainplot.times(".")[1:]
    sheet(written[:: max(1, (len(written) - 1) // 6)])
    curves()
