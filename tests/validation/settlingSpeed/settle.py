# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling speeds over those in the box, means over places in a cell: results.csv, results.png.

Usage: settle.py [Re ...]
"""

import os
import shutil
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from conftest import Case
from grainresults import Results
from settling_box import DRAG, PLACES, speeds_of_places, speed_in_box

WIDTHS = {8: 64, 4: 32, 2: 24, 1.4: 16.8, 1: 12, 0.7: 8.4, 0.5: 8}  # of the box, in diameters
RUNS = {
    "SchillerNaumann": {
        0.01: (8, 4, 2, 1.4, 1, 0.7),
        0.1: (8, 4, 2, 1.4, 1, 0.7, 0.5),
        1: (8, 4, 2, 1.4, 1, 0.7, 0.5),
        10: (8, 4, 2, 1.4, 1, 0.7, 0.5),
        95: (8, 4, 2, 1.4, 1),
    },
    "DallavalleDiFelice": {0.1: (4, 2, 1, 0.7), 10: (4, 2, 1, 0.7)},
}


def clone(template, name):
    """As the fixture of the case tests."""
    path = Path("case") / name
    shutil.rmtree(path, ignore_errors=True)
    shutil.copytree(Path(os.environ["GRAINFOAM_DIR"]) / template, path)
    return Case(path)


def tolerance(Re, cell):
    """Where the cell's own fluid goes as fast as the law's sphere no drag coefficient is right."""
    if cell < 0.7:
        return ""
    if cell < 1:
        return "10 %" if Re >= 1 else "15 %"
    return "5 %"


def main():
    results = Results()
    figure, ax = plt.subplots(figsize=(7, 4.5), layout="constrained")
    chosen = [float(word) for word in sys.argv[1:]]
    for law, table in RUNS.items():
        for Re, cells in table.items():
            if chosen and Re not in chosen:
                continue
            ratios = []
            for cell in cells:
                width = WIDTHS[cell]
                speeds = speeds_of_places(clone, Re, cell, width, law)
                ratio = speeds / speed_in_box(Re, width, DRAG[law](Re))
                mean = np.average(ratio, weights=list(PLACES.values()))
                ratios.append(mean)
                name = f"{law}, Re {Re:g}, h/d = {cell:g}"
                source = "law in the flow of the box"
                results.add(f"{name}: speed", mean, "-", 1, tolerance(Re, cell), source)
                results.add(f"{name}: largest less smallest of all places", np.ptp(ratio))
            style = "o-" if law == "SchillerNaumann" else "s:"
            ax.plot(cells, ratios, style, label=f"{law}, Re {Re:g}")
    ax.axhline(1, color="k", ls="--")
    ax.fill_between([0.7, 8], 0.95, 1.05, color="0.9")
    ax.set_xscale("log", base=2)
    ax.set(xlabel="h/d", ylabel="settling speed over that in the box")
    ax.legend(fontsize=7)
    figure.savefig("results.png", dpi=110)
    shutil.rmtree("case")
    results.finish()


main()
