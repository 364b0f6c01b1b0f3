# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid that is warmer above stays at rest among fixed grains."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace
from heat_box import fix_grains, heat_ledger, with_heat

SLOPE = 0.0577  # of the sheared box's sides: 30 degrees over its height of 0.1 m
RHO, EXPANSION, GRADIENT = 1000.0, 1e-3, 1000.0  # [kg/m^3, 1/K, K/m]: a tenth lighter at the top

# Of the pressure
TOLERANCE = "DIC;\n        tolerance       1e-12"

# Grains in one part of the box
CENTRES = lattice(4, 5, 0.01, (0.055, 0.02))


def shear(case):
    """Turn the sides of the box."""
    top = f"({0.1 + SLOPE} 0.1 z) ({SLOPE} 0.1 z)"
    old = ("(0.1 0.1 0) (0   0.1 0)", "(0.1 0.1 0.01) (0   0.1 0.01)")
    for text, z in zip(old, ("0", "0.01"), strict=True):
        replace(case, "system/blockMeshDict", text, top.replace("z", z))
    case.run("blockMesh")


def write_cells(case, file, values):
    """Values of the cells in the place of one for all."""
    listed = "\n".join(repr(float(value)) for value in values)
    replace(case, file, "uniform 0;\n\nb", f"nonuniform List<scalar> {len(values)}({listed});\n\nb")


@pytest.mark.parametrize("mesh, bound", [("quads", 1e-10), ("sheared", 1e-8), ("triangles", 1e-8)])
def test_stratified_fluid_stays_at_rest_among_grains(clone, mesh, bound):
    """In each of 100 steps the difference of weights would give 0.01 m/s."""
    case = grain_box(clone, CENTRES, 0.004, mesh if mesh == "triangles" else "quads")
    if mesh == "sheared":
        shear(case)
    height = np.array([polygon.mean(axis=0)[1] for polygon in case.mesh().polygons])
    T = 300 + GRADIENT * height

    # So bad a conductor that temperatures stay, whatever the grains' are
    with_heat(case, T=T, grains=350, fluid=f"Cp 1000; kappa 1e-20; beta {EXPANSION}; TRef 300;")
    fix_grains(case)

    # Internal waves of a start without it would take minutes to decay
    hydrostatic = -0.5 * RHO * EXPANSION * GRADIENT * 9.81 * height**2
    write_cells(case, "0/p_rgh", hydrostatic)
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure; value uniform 0")
    if mesh != "quads":
        replace(case, "system/fvSolution", "Correctors 0", "Correctors 30")
    replace(case, "system/fvSolution", TOLERANCE, TOLERANCE.replace("-12", "-15"))
    control(case, deltaT=1e-2, endTime=1, writeInterval=100)
    case.run("grainThermalFoam")

    assert case.times[-1] == "1"
    # Round-off, on meshes that are not orthogonal with what its repeated correction leaves
    assert np.abs(case.field("U")).max() <= bound
    np.testing.assert_allclose(case.field("T"), T, rtol=0, atol=GRADIENT * bound)
    assert heat_ledger(case)["fluidError"].max() <= 1e-12
    p = case.field("p_rgh")
    np.testing.assert_allclose(p - p[0], hydrostatic - hydrostatic[0], rtol=0, atol=1e-6)


@pytest.mark.parametrize("value", [300, 1000])
def test_warm_fluid_rests_beside_an_open_side(clone, value):
    """T there is that of the cells from the first step on, whatever stands as 'value': with
    the weight that 1000 K would have, the fluid had 0.07 m/s after five steps."""
    case = grain_box(clone, CENTRES, 0.004)
    begin = "right\n    {\n        type    "
    replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    side = f"right {{ type inletOutlet; inletValue uniform 320; value uniform {value}; }}"
    walls = '"left|bottom|top"'
    with_heat(
        case,
        T=320,
        grains=320,
        fluid=f"Cp 1000; kappa 0.6; beta {EXPANSION}; TRef 300;",
        patches=f"{side} {walls} {{ type zeroGradient; }}",
    )
    fix_grains(case)
    patches = '"left|right|bottom|top"'
    velocity = "right { type pressureInletOutletVelocity; value uniform (0 0 0); }"
    replace(case, "0/U", patches, f"{velocity} {walls}")
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure; value uniform 0")
    pressure = "right { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", patches, f"{pressure} {walls}")
    control(case, deltaT=1e-2, endTime=0.05, writeInterval=5)
    case.run("grainThermalFoam")
    assert np.abs(case.field("U")).max() <= 1e-10
