# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the heaps, snapshots/*.png, and their angles, angles.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

DIAMETER = 0.005  # mean [m]


def surface(grains):
    """Radii of rings one grain wide around the axis and the mean height of the surface in them
    [m]: of the highest grain in each piece, two grains long, of a ring."""
    x, y, z = grains["position"].T
    ring = (np.hypot(x, y) / DIAMETER).astype(int)
    turn = (np.arctan2(y, x) / (2 * np.pi)) % 1
    top = z + grains["radius"]
    heights = []
    for i in range(ring.max() + 1):
        pieces = max(1, round(np.pi * (i + 0.5)))
        piece = (turn * pieces).astype(int)
        tops = [top[(ring == i) & (piece == k)] for k in range(pieces)]
        heights.append(np.mean([values.max() if len(values) else 0 for values in tops]))
    return (np.arange(len(heights)) + 0.5) * DIAMETER, np.array(heights)


def slope(radius, height):
    """Line through the surface where it is between 0.25 and 0.85 of its greatest height:
    angle [degrees], slope, height at the axis [m]."""
    middle = (height > 0.25 * height.max()) & (height < 0.85 * height.max())
    if np.count_nonzero(middle) < 2:
        return np.nan, np.nan, np.nan
    rise, offset = np.polyfit(radius[middle], height[middle], 1)
    return np.degrees(np.arctan(-rise)), rise, offset


def draw(axis, grains, values, **style):
    """Side view; grains in front hide those behind."""
    order = np.argsort(-grains["position"][:, 1])
    shown = {"position": grains["position"][order][:, [0, 2]], "radius": grains["radius"][order]}
    discs = grainplot.draw_grains(axis, shown, values[order], **style)
    axis.set_xlim(-0.12, 0.12)
    axis.set_ylim(0, 0.12)
    return discs


def heaps(cases, measured):
    """Side view of each heap at the end with the line that was fitted."""
    figure, axes = plt.subplots(2, 2, figsize=(11, 4), layout="compressed")
    for axis, case in zip(axes.flat, cases, strict=True):
        grains = grainplot.read_grains(case, grainplot.times(case)[-1])
        draw(axis, grains, grains["position"][:, 1], cmap="Greys", clim=(-0.1, 0.12))
        angle, rise, offset = measured[case]
        x = np.array([0, 0.1])
        for side in (-1, 1):
            axis.plot(side * x, offset + rise * x, "r-", linewidth=1)
        friction, rolling = case.name.split("_")[1:]
        axis.set_title(f"friction {friction}, of rolling {rolling}: {angle:.1f} degrees")
        axis.set_ylim(0, 0.06)
    figure.savefig("snapshots/heaps.png", dpi=110)


def lifting(case):
    """The cylinder, which is not drawn, is lifted."""
    times = [time for time in grainplot.times(case) if time != "0"]
    shown = [times[i] for i in np.linspace(0, len(times) - 1, 4).round().astype(int)]
    figure, axes = plt.subplots(2, 2, figsize=(11, 6), layout="compressed")
    for axis, time in zip(axes.flat, shown, strict=True):
        grains = grainplot.read_grains(case, time)
        speed = grainplot.magnitude(grains["velocity"])
        discs = draw(axis, grains, speed, clim=(0, 0.2))
        axis.set_title(f"t = {time} s")
    figure.colorbar(discs, ax=list(axes.flat), label="grain speed [m/s]", shrink=0.6)
    figure.savefig("snapshots/lifting.png", dpi=110)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    cases = sorted(Path().glob("friction_*"), key=lambda path: path.name.split("_")[::-1])
    measured = {}
    with open("angles.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["friction", "rolling", "angle", "grains"])
        for case in cases:
            grains = grainplot.read_grains(case, grainplot.times(case)[-1])
            measured[case] = slope(*surface(grains))
            row = [*case.name.split("_")[1:], f"{measured[case][0]:.1f}", len(grains["id"])]
            writer.writerow(row)
            print("friction {}, of rolling {}: {} degrees, {} grains".format(*row))
    heaps(cases, measured)
    lifting(Path("friction_0.4_0"))


main()
