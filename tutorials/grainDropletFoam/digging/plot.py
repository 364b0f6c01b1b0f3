# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The droplet among the grains and its vapour, and its history (snapshots/)."""

import re
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

DEPTH = 0.0015  # [m]
RADIUS, BED = 1.25e-3, 0.0225  # of the droplet at the start; height of the bed [m]
GRAVITY = 9.81  # [m/s^2]
CONDUCTIVITY = 0.026  # of the gas [W/m/K]


def bed_temperature():
    """[C]"""
    text = Path("parameters").read_text()
    return float(re.search(r"bedTemperature\s+([\d.]+)", text)[1]) - 273.15


def curves(hot):
    """In the scales of Henry 2025, fig. 4.14 to 4.19."""
    t = grainplot.read_droplets(".")
    step = np.diff(t["time"], prepend=0)
    time = t["time"] / np.sqrt(2 * RADIUS / GRAVITY)
    window = np.ones(min(100, len(time))) / min(100, len(time))

    def mean(values):
        return np.convolve(values, window, "same") / np.convolve(np.ones(len(time)), window, "same")

    # Conduction over a radius at the start
    scale = CONDUCTIVITY * (hot - 100) / RADIUS * 2 * np.pi * RADIUS * DEPTH
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
    hot = bed_temperature()
    if written:
        sheet = grainplot.droplets(".", written[:: max(1, (len(written) - 1) // 6)], (100, hot))
        sheet.savefig("snapshots/droplet.png", dpi=110)
        plt.close(sheet)
    curves(hot)
