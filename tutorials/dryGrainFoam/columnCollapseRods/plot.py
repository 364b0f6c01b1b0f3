# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the collapse, snapshots/*.png, and the front over time, runout.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

WIDTH = 0.1  # of the column at the start [m]


def deposit(members):
    """Front, height at the wall and top [m].  The front is where the pile that begins at the wall
    ends: what rolls ahead of it, with a gap of a grain's diameter, does not count."""
    x, y = members["position"].T
    r = members["radius"]
    order = np.argsort(x - r)
    reach = np.maximum.accumulate((x + r)[order])
    ahead = np.flatnonzero((x - r)[order][1:] - reach[:-1] > 0.004)
    front = reach[ahead[0]] if len(ahead) else reach[-1]
    wall = np.max((y + r)[x < 0.1 * WIDTH])
    return front, wall, np.max(y + r)


def initial_height(case):
    """Twice that of the centre of mass in the CSV file that the run began with [m]."""
    data = np.genfromtxt(case / "constant/grains.csv", delimiter=",", names=True, usecols=range(4))
    return 2 * np.average(data["y"], weights=data["radius"] ** 2)


def draw(axis, case, time):
    members = grainplot.read_members(case, time)
    grains = grainplot.read_grains(case, time)
    speed = grainplot.magnitude(grains["velocity"])[members["grain"]]
    discs = grainplot.draw_grains(axis, members, speed, clim=(0, 1), linewidths=0)
    axis.set_xlim(0, 0.8)
    axis.set_ylim(0, 0.26)
    return discs


def collapse(cases, times):
    figure, axes = plt.subplots(
        len(times), len(cases), figsize=(17, 2.1 * len(times) + 0.4), layout="compressed"
    )
    for row, time in zip(axes, times, strict=True):
        for axis, case in zip(row, cases, strict=True):
            discs = draw(axis, case, time)
            axis.set_title(f"{name(case)}, t = {time} s")
    figure.colorbar(discs, ax=list(axes.flat), label="grain speed [m/s]", shrink=0.6)
    figure.savefig("snapshots/collapse.png", dpi=110)


def closer(case, time):
    """Rods in colours of their direction."""
    members = grainplot.read_members(case, time)
    angle = grainplot.read_grains(case, time)["orientation"].ravel() % np.pi
    figure, axis = plt.subplots(figsize=(11, 5), layout="constrained")
    discs = grainplot.draw_grains(
        axis, members, np.degrees(angle)[members["grain"]], cmap="twilight", linewidths=0
    )
    axis.set(xlim=(0, 0.3), ylim=(0, 0.13), title=f"{name(case)}, t = {time} s")
    figure.colorbar(discs, label="direction to the floor [degrees]", shrink=0.6)
    figure.savefig("snapshots/directions.png", dpi=110)


def name(case):
    ratio = case.name[6:]
    return "discs" if ratio == "1" else f"rods {ratio} : 1"


def main():
    Path("snapshots").mkdir(exist_ok=True)
    cases = sorted(Path().glob("ratio_*"))
    times = [time for time in grainplot.times(cases[0]) if time != "0"]
    shown = [times[i] for i in np.unique(np.linspace(0, len(times) - 1, 4).round().astype(int))]
    collapse(cases, shown)
    closer(cases[-1], times[-1])

    with open("runout.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["ratio", "time", "front", "heightAtWall", "top"])
        for case in cases:
            rows = [deposit(grainplot.read_members(case, time)) for time in times]
            for time, row in zip(times, rows, strict=True):
                writer.writerow([case.name[6:], time, *(f"{value:.4f}" for value in row)])
            aspect = initial_height(case) / WIDTH
            front, wall, _ = rows[-1] / np.array(WIDTH)
            print(
                f"{name(case)}: aspect ratio {aspect:.2f}, run-out {front - 1:.2f} widths,"
                f" height at the wall {wall:.2f} widths"
            )


main()
