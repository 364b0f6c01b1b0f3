# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clusters in the place of the discs or spheres of a case.

    case = grain_box(clone, [(0.05, 0.05)], radius=0.015)
    make_clusters(case, ROD, angle=0.7, spin=20.0)

The radius is that of the circle or sphere around a cluster.
"""

import numpy as np
from grain_box import replace

ROD = "centres ((-2 0 0) (-1 0 0) (0 0 0) (1 0 0) (2 0 0)); radii (1 1 1 1 1);"
PAIR = "centres ((-1 0 0) (1 0 0)); radii (1 1);"
CROSS = "centres ((-1 0 0) (1 0 0) (0 1 0) (0 -1 0)); radii (1 1 1 1);"


def make_clusters(case, members, angle=0.0, spin=0.0):
    """All grains of constant/grains.csv, turned about z [rad], with a spin about it [rad/s]."""
    replace(
        case,
        "constant/grainProperties",
        "\nwalls\n{",
        f"\nshapes {{ body {{ type cluster; {members} }} }}\n\nwalls\n{{",
    )
    file = case.path / "constant/grains.csv"
    header, *lines = file.read_text().splitlines()
    turned = f"body,{np.cos(angle / 2):.15f},0,0,{np.sin(angle / 2):.15f},0,0,{spin}"
    rows = [f"{header},shape,qw,qx,qy,qz,wx,wy,wz", *(f"{line},{turned}" for line in lines)]
    file.write_text("\n".join([*rows, ""]))
