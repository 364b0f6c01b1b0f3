# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case grainBox without fluid: discs in its 0.1 m x 0.1 m, or spheres in a cube of 0.1 m.

    case = dry_box(clone, [(0.05, 0.05, 0.02)], radius=0.004)
    case.run("dryGrainFoam")

Gravity points along -y in two dimensions and along -z in three.
"""

import shutil

import numpy as np
from grain_box import DEPTH, replace

GRAINS = "constant/grainProperties"
G = 9.81
COLUMNS = "x,y,z,radius,vx,vy,vz"


def dry_box(clone, centres=(), radius=0.004, velocity=None, dimension=3, name=None):
    """The case with grains at the given centres (n, dimension) and its mesh."""
    case = clone("grainBox", name)
    shutil.rmtree(case.path / "0")
    (case.path / "constant/transportProperties").unlink()
    text = (case.path / GRAINS).read_text()
    (case.path / GRAINS).write_text(text[: text.index("\ncoupling\n")])
    write_grains(case, centres, radius, velocity, dimension)
    if dimension == 3:
        replace(case, GRAINS, "shape   disc", "shape   sphere")
        replace(case, GRAINS, "(left right bottom top)", '(".*")')
        replace(case, "constant/g", "(0 -9.81 0)", "(0 0 -9.81)")
        blocks = case.path / "system/blockMeshDict"
        text = blocks.read_text().replace("0.01)", "0.1)").replace("(10 10 1)", "(5 5 5)")
        blocks.write_text(text.replace("empty", "wall"))
    case.run("blockMesh")
    return case


def write_grains(case, centres, radius, velocity=None, dimension=3):
    """constant/grains.csv; radius is one number or one per grain."""
    centres = np.asarray(centres, dtype=float).reshape(-1, dimension)
    n = len(centres)
    velocity = np.zeros((n, dimension)) if velocity is None else np.asarray(velocity)
    if dimension == 2:
        centres = np.column_stack([centres, np.full(n, DEPTH / 2)])
        velocity = np.column_stack([velocity.reshape(n, 2), np.zeros(n)])
    rows = np.column_stack([centres, np.broadcast_to(radius, n), velocity.reshape(n, 3)])
    lines = [",".join(repr(float(value)) for value in row) for row in rows]
    (case.path / "constant/grains.csv").write_text("\n".join([COLUMNS, *lines, ""]))


def cubic(nx, ny, nz, spacing, corner):
    """Centres of a cubic lattice, the first at the corner."""
    x, y, z = np.meshgrid(np.arange(nx), np.arange(ny), np.arange(nz), indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()]) * spacing + np.asarray(corner)


def write_facets(case, name, facets):
    """constant/triSurface/<name>.stl of triangles, three corners each."""
    corner = "vertex {!r} {!r} {!r}"
    lines = [f"solid {name}"]
    for facet in facets:
        corners = " ".join(corner.format(*map(float, c)) for c in facet)
        lines.append(f"facet normal 0 0 1 outer loop {corners} endloop endfacet")
    folder = case.path / "constant/triSurface"
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.stl").write_text("\n".join([*lines, f"endsolid {name}", ""]))
