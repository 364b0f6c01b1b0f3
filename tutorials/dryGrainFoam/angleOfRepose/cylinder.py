# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tube without bottom and lid on the floor: constant/triSurface/cylinder.stl."""

from pathlib import Path

import numpy as np

RADIUS = 0.03  # [m]
HEIGHT = 0.25
SIDES = 24


def main():
    angle = np.linspace(0, 2 * np.pi, SIDES + 1)
    ring = RADIUS * np.column_stack([np.cos(angle), np.sin(angle)])
    facets = []
    for (ax, ay), (bx, by) in zip(ring[:-1], ring[1:], strict=True):
        a, b, c, d = (ax, ay, 0), (bx, by, 0), (bx, by, HEIGHT), (ax, ay, HEIGHT)
        facets += [(a, b, c), (a, c, d)]
    folder = Path("constant/triSurface")
    folder.mkdir(exist_ok=True)
    with open(folder / "cylinder.stl", "w") as file:
        file.write("solid cylinder\n")
        for facet in facets:
            file.write("facet normal 0 0 0\nouter loop\n")
            for x, y, z in facet:
                file.write(f"vertex {x:.9g} {y:.9g} {z:.9g}\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid cylinder\n")


main()
