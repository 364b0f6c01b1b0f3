# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls of grains that are patches of a mesh that moves: pistons."""

import numpy as np
import pytest
from grain_box import (
    DEPTH,
    assert_same_grains,
    control,
    grain_box,
    lattice,
    ledger,
    replace,
    run_whole_and_parts,
    tracks,
    write_csv,
)
from moving_mesh import add_motion

pytestmark = pytest.mark.parallel

SPEED = 0.05
RADIUS = 0.004
END = 0.2
HEIGHT = 0.1
TOLERANCE = 1e-7

PROPERTIES = "constant/grainProperties"

# How the piston moves: its wall's motion, and the displacement of its patch
MOTIONS = {
    "wall": (
        f"type translation; velocity ({SPEED} 0 0);",
        "type grainWallMotion; value uniform (0 0 0);",
    ),
    "mesh": (
        "type mesh;",
        "type uniformFixedValue;"
        f" uniformValue table ((0 (0 0 0)) (1 ({SPEED} 0 0))); value uniform (0 0 0);",
    ),
}

OUTFLOW = """
    outflow
    {
        type            surfaceFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      patch;
        name            right;
        operation       sum;
        fields          (phi);
        writeFields     false;
        writePrecision  16;
        writeControl    timeStep;
        writeInterval   1;
    }
"""


def piston(clone, motion, patch, name=None):
    """The left side of a box of fluid pushes grains towards a sieve on its right."""
    grains = lattice(4, 6, 2.02 * RADIUS, (1.05 * RADIUS, 1.02 * RADIUS))
    case = grain_box(clone, grains, RADIUS, name=name)
    side = "right\n    {\n        type    "
    replace(case, "system/blockMeshDict", side + "wall", side + "patch")
    walls = '"left|right|bottom|top"'
    replace(
        case,
        "0/U",
        f"{walls}\n    {{\n        type    noSlip;\n    }}",
        "left { type movingWallVelocity; value uniform (0 0 0); }\n"
        'right { type zeroGradient; } "bottom|top" { type noSlip; }',
    )
    replace(case, "0/p_rgh", walls, 'right { type fixedValue; value uniform 0; } "left|bottom|top"')
    replace(
        case,
        PROPERTIES,
        "patches     (left right bottom top);\n        material    steel;\n    }",
        "patches     (right bottom top);\n        material    steel;\n    }\n"
        f"    piston {{ type patches; patches (left); material steel; motion {{ {motion} }} }}",
    )
    case.run("blockMesh")
    add_motion(
        case,
        {
            "left": patch,
            "right": "type fixedValue; value uniform (0 0 0);",
            '"bottom|top"': "type zeroGradient;",
        },
    )
    replace(case, "system/controlDict", "functions\n{", "functions\n{" + OUTFLOW)
    control(case, deltaT=2e-3, endTime=END, writeInterval=50)
    return case


