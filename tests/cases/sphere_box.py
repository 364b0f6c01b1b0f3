# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case grainBox in three dimensions: spheres in a cube of fluid between walls.

    case = sphere_box(clone, [(0.05, 0.05, 0.02)], radius=0.004, mesh="tetrahedra")
    case.run("grainFoam")

Gravity points along -z.  The meshes are "hexahedra", "warped" ones, whose inner faces are not
plane, and "tetrahedra".
"""

import foamlib
import grainplot
import numpy as np
from dry_box import GRAINS, write_grains
from grain_box import control, make_cyclic, remove_walls, replace
from moving_mesh import write

SIDE = 0.1
PATCHES = ("left", "right", "bottom", "top", "back", "front")


def correct_non_orthogonal(case):
    replace(case, "system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 1")


def refine(case, dictionary):
    """constant/dynamicMeshDict; faces between two sizes of cells are not orthogonal."""
    write(case, "constant/dynamicMeshDict", "dictionary", dictionary)
    correct_non_orthogonal(case)


def sphere_box(
    clone, centres=(), radius=0.004, mesh="hexahedra", n=10, side=SIDE, velocity=None, name=None
):
    """The case with grains at the given centres (n, 3), and about n cells along each side [m]."""
    case = clone("grainBox", name)
    write_grains(case, centres, radius, velocity)
    replace(case, GRAINS, "shape   disc;\n\n", "shape   sphere;\n\n")
    replace(case, GRAINS, "        shape   disc;", "        shape   sphere;")
    replace(case, GRAINS, "(left right bottom top)", '(".*")')
    replace(case, "constant/g", "(0 -9.81 0)", "(0 0 -9.81)")
    for file in ("0/U", "0/p_rgh"):
        text = (case.path / file).read_text()
        text = text[: text.index("    frontAndBack")] + "}\n"
        (case.path / file).write_text(text.replace('"left|right|bottom|top"', '".*"'))
    if mesh != "hexahedra":
        correct_non_orthogonal(case)
    control(case, writeFormat="ascii")

    file = case.path / "system/blockMeshDict"
    blocks = file.read_text().replace("0.01)", "0.1)").replace("(10 10 1)", f"({n} {n} {n})")
    blocks = blocks.replace("vertices", f"scale {side / 0.1};\n\nvertices")
    blocks = blocks[: blocks.index("    frontAndBack")]
    for patch, face in (("back", "0 3 2 1"), ("front", "4 5 6 7")):
        blocks += f"    {patch}\n    {{\n        type    wall;\n        faces (({face}));\n    }}\n"
    file.write_text(blocks + ");\n")

    if mesh == "tetrahedra":
        mesh_tetrahedra(case, n, side)
    else:
        case.run("blockMesh")
    if mesh == "warped":
        warp(case, n, side)
    return case


def cyclic_cube(clone, centres, radius, n, velocity=None, name=None):
    """No walls and no weight: what leaves on one side comes in on the other."""
    case = sphere_box(clone, centres, radius, n=n, velocity=velocity, name=name)
    make_cyclic(case, ("left", "right"), ("bottom", "top"), ("back", "front"))
    replace(case, "0/U", "noSlip", "cyclic")
    replace(case, "0/p_rgh", "zeroGradient", "cyclic")
    replace(case, "constant/g", "-9.81", "0")
    remove_walls(case)
    case.run("blockMesh")
    return case


def mesh_tetrahedra(case, n, side):
    """The cube of box.geo in tetrahedra."""
    geometry = (case.path / "box.geo").read_text()
    for old, new in (
        ("h = 0.01;", f"h = {side / n};"),
        ("0.1", str(side)),
        ("0.01} { Surface{1}; Layers{1}; Recombine; }", f"{side}}} {{ Surface{{1}}; }}"),
        ('("frontAndBack") = {1, e[0]}', '("back") = {1};\nPhysical Surface("front") = {e[0]}'),
    ):
        assert old in geometry
        geometry = geometry.replace(old, new)
    (case.path / "cube.geo").write_text(geometry)
    case.run("gmsh -3 -format msh2 cube.geo")
    case.run("gmshToFoam cube.msh")
    for patch in PATCHES:
        case.dict_set("constant/polyMesh/boundary", f"entry0/{patch}/type", "wall")


def warp(case, n, side):
    """Move the inner points by up to an eighth of a cell."""
    file = foamlib.FoamFile(case.path / "constant/polyMesh/points")
    points = np.array(file[()])
    inner = np.all((points > 1e-6 * side) & (points < side - 1e-6 * side), axis=1)
    shift = np.random.default_rng(4).uniform(-1, 1, points.shape) * side / n / 8
    file[()] = points + inner[:, None] * shift


def random_spheres(rng, radii, margin=1e-4):
    """Centres of spheres that touch neither each other nor the walls, the largest placed first."""
    radii = np.sort(radii)[::-1]
    centres = np.empty((0, 3))
    for i, radius in enumerate(radii):
        while True:
            x = rng.uniform(radius + margin, SIDE - radius - margin, 3)
            gaps = np.linalg.norm(centres - x, axis=1) - radii[:i] - radius
            if np.all(gaps > margin):
                break
        centres = np.vstack([centres, x])
    return centres, radii


def decompose(case, ranks):
    """Divide the case: 2 ranks along x, 4 along x and z."""
    replace(case, "system/decomposeParDict", "numberOfSubdomains 2", f"numberOfSubdomains {ranks}")
    replace(case, "system/decomposeParDict", "(2 1 1)", f"(2 1 {ranks // 2})")
    case.run("decomposePar")


def field(case, name, time=None):
    """Internal values at a time, the last one by default."""
    return grainplot.read_field(case.path, case.times[-1] if time is None else time, name)


def cell_volumes(case):
    """[m^3], one per cell."""
    time = case.times[-1]
    case.run(f"postProcess -func writeCellVolumes -time {time}")
    return field(case, "V", time)
