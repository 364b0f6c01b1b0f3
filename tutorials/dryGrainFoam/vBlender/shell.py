# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell of the blender: constant/triSurface/shell.stl; `facets` also for its pictures."""

from pathlib import Path

import numpy as np

RADIUS = 0.04  # of the legs [m]
LENGTH = 0.08  # of a leg's axis from where the two meet [m]
SLOPE = np.pi / 4  # of the axes to the vertical
SIDES = 32


def leg(side):
    """A cylinder that the plane x = 0 cuts off below and a lid closes above; triangles
    (n, 3, 3), the x axis in the middle of the blender's height."""
    axis = np.array([side * np.sin(SLOPE), 0, np.cos(SLOPE)])
    outward = np.array([side * np.cos(SLOPE), 0, -np.sin(SLOPE)])
    across = np.array([0, 1, 0])
    turn = np.linspace(0, 2 * np.pi, SIDES + 1)[:, np.newaxis]
    ring = RADIUS * (np.cos(turn) * outward + np.sin(turn) * across)
    low = ring - RADIUS * np.cos(turn) / np.tan(SLOPE) * axis
    low[:, 0] = 0
    high = ring + LENGTH * axis

    bottom = -RADIUS / np.sin(SLOPE)
    top = LENGTH * np.cos(SLOPE) + RADIUS * np.sin(SLOPE)
    middle = np.array([0, 0, (bottom + top) / 2])
    triangles = []
    for i in range(SIDES):
        triangles += [(low[i], low[i + 1], high[i + 1]), (low[i], high[i + 1], high[i])]
        triangles.append((high[i], high[i + 1], LENGTH * axis))
    return np.array(triangles) - middle


def facets():
    return np.concatenate([leg(-1), leg(1)])


def main():
    folder = Path("constant/triSurface")
    folder.mkdir(exist_ok=True)
    with open(folder / "shell.stl", "w") as file:
        file.write("solid shell\n")
        for triangle in facets():
            file.write("facet normal 0 0 0\nouter loop\n")
            for x, y, z in triangle:
                file.write(f"vertex {x:.9g} {y:.9g} {z:.9g}\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid shell\n")


if __name__ == "__main__":
    main()