@pytest.mark.parametrize("kind", MOTIONS)
def test_a_piston_pushes_fluid_and_grains(clone, kind):
    case = piston(clone, *MOTIONS[kind])
    case.run("grainFoam")

    # No grain leaves: what goes out is fluid, and what the piston sweeps
    flux = np.loadtxt(case.path / "postProcessing/outflow/0/surfaceFieldValue.dat")[:, 1]
    np.testing.assert_allclose(flux, SPEED * HEIGHT * DEPTH, rtol=1e-10)

    book = ledger(case)
    assert book["mappingError"].max() <= 1e-12
    assert book["momentumError"].max() <= 1e-10
    assert book["grainMomentumError"].max() <= 1e-10
    assert book["divergence"].max() <= 1e-10

    # The grains are in front of the piston at the end of every step, and it has pushed them
    lines = tracks(case)
    overlap = SPEED * lines[:, 0] + RADIUS - lines[:, 2]
    assert overlap.max() <= 2 * TOLERANCE
    assert overlap[len(overlap) // 2 :].max() >= -TOLERANCE
    assert lines[-24:, 2].mean() > lines[:24, 2].mean() + 0.7 * SPEED * END


@pytest.mark.parametrize("kind", MOTIONS)
def test_a_piston_before_fixed_grains(clone, kind):
    """It pushes the fluid past them; the wall of grains goes with its patch."""
    case = piston(clone, *MOTIONS[kind])
    grains = lattice(3, 6, 2.1 * RADIUS, (0.04, 0.02))
    write_csv(case, grains, RADIUS)
    replace(case, PROPERTIES, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    case.run("grainFoam")
    flux = np.loadtxt(case.path / "postProcessing/outflow/0/surfaceFieldValue.dat")[:, 1]
    np.testing.assert_allclose(flux, SPEED * HEIGHT * DEPTH, rtol=1e-10)
    np.testing.assert_array_equal(case.grains()["position"][:, :2], grains)
    # Drag of the stream that the piston makes
    assert tracks(case)[-len(grains) :, 11].sum() > 0


def test_a_wall_that_moves_the_mesh_and_one_that_follows_it_are_the_same(clone):
    ends = []
    for kind in MOTIONS:
        case = piston(clone, *MOTIONS[kind], name=kind)
        case.run("grainFoam")
        ends.append((case.grains(), case.field("U")))
    (one, U), (other, V) = ends
    np.testing.assert_allclose(one["position"], other["position"], atol=1e-10)
    np.testing.assert_allclose(U, V, atol=1e-8 * SPEED)


def test_stop_and_restart(clone):
    whole, parts = (piston(clone, *MOTIONS["wall"], name=name) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainFoam", stop=END / 2, end=END)
    assert_same_grains(whole, parts)
    for name in ("U", "p_rgh", "eps"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)


def test_stop_and_restart_with_a_motion_of_openfoam(clone):
    """The patch is at speed times time, and time has another round-off after a restart."""
    whole, parts = (piston(clone, *MOTIONS["mesh"], name=name) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainFoam", stop=END / 2, end=END)
    one, other = whole.grains(), parts.grains()
    np.testing.assert_allclose(one["position"], other["position"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(whole.field("U"), parts.field("U"), rtol=0, atol=1e-10 * SPEED)


@pytest.mark.parametrize(("kind", "ranks"), [*((kind, 2) for kind in MOTIONS), ("wall", 4)])
def test_ranks_agree(clone, kind, ranks):
    serial, parts = (piston(clone, *MOTIONS[kind], name=name) for name in ("serial", "parts"))
    serial.run("grainFoam")
    replace(parts, "system/decomposeParDict", "Subdomains 2", f"Subdomains {ranks}")
    replace(parts, "system/decomposeParDict", "(2 1 1)", f"(2 {ranks // 2} 1)")
    parts.run("decomposePar")
    parts.parallel("grainFoam", ranks)
    one, many = serial.grains(), parts.grains()
    # What contacts leave uncertain in a step
    assert np.abs(one["position"] - many["position"]).max() <= TOLERANCE


BAD = {
    # Name: motion of the wall, displacement of the patch, what the message has
    "two motions": (
        f"type translation; velocity ({2 * SPEED} 0 0);",
        MOTIONS["mesh"][1],
        ["Patch 'left' has moved by", "away from the wall", "'piston'", "grainWallMotion"],
    ),
    "bent": (
        "type mesh;",
        "type waveDisplacement; amplitude (1e-3 0 0); omega 100; waveNumber (0 50 0);"
        " value uniform (0 0 0);",
        ["'motion' of wall 'piston'", "'mesh'", "move by between", "neither turns nor bends"],
    ),
    "free": (
        "type free; mass 1; centre (0 0.05 0);",
        MOTIONS["wall"][1],
        ["grainProperties", "'type'", "free", "grainWallMotion"],
    ),
    "both follow": (
        "type mesh;",
        MOTIONS["wall"][1],
        ["grainProperties", "'type'", "mesh", "grainWallMotion"],
    ),
    "another patch": (
        MOTIONS["wall"][0],
        MOTIONS["wall"][1],
        ["grainProperties", "'walls'", "patch 'top'", "'motion'"],
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_walls_and_patches_that_do_not_fit_are_refused(clone, name):
    motion, patch, fragments = BAD[name]
    case = piston(clone, motion, patch)
    if name == "another patch":
        text = (case.path / "0/pointDisplacement").read_text()
        text = text.replace("}\n frontAnd", f"}}\n top {{ {patch} }}\n frontAnd")
        (case.path / "0/pointDisplacement").write_text(text)
    assert case.run("grainFoam", check=False) == 1
    for fragment in ("FOAM FATAL IO ERROR", "allowed: ", *fragments):
        assert fragment in case.log


def test_a_wall_that_follows_a_mesh_at_rest_is_refused(clone):
    case = piston(clone, *MOTIONS["mesh"])
    (case.path / "constant/dynamicMeshDict").unlink()
    assert case.run("grainFoam", check=False) == 1
    for fragment in ("grainProperties", "'piston'", "'mesh'", "constant/dynamicMeshDict"):
        assert fragment in case.log


def test_walls_that_the_fluid_does_not_see_are_named(clone):
    case = piston(clone, *MOTIONS["wall"])
    (case.path / "constant/dynamicMeshDict").unlink()
    control(case, endTime=2e-3)
    case.run("grainFoam")
    assert "Wall 'piston' moves inside a mesh that does not" in case.log


def test_fluid_before_a_piston_has_its_speed(clone):
    """Between walls that slip; the first cells had 0.77, 1.16 and 0.91 of it."""
    case = piston(clone, *MOTIONS["mesh"])
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n")
    slip = '"bottom|top" { type slip; }'
    replace(case, "0/U", slip.replace("slip", "noSlip"), slip)
    replace(case, "constant/transportProperties", "1e-4;", "1e-6;")
    replace(case, "constant/g", "-9.81", "0")
    case.run("grainFoam")
    np.testing.assert_allclose(case.field("U")[:, 0], SPEED, rtol=2e-3)
