# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case grainBox: 0.1 m x 0.1 m of fluid between walls, with grains of one's own.

    case = grain_box(clone, [(0.05, 0.02)], radius=0.004)
    case.run("grainFoam")
"""

import re

import numpy as np

DEPTH = 0.01
PATCHES = {"frontAndBack": "empty"} | dict.fromkeys(["left", "right", "bottom", "top"], "wall")


def grain_box(clone, centres=(), radius=0.004, mesh="quads", velocity=None, name=None):
    """The case with grains at the given centres (n, 2) and its mesh of quads or triangles."""
    case = clone("grainBox", name)
    write_csv(case, centres, radius, velocity)
    if mesh == "triangles":
        mesh_triangles(case)
    else:
        case.run("blockMesh")
    return case


def write_csv(case, centres, radius, velocity=None):
    """constant/grains.csv; radius is one number or one per grain, velocity (n, 2)."""
    centres = np.asarray(centres, dtype=float).reshape(-1, 2)
    n = len(centres)
    velocity = np.zeros((n, 2)) if velocity is None else np.asarray(velocity).reshape(n, 2)
    rows = np.column_stack([centres, np.full(n, DEPTH / 2), np.broadcast_to(radius, n), velocity])
    lines = [",".join(repr(float(value)) for value in row) for row in rows]
    (case.path / "constant/grains.csv").write_text("\n".join(["x,y,z,radius,vx,vy", *lines, ""]))


def mesh_triangles(case):
    """One layer of prisms of box.geo instead of the blocks."""
    case.run("gmsh -3 -format msh2 box.geo")
    case.run("gmshToFoam box.msh")
    for patch, kind in PATCHES.items():
        case.dict_set("constant/polyMesh/boundary", f"entry0/{patch}/type", kind)


def make_cyclic(case, *pairs):
    """Cyclic patches instead of walls in the blockMeshDict, for pairs of opposite ones."""
    for pair in pairs:
        for name, partner in (pair, pair[::-1]):
            wall = f"{name}\n    {{\n        type    wall;"
            cyclic = wall.replace("wall;", f"cyclic;\n        neighbourPatch {partner};")
            replace(case, "system/blockMeshDict", wall, cyclic)


def remove_walls(case):
    """Those that grains meet."""
    file = case.path / "constant/grainProperties"
    text = file.read_text()
    start, end = text.index("walls\n{"), text.index("initialGrains")
    file.write_text(f"{text[:start]}walls\n{{}}\n\n{text[end:]}")


def cyclic_box(clone, centres, radius, **options):
    """No walls: what leaves on one side comes in on the other; options of grain_box."""
    case = grain_box(clone, centres, radius, **options)
    make_cyclic(case, ("left", "right"), ("bottom", "top"))
    replace(case, "0/U", "noSlip", "cyclic")
    replace(case, "0/p_rgh", "zeroGradient", "cyclic")
    remove_walls(case)
    replace(case, "constant/g", "(0 -9.81 0)", "(0 0 0)")
    case.run("blockMesh")
    return case


def open_ends(case, speed):
    """Fluid that flows in below at a speed, up between frictionless walls; no gravity."""
    walls = '"left|right|bottom|top"'
    for patch in ("bottom", "top"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    replace(
        case,
        "0/U",
        f"{walls}\n    {{\n        type    noSlip;\n    }}",
        f'"left|right" {{ type slip; }} top {{ type zeroGradient; }}'
        f" bottom {{ type fixedValue; value uniform (0 {speed} 0); }}",
    )
    outlet = "top { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", walls, f'{outlet} "left|right|bottom"')
    replace(case, "constant/grainProperties", "(left right bottom top)", "(left right)")
    replace(case, "constant/g", "-9.81", "0")


def replace(case, file, old, new):
    """Replace a text that stands once in a file of the case."""
    path = case.path / file
    text = path.read_text()
    assert text.count(old) == 1, f"'{old}' stands {text.count(old)} times in {file}"
    path.write_text(text.replace(old, new))


def halve_height(case):
    """Of the box, before blockMesh."""
    for z in ("0", "0.01"):
        for x in ("0.1", "0  "):
            replace(case, "system/blockMeshDict", f"({x} 0.1 {z})", f"({x} 0.05 {z})")


def control(case, **entries):
    """Set entries of system/controlDict."""
    path = case.path / "system/controlDict"
    text = path.read_text()
    for key, value in entries.items():
        text, count = re.subn(rf"(?m)^({key}\s+)[^;]+;", rf"\g<1>{value};", text)
        assert count == 1, key
    path.write_text(text)


def run_whole_and_parts(whole, parts, application, stop, end):
    """One case without a break, the other stopped at a time and continued."""
    whole.run(application)
    control(parts, endTime=stop)
    parts.run(application)
    control(parts, endTime=end)
    parts.run(application)


def assert_same_grains(one, other):
    """Two cases have the same grains, bit for bit, at the same last time."""
    assert one.times[-1] == other.times[-1]
    a, b = one.grains(), other.grains()
    assert a.keys() == b.keys()
    for name in a:
        np.testing.assert_array_equal(a[name], b[name], err_msg=name)


def lattice(nx, ny, spacing, corner):
    """Centres of a square lattice, the first at the corner, row by row."""
    x, y = np.meshgrid(np.arange(nx), np.arange(ny))
    return np.column_stack([x.ravel(), y.ravel()]) * spacing + np.asarray(corner)


def ledger(case):
    """Columns of the ledger, all starts of the run one after the other."""
    folder = case.path / "postProcessing/ledger"
    tables = [
        case.table(start.relative_to(case.path) / "ledger.csv")
        for start in sorted(folder.iterdir(), key=lambda path: float(path.name))
    ]
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


def tracks(case, start="0"):
    """Lines of the function object's file, (steps * grains, 14)."""
    file = case.path / "postProcessing/tracks" / start / "grains.csv"
    return np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
