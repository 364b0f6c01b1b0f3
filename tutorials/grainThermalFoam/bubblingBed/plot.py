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


def means(time, folder="."):
    """Solid fraction and flux of the grains [m/s] on a coarse grid, means of up to 5 s before."""
    mesh = grainplot.read_mesh(folder)
    n = len(mesh.polygons)
    at = np.array([polygon.mean(axis=0) for polygon in mesh.polygons])
    edges = [np.linspace(0, WIDTH, CELLS[0] + 1), np.linspace(0, TOP, CELLS[1] + 1)]
    solid = grainplot.read_field(folder, time, "packingMean", n)
    flux = grainplot.read_field(folder, time, "grainFluxMean", n)
    number = np.histogram2d(*at.T, edges)[0]
    fields = [
        np.histogram2d(*at.T, edges, weights=field)[0] / number
        for field in (solid, flux[:, 0], flux[:, 1])
    ]
    return edges, fields[0], np.stack(fields[1:], axis=-1)


def before(times, end):
    """The last one before an end, at which means begin anew every 5 s."""
    return max((t for t in times if float(t) < end), key=float)


def apart(one, other):
    """Root mean square of what two fields differ by, over that of their mean."""
    return 2 * np.linalg.norm(one - other) / np.linalg.norm(one + other)


def motion(times):
    end = float(times[-1])
    (x, y), solid, flux = means(before(times, end))
    if end == 10:
        _, first, flux_1 = means(before(times, 5))
        parts = f"{apart(first, solid):.3f}, of the flux {apart(flux_1, flux):.3f}"
        print(f"Means of the two halves differ, of the packing by {parts}")
    velocity = flux / np.maximum(solid, 1e-3)[..., None]
    figure, ax = plt.subplots(figsize=(5, 6), layout="constrained")
    drawn = ax.pcolormesh(x, y, solid.T, cmap="viridis", vmin=0)
    middle = np.meshgrid(0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]))
    ax.quiver(*middle, velocity[..., 0].T, velocity[..., 1].T, color="w", scale=4)
    ax.set(title=f"mean of up to 5 s until {times[-1]} s", aspect="equal")
    figure.colorbar(drawn, ax=ax, label="solid fraction that the fluid sees")
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
    motion(times)


main()
