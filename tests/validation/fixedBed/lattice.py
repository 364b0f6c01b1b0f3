# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Body-centred cubic lattice of spheres of 1 mm that fills the column. The column's sides are
planes of symmetry, so that each cell of two lattice constants has the same fluid fraction.

Usage: lattice.py <fluid fraction>      writes constant/grains.csv, prints the cell size [m]
"""

import sys

import numpy as np

D, CELLS = 1e-3, (1, 1, 12)

phi = 1 - float(sys.argv[1])
period = (2 * np.pi / 6 / phi) ** (1 / 3) * D
box = 2 * period * np.array(CELLS)

corners = np.stack(
    np.meshgrid(*(np.arange(2 * n + 1) for n in CELLS), indexing="ij"), axis=-1
).reshape(-1, 3)
centres = period * np.concatenate([corners, corners + 0.5])
centres = centres[np.all(centres < box + 1e-9, axis=1)]
# Inside the mesh, if only just
centres = np.clip(centres, 1e-12, box - 1e-12)

with open("constant/grains.csv", "w") as file:
    file.write("x,y,z,radius\n")
    for x in centres:
        file.write(",".join(repr(float(value)) for value in (*x, D / 2)) + "\n")
print(repr(float(2 * period)))
