# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplet and grains in the middle plane, and the droplet's history (snapshots/)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

SIDE, TOP, BED = 8e-3, 14e-3, 7.4e-3  # of the cell, height of the bed [m]
RADIUS = 1.25e-3  # of the droplet at the start [m]
HOT = 400.0  # [degrees C]


def draw(ax, books, time):
    """What the plane through the middle cuts."""
    grains = grainplot.read_grains(".", time)
    x, radius = grains["position"], grains["radius"].ravel()
    off = np.abs(x[:, 2] - SIDE / 2)
    cut = off < radius
    discs = {"position": x[cut, :2], "radius": np.sqrt(radius[cut] ** 2 - off[cut] ** 2)}
    drawn = grainplot.draw_grains(
        ax, discs, grains["temperature"].ravel()[cut] - 273.15,
        clim=(100, HOT), cmap="inferno", linewidths=0,
    )
    grainplot.draw_droplets(ax, books, time)
    ax.set(title=f"t = {time} s", xlim=(0, SIDE), ylim=(0, TOP), aspect="equal")
    return drawn


def sheet(books, times):
    figure, row = plt.subplots(
        1, len(times), figsize=(2.3 * len(times), 4), sharey=True, layout="constrained"
    )
    for ax, time in zip(np.atleast_1d(row), times, strict=True):
        drawn = draw(ax, books, time)
    figure.colorbar(drawn, ax=row, label="temperature of the grains [C]", shrink=0.6)
    figure.savefig("snapshots/droplet.png", dpi=110)
    plt.close(figure)


def history(books):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    left.plot(books["time"], (BED - books["y"]) / (2 * RADIUS))
    left.set(xlabel="time [s]", ylabel="depth of the centre / diameter")
    right.plot(books["time"], books["liquid"] / books["liquid"][0], label="liquid, of the first")
    volume = 4 / 3 * np.pi * books["radius"] ** 3
    right.plot(books["time"], books["inside"] / volume, label="grains, of the volume")
    right.set(xlabel="time [s]", ylim=(0, None))
    right.legend()
    figure.savefig("snapshots/history.png", dpi=110)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    books = grainplot.read_droplets(".")
    times = grainplot.times(".")[1:]
    sheet(books, [times[i] for i in np.unique(np.linspace(0, len(times) - 1, 6).astype(int))])
    history(books)


main()
