# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""tank and constant/triSurface/gate.stl: setUp.py slice|whole [end time [s]]"""

import sys
from pathlib import Path

from grainwalls import write_gate

LENGTH, TOP, COLUMN, LEVEL, DEEP = 0.2, 0.15, 0.05, 0.1, 0.1  # [m]
BEAD, BEADS = 2.7e-3, 7762  # diameter [m], number over the whole depth
CELL = 5e-3  # [m]


def main():
    whole = sys.argv[1] == "whole"
    thickness = DEEP if whole else 4 * BEAD
    end = float(sys.argv[2]) if len(sys.argv) > 2 else 0.5
    volume = BEADS / DEEP * 3.14159265 / 6 * BEAD**3
    layers = round(thickness / CELL)
    tank = {
        "length": LENGTH, "top": TOP, "column": COLUMN, "level": LEVEL, "thickness": thickness,
        "cells": f"{round(LENGTH / CELL)} {round(TOP / CELL)} {layers}",
        "sides": "wall" if whole else "cyclic",
        "solid": "walls back front" if whole else "walls",
        "bed": volume / (0.6 * COLUMN),
        "settled": 0.02 if end > 0.1 else 1,
        "end": end, "write": 0.01,
    }  # fmt: skip
    Path("tank").write_text("".join(f"{name} {value};\n" for name, value in tank.items()))

    write_gate(COLUMN, -1e-3, TOP)


if __name__ == "__main__":
    main()
