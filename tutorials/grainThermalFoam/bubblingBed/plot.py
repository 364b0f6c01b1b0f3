# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bed as it bubbles and cools, its mean temperature and its mean motion (snapshots/).

Usage: plot.py [-compare | -spheres]
    -compare: mean temperatures of all folders bed_<g>_<m/s>, and of spheres
    -spheres: the mean temperature alone
"""

import re
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

WIDTH, HEIGHT, GAP = 0.08, 0.25, 0.015  # [m]
COLD, HOT = 20.0, 90.0  # [degrees C]
CELLS = (16, 24)  # of the means, in the lower 0.12 m
TOP = 0.12
# Cooling time [s] of a bed of one temperature, 75 g, at 1.54 m/s by the gas alone; and what plates
# and side walls add to its inverse as far as the static bed wets them: for any mass
GAS, WALLS = 28.03, 1 / 12.55 - 1 / 28.03


def cooling_times(folder="."):
    """By the gas alone, and with the walls; of the mass and the speed of a folder."""
    packing, U = (Path(folder, file).read_text() for file in ("system/packGrainsDict", "0/U"))
    height, depth = re.search(r"box +\(0 0 0\) \(0.08 (\S+) (\S+)\)", packing).groups()
    speed = float(re.search(r"value +uniform \(0 (\S+) 0\)", U)[1])
    of75g = 0.0375 if depth == "0" else 0.0417
    gas = GAS * float(height) / of75g * 1.54 / speed
    return gas, 1 / (1 / gas + WALLS)


def ledger(folder="."):
    file = Path(folder, "postProcessing/heatLedger/0/heatLedger.csv")
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
    gas, walls = cooling_times()
    for tau, style, name in ((gas, "k--", "gas"), (walls, "k:", "gas and walls of the static bed")):
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


def compare():
    """All beds that are done in one figure, and what they have lost after some times."""
    figure, ax = plt.subplots(figsize=(7, 4.5), layout="constrained")
    print(f"{'bed':16} {'of 70 K after 1, 2, 5, 10 s':32} initial slope and those in 0-D [K/s]")
    for folder in [*sorted(Path(".").glob("bed_*_*")), Path("spheres")]:
        if not (folder / "done").exists():
            continue
        book = ledger(folder)
        time, T = book["time"], book["meanGrainT"] - 273.15
        _, mass, speed = (*folder.name.split("_"), "75", "1.54")[:3]
        name = ", spheres" if folder.name == "spheres" else ""
        ax.plot(time, T, "--" if mass == "125" else "-", label=f"{mass} g, {speed} m/s{name}")
        left = [np.interp(t, time, T) - COLD if t <= time[-1] else np.nan for t in (1, 2, 5, 10)]
        first = time <= 1
        slope = -np.polyfit(time[first], T[first], 1)[0]
        gas, walls = ((HOT - COLD) / tau for tau in cooling_times(folder))
        parts = "".join(f"{value:8.2f}" for value in left)
        print(f"{folder.name:16} {parts} {slope:8.2f} ({gas:.2f}, {walls:.2f})")
    ax.set(xlabel="t [s]", ylabel="mean temperature of the grains [C]")
    ax.legend()
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig("snapshots/beds.png", dpi=110)
    plt.close(figure)


def main():
    if "-compare" in sys.argv[1:]:
        compare()
        return
    Path("snapshots").mkdir(exist_ok=True)
    cooling()
    if "-spheres" in sys.argv[1:]:
        return
    times = [time for time in grainplot.times(".") if float(time) > 0]
    sheet(times[:: max(len(times) // 6, 1)][:6])
    motion(times[len(times) // 2 :])


main()
