# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fingers and bubbles (fig. 3.14), their number, and where the time goes."""

import csv
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

WIDTH, HEIGHT = 0.056, 0.068  # [m]


def initial():
    data = np.genfromtxt("constant/grains.csv", delimiter=",", names=True, usecols=range(4))
    return {
        "id": np.arange(len(data)),
        "position": np.column_stack([data["x"], data["y"]]),
        "radius": data["radius"],
    }


def draw(axes, state, height):
    """Grains coloured by their height at the beginning [mm]."""
    discs = grainplot.draw_grains(
        axes, state, 1e3 * height[state["id"]], clim=(14, 68), cmap="turbo", linewidths=0
    )
    axes.set(xlim=(0, WIDTH), ylim=(0, HEIGHT), aspect="equal", xticks=[], yticks=[])
    return discs


def columns(state, n=112):
    """Area of grains per width and bin of x."""
    x, r = state["position"][:, 0], state["radius"]
    index = np.clip((x / WIDTH * n).astype(int), 0, n - 1)
    return np.bincount(index, np.pi * r**2, n) / (WIDTH / n)


def below(state, height):
    """The grains whose centres are below a height [m]."""
    chosen = state["position"][:, 1] < height
    return {name: state[name][chosen] for name in ("position", "radius")}


def fingers(state):
    """Dominant number of fingers across the width below where the packing began."""
    profile = columns(below(state, 0.0145))
    spectrum = np.abs(np.fft.rfft(profile - profile.mean())) ** 2
    return int(np.argmax(spectrum[1:40]) + 1) if profile.any() else 0


def ledger():
    (path,) = Path("postProcessing/ledger").glob("*/ledger.csv")
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def main():
    test = "-test" in sys.argv
    Path("snapshots").mkdir(exist_ok=True)
    start = initial()
    height = start["position"][:, 1]
    times = [time for time in grainplot.times(".") if time != "0"]
    states = {"0": start} | {time: grainplot.read_grains(".", time) for time in times}

    n = (len(states) + 1) // 2
    figure, axes = plt.subplots(2, n, figsize=(3 * n, 7.6), layout="constrained", squeeze=False)
    for place in axes.flat:
        place.axis("off")
    for place, (time, state) in zip(axes.flat, states.items(), strict=False):
        place.axis("on")
        discs = draw(place, state, height)
        place.set_title(f"t = {time} s")
    figure.colorbar(discs, ax=axes, label="height at t = 0 [mm]", shrink=0.6)
    figure.savefig("results.png", dpi=60)
    figure.savefig("snapshots/all.png", dpi=130)

    books = ledger()
    clock = books["elapsedTime"][-1] - books["elapsedTime"][0]
    share = {
        name: (books[name][-1] - books[name][0]) / clock for name in ("motionTime", "exchangeTime")
    }

    results = Results()
    results.add("grains", len(height))
    results.add("steps", len(books["time"]))
    for time in ("0.05", "0.1", "0.15"):
        if time in states:
            results.add(f"fingers at {time} s", fingers(states[time]))
    results.add("mapping error", books["mappingError"].max(), "-", 1e-12, "<=", "round-off")
    results.add("momentum error", books["momentumError"].max(), "-", 1e-9, "<=", "round-off")
    results.add("volume without room", books["overfull"].max(), "m3", 0, "<=", "exact overlap")
    results.add(
        "worst overlap", books["worstOverlap"].max() / 2.3e-4, "d", 0.05, "<=", "contact solver"
    )
    results.add("wall clock", books["elapsedTime"][-1], "s", 720, "<=", "thesis: 4 h")
    results.add("contacts", 100 * share["motionTime"], "% of it")
    results.add("mapping and exchange", 100 * share["exchangeTime"], "% of it", 15, "<=", "")
    if test:
        results.write("results.csv")
    else:
        results.finish()


main()
