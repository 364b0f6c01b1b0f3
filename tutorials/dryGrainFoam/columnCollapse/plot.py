# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the collapse, snapshots/*.png, and the front over time, runout.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

WIDTH = 0.1  # of the column at the start [m]


def initial():
    """Grains of the CSV file that the run began with."""
    file = "constant/grains.csv"
    data = np.genfromtxt(file, delimiter=",", names=True, usecols=range(8))
    position = np.column_stack([data["x"], data["y"]])
    return {"position": position, "radius": data["radius"], "velocity": 0 * position}


def grains(time):
    return initial() if time == "0" else grainplot.read_grains(".", time)


def front(state):
    """How far the pile reaches [m]: grains that rest on others or on the floor, in a row of
    neighbours from the wall on; single grains that roll ahead do not count."""
    order = np.argsort(state["position"][:, 0])
    x, r = state["position"][order, 0], state["radius"][order]
    ahead = np.flatnonzero(np.diff(x) > 2 * r.max())
    last = ahead[0] if len(ahead) else len(x) - 1
    return x[last] + r[last]


def snapshot(axis, time):
    state = grains(time)
    grainplot.draw_cells(axis, grainplot.read_mesh("."), linewidths=0.1)
    speed = grainplot.magnitude(state["velocity"])
    discs = grainplot.draw_grains(axis, state, speed, clim=(0, 1), linewidths=0)
    axis.set_ylim(0, 0.26)
    axis.set_title(f"t = {time} s")
    return discs


def main():
    times = ["0", *(t for t in grainplot.times(".") if t != "0")]
    shown = [times[i] for i in np.unique(np.linspace(0, len(times) - 1, 6).round().astype(int))]
    Path("snapshots").mkdir(exist_ok=True)

    rows = -(-len(shown) // 2)
    figure, axes = plt.subplots(
        rows, 2, figsize=(13, 2.3 * rows), layout="constrained", squeeze=False
    )
    for axis, time in zip(axes.flat, shown, strict=False):
        discs = snapshot(axis, time)
    for axis in axes.flat[len(shown) :]:
        axis.set_visible(False)
    figure.colorbar(discs, ax=list(axes.flat), label="grain speed [m/s]", shrink=0.6)
    figure.savefig("snapshots/collapse.png", dpi=110)

    with open("runout.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time", "front", "height"])
        for time in times:
            state = grains(time)
            top = np.max(state["position"][:, 1] + state["radius"])
            writer.writerow([time, f"{front(state):.4f}", f"{top:.4f}"])
    start, end = grains("0"), grains(times[-1])
    height = np.max(start["position"][:, 1])
    print(f"aspect ratio {height / WIDTH:.2f}, run-out {front(end) / WIDTH - 1:.2f} widths")


main()
