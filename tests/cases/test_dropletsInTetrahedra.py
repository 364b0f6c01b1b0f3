# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets at rest in triangles and tetrahedra, which do not fit them."""

import numpy as np
import pytest
from droplet_box import (
    BOILING,
    GAS,
    GAS_CP,
    GAS_K,
    LATENT,
    WALLS,
    droplet_table,
    make_gas,
    with_droplets,
)
from grain_box import DEPTH, control, grain_box, mesh_triangles, replace
from heat_box import heat_ledger, with_heat
from sphere_box import sphere_box


def held(case, place, radius, profile, empty, walls, dt):
    """A heavy droplet in gas that has, on the sides, the profile of an expression in r [m]:
    what evaporates in the last step, per time [kg/s]."""
    r = f"mag(pos() - vector({place[0]}, {place[1]}, {place[2]}))"
    T = f"{BOILING} + {LATENT / GAS_CP}*({profile.format(r=r)} - 1)"
    sides = f'{walls} {{ type exprFixedValue; value $internalField; valueExpr "{T}"; }}'
    with_heat(
        case, T=BOILING, grains=300, patches=sides, fluid=GAS, empty=empty, convection="linear"
    )
    make_gas(case)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "0/U", "type    noSlip", "type    zeroGradient")
    replace(case, "0/p_rgh", "type    zeroGradient", "type fixedValue; value uniform 0")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     3")
    with_droplets(case, [place[:2]], radius, entries="motion fixed;", density=1e9)
    row = ",".join(map(repr, [*place, radius]))
    (case.path / "constant/droplets.csv").write_text(f"x,y,z,radius\n{row}\n")
    control(case, deltaT=dt, endTime=60 * dt, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    # There are no grains
    assert abs(book["fromGrains"][-1] / book["fromFluid"][-1]) < 2e-3
    assert heat_ledger(case)["fluidError"].max() < 1e-8
    return book["vapour"][-1] / dt


def test_a_disc_in_triangles_evaporates_as_stefan_says(clone):
    """2 pi k/c ln(1 + B)/ln(R_o/R), 8 edges across."""
    B, radius, outer, place = 1.0, 1e-3, 2.5e-3, (2.535e-3, 2.445e-3, 2.5e-4)
    case = grain_box(clone)
    replace(case, "box.geo", "h = 0.01;", "h = 0.005;")
    mesh_triangles(case)
    case.run("transformPoints -scale 0.05")
    correctors = "nNonOrthogonalCorrectors"
    replace(case, "system/fvSolution", f"{correctors} 0", f"{correctors} 2")
    a = np.log1p(B) / np.log(outer / radius)
    profile = f"pow({{r}}/{radius}, {a})"
    rate = held(case, place, radius, profile, "frontAndBack { type empty; }", WALLS, 2e-3)
    exact = 2 * np.pi * GAS_K / GAS_CP * 0.05 * DEPTH * np.log1p(B) / np.log(outer / radius)
    assert rate == pytest.approx(exact, rel=0.02)


def test_a_sphere_in_tetrahedra_evaporates_as_stefan_says(clone):
    """4 pi R k/c ln(1 + B), 5.6 edges across; with Gauss linear gradients 6 % too much."""
    B, radius, side, n = 1.0, 1e-3, 5e-3, 14
    case = sphere_box(clone, n=n, side=side, mesh="tetrahedra")
    replace(case, "system/fvSchemes", "default         Gauss linear;", "default leastSquares;")
    place = 3 * (side / 2 + 0.3 * side / n,)
    profile = f"exp({np.log1p(B) * radius}*({1 / radius} - 1/{{r}}))"
    rate = held(case, place, radius, profile, "", '".*"', 2e-3)
    assert rate == pytest.approx(4 * np.pi * radius * GAS_K / GAS_CP * np.log1p(B), rel=0.02)
