# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""parameters and constant/grains.csv: a sphere near the top of a box.

Usage: box.py <cell over diameter> <width over diameter>
"""

import sys

D, SPEED = 2.663e-3, 0.0299

cell, width = (float(word) * D for word in sys.argv[1:])
# Speed over reduced gravity is 0.1 s; where the flow is resolved it takes longer to be steady [s]
time = 0.8 if cell > 0.6 * D else 1.4
n = round(width / cell)
# Six diameters below the sphere at the end, three above it at the start
height = SPEED * time + 9 * D
m = max(-int(-height // cell), 4)
# A third of a cell per step at the final speed, and not more than 2 ms: the time scheme adds a
# viscosity of half the speed squared times the step, at 2 ms as much as that of water
delta_t = time / max(round(time * SPEED / (cell / 3)), round(time / 2e-3))
# Neither in the middle of a cell nor on a face
x, y, z = 0.5 * n * cell + 0.13 * cell, 0.5 * n * cell + 0.31 * cell, m * cell - 3 * D

with open("parameters", "w") as file:
    for name, value in (
        ("cell", cell),
        ("n", n),
        ("m", m),
        ("deltaT", delta_t),
        ("endTime", time),
    ):
        file.write(f"{name} {value!r};\n")
with open("constant/grains.csv", "w") as file:
    file.write(f"x,y,z,radius\n{x!r},{y!r},{z!r},{D / 2!r}\n")
