# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact overlaps whose sums are spread by diffusion: nothing is lost, whatever the length."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, grain_box, lattice, ledger, replace
from heat_box import with_heat
from sphere_box import decompose, field
from test_motion import RHO, RHO_GRAIN, gamma
from test_spheres import falling_spheres
from water_box import level, water_box

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
SIDE = 0.1
MAPPING = "type    exactOverlap;"


def falling(clone, length, mesh="quads", name=None):
    """Discs that fall upon the floor and each other, in cells of 0.01 m."""
    rng = np.random.default_rng(2)
    centres = lattice(6, 4, 0.0155, (0.011, 0.012)) + rng.uniform(-1e-3, 1e-3, (24, 2))
    case = grain_box(clone, centres, 0.006, mesh, name=name)
    if length:
        replace(case, GRAINS, MAPPING, f"type diffused; length {length};")
    control(case, endTime=0.2, deltaT=2e-3, writeInterval=100)
    return case


@pytest.mark.parametrize("mesh", ["quads", "triangles"])
@pytest.mark.parametrize("length", [0.002, 0.02, 0.1])
def test_volume_and_momentum_are_kept(clone, mesh, length):
    case = falling(clone, length, mesh)
    case.run("grainFoam")
    book = ledger(case)
    assert book["active"].max() >= 5
    # Linear solvers to 1e-13, of what falls from rest and later rests on the floor
    assert book["momentumError"].max() <= 1e-9
    assert book["divergence"].max() <= 1e-8
    assert book["mappingError"][book["active"] == 0].max() <= 1e-12
    if mesh == "quads":
        # Less what is beyond the walls, by the contact solver's tolerance
        solid = np.mean(1 - case.field("eps")) * SIDE**2
        assert solid == pytest.approx(24 * np.pi * 0.006**2, rel=1e-6)


def test_of_spheres_too(clone):
    case = falling_spheres(clone, "tetrahedra")
    replace(case, GRAINS, MAPPING, "type diffused; length 0.02;")
    case.run("grainFoam")
    book = ledger(case)
    assert book["momentumError"].max() <= 1e-9
    assert book["mappingError"][book["active"] == 0].max() <= 1e-12


def test_a_short_length_is_the_exact_overlap(clone):
    """What spreads in a step is (b/2h)^2, 2.5e-9 of a cell's content."""
    exact = falling(clone, None, name="exact")
    replace(exact, GRAINS, "coupling\n{", "coupling\n{\n    undisturbedFlow { type none; }")
    short = falling(clone, 1e-6, name="short")
    for case in (exact, short):
        control(case, endTime=0.02, writeInterval=10)
        case.run("grainFoam")
    difference = exact.grains()["position"] - short.grains()["position"]
    assert np.abs(difference).max() <= 1e-8 * 0.02
    np.testing.assert_allclose(exact.field("eps"), short.field("eps"), rtol=0, atol=1e-7)


def test_a_long_length_is_the_mean_over_the_box(clone):
    """Single implicit steps of a length of many boxes leave the mean."""
    case = falling(clone, 10)
    control(case, endTime=2e-3, writeInterval=1)
    case.run("grainFoam")
    mean = 24 * np.pi * 0.006**2 / SIDE**2
    np.testing.assert_allclose(1 - case.field("eps"), mean, rtol=1e-6)


def test_a_uniform_suspension_does_not_know_of_it(clone):
    """The slip's decay is that of test_motion."""
    radius = 0.004
    phi = np.pi * radius**2 / 0.01**2
    slip, mu, steps = 1e-11, RHO * 1.0, 20
    case = cyclic_box(clone, lattice(10, 10, 0.01, (0.005, 0.005)), radius)
    replace(case, GRAINS, MAPPING, "type diffused; length 0.03;")
    replace(case, FLUID, "1e-4", "1")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {slip} 0)")
    rate = gamma(0.0, 2 * radius, mu, 1 - phi) * (1 / RHO_GRAIN + phi / ((1 - phi) * RHO))
    delta_t = 0.1 / rate
    control(case, deltaT=delta_t, endTime=delta_t * (steps + 0.5), timePrecision=12)
    control(case, writeInterval=steps)
    case.run("grainFoam")
    u = case.field("U")[:, 1]
    v = case.grains()["velocity"][:, 1]
    assert u.mean() - v.mean() == pytest.approx(slip * (1 + rate * delta_t) ** -steps, rel=1e-6)
    assert np.ptp(v) <= 1e-6 * slip


@pytest.mark.parametrize("length", [0.005, 0.02])
def test_momentum_is_kept_across_a_water_surface(clone, length):
    """A row of discs just below it displaces, spread, air as well: 9 and 34 % of the first step's
    momentum were lost where the discs saw the density in their own cells."""
    row = lattice(8, 1, 0.011, (0.0115, 0.0455))
    case = water_box(clone, level(0.05), row, radius=0.004, cells=(20, 20))
    replace(case, GRAINS, MAPPING, f"type diffused; length {length};")
    control(case, endTime=0.05, deltaT=1e-3, writeInterval=50)
    case.run("grainInterFoam")
    assert ledger(case)["momentumError"].max() <= 1e-9


def test_momentum_is_kept_in_a_fluid_that_heat_makes_lighter(clone):
    centres = lattice(5, 4, 0.0155, (0.021, 0.022))
    case = grain_box(clone, centres, 0.006)
    replace(case, GRAINS, MAPPING, "type diffused; length 0.02;")
    replace(case, "0/p_rgh", "zeroGradient;", "fixedFluxPressure; value uniform 0;")
    fluid = "Cp 1000; kappa 0.6; beta 1e-3; TRef 300;"
    with_heat(case, T=np.repeat(np.linspace(300, 600, 10), 10), fluid=fluid)
    control(case, endTime=0.05, deltaT=1e-3, writeInterval=50)
    case.run("grainThermalFoam")
    # Of 1e-3 before
    assert ledger(case)["momentumError"].max() <= 1e-9


@pytest.mark.parallel
def test_ranks_agree(clone):
    one, many = (falling_spheres(clone, name=name) for name in ("one", "many"))
    for case in (one, many):
        replace(case, GRAINS, MAPPING, "type diffused; length 0.02;")
    one.run("grainFoam")
    decompose(many, 2)
    many.parallel("grainFoam", 2)
    # What the contact solver's tolerance leaves uncertain
    difference = one.grains()["position"] - many.grains()["position"]
    assert np.abs(difference).max() <= 1e-7
    assert ledger(many)["momentumError"].max() <= 1e-9
    assert field(one, "eps").min() >= 0
