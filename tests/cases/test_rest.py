# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in equilibrium stays at rest: grains of the fluid's density, in contact, in gravity."""

import shutil

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace

# Seven in a row fill the box from wall to wall
RADIUS = 0.1 / 14
PILE = lattice(7, 3, 2 * RADIUS, (RADIUS, RADIUS))


def made_of(case, density):
    replace(case, "constant/grainProperties", "density 2500", f"density {density}")


@pytest.mark.parametrize("mesh", ["quads", "triangles"])
def test_neutrally_buoyant_grains_stay_at_rest(clone, mesh):
    """Grains that touch each other and the walls, and one that floats."""
    start = [*PILE, (0.0713, 0.0617)]
    case = grain_box(clone, start, RADIUS, mesh)
    made_of(case, 1000)
    case.run("grainFoam")
    assert case.times == ["0", "0.05"]

    # Round-off of g dt = 1e-2 m/s per step, over 50 steps
    assert np.abs(case.field("U")).max() <= 1e-10
    grains = case.grains()
    assert np.abs(grains["velocity"]).max() <= 1e-10
    np.testing.assert_allclose(grains["position"], start, rtol=0, atol=1e-12)
    assert np.abs(case.logged("fastest grain ")).max() <= 1e-10


@pytest.mark.parametrize("mesh", ["quads", "triangles"])
def test_pile_of_heavy_grains_stays_at_rest(clone, mesh):
    case = grain_box(clone, PILE, RADIUS, mesh)
    made_of(case, 2500)
    case.run("grainFoam")

    # The contact solver may leave each of 50 steps of 1 ms an error of its tolerance, 1e-7 m
    assert np.abs(case.grains()["position"] - PILE).max() <= 50 * 1e-7
    assert np.abs(case.grains()["velocity"]).max() <= 1e-7 / 1e-3


@pytest.mark.parametrize("mesh", ["quads", "triangles"])
def test_pile_does_not_move_the_fluid_from_the_first_step_on(clone, mesh):
    """It was expected to fall in that step, and threw the fluid up by more than g dt."""
    case = exact_pile(clone, mesh)
    control(case, deltaT=1e-3, endTime=0.003, writeInterval=1)
    case.run("grainFoam")
    assert_still(case, case.times[1:])


def exact_pile(clone, mesh="quads"):
    case = grain_box(clone, PILE, RADIUS, mesh)
    made_of(case, 2500)
    case.dict_set("constant/grainProperties", "contact/tolerance", "1e-12")
    case.dict_set("constant/grainProperties", "contact/maxSweeps", "2000")
    return case


def assert_still(case, times):
    # The contacts may leave 1e-9 m/s, which drag makes a hundredfold error of the impulses
    assert times
    for time in times:
        assert np.abs(case.field("U", time)).max() <= 1e-4 * 9.81 * 1e-3


def test_pile_that_was_dry_does_not_move_the_fluid_that_comes(clone):
    """Contacts that carried the whole weight threw it up by half of g dt."""
    case = exact_pile(clone)
    control(case, deltaT=1e-3, endTime=0.002, writeInterval=1)
    case.run("dryGrainFoam")
    for name in ("U", "p_rgh"):
        shutil.copy(case.path / "0" / name, case.path / "0.002")
    control(case, endTime=0.005)
    case.run("grainFoam")
    assert_still(case, case.times[3:])
