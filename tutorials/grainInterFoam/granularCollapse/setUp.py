# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""column, cells and constant/triSurface/gate.stl: setUp.py height width depth cell  [m]"""

import sys
from pathlib import Path

END, AIR = 1.8, 0.1  # of the basin; above the column

height, width, depth, cell = map(float, sys.argv[1:])
top = depth + height + AIR
files = {
    "column": {"platform": width, "level": depth, "column": depth + height, "top": top},
    "cells": {
        "end": END,
        "across": round((END - width) / cell),
        "deep": round(depth / cell),
        "wide": round(width / cell),
        "high": round((top - depth) / cell),
    },
}
for file, entries in files.items():
    Path(file).write_text("".join(f"{name} {value:g};\n" for name, value in entries.items()))

corners = [(width, depth, -1), (width, top, -1), (width, top, 1), (width, depth, 1)]
lines = ["solid gate"]
for facet in ((0, 1, 2), (0, 2, 3)):
    lines += ["facet normal 1 0 0", "outer loop"]
    lines += ["vertex {:g} {:g} {:g}".format(*corners[i]) for i in facet]
    lines += ["endloop", "endfacet"]
folder = Path("constant/triSurface")
folder.mkdir(exist_ok=True)
(folder / "gate.stl").write_text("\n".join([*lines, "endsolid gate", ""]))
