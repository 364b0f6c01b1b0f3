# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""parameters and constant/grains.csv: a grain near the top of a box.

Usage: box.py <sphere or disc> <cell over diameter> <width over diameter>

A sphere that is not resolved falls through a box at rest.  Discs, and spheres with four cells in
a diameter or more, are seen from a frame of reference that falls with 0.8 of the law's
speed: the box can be short, and the grain still passes cells.  With 0.95 of it a sphere of four
cells took the speed of the frame, held between positions at which its cells change.
"""

import math
import sys

D, SPEED = 2.663e-3, 0.0299  # diameter [m], settling speed of the drag law [m/s]
RATIO = 10  # largest over smallest cell of a refined mesh


def at_rest(cell, width):
    """Settings of a box six diameters below the sphere at the end, three above it at the start."""
    # Speed over reduced gravity is 0.1 s, and in smaller cells it takes longer to be steady
    time = 0.8 if cell > 0.6 else 1.4
    n = round(width / cell)
    m = max(-int(-(SPEED * time / D + 9) // cell), 4)
    # A third of a cell per step, and not more than 2 ms: Euler's scheme adds a viscosity of half
    # the speed squared times the step, at 2 ms as much as that of water
    steps = max(round(time * SPEED / (cell * D / 3)), round(time / 2e-3))
    # Neither in the middle of a cell nor on a face
    start = (n / 2 + 0.13) * cell, m * cell - 3, (n / 2 + 0.31) * cell
    return {
        "sections": [[(n * cell, n, 1)], [(m * cell, m, 1)]],
        "start": start,
        "frame": 0,
        "time": time,
        "deltaT": time / steps,
        "ddt": "Euler",
    }


def falling(cell, lateral, vertical, start, time):
    """Settings of a box whose cells are of one size between the middle two of four lengths."""
    steps = math.ceil(time * SPEED / (0.5 * cell * D))
    return {
        "sections": [list(sections(cell, *lateral)), list(sections(cell, *vertical))],
        "start": (start[0] + 0.13 * cell, start[1], start[2] + 0.31 * cell),
        "frame": 0.8 * SPEED,
        "time": time,
        "deltaT": time / max(steps, round(time / 4e-3)),
        "ddt": "backward",
    }


def sections(cell, low, first, last, high):
    """Length, number of cells, last over first cell of the parts of an edge."""
    if cell > 0.25:
        yield high - low, round((high - low) / cell), 1
        return
    mean = cell * (RATIO - 1) / math.log(RATIO)
    yield first - low, round((first - low) / mean), 1 / RATIO
    yield last - first, round((last - first) / cell), 1
    yield high - last, round((high - last) / mean), RATIO


def settings(shape, cell, width):
    half = width / 2
    if shape == "disc":
        # Vortices are shed from half of it on
        around = (0, half - 2, half + 2, width)
        return falling(cell, around, (0, 8, 26, 38), (half, 24, 0), 80 * D / SPEED)
    if cell > 0.25:
        return at_rest(cell, width)
    around = (0, half - 1.5, half + 1.5, width)
    return falling(cell, around, (0, 2, 7.5, 13), (half, 6, half), 1.4)


def main():
    shape = sys.argv[1]
    case = settings(shape, *(float(word) for word in sys.argv[2:]))
    lateral, vertical = case["sections"]
    with open("parameters", "w") as file:
        for name, edge in (("lateral", lateral), ("vertical", vertical)):
            words = " ".join(f"({length!r} {n} {ratio!r})" for length, n, ratio in edge)
            file.write(f"{name} ({words});\n")
        for name, value in (
            ("nx", sum(n for _, n, _ in lateral)),
            ("ny", sum(n for _, n, _ in vertical)),
            ("width", D * sum(length for length, _, _ in lateral)),
            ("height", D * sum(length for length, _, _ in vertical)),
            ("frame", case["frame"]),
            ("deltaT", case["deltaT"]),
            ("endTime", case["time"]),
            ("ddt", case["ddt"]),
        ):
            file.write(f"{name} {value};\n")

    x, y, z = (D * value for value in case["start"])
    with open("constant/grains.csv", "w") as file:
        file.write(f"x,y,z,radius\n{x!r},{y!r},{z!r},{D / 2!r}\n")


main()
