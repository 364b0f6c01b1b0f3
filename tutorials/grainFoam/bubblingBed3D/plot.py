# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bubbles in a slice across the tube (snapshots/t_*.png), pressure drop over time (results.*).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import csv
import re
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RADIUS, TUBE, TUBE_HEIGHT, TOP = 18e-3, 4e-3, 15e-3, 108e-3  # [m]
RHO, RHO_P = 1.2, 2500.0
# The bed has fallen and bubbles from then on [s]
START = 0.4


def slice_of(state):
    """Grains cut by the plane x = 0: discs (y, z), and their speeds [m/s]."""
    x, radius = state["position"], state["radius"].ravel()
    cut = np.abs(x[:, 0]) < radius
    discs = {"position": x[cut, 1:], "radius": np.sqrt(radius[cut] ** 2 - x[cut, 0] ** 2)}
    return discs, grainplot.magnitude(state["velocity"])[cut]


def draw(ax, time):
    discs, speed = slice_of(grainplot.read_grains(".", time))
    grains = grainplot.draw_grains(ax, discs, speed, clim=(0, 0.6), linewidths=0)
    ax.add_patch(plt.Circle((0, TUBE_HEIGHT), TUBE, color="0.7"))
    ax.set(title=f"t = {time} s", xlim=(-RADIUS, RADIUS), ylim=(0, TOP), aspect="equal")
    return grains


def sheet(times, path):
    figure, row = plt.subplots(
        1, len(times), figsize=(2.2 * len(times), 6), sharey=True, layout="constrained"
    )
    for ax, time in zip(np.atleast_1d(row), times, strict=True):
        grains = draw(ax, time)
    figure.colorbar(grains, ax=row, label="speed [m/s]", shrink=0.6)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def mean_velocity(time):
    """Of the bed's mass, upwards [m/s]."""
    state = grainplot.read_grains(".", time)
    return np.average(state["velocity"][:, 2], weights=state["radius"].ravel() ** 3)


def mean_force(time, drop, weight, begin, end):
    """Mean pressure drop over the weight, less what has speeded the bed up in that time."""
    inside = (time > float(begin)) & (time <= float(end))
    gain = mean_velocity(end) - mean_velocity(begin)
    return drop[inside].mean() / weight - gain / (9.81 * (float(end) - float(begin)))


def heights(times):
    """Twice the mean height of the grains above the bottom [m]: that of a uniform bed."""
    state = (grainplot.read_grains(".", time) for time in times)
    return np.array(
        [2 * np.average(s["position"][:, 2], weights=s["radius"].ravel() ** 3) for s in state]
    )


def pressure():
    """Area of the mesh's bottom [m^2], time [s], pressure drop [Pa]."""
    text = Path("postProcessing/inlet/0/surfaceFieldValue.dat").read_text()
    area = float(re.search(r"Area\s*: (\S+)", text)[1])
    rows = [line.split()[:2] for line in text.splitlines() if line[0] != "#"]
    return area, *np.array(rows, dtype=float).T


def ledger(name):
    with open("postProcessing/ledger/0/ledger.csv") as file:
        return np.array([float(row[name]) for row in csv.DictReader(file)])


def main():
    Path("snapshots").mkdir(exist_ok=True)
    times = grainplot.times(".")[1:]
    grains = np.genfromtxt("constant/grains.csv", delimiter=",", names=True, usecols=range(8))
    volume = np.sum(np.pi / 6 * (2 * grains["radius"]) ** 3)
    area, time, drop = pressure()
    weight = volume * (RHO_P - RHO) * 9.81 / area

    late = [time for time in times if float(time) >= START] or times
    sheet(times[:: max(len(times) // 6, 1)][:6], "snapshots/whole.png")
    sheet(late[-8:], "snapshots/bubbles.png")

    height = heights(times)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    left.plot(time, drop / weight, lw=0.7)
    left.axhline(1, color="k", ls="--", label="weight")
    left.set(xlabel="t [s]", ylabel="pressure drop over the bed's weight", ylim=(0, 2.5))
    left.legend()
    right.plot(np.array(times, dtype=float), 1e3 * height, ".-")
    right.set(xlabel="t [s]", ylabel="height of the bed [mm]")
    figure.savefig("results.png", dpi=110)

    results = Results()
    results.add("grains", len(grains))
    results.add("mean pressure drop over weight", mean_force(time, drop, weight, late[0], late[-1]),
                "-", 1, "5 %", "weight")
    results.add("height of the bed, mean", height[-len(late):].mean(), "m")
    # The cap of a grain that is a hundredth of its diameter deep in a wall, outside the mesh
    results.add("grain outside the mesh, worst", ledger("mappingError").max(), "-", 3e-4, "<=",
                "contacts")
    results.add("momentum error, worst", ledger("momentumError").max(), "-", 1e-9, "<=",
                "round-off")
    results.add("divergence of the mixture, worst", ledger("divergence").max())
    results.add("overlap, mean of the worst over d",
                ledger("worstOverlap").mean() / (2 * grains["radius"].min()))
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
