# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of grains and force chains, snapshots/t_*.png; grains above the neck, discharge.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

NECK = 0.155  # height of its middle [m]
STRONG = 40 * 2500 * np.pi * 1e-3**2 * 0.01 * 9.81  # 40 mean grains' weight [N]


def snapshot(time):
    """Grains in colours of their speed, beside them the forces between them (fig. 1.2)."""
    state = grainplot.read_grains(".", time)
    mesh = grainplot.read_mesh(".")
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(6.5, 9.5), sharey=True, layout="constrained"
    )
    for axis in (left, right):
        grainplot.draw_cells(axis, mesh, linewidths=0.15)
    speed = grainplot.magnitude(state["velocity"])
    discs = grainplot.draw_grains(left, state, speed, clim=(0, 1), linewidths=0)
    grainplot.draw_grains(right, state, facecolors="0.88", linewidths=0)
    lines, force = grainplot.read_contacts(".", "forceChains", time)
    grainplot.draw_contacts(right, lines, np.minimum(force / STRONG, 1), scale=3)
    left.set_title(f"t = {time} s")
    right.set_title("forces")
    figure.colorbar(discs, ax=left, label="grain speed [m/s]", location="bottom", shrink=0.8)
    return figure


def main():
    times = [time for time in grainplot.times(".") if time != "0"]
    shown = [times[i] for i in np.unique(np.linspace(0, len(times) - 1, 6).round().astype(int))]
    Path("snapshots").mkdir(exist_ok=True)
    for time in shown:
        figure = snapshot(time)
        figure.savefig(f"snapshots/t_{time}.png", dpi=110)
        plt.close(figure)

    with open("discharge.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time", "above"])
        for time in times:
            height = grainplot.read_grains(".", time)["position"][:, 1]
            writer.writerow([time, np.count_nonzero(height > NECK)])


main()
