# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""cells and constant/triSurface/gate.stl: setUp.py cell top  [mm], [m]

The top is that of the column, 80 mm over the bottom of the basin.
"""

import sys
from pathlib import Path

cell, top = (float(word) for word in sys.argv[1:])
entries = {"across": 920 / cell, "deep": 80 / cell, "wide": 80 / cell, "high": 320 / cell}
entries |= {"thick": 100 / cell}
lines = [f"{name} {round(n)};" for name, n in entries.items()]
Path("cells").write_text("\n".join([*lines, f"top {top:g};", ""]))

corners = [(0.08, 0.08, -1), (0.08, 0.5, -1), (0.08, 0.5, 1), (0.08, 0.08, 1)]
lines = ["solid gate"]
for facet in ((0, 1, 2), (0, 2, 3)):
    lines += ["facet normal 1 0 0", "outer loop"]
    lines += ["vertex {:g} {:g} {:g}".format(*corners[i]) for i in facet]
    lines += ["endloop", "endfacet"]
folder = Path("constant/triSurface")
folder.mkdir(exist_ok=True)
(folder / "gate.stl").write_text("\n".join([*lines, "endsolid gate", ""]))
