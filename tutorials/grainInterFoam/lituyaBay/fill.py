# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""0/alpha.water up to the level 0 and constant/grains.csv: fill.py scale speed  [-], [m/s]

The speed, of the bay, is that of the slide at the start, down the slope.
"""

import sys
from pathlib import Path

import grainplot
import numpy as np

LENGTH, THICKNESS, ABOVE = 970.0, 92.0, 230.0  # of the slide, of its toe over the water [m]
DOWN, OFF = np.array([1, -1]) / 2**0.5, np.array([1, 1]) / 2**0.5  # the slope and its normal


def share_below(polygon, level):
    """Of a convex polygon's area."""
    height = polygon[:, 1] - level
    kept = []
    for (a, ha), (b, hb) in zip(
        zip(polygon, height, strict=True),
        zip(np.roll(polygon, -1, axis=0), np.roll(height, -1), strict=True),
        strict=True,
    ):
        if ha <= 0:
            kept.append(a)
        if ha * hb < 0:
            kept.append(a + (b - a) * ha / (ha - hb))
    return area(np.array(kept)) / area(polygon) if len(kept) > 2 else 0.0


def area(polygon):
    x, y = (polygon - polygon[0]).T
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def fill():
    shares = [share_below(polygon, 0.0) for polygon in grainplot.read_mesh(".").polygons]
    values = "\n".join(f"{share:.12g}" for share in shares)
    path = Path("0/alpha.water")
    text = path.read_text().replace(
        "internalField   uniform 0;",
        f"internalField   nonuniform List<scalar>\n{len(shares)}\n(\n{values}\n);",
    )
    path.write_text(text)


def slide(scale, speed):
    """Half of the slab: a wedge at either end, thickest in its middle."""
    slab = np.genfromtxt("constant/slab.csv", delimiter=",", names=True)
    along, off, radius = (slab[name] for name in ("x", "y", "radius"))
    # Of the upper side of the wedges
    slope = 2 * THICKNESS / LENGTH
    reach = np.minimum(along, LENGTH * scale - along) * slope - radius * np.hypot(1, slope)
    kept = off < reach
    toe = ABOVE * scale * np.array([-1, 1])
    centres = toe - np.outer(along[kept], DOWN) + np.outer(off[kept], OFF)
    v = speed * scale**0.5 * DOWN
    with open("constant/grains.csv", "w") as file:
        file.write("x,y,z,radius,vx,vy\n")
        for (x, y), z, r in zip(centres, slab["z"][kept], radius[kept], strict=True):
            file.write(f"{x:.12g},{y:.12g},{z:.12g},{r:.12g},{v[0]:.9g},{v[1]:.9g}\n")
    mass = 2640 * np.pi * (radius[kept] ** 2).sum() / scale**2
    print(f"{kept.sum()} discs of mean diameter {2 * radius[kept].mean() / scale:.3f} m,", end=" ")
    print(f"{mass / 1e6:.1f}e3 t/m without packingRatio")


if __name__ == "__main__":
    scale, speed = map(float, sys.argv[1:])
    fill()
    slide(scale, speed)
