# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""cells and constant/triSurface/gate.stl: setUp.py cell top  [mm], [m]

The top is that of the column, 80 mm over the bottom of the basin.
"""

import sys
from pathlib import Path

from grainwalls import write_gate

cell, top = (float(word) for word in sys.argv[1:])
entries = {"across": 920 / cell, "deep": 80 / cell, "wide": 80 / cell, "high": 320 / cell}
entries |= {"thick": 100 / cell}
lines = [f"{name} {round(n)};" for name, n in entries.items()]
Path("cells").write_text("\n".join([*lines, f"top {top:g};", ""]))

write_gate(0.08, 0.08, 0.5)
