# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bed as it bubbles and cools, its mean temperature and its mean motion (snapshots/)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

WIDTH, HEIGHT, GAP = 0.08, 0.25, 0.015  # [m]
COLD, HOT = 20.0, 90.0  # [degrees C]
CELLS = (16, 24)  # of the means, in the lower 0.12 m
TOP = 0.12
# Cooling times [s] of a bed of one temperature at 1.54 m/s: by the gas alone, and by the plates and
# side walls, too, as far as the static bed wets them
GAS, WALLS = 28.03, 12.55


def ledger():
    file = Path("postProcessing/heatLedger/0/heatLedger.csv")
    return np.genfromtxt(file, delimiter=",", names=True)


def sheet(times):
    figure, row = plt.subplots(
        1, len(times), figsize=(2.4 * len(times), 6.5), sharey=True, layout="constrained"
    )
    for ax, time in zip(np.atleast_1d(row), times, strict=True):
        grains = grainplot.read_grains(".", time)
        drawn = grainplot.draw_grains(
            ax, grains, grains["temperature"].ravel() - 273.15,
            clim=(COLD, HOT), cmap="inferno", linewidths=0,
        )
        ax.set(title=f"t = {time} s", xlim=(0, WIDTH), ylim=(0, HEIGHT), aspect="equal")
    figure.colorbar(drawn, ax=row, label="temperature [C]", shrink=0.6)
    figure.savefig("snapshots/temperature.png", dpi=110)
    plt.close(figure)


def cooling():
    book = ledger()
    time, T = book["time"], book["meanGrainT"] - 273.15
    figure, ax = plt.subplots(figsize=(6, 4), layout="constrained")
    ax.plot(time, T, label="grains, mean")
    for tau, style, name in ((GAS, "k--", "gas"), (WALLS, "k:", "gas and walls of the static bed")):
        ax.plot(time, COLD + (HOT - COLD) * np.exp(-time / tau), style, label=f"0-D: {name}")
    ax.set(xlabel="t [s]", ylabel="temperature [C]", ylim=(COLD, HOT))
    ax.legend()
    figure.savefig("snapshots/cooling.png", dpi=110)
    plt.close(figure)


def means(times):
    """Solid fraction and mean velocity of the grains on a coarse grid."""
    edges = [np.linspace(0, WIDTH, CELLS[0] + 1), np.linspace(0, TOP, CELLS[1] + 1)]
    area, momentum = np.zeros(CELLS), np.zeros((*CELLS, 2))
    for time in times:
        grains = grainplot.read_grains(".", time)
        x, v = grains["position"], grains["velocity"]
        a = np.pi * grains["radius"].ravel() ** 2
        area += np.histogram2d(x[:, 0], x[:, 1], edges, weights=a)[0]
        for k in range(2):
            momentum[..., k] += np.histogram2d(x[:, 0], x[:, 1], edges, weights=a * v[:, k])[0]
    cell = WIDTH * TOP / np.prod(CELLS)
    return edges, area / cell / len(times), momentum / np.maximum(area, 1e-12)[..., None]


def motion(times):
    (x, y), solid, velocity = means(times)
    figure, ax = plt.subplots(figsize=(5, 6), layout="constrained")
    drawn = ax.pcolormesh(x, y, solid.T, cmap="viridis", vmin=0)
    middle = np.meshgrid(0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]))
    ax.quiver(*middle, velocity[..., 0].T, velocity[..., 1].T, color="w", scale=4)
    ax.set(title=f"mean of t = {times[0]} to {times[-1]} s", aspect="equal")
    figure.colorbar(drawn, ax=ax, label="solid fraction of discs")
    figure.savefig("snapshots/motion.png", dpi=110)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    times = [time for time in grainplot.times(".") if float(time) > 0]
    sheet(times[:: max(len(times) // 6, 1)][:6])
    cooling()
    motion(times[len(times) // 2 :])


main()
