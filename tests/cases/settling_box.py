# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere that settles in a box with frictionless sides, at a Reynolds number of one's own.

    case = settling_box(clone, Re=1, cell=2, width=12)
    case.run("grainFoam")
    error = settling_speed(case) / speed_in_box(Re=1, width=12) - 1

Lengths are in diameters and speeds over the one that the law gives in a fluid without end.
"""

import math
import shutil

import numpy as np
from grain_box import replace

D, SPEED, DENSITY = 1e-3, 0.01, 1000  # diameter [m], law's speed [m/s], of the fluid [kg/m3]

# Of a cell, with the times that they count: the middles of 4 x 4 squares, by symmetry
PLACES = {(1 / 8, 1 / 8): 1, (1 / 8, 3 / 8): 2, (3 / 8, 3 / 8): 1}

DRAG = {  # over Stokes' drag
    "SchillerNaumann": lambda Re: 1 + 0.15 * Re**0.687,
    "DallavalleDiFelice": lambda Re: (0.63 * Re**0.5 + 4.8) ** 2 / 24,
    # Re <= 20: Clift, Grace and Weber, Bubbles, Drops, and Particles, 1978
    "standard": lambda Re: 1 + 0.1315 * Re ** (0.82 - 0.05 * math.log10(Re)),
}


def settling_box(
    clone,
    Re,
    cell,
    width,
    law="SchillerNaumann",
    start=(0.125, 0.375),
    fall=None,
    coupling="",
    stretch=1,
    name=None,
):
    """The sphere of the tutorial singleGrain, `start` cells beside a corner of cells in the middle
    of the box.  Cells are `stretch` times as long along the fall."""
    case = clone("tutorials/grainFoam/singleGrain", name or f"Re{Re}_cell{cell}")
    for source in ("constant", "system", "0.orig"):
        target = case.path / source.replace(".orig", "")
        shutil.copytree(case.path / "sphere" / source, target, dirs_exist_ok=True)

    nu = SPEED * D / Re
    weight = 18 * DRAG[law](Re) * nu * SPEED / D**2
    for file, old, new in (
        ("constant/transportProperties", "996.78", DENSITY),
        ("constant/transportProperties", "8.379e-7", nu),
        ("constant/g", "-9.81", -weight),
        ("constant/grainProperties", "density 1029", f"density {2 * DENSITY}"),
        ("constant/grainProperties", "DallavalleDiFelice", law),
        ("constant/grainProperties", "coupling\n{", f"coupling\n{{\n    {coupling}"),
    ):
        replace(case, file, old, str(new))

    # Half a width from the ends of the box, what they do to the flow is a few per cent of what
    # the sides do
    fall = fall or last_fall(cell * stretch) + 1.5 + min(Re, 10)
    n = round(width / cell)
    layers = -int(-(fall + max(width, 8)) // (cell * stretch))
    height = layers * stretch
    # A sixth of a cell, and no more than a viscosity of Euler's scheme as large as the fluid's
    step = min(cell / 6, 2 / Re)
    steps = -int(-fall // step)
    (case.path / "parameters").write_text(
        f"""lateral ((1 {n} 1));
vertical ((1 {layers} 1));
nx {n};
ny {layers};
width {n * cell * D!r};
height {height * cell * D!r};
frame 0;
deltaT {fall / steps * D / SPEED!r};
endTime {fall * D / SPEED!r};
ddt Euler;
"""
    )
    x, z = (D * cell * (n // 2 + s) for s in start)
    y = D * (height * cell - max(width, 8) / 2)
    (case.path / "constant/grains.csv").write_text(
        f"x,y,z,radius,vy\n{x!r},{y!r},{z!r},{D / 2!r},{-0.8 * SPEED}\n"
    )
    case.run("blockMesh")
    return case


def last_fall(cell):
    """The part of the fall that counts: whole cells."""
    return cell * math.ceil(3 / cell)


def settling_speed(case, cell):
    """Mean over the last whole cells."""
    track = case.table("postProcessing/tracks/0/grains.csv")
    y, t = track["y"] / D, track["time"] * SPEED / D
    before = y[-1] + last_fall(cell)
    return last_fall(cell) / (t[-1] - np.interp(-before, -y, t))


def speeds_of_places(clone, Re, cell, width, law, stretch=1):
    """Settling speeds by the ways through the cells, PLACES."""
    speeds = []
    for i, start in enumerate(PLACES):
        name = f"{Re}_{cell}_{i}"
        case = settling_box(clone, Re, cell, width, law, start, stretch=stretch, name=name)
        case.run("grainFoam")
        speeds.append(settling_speed(case, cell * stretch))
    return np.array(speeds)


def speed_in_box(Re, width, drag, n=200):
    """Of a sphere that settles at the middle of a box with frictionless sides, which is that of a
    square lattice of spheres: each falls in the flow of the others, Oseen's at a distance r,

        u = 3/8 drag exp(-Re r/2)/r

    in the plane of the lattice, less its mean, as there is no flow through the box (doc/theory,
    eq. 4.31).  `drag` is over that of Stokes.
    """
    i = np.arange(-n, n + 1)
    r = np.hypot(*np.meshgrid(i, i)).ravel()
    r = r[r > 0]
    k = max(Re * width / 2, 1e-12)
    # The mean by the integral over the same square
    angle = (np.arange(1000) + 0.5) / 1000 * np.pi / 4
    mean = 2 * np.pi * np.mean(-np.expm1(-k * (n + 0.5) / np.cos(angle)) / k)
    return 1 + 3 / 8 * drag / width * (np.sum(np.exp(-k * r) / r) - mean)
