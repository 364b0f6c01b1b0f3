# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""column, cells, grains, stations and constant/triSurface/gate.stl of a case.

setUp.py height width depth cell shape

Lengths in m.  shape: discs in a plane, or spheres in a slice of four diameters with cyclic sides.
"""

import sys
from pathlib import Path

from grainwalls import write_gate

END, AIR = 1.8, 0.1  # of the basin; above the column
SLICE = 4 * 4.6e-3  # four diameters

height, width, depth, cell = map(float, sys.argv[1:5])
shape = sys.argv[5]
top = depth + height + AIR
files = {
    "column": {"platform": width, "level": depth, "column": depth + height, "top": top},
    "grains": {
        "disc": {"shape": "disc", "packing": 0.8, "packingRatio": 0.8},
        "sphere": {"shape": "sphere", "packing": 0.6, "packingRatio": 1},
    }[shape],
    "cells": {
        "sides": {"disc": "empty", "sphere": "cyclic"}[shape],
        "thickness": {"disc": 0.01, "sphere": SLICE}[shape],
        "layers": {"disc": 1, "sphere": max(1, round(SLICE / cell))}[shape],
        "end": END,
        "across": round((END - width) / cell),
        "deep": round(depth / cell),
        "wide": round(width / cell),
        "high": round((top - depth) / cell),
    },
}
for file, entries in files.items():
    Path(file).write_text("".join(f"{name} {value};\n" for name, value in entries.items()))

# Where the water's level is followed, in the middle of cells
at = [cell * (k + 0.5) for k in range(round(END / cell)) if k % round(0.02 / cell) == 0]
points = " ".join(f"({x:g} 0 {SLICE / 5:g})" for x in at)
Path("stations").write_text(f"stations ({points});\n")

write_gate(width, depth, top)
