# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water that drains out of a column of fixed grains, and air that follows it."""

import numpy as np
import pytest
from grain_box import control, replace
from sphere_box import sphere_box
from water_box import WATER, liquid_ledger, to_two_fluids

GRAINS = "constant/grainProperties"
D, PITCH, N_SIDE, N_HIGH, CELLS = 1e-3, 1.06e-3, 4, 48, 16
WIDTH, HEIGHT = N_SIDE * PITCH, N_HIGH * PITCH
EPS = 1 - np.pi / 6 * (D / PITCH) ** 3
MU = 1e-6 * WATER


def ergun():
    """Flux per area under the water's own weight [m/s]; Ergun 1952."""
    linear = 150 * (1 - EPS) ** 2 / EPS**3 * MU / D**2
    square = 1.75 * (1 - EPS) / EPS**3 * WATER / D
    return (np.sqrt(linear**2 + 4 * square * WATER * 9.81) - linear) / (2 * square)


def column(clone):
    """Open to air at both ends, sides without friction; full of water."""
    case = sphere_box(clone)
    mesh = case.path / "system/blockMeshDict"
    text = mesh.read_text().replace("(10 10 10)", f"(1 1 {CELLS})")
    head, rest = text.split("vertices", 1)
    corners, rest = rest.split(");", 1)
    corners = "".join(
        f"({x * WIDTH} {y * WIDTH} {z * HEIGHT})"
        for z in (0, 1)
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))
    )
    for patch in ("back", "front"):
        begin = f"    {patch}\n    {{\n        type    "
        rest = rest.replace(begin + "wall", begin + "patch")
    mesh.write_text(f"{head}vertices ({corners});{rest}")
    case.run("blockMesh")
    index = np.indices((N_SIDE, N_SIDE, N_HIGH)).reshape(3, -1).T
    rows = [",".join(map(repr, [*map(float, (i + 0.5) * PITCH), D / 2])) for i in index]
    (case.path / "constant/grains.csv").write_text("\n".join(["x,y,z,radius", *rows, ""]))
    law = "type    DallavalleDiFelice;\n        shape   sphere;"
    replace(case, GRAINS, law, "type    ErgunWenYu;")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    replace(case, GRAINS, '(".*")', "(left right bottom top)")
    to_two_fluids(case)
    (case.path / "0/alpha.water").write_text(
        "FoamFile { version 2.0; format ascii; class volScalarField; object alpha.water; }\n"
        "dimensions [0 0 0 0 0 0 0]; internalField uniform 1; boundaryField\n{\n"
        '"left|right|bottom|top" { type zeroGradient; } back { type zeroGradient; }\n'
        "front { type inletOutlet; inletValue uniform 0; value uniform 0; }\n}\n"
    )
    header = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
    (case.path / "0/U").write_text(
        header.format("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\n"
        "internalField uniform (0 0 0); boundaryField\n{\n"
        '"left|right|bottom|top" { type slip; }\n'
        '"back|front" { type pressureInletOutletVelocity; value uniform (0 0 0); }\n}\n'
    )
    (case.path / "0/p_rgh").write_text(
        header.format("volScalarField", "p_rgh") + "dimensions [1 -1 -2 0 0 0 0];\n"
        "internalField uniform 0; boundaryField\n{\n"
        '"left|right|bottom|top" { type fixedFluxPressure; value uniform 0; }\n'
        f"back {{ type fixedValue; value uniform 0; }}\n"
        f"front {{ type fixedValue; value uniform {9.81 * HEIGHT}; }}\n}}\n"
    )
    return case


def test_water_drains_as_ergun_has_it(clone):
    """Its own weight drives it, so that the flux is that of Darcy until air comes through."""
    case = column(clone)
    through = EPS * HEIGHT / ergun()
    control(case, deltaT=through / 400, endTime=0.6 * through, writeInterval=240)
    case.run("grainInterFoam")
    liquid = liquid_ledger(case)
    flux = -np.diff(liquid["liquid"]) / np.diff(liquid["time"]) / WIDTH**2
    part = slice(len(flux) // 5, None)
    assert flux[part].mean() == pytest.approx(ergun(), rel=0.1)
    assert flux[part] == pytest.approx(np.full(len(flux[part]), ergun()), rel=0.1)
    assert np.abs(liquid["unaccounted"]).max() <= 1e-10
