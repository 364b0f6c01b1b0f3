# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets in meshes whose cells change."""

import pytest
from droplet_box import (
    BOILING,
    GAS,
    droplet_table,
    force_in_fall,
    make_gas,
    with_droplets,
)
from grain_box import control, replace
from heat_box import heat_ledger, with_heat
from sphere_box import decompose, refine, sphere_box

HOT = 600.0
REFINEMENT = """
dynamicFvMesh dynamicRefineFvMesh;
dynamicRefineFvMeshCoeffs
{{
    refineInterval  {interval};
    field           {field};
    lowerRefineLevel {lower};
    upperRefineLevel {upper};
    unrefineLevel   0.5;
    nBufferLayers   1;
    maxRefinement   1;
    maxCells        100000;
    correctFluxes   ((phi none) (phiU none) (phiFluid none));
    dumpLevel       true;
}}
"""
SIDE, RADIUS = 6e-3, 1e-3


def droplet_in_hot_gas(clone, entries="", n=12, name=None):
    """In an open box, with n^3 cells."""
    case = sphere_box(clone, n=n, side=SIDE, name=name)
    hot = f"inletValue uniform {HOT}; value uniform {HOT};"
    sides = f'".*" {{ type inletOutlet; phi phiFluid; {hot} }}'
    with_heat(case, T=HOT, grains=300, patches=sides, fluid=GAS, empty="")
    make_gas(case)
    replace(case, "0/U", "type    noSlip", "type    zeroGradient")
    replace(case, "0/p_rgh", "type    zeroGradient", "type fixedValue; value uniform 0")
    with_droplets(case, [(SIDE / 2, SIDE / 2)], RADIUS, entries=entries)
    (case.path / "constant/droplets.csv").write_text(
        f"x,y,z,radius\n{0.51 * SIDE},{0.49 * SIDE},{0.6 * SIDE},{RADIUS}\n"
    )
    control(case, endTime=0.02, deltaT=4e-4, writeInterval=50)
    return case


def test_cells_are_divided_around_a_droplet(clone):
    """Where the gas is cooled; all heat that reaches the droplet makes vapour."""
    case = droplet_in_hot_gas(clone, "motion fixed;")
    levels = {"lower": BOILING - 1, "upper": BOILING + 20}
    refine(case, REFINEMENT.format(interval=2, field="T", **levels))
    case.run("grainDropletFoam")
    assert "Refined from 1728 to" in case.log
    assert heat_ledger(case)["fluidError"].max() < 1e-8
    book = droplet_table(case)
    assert book["vapour"][-1] > 0
    first = book["liquid"][0] + book["vapour"][0]
    assert book["liquid"][-1] + book["vapour"].sum() == pytest.approx(first, rel=1e-12)


def falling(clone, n, field=None, margin=0):
    """A droplet of 830 times the density of the gas, cells divided by a field."""
    case = droplet_in_hot_gas(clone, n=n, name=f"cells{n}")
    if field == "refinement":
        refine(case, REFINEMENT.format(interval=1, field=field, lower=0.5, upper=2))
        indicator = f"type refinementIndicator; margin {margin};"
        libs = 'libs ("libgrainFunctionObjects.so");'
        replace(
            case,
            "system/controlDict",
            "functions\n{",
            f"functions\n{{\n    indicator {{ {indicator} {libs} }}",
        )
    elif field == "T":
        levels = {"lower": BOILING - 1, "upper": BOILING + 20}
        refine(case, REFINEMENT.format(interval=2, field=field, **levels))
    return case


@pytest.mark.parametrize("margin", [0, 2])
@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=pytest.mark.parallel)])
def test_a_droplet_falls_as_in_small_cells_everywhere(clone, margin, ranks):
    """Small cells end at its surface, or two layers beyond: the force is 1.02 and 1.004 of that
    there."""
    tables = []
    for case in (falling(clone, 24), falling(clone, 12, "refinement", margin)):
        if ranks > 1:
            decompose(case, ranks)
            case.parallel("grainDropletFoam", ranks)
        else:
            case.run("grainDropletFoam")
        tables.append(droplet_table(case))
    assert "Refined from 1728 to" in case.log
    everywhere, divided = (force_in_fall(table, "vz") for table in tables)
    print("force", divided / everywhere)
    assert everywhere > 4e-3
    assert divided == pytest.approx(everywhere, rel=0.03)
    assert abs(tables[1]["vx"][-1]) < 2e-4 * abs(tables[1]["vz"][-1])


def test_cells_of_two_sizes_at_the_surface_do_not_throw_a_droplet(clone):
    """Where the gas is cooled, and every two steps others: the gas had a thousand times its
    speed after 39 steps."""
    case = falling(clone, 12, "T")
    case.run("grainDropletFoam")
    table = droplet_table(case)
    speed = abs(table["vz"][-1])
    assert "Refined from" in case.log
    # As if nothing but its weight were there, less what the gas carries: 0.9971 was measured
    assert speed / (9.81 * table["time"][-1]) == pytest.approx(0.996, abs=3e-3)
    assert abs(table["vx"][-1]) < 1e-3 * speed
