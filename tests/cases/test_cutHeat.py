# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat around resolved grains that leave parts of cells open."""

import numpy as np
import pytest
from grain_box import assert_same_grains, control, grain_box, replace, run_whole_and_parts
from heat_box import GRAINS, fix_grains, heat_ledger, stream, with_heat
from test_cutCells import choose, with_cells
from test_heatRandom import assert_bounded_and_kept, random_box
from test_heatRuns import assert_books_close, assert_ranks_agree, settling
from test_resolvedHeat import CENTRE, CP, DEPTH, K, around, given
from test_thermalRest import EXPANSION, GRADIENT, RHO, write_cells

COLD, HOT = 300.0, 400.0


def test_conduction_around_a_disc(clone):
    """Heat that leaves a disc which the mesh does not fit; found 0.7, 0.3 and 0.06 % off."""
    radius = 0.012
    T = lambda x, y: HOT - 50 * np.log(around(x, y) / radius)
    errors = []
    for n in (20, 40, 80):
        case = choose(with_cells(grain_box(clone, [CENTRE], radius, name=f"n{n}"), n))
        fix_grains(case)
        fluid = f"Cp {CP}; kappa {K};"
        with_heat(case, HOT, HOT, given(T, n), fluid=fluid, ofGlass="heatCapacity 1e10;")
        file = case.path / "constant/g"
        file.write_text(file.read_text().replace("-9.81", "0"))
        replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
        # What is explicit of the flux has settled after some steps, however long
        control(case, deltaT=1e3, endTime=5e3, writeInterval=5)
        case.run("grainThermalFoam")
        book = heat_ledger(case)
        errors.append(abs(-book["exchanged"][-1] / 1e3 / (2 * np.pi * 50 * K * DEPTH) - 1))
        assert book["fluidError"].max() <= 1e-10
    assert errors[0] <= 0.01
    assert errors[1] <= 0.004
    assert errors[2] <= 0.001


SPEED, RADIUS = 1 / 3, 0.005
# A tenth of a cell each
STEPS = 240


def place_and_velocity(moves):
    return (0.0803 if moves else 0.0403, 0.0502), (-SPEED if moves else 0, 0)


def hot_gas(case, moves):
    """Gas that streams, or rests for a cold disc of 8 cells to move through, at Re 208."""
    n, hot = 80, 573.15
    with_cells(case, n)
    stream(case, SPEED)
    if moves:
        path = case.path / "0/U"
        text = path.read_text().replace(f"({SPEED} 0 0)", "(0 0 0)")
        path.write_text(text)
    ends = (
        f"left {{ type fixedValue; value uniform {hot}; }} right {{ type inletOutlet; inletValue"
        f' uniform {hot}; value uniform {hot}; }} "bottom|top" {{ type zeroGradient; }}'
    )
    replace(case, "constant/transportProperties", "1000;", "1.2;")
    replace(case, "constant/transportProperties", "1e-4;", "1.6e-5;")
    with_heat(
        case, hot, 373.15, ends, fluid="Cp 1000; kappa 0.026;", ofGlass="heatCapacity 1e6;",
        convection="limitedLinear 1",
    )
    deltaT = 0.1 * 0.1 / n / SPEED
    control(case, deltaT=repr(deltaT), endTime=repr(deltaT * STEPS), writeInterval=STEPS)
    return case


