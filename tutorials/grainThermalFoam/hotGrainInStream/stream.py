# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write what depends on the cell size: the file parameters and the grain.

Usage: stream.py <case> <cell size over diameter> [-test]
"""

import math
import sys
from pathlib import Path

D, U = 0.01, 0.1  # [m], [m/s]
LENGTH, WIDTH = 16, 8  # of the box, in diameters, or 12 and 8 cells if that is more
COURANT = 0.4
PASSAGES = 2.5  # of the box by the stream, until it is steady

case, h = Path(sys.argv[1]), float(sys.argv[2]) * D
nx = max(math.ceil(LENGTH * D / h), 12)
ny = 2 * math.ceil(max(WIDTH * D / h, 8) / 2)
deltaT = COURANT * h / U
steps = 10 if "-test" in sys.argv else math.ceil(max(PASSAGES * nx / COURANT, 60))
entries = {
    "nx": nx, "ny": ny, "length": nx * h, "width": ny * h,
    "step": deltaT, "end": steps * deltaT, "steps": steps,
}
(case / "parameters").write_text("".join(f"{key} {value};\n" for key, value in entries.items()))

# Not where a cell has its centre or its corner
centre = ((round(0.35 * nx) + 0.37) * h, (ny // 2 + 0.22) * h, (ny // 2 + 0.21) * h)
row = ",".join(repr(value) for value in (*centre, D / 2))
(case / "constant/grains.csv").write_text(f"x,y,z,radius\n{row}\n")
