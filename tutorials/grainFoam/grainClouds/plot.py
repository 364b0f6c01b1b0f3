# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clouds and dynamic pressure (snapshots), order of convergence of their speed (results.*).

Usage: plot.py [-test]        -test: too few meshes and steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D = 5e-5  # diameter of grains [m]
WIDEST = 1.6e-3  # cells of n = 1 [m]
THESIS = 1.65
SOURCE = "thesis, fig. 3.11"
FROM = 0.5  # part of the time from which on the speed is averaged


def fall(case):
    """Times [s] and mean height of the grains [m]."""
    names = grainplot.times(case)[1:]
    height = [grainplot.read_grains(case, name)["position"][:, 1].mean() for name in names]
    return np.array([float(name) for name in names]), np.array(height)


def order(size, error):
    """Slope of the error over the cell size, both logarithmic, by least squares."""
    return np.polyfit(np.log(size), np.log(error), 1)[0]


def snapshots(case, label):
    """Clouds and p_rgh at four times."""
    mesh = grainplot.read_mesh(case)
    names = grainplot.times(case)
    chosen = [names[k] for k in np.linspace(1, len(names) - 1, 4).round().astype(int)]
    figure, row = plt.subplots(1, 4, figsize=(11, 6), sharey=True, layout="constrained")
    limit = None
    for ax, name in zip(row, chosen, strict=True):
        pressure = grainplot.read_field(case, name, "p_rgh", len(mesh.polygons))
        pressure = pressure - np.average(pressure, weights=mesh.areas)
        limit = limit or 1.2 * np.abs(pressure).max()
        cells = grainplot.draw_cells(
            ax, mesh, pressure, lines=False, cmap="RdBu_r", clim=(-limit, limit)
        )
        x, y = grainplot.read_grains(case, name)["position"].T
        ax.plot(x, y, "k.", ms=0.6)
        ax.set(xlim=(-0.012, 0.012), ylim=(0, 0.064), xlabel="x [m]", title=f"t = {name} s")
    row[0].set_ylabel("y [m]")
    figure.colorbar(cells, ax=list(row), label="p_rgh less its mean [Pa]", shrink=0.7)
    figure.suptitle(label)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig(f"snapshots/{case}.png", dpi=110)
    plt.close(figure)


def main():
    test = "-test" in sys.argv
    numbers = sorted(int(path.name.split("_")[1]) for path in Path().glob("cells_*"))
    size = WIDEST / np.array(numbers) / D
    results = Results()
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    speeds = []
    for number, h in zip(numbers, size, strict=True):
        label = f"h/d = {h:g}"
        time, height = fall(f"cells_{number}")
        middle, speed = 0.5 * (time[1:] + time[:-1]), -np.diff(height) / np.diff(time)
        left.plot(middle, speed, ".-", lw=1, label=label)
        start = np.searchsorted(time, FROM * time[-1])
        speeds.append((height[start] - height[-1]) / (time[-1] - time[start]))
        results.add(f"speed of fall, {label}", speeds[-1], "m/s")
        snapshots(f"cells_{number}", label)
    left.set(xlabel="t [s]", ylabel="mean speed of fall of the grains [m/s]")
    left.legend()

    h, error = size[:-1], np.abs(np.array(speeds[:-1]) / speeds[-1] - 1)
    right.loglog(h, error, "o-", label="grainFoam")
    right.loglog(h, error[0] * (h / h[0]) ** THESIS, "k--", label=f"{SOURCE}: slope {THESIS}")
    right.set(xlabel="h/d", ylabel=f"speed over that of h/d = {size[-1]:g}, less 1")
    right.legend()
    figure.savefig("results.png", dpi=110)
    if test:
        results.write("results.csv")
    else:
        note = f"h/d = {h[0]:g} to {h[-1]:g} against {size[-1]:g}"
        results.add(f"order of convergence, {note}", order(h, error), "-", THESIS, ">=", SOURCE)
        results.finish()


main()
