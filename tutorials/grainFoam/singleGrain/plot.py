# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling speeds (results.*) and the flow around the disc (snapshots).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, SPEED = 2.663e-3, 0.02990  # diameter [m]; settling speed of the law [m/s]
LAW = "Dallavalle's law"
FLOWS = {"none": "flow of the cell", "filtered": "undisturbed flow"}
LAST = 0.3  # of the time, in which the speed is averaged


def parameter(case, name):
    """A number of the file that box.py wrote."""
    lines = (case / "parameters").read_text().splitlines()
    return float(next(x.split()[1] for x in lines if x.startswith(name + " ")).rstrip(";"))


def track(case):
    """Time and speed of fall."""
    data = np.genfromtxt(case / "postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    return data["time"], parameter(case, "frame") - data["vy"]


def runs(shape):
    """h/d, width of the box, flow, time, speed of fall; from wide to small cells."""
    found = []
    for path in Path(".").glob(f"{shape}_cells_*_width_*"):
        _, _, h, _, width, flow = path.name.split("_")
        found.append((float(h), float(width), flow, *track(path)))
    return sorted(found, key=lambda run: (-run[0], -run[1], run[2]))


def mean(time, speed):
    last = speed[time > (1 - LAST) * time[-1]]
    return last.mean(), last.std() / last.mean()


def spheres(results, left, right):
    speeds = []
    for h, width, flow, time, speed in runs("sphere"):
        value, scatter = mean(time, speed)
        speeds.append((h, width, flow, value))
        name = f"sphere, h/d = {h:g}, box {width:g} d wide, {FLOWS[flow]}"
        tolerance = "10 %" if flow == "filtered" else ""
        results.add(f"{name}: over the law's", value / SPEED, "-", 1, tolerance, LAW)
        results.add(f"{name}: scatter over the mean", scatter)
        left.plot(time, speed, ls="-" if flow == "filtered" else ":", label=name)
    for flow, label in FLOWS.items():
        points = [(h, v) for h, width, f, v in speeds if f == flow and width in (8, 12, 32)]
        if points:
            h, value = np.array(points).T
            right.plot(h, value / SPEED, "o-", label=f"sphere, {label}, over the law's")


def discs(results, left, right):
    cases = runs("disc")
    _, _, _, time, speed = cases[-1]
    finest, (reference, _) = cases[-1][0], mean(time, speed)
    source = f"resolved, h/d = {finest:g}"
    results.add(f"disc, {source}: over the law's", reference / SPEED, "-", 1, "", LAW)
    points = []
    for h, width, flow, time, speed in cases:
        left.plot(time, speed, label=f"disc, h/d = {h:g}", lw=0.7)
        if h == finest:
            continue
        value, scatter = mean(time, speed)
        name = f"disc, h/d = {h:g}, box {width:g} d wide, {FLOWS[flow]}"
        results.add(f"{name}: over the resolved", value / reference, "-", 1, "10 %", source)
        results.add(f"{name}: scatter over the mean", scatter)
        points.append((h, value / reference))
    if points:
        right.plot(*np.array(points).T, "s-", label="disc, undisturbed flow, over the resolved")


def snapshot(case):
    """Speed of the fluid at the end, seen from the ground."""
    time = grainplot.times(case)[-1]
    mesh = grainplot.read_mesh(case)
    velocity = grainplot.read_field(case, time, "U", len(mesh.polygons))
    velocity = velocity - [0, parameter(case, "frame"), 0]
    grains = grainplot.read_grains(case, time)
    figure, ax = plt.subplots(figsize=(4, 6), layout="constrained")
    cells = grainplot.draw_cells(ax, mesh, np.linalg.norm(velocity, axis=1), lines=False)
    grainplot.draw_grains(ax, grains, facecolors="0.4")
    x, y = grains["position"][0]
    ax.set(xlim=(x - 4 * D, x + 4 * D), ylim=(y - 3 * D, y + 9 * D), title=f"t = {time} s")
    figure.colorbar(cells, label="speed of the fluid [m/s]", shrink=0.7)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig("snapshots/disc.png", dpi=110)


def main():
    results = Results()
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(15, 4.4), layout="constrained")
    spheres(results, left, right)
    discs(results, middle, right)
    for ax in (left, middle):
        ax.axhline(SPEED, color="k", ls="--", label=LAW)
        ax.set(xlabel="t [s]", ylabel="speed of fall [m/s]")
        ax.legend(fontsize=5)
    right.axhline(1, color="k", ls="--")
    right.fill_between([1 / 8, 4], 0.9, 1.1, color="0.9")
    right.set_xscale("log", base=2)
    right.set(xlabel="h/d", ylabel="speed over the reference's")
    right.legend(fontsize=7)
    figure.savefig("results.png", dpi=110)

    finest = min(Path(".").glob("disc_cells_*"), key=lambda path: float(path.name.split("_")[2]))
    snapshot(finest)
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
