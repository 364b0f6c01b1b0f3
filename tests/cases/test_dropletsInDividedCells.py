# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets in meshes whose cells change."""

import pytest
from droplet_box import BOILING, GAS, droplet_table, make_gas, with_droplets
from grain_box import control, replace
from heat_box import heat_ledger, with_heat
from sphere_box import refine, sphere_box

HOT = 600.0
# Cells whose temperature is between the levels are split
REFINEMENT = f"""
dynamicFvMesh dynamicRefineFvMesh;
dynamicRefineFvMeshCoeffs
{{
    refineInterval  2;
    field           T;
    lowerRefineLevel {BOILING - 1};
    upperRefineLevel {BOILING + 20};
    unrefineLevel   0;
    nBufferLayers   1;
    maxRefinement   1;
    maxCells        100000;
    correctFluxes   ((phi none) (phiU none) (phiFluid none));
    dumpLevel       true;
}}
"""


def test_cells_are_divided_around_a_droplet(clone):
    """Where the gas is cooled; all heat that reaches the droplet makes vapour."""
    side, radius = 6e-3, 1e-3
    case = sphere_box(clone, n=12, side=side)
    hot = f"inletValue uniform {HOT}; value uniform {HOT};"
    sides = f'".*" {{ type inletOutlet; phi phiFluid; {hot} }}'
    with_heat(case, T=HOT, grains=300, patches=sides, fluid=GAS, empty="")
    make_gas(case)
    replace(case, "0/U", "type    noSlip", "type    zeroGradient")
    replace(case, "0/p_rgh", "type    zeroGradient", "type fixedValue; value uniform 0")
    with_droplets(case, [(side / 2, side / 2)], radius, entries="motion fixed;")
    (case.path / "constant/droplets.csv").write_text(
        f"x,y,z,radius\n{0.51 * side},{0.49 * side},{0.6 * side},{radius}\n"
    )
    refine(case, REFINEMENT)
    control(case, endTime=0.02, deltaT=4e-4, writeInterval=50)
    case.run("grainDropletFoam")
    assert "Refined from 1728 to" in case.log
    assert heat_ledger(case)["fluidError"].max() < 1e-8
    book = droplet_table(case)
    assert book["vapour"][-1] > 0
    first = book["liquid"][0] + book["vapour"][0]
    assert book["liquid"][-1] + book["vapour"].sum() == pytest.approx(first, rel=1e-12)
