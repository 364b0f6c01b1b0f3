# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls behind a coefficient of heat transfer, beside grains and droplets."""

import pytest
from droplet_box import BOILING, GAS, GAS_K, SURFACES, make_gas, open_top, with_droplets
from grain_box import DEPTH, control, grain_box, lattice, replace
from heat_box import GRAINS, KAPPA, fix_grains, heat_ledger, with_heat

COLD, AMBIENT, SIDE, STEPS, STEP = 350.0, 450.0, 0.1, 10, 1.0
GIVEN = f"type fixedValue; value uniform {AMBIENT};"
# Centres, radius: in cells; a gap of 0.2 and of 0.04 cells between a disc of 8 and the wall
BED = lattice(20, 20, 0.005, (0.0025, 0.0025)), 0.002
NEAR = [(0.021, 0.05)], 0.02
NEARER = [(0.0202, 0.05)], 0.02
BESIDE = pytest.mark.parametrize(
    "kind, grains",
    [("none", BED), ("locked", NEAR), ("locked", NEARER), ("cutCells", NEAR), ("cutCells", NEARER)],
)


def newton(h, of="surface", ambient=AMBIENT):
    return f"type NewtonWall; of {of}; h uniform {h}; Ta uniform {ambient}; value uniform 400;"


def without_weight(case):
    replace(case, "constant/g", "-9.81", "0")


def heat_through(clone, left, kind, grains, name):
    """What comes through the left wall of a box of fixed grains in ten steps [J]."""
    case = grain_box(clone, *grains, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    fix_grains(case)
    sides = f'left {{ {left} }} "right|bottom|top" {{ type zeroGradient; }}'
    with_heat(case, COLD, COLD, sides)
    without_weight(case)
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ resolvedGrains {{ type {kind}; }}")
    control(case, deltaT=STEP, endTime=STEPS * STEP, writeInterval=STEPS)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-12
    return -book["conducted_left"].sum()


@BESIDE
def test_little_transfer_does_not_see_what_is_beside_the_wall(clone, kind, grains):
    h = 1e-3
    through = h * SIDE * DEPTH * (AMBIENT - COLD) * STEPS * STEP
    for of in ("surface", "cell"):
        heat = heat_through(clone, newton(h, of), kind, grains, of)
        assert heat == pytest.approx(through, rel=2e-5), of


@BESIDE
def test_much_transfer_is_a_wall_of_given_temperature(clone, kind, grains):
    heat = heat_through(clone, newton(1e9), kind, grains, "much")
    assert heat == pytest.approx(heat_through(clone, GIVEN, kind, grains, "given"), rel=1e-5)


def test_films_and_fluid_are_in_series(clone):
    """Two walls, fluid at rest between them, and a grain that covers nothing of it."""
    first, second = 30.0, 5.0
    case = grain_box(clone, [(0.055, 0.055)], 1e-5)
    fix_grains(case)
    sides = f"left {{ {newton(first)} }} right {{ {newton(second, ambient=COLD)} }}"
    with_heat(case, 400, 400, sides + ' "bottom|top" { type zeroGradient; }')
    without_weight(case)
    control(case, deltaT=1e6, endTime=2e7, writeInterval=20)
    case.run("grainThermalFoam")
    flux = (AMBIENT - COLD) / (1 / first + SIDE / KAPPA + 1 / second)
    book = heat_ledger(case)
    through = flux * SIDE * DEPTH * 1e6
    assert book["conducted_right"][-1] == pytest.approx(through, rel=1e-6)
    assert book["conducted_left"][-1] == pytest.approx(-through, rel=1e-6)


@SURFACES
@pytest.mark.parametrize("given", ["flux", "little"])
def test_what_a_wall_gives_passes_beside_a_droplet(clone, surface, given):
    """A gap of 0.2 cells between a held droplet of 8 and the wall."""
    h, gradient, steps, step = 1e-3, 100.0, 10, 1e-3
    walls = {
        "flux": (f"type fixedGradient; gradient uniform {gradient};", GAS_K * gradient, 1e-9),
        "little": (newton(h), h * (AMBIENT - BOILING), 1e-4),
    }
    bottom, flux, error = walls[given]
    case = grain_box(clone)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    case.run("blockMesh")
    sides = f'bottom {{ {bottom} }} "left|right|top" {{ type zeroGradient; }}'
    with_heat(case, BOILING, BOILING, sides, fluid=GAS)
    make_gas(case)
    open_top(case)
    without_weight(case)
    with_droplets(case, [(0.05, 0.0105)], 0.01, surface=surface, entries="motion fixed;")
    control(case, deltaT=step, endTime=steps * step, writeInterval=steps)
    case.run("grainDropletFoam")
    heat = -heat_ledger(case)["conducted_bottom"].sum()
    assert heat == pytest.approx(flux * SIDE * DEPTH * steps * step, rel=error)
