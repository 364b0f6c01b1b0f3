# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Beads in a slice, their temperatures over time, what must hold (snapshots/, results.*).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RADIUS, INLET, CONE, TOP = 18e-3, 12e-3, 18e-3, 108e-3  # [m]
TUBE, LOWER, UPPER = 4e-3, 18e-3, 30e-3
COLD, HOT = 300.0, 450.0


def ledger(name, folder="heatLedger"):
    file = Path(f"postProcessing/{folder}/0/{folder}.csv")
    return np.genfromtxt(file, delimiter=",", names=True)[name]


def draw(ax, time):
    """Beads that the plane x = 0 cuts, tubes and vessel."""
    state = grainplot.read_grains(".", time)
    x, radius = state["position"], state["radius"].ravel()
    cut = np.abs(x[:, 0]) < radius
    discs = {"position": x[cut, 1:], "radius": np.sqrt(radius[cut] ** 2 - x[cut, 0] ** 2)}
    ax.add_patch(plt.Rectangle((-RADIUS, UPPER - TUBE), 2 * RADIUS, 2 * TUBE, color="0.7"))
    ax.add_patch(plt.Circle((0, LOWER), TUBE, color="0.7"))
    for side in (-1, 1):
        ax.plot(side * np.array([INLET, RADIUS, RADIUS]), [0, CONE, TOP], color="0.4", lw=1)
    drawn = grainplot.draw_grains(
        ax, discs, state["temperature"].ravel()[cut], clim=(COLD, HOT), cmap="inferno",
        linewidths=0,
    )
    ax.set(
        title=f"t = {time} s", xlim=(-1.05 * RADIUS, 1.05 * RADIUS), ylim=(0, TOP), aspect="equal"
    )
    return drawn


def sheet(times):
    figure, row = plt.subplots(
        1, len(times), figsize=(2.2 * len(times), 6), sharey=True, layout="constrained"
    )
    for ax, time in zip(np.atleast_1d(row), times, strict=True):
        drawn = draw(ax, time)
    figure.colorbar(drawn, ax=row, label="temperature [K]", shrink=0.6)
    figure.savefig("snapshots/beds.png", dpi=110)
    plt.close(figure)


def halves(times):
    """Mean temperatures [K] and heights [m] of the beads that were cold and hot."""
    start = grainplot.read_grains(".", times[0])["temperature"].ravel() > 0.5 * (COLD + HOT)
    rows = []
    for time in times:
        state = grainplot.read_grains(".", time)
        T, z = state["temperature"].ravel(), state["position"][:, 2]
        rows.append([T[~start].mean(), T[start].mean(), z[~start].mean(), z[start].mean()])
    return np.array(rows).T


def curves(times):
    cold, hot, low, high = halves(times)
    t = np.array(times, dtype=float)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    left.plot(t, hot - hot[0], "C3.-", label="hot beads")
    left.plot(t, cold - cold[0], "C0.-", label="cold beads")
    left.set(xlabel="t [s]", ylabel="mean temperature, change [K]")
    left.legend()
    right.plot(t, 1e3 * high, "C3.-", label="hot beads")
    right.plot(t, 1e3 * low, "C0.-", label="cold beads")
    right.set(xlabel="t [s]", ylabel="mean height [mm]")
    right.legend()
    figure.savefig("results.png", dpi=110)
    plt.close(figure)
    return cold, hot


def main():
    Path("snapshots").mkdir(exist_ok=True)
    times = grainplot.times(".")[1:]
    sheet([times[i] for i in np.unique(np.linspace(0, len(times) - 1, 6).astype(int))])
    cold, hot = curves(times)

    exchanged = np.abs(ledger("exchanged")).sum()
    tubes = sum(ledger(f"conducted_{name}").sum() for name in ("lower", "upper"))
    results = Results()
    results.add("cold beads, warmed by", cold[-1] - COLD, "K")
    results.add("hot beads, cooled by", HOT - hot[-1], "K")
    results.add("heat to the tubes by contacts", -ledger("walls").sum(), "J")
    results.add("heat to the tubes by air", tubes, "J")
    results.add("heat that beads and air exchanged", exchanged, "J")
    results.add("heat of the air unaccounted for, worst", ledger("fluidError").max(), "-", 1e-9,
                "<=", "round-off")
    results.add("heat of the beads unaccounted for, worst", ledger("grainError").max(), "-", 1e-12,
                "<=", "round-off")
    results.add("coldest, air and beads", min(ledger("leastT").min(), ledger("leastGrainT").min()),
                "K", COLD - 1e-6, ">=", "bounds")
    results.add("hottest, air and beads", max(ledger("mostT").max(), ledger("mostGrainT").max()),
                "K", HOT + 1e-6, "<=", "bounds")
    results.add("momentum error, worst", ledger("momentumError", "ledger").max(), "-", 1e-9, "<=",
                "round-off")
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
