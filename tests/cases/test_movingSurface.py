# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two fluids and grains on meshes that move or change their cells."""

import re

import grainplot
import numpy as np
import pytest
from grain_box import control, replace
from moving_mesh import add_motion, translate, write
from sphere_box import decompose, refine, sphere_box
from water_box import level, liquid_ledger, to_two_fluids, water_box

WALLS = '"left|right|bottom|top"'
GRAINS = "constant/grainProperties"
MOVING = "type    movingWallVelocity; value uniform (0 0 0)"

REFINEMENT = """
dynamicFvMesh dynamicRefineFvMesh;
dynamicRefineFvMeshCoeffs
{
    refineInterval  1;
    field           alpha.water;
    lowerRefineLevel 0.01;
    upperRefineLevel 0.99;
    unrefineLevel   10;
    nBufferLayers   1;
    maxRefinement   1;
    maxCells        100000;
    correctFluxes   ((phi none) (phiU none) (phiFluid none));
    dumpLevel       true;
}
"""


def assert_kept(case, volume):
    """The liquid's volume, but for the digits of the ledger, and its bounds."""
    book = liquid_ledger(case)
    assert np.abs(book["unaccounted"]).max() <= 1e-12
    assert book["leastAlpha"].min() >= -1e-10
    assert book["mostAlpha"].max() <= 1 + 1e-10
    assert book["liquid"][-1] == pytest.approx(volume, rel=1e-9)


def test_a_pool_goes_with_its_mesh(clone):
    """The flux that carries is that of the mesh to 1e-7, and so is the surface level."""
    speed, height = 0.1, 0.05
    case = water_box(clone, level(height))
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {speed} 0)")
    replace(case, "0/U", "type    noSlip", MOVING)
    steel = "material    steel;"
    replace(case, GRAINS, f"{steel}\n    }}", f"{steel} motion {{ type mesh; }}\n    }}")
    translate(case, (0, speed, 0))
    control(case, endTime=0.2, deltaT=2e-3, writeInterval=100)
    case.run("grainInterFoam")
    still = np.sqrt(9.81 * height)
    U = case.field("U")
    np.testing.assert_allclose(U[:, 1], speed, atol=1e-5 * still)
    np.testing.assert_allclose(U[:, 0], 0, atol=1e-5 * still)
    np.testing.assert_allclose(case.field("alpha.water"), case.field("alpha.water", "0"), atol=1e-6)
    assert_kept(case, height * 0.1 * 0.01)


def test_a_wall_makes_waves(clone):
    """The left side swings under an open top; grains lie on the bottom."""
    height = 0.053
    case = water_box(clone, level(height), [(0.05, 0.004), (0.07, 0.004)], cells=(20, 20))
    replace(case, "0/U", "type    noSlip", MOVING)
    swing = "type oscillatingDisplacement; amplitude (0.01 0 0); omega 20;"
    add_motion(
        case,
        {
            "left": f"{swing} value uniform (0 0 0);",
            "right": "type fixedValue; value uniform (0 0 0);",
            '"bottom|top"': "type slip;",
        },
    )
    sides = '"left|right|bottom"'
    for field, kind in {
        "U": "pressureInletOutletVelocity; value uniform (0 0 0);",
        "p_rgh": "fixedValue; value uniform 0;",
        "alpha.water": "inletOutlet; inletValue uniform 0; value uniform 0;",
    }.items():
        replace(case, f"0/{field}", WALLS, f"top {{ type {kind} }} {sides}")
    # The side passes grains by: they stay away from it
    replace(case, GRAINS, "(left right bottom top)", "(right bottom)")
    control(case, endTime=0.4, deltaT=1e-3, writeInterval=100)
    case.run("grainInterFoam")
    # The wall goes 0.01 m to and fro at up to 0.2 m/s, some gas with ten times that
    assert 0.2 < np.abs(case.field("U")).max() < 3
    brought = liquid_ledger(case)["broughtIn"].sum()
    assert_kept(case, (height * 0.1 - 2 * np.pi * 0.004**2) * 0.01 + brought)


def spheres_into_water(clone, name=None):
    """Nine spheres that fall through a surface whose cells are refined."""
    centres = [(0.03 + 0.02 * i, 0.03 + 0.02 * j, 0.07) for i in range(3) for j in range(3)]
    case = sphere_box(clone, centres, 0.006, n=8, name=name)
    to_two_fluids(case)
    layers = np.clip((0.053 - np.arange(8) * 0.0125) / 0.0125, 0, 1)
    values = "\n".join(repr(float(value)) for value in np.repeat(layers, 64))
    write(
        case,
        "0/alpha.water",
        "volScalarField",
        f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar> 512\n({values}\n);\n"
        'boundaryField { ".*" { type zeroGradient; } }\n',
    )
    refine(case, REFINEMENT)
    control(case, endTime=0.2, deltaT=1e-3, writeInterval=100)
    return case


def test_cells_of_the_surface_are_refined(clone):
    case = spheres_into_water(clone)
    case.run("grainInterFoam")
    assert case.log.count("Refined from") >= 2 and case.log.count("Unrefined from") >= 1
    assert_kept(case, 0.053 * 0.01)


@pytest.mark.parametrize("upper", [0.99, 1])
def test_cells_of_grains_and_of_the_surface_are_refined(clone, upper):
    """Or, up to a share of 1, those of all water."""
    case = spheres_into_water(clone)
    refinement = re.sub("field .*;", "field refinement;", REFINEMENT)
    refinement = re.sub("lowerRefineLevel .*;", "lowerRefineLevel 0.5;", refinement)
    refinement = re.sub("upperRefineLevel .*;", "upperRefineLevel 2;", refinement)
    refinement = re.sub("unrefineLevel .*;", "unrefineLevel 0.5;", refinement)
    write(case, "constant/dynamicMeshDict", "dictionary", refinement)
    watched = 'type refinementIndicator; libs ("libgrainFunctionObjects.so"); alpha alpha.water;'
    watched += f" upperAlpha {upper};"
    indicator = f"functions\n{{\n    indicator {{ {watched} }}"
    replace(case, "system/controlDict", "functions\n{", indicator)
    control(case, endTime=0.05, writeInterval=50)
    case.run("grainInterFoam")
    assert_kept(case, 0.053 * 0.01)
    case.run("postProcess -func writeCellVolumes -latestTime")
    names = ("V", "eps", "alpha.water")
    volumes, eps, alpha = (grainplot.read_field(case.path, case.times[-1], n) for n in names)
    coarse = volumes > 0.5 * 0.0125**3
    assert eps[coarse].min() > 0.9
    mixed = (alpha > 0.05) & (alpha < 0.95)
    assert not (mixed & coarse).any()
    assert ((alpha > 0.99) & coarse).any() == (upper < 1)


@pytest.mark.parallel
def test_refinement_on_two_ranks_and_restart(clone):
    parts = spheres_into_water(clone, "parts")
    control(parts, endTime=0.1)
    decompose(parts, 2)
    parts.parallel("grainInterFoam", 2)
    control(parts, endTime=0.2)
    parts.parallel("grainInterFoam", 2)
    assert_kept(parts, 0.053 * 0.01)
    one = spheres_into_water(clone, "one")
    one.run("grainInterFoam")
    z = one.grains()["position"][:, 2]
    # Ranks refine the same cells; contacts and pressure leave 1e-7 of a step each
    np.testing.assert_allclose(parts.grains()["position"][:, 2], z, atol=1e-5)
