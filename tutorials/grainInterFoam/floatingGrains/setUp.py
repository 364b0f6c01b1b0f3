# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""tank and constant/grains.csv of a case: setUp.py discs|raft|heave"""

import sys
from pathlib import Path

DIAMETER = 0.048  # of the discs [m]
# Material, place [m], depth of its lowest point over the diameter where it floats
DISCS = (("light", 0.076, 0.298), ("half", 0.204, 0.5), ("heavy", 0.332, 0.702))
RADIUS, LIFT = 0.0762, 0.0254  # of the cylinder that heaves [m]
BEAD = 1e-3  # radius [m]


def discs():
    tank = {
        "left": 0, "right": 0.408, "bottom": -0.12, "top": 0.132, "cells": "136 84 1",
        "across": 1, "upwards": 1, "end": 4, "write": 0.1,
        "stations": "((0.1395 0 0) (0.2685 0 0))",
    }
    # 8 mm above where they float
    rows = [
        (x, 0.008 + DIAMETER * (0.5 - depth), DIAMETER / 2, material)
        for material, x, depth in DISCS
    ]
    return tank, rows


def raft():
    tank = {
        "left": 0, "right": 0.2, "bottom": -0.06, "top": 0.06, "cells": "50 30 1",
        "across": 1, "upwards": 1, "end": 4, "write": 0.1, "stations": "((0.099 0 0))",
    }
    rows = [
        (0.0105 + 2.05 * BEAD * (i + 0.5 * (j % 2)), 0.0015 + 2.05 * BEAD * j, BEAD, "half")
        for j in range(8)
        for i in range(87)
    ]
    return tank, rows


def heave():
    # 16 cells across the cylinder; wider ones where waves go
    tank = {
        "left": -2.5, "right": 2.5, "bottom": -0.9, "top": 0.3, "cells": "163 75 1",
        "across": "((0.44 50 0.125) (0.12 63 1) (0.44 50 8))",
        "upwards": "((0.58333 25 0.16667) (0.33333 42 1) (0.08334 8 1.5))",
        "end": 1.4, "write": 0.1, "stations": "((0.5 0 0))",
    }
    return tank, [(0, LIFT, RADIUS, "half")]


if __name__ == "__main__":
    tank, rows = {"discs": discs, "raft": raft, "heave": heave}[sys.argv[1]]()
    Path("tank").write_text("".join(f"{name} {value};\n" for name, value in tank.items()))
    lines = [f"{x:.9g},{y:.9g},0.005,{r:.9g},{material}" for x, y, r, material in rows]
    Path("constant/grains.csv").write_text("\n".join(["x,y,z,radius,material", *lines, ""]))
