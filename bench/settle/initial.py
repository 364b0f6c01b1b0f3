#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres on a jittered lattice above the floor of an open box, for all codes alike.

usage: initial.py N side directory

Diameters are 5 mm within 10 %, uniformly. Writes initial.csv (x, y, z, r [m]) and,
for LIGGGHTS, initial.data. The same for every run.
"""

import sys
from pathlib import Path

import numpy as np

DENSITY = 2500
PITCH, JITTER, FIRST = 5.9e-3, 0.19e-3, 2.9e-3  # no two spheres can touch


def spheres(count, side):
    random = np.random.default_rng(42)
    radius = 2.5e-3 * random.uniform(0.9, 1.1, count)
    row = np.linspace(FIRST, side - FIRST, int((side - 5.6e-3) // PITCH) + 1)
    layer = np.array([(x, y) for x in row for y in row])
    k = np.arange(count) // len(layer)
    centre = np.column_stack([layer[np.arange(count) % len(layer)], 3e-3 + PITCH * k])
    centre += random.uniform(-JITTER, JITTER, centre.shape)
    clear = radius + 1e-6
    centre[:, :2] = np.clip(centre[:, :2], clear[:, None], side - clear[:, None])
    centre[:, 2] = np.maximum(centre[:, 2], clear)
    return centre, radius


def main():
    count, side, directory = int(sys.argv[1]), float(sys.argv[2]), Path(sys.argv[3])
    centre, radius = spheres(count, side)
    np.savetxt(directory / "initial.csv", np.c_[centre, radius], delimiter=",", fmt="%.10g")
    top = max(0.2, centre[:, 2].max() + 0.02)
    with open(directory / "initial.data", "w", encoding="ascii") as out:
        out.write(f"spheres\n\n{count} atoms\n1 atom types\n\n")
        out.write(f"0 {side} xlo xhi\n0 {side} ylo yhi\n-0.002 {top:.4f} zlo zhi\n\nAtoms\n\n")
        for i, (x, r) in enumerate(zip(centre, radius), 1):
            out.write(f"{i} 1 {2 * r:.10g} {DENSITY} {x[0]:.10g} {x[1]:.10g} {x[2]:.10g}\n")


main()
