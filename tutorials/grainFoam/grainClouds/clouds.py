# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/grains.csv: two discs of grains at random places, without overlaps."""

import numpy as np

RADIUS, CLOUD, FRACTION = 25e-6, 3.3e-3, 0.2  # of grains and clouds [m]; of area in a cloud
CENTRES = ((0, 46e-3), (0, 56e-3))  # [m]


def cloud(random):
    """Centres of grains that are wholly in the disc about the origin, (n, 2) [m]."""
    number = round(FRACTION * (CLOUD / RADIUS) ** 2)
    # One grain at most per square of a diameter's diagonal: neighbours are within two squares
    side = 2**0.5 * RADIUS
    squares = {}
    while len(squares) < number:
        point = (CLOUD - RADIUS) * (2 * random.random(2) - 1)
        if np.hypot(*point) > CLOUD - RADIUS:
            continue
        i, j = (int(x // side) for x in point)
        near = (squares.get((i + a, j + b)) for a in range(-2, 3) for b in range(-2, 3))
        if all(other is None or np.hypot(*(point - other)) >= 2 * RADIUS for other in near):
            squares[i, j] = point
    return np.array(list(squares.values()))


def main():
    random = np.random.default_rng(1)
    points = np.concatenate([centre + cloud(random) for centre in CENTRES])
    with open("constant/grains.csv", "w") as file:
        file.write("x,y,z,radius\n")
        file.writelines(f"{x:.9g},{y:.9g},0.0005,{RADIUS!r}\n" for x, y in points)


main()
