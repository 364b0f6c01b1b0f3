# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nusselt number of the sphere over that of the law, by the cell size (results.*, snapshots/).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, KAPPA, COLD = 0.01, 1 / 70, 300.0
RE, PR = 100, 0.7
LAW = 2 + 0.6 * math.sqrt(RE) * PR ** (1 / 3)
# Of the unresolved ones from a cell of a diameter on 5 %, of the others 15 %
FINE = 1


def nusselt(case):
    """Of the last ten steps."""
    file = case / "postProcessing/heatLedger/0/heatLedger.csv"
    book = np.genfromtxt(file, delimiter=",", names=True)
    deltaT = book["time"][1] - book["time"][0]
    heat = -book["exchanged"][-10:].mean() / deltaT
    return heat / (math.pi * D * KAPPA * (book["meanGrainT"][-1] - COLD))


def main():
    Path("snapshots").mkdir(exist_ok=True)
    cases = sorted(Path().glob("hd_*"), key=lambda path: float(path.name[3:]))
    sizes = [float(case.name[3:]) for case in cases]
    ratios = [nusselt(case) / LAW for case in cases]

    figure, ax = plt.subplots(figsize=(6, 4), layout="constrained")
    ax.semilogx(sizes, ratios, "o-")
    ax.axhline(1, color="k", ls="--", label="Ranz and Marshall")
    ax.set(xlabel="h/d", ylabel="Nu over that of the law", ylim=(0.5, 1.5))
    ax.legend()
    figure.savefig("snapshots/nusselt.png", dpi=110)
    figure.savefig("results.png", dpi=110)

    results = Results()
    for size, ratio in zip(sizes, ratios, strict=True):
        tolerance = "5 %" if size >= FINE else "15 %"
        results.add(f"Nu over the law, h/d = {size:g}", ratio, "-", 1, tolerance, "Ranz, Marshall")
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
