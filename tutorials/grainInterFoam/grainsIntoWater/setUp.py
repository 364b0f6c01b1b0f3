# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""tank and constant/grains.csv: rows of beads over water.  setUp.py [end time [s]]"""

import sys
from pathlib import Path

import numpy as np

WIDTH, DEPTH, HEIGHT = 0.2, 0.06, 0.08  # of the tank, water below and air above y = 0 [m]
BEAD = 1e-3  # radius [m]
COLUMNS, ROWS, PITCH, LOWEST = 60, 12, 2.6e-3, 0.02  # [m]
CELL = 4e-3  # [m]


def main():
    end = float(sys.argv[1]) if len(sys.argv) > 1 else 2
    tank = {
        "left": 0, "right": WIDTH, "bottom": -DEPTH, "top": HEIGHT,
        "cells": f"{round(WIDTH / CELL)} {round((DEPTH + HEIGHT) / CELL)} 1",
        "end": end, "write": 0.02,
        "stations": "(" + " ".join(f"({x:.3f} 0 0)" for x in np.arange(0.006, WIDTH, 0.012)) + ")",
    }
    Path("tank").write_text("".join(f"{name} {value};\n" for name, value in tank.items()))
    shift = np.random.default_rng(1).uniform(-2e-4, 2e-4, (ROWS, COLUMNS, 2))
    first = (WIDTH - (COLUMNS - 1) * PITCH) / 2
    rows = [
        f"{first + PITCH * i + shift[j, i, 0]:.9g},{LOWEST + PITCH * j + shift[j, i, 1]:.9g},"
        f"0.005,{BEAD:g}"
        for j in range(ROWS)
        for i in range(COLUMNS)
    ]
    Path("constant/grains.csv").write_text("\n".join(["x,y,z,radius", *rows, ""]))


if __name__ == "__main__":
    main()