def mean_and_jump(values):
    """Of the second half, and the largest jump from step to step over it."""
    later = values[len(values) // 2 :]
    return later.mean(), np.abs(np.diff(later)).max() / abs(later.mean())


def across_gas(clone, name, moves):
    """Heat in the second half of three diameters of way."""
    place, velocity = place_and_velocity(moves)
    case = hot_gas(grain_box(clone, [place], RADIUS, velocity=[velocity], name=name), moves)
    if not moves:
        fix_grains(case)
    choose(case)
    replace(case, GRAINS, "density 2500;", "density 10000;")
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-11
    return mean_and_jump(book["exchanged"])


def test_a_disc_that_moves_takes_the_heat_of_one_in_a_stream(clone):
    """Cells that it comes to give none of theirs: found 1.04 times, jumps of 0.04; locked cells
    have 1.26 and 0.69."""
    held, _ = across_gas(clone, "held", False)
    moved, jump = across_gas(clone, "moved", True)
    assert abs(moved / held - 1) <= 0.06
    assert jump <= 0.08


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("dimension", [2, 3])
def test_bounded_and_kept(clone, dimension, seed):
    """As in test_heatRandom.py, grains of 4 to 10 cells."""
    rng = np.random.default_rng((dimension, seed, 7))
    # nu dt/h^2 is at most 1
    case, passing = random_box(clone, rng, dimension, 40, smallest=4.2, least_Re=2.5)
    choose(case)
    case.run("grainThermalFoam")
    assert_bounded_and_kept(case, passing)


def test_restart_continues_exactly(clone):
    whole, parts = (choose(settling(clone, name, 0.005, 40)) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainThermalFoam", 0.05, 0.1)
    assert_same_grains(whole, parts)
    for name in ("T", "U", "p_rgh"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name))
    assert_books_close(whole)


@pytest.mark.parallel
def test_ranks_agree(clone):
    cases = (choose(settling(clone, name, 0.005, 40)) for name in ("one", "several"))
    assert_ranks_agree(*cases, 2)


def test_stratified_fluid_stays_at_rest(clone):
    """Around a fixed disc."""
    case = choose(with_cells(grain_box(clone, [(0.0513, 0.0487)], 0.0123), 40))
    height = np.array([polygon.mean(axis=0)[1] for polygon in case.mesh().polygons])
    T = 300 + GRADIENT * height
    with_heat(case, T, 350, fluid=f"Cp 1000; kappa 1e-20; beta {EXPANSION}; TRef 300;")
    fix_grains(case)
    write_cells(case, "0/p_rgh", -0.5 * RHO * EXPANSION * GRADIENT * 9.81 * height**2)
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure; value uniform 0")
    control(case, deltaT=1e-2, endTime=1, writeInterval=100)
    case.run("grainThermalFoam")
    assert np.abs(case.field("U")).max() <= 1e-8


def test_grains_that_conduct_inside_are_refused(clone):
    case = choose(with_cells(grain_box(clone, [(0.05, 0.05)], 0.012), 40))
    fix_grains(case)
    with_heat(
        case, heat="conductance none; inside conducting;",
        ofGlass="heatCapacity 800; conductivity 1;",
    )
    assert case.run("grainThermalFoam", check=False) == 1
    for word in ("'type'", "value cutCells", "allowed: locked none, with", "conduct inside"):
        assert word in case.log
    assert "\nTime = " not in case.log


@pytest.mark.parametrize("kind", ["locked", "cutCells"])
def test_a_wall_gives_what_it_is_told_to(clone, kind):
    """A heat flux through the bottom, which a fixed disc touches nearly; [J] in a step."""
    n, slope, delta_t, radius, gap = 40, 1000.0, 1e-2, 0.012, 0.0006
    case = choose(with_cells(grain_box(clone, [(0.05, radius + gap)], radius), n), kind)
    fix_grains(case)
    walls = (
        f"bottom {{ type fixedGradient; gradient uniform {slope}; }}"
        ' "left|right|top" { type zeroGradient; }'
    )
    with_heat(case, 300, 300, walls, ofGlass="heatCapacity 1e6;")
    control(case, deltaT=delta_t, endTime=5 * delta_t, writeInterval=5)
    case.run("grainThermalFoam")
    given = 0.6 * slope * 0.1 * DEPTH * delta_t
    np.testing.assert_allclose(-heat_ledger(case)["conducted_bottom"], given, rtol=1e-9)
