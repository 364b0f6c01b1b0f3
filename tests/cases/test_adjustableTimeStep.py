# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time steps that adjust themselves: limits hold, times of writing are met, restarts continue."""

import re

import numpy as np
import pytest
from dry_box import dry_box
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    lattice,
    ledger,
    replace,
    run_whole_and_parts,
    tracks,
)
from test_restart import assert_same, track_lines

RADIUS = 0.004
D = 2 * RADIUS
PILE = [*lattice(6, 2, D, (RADIUS, RADIUS)), (0.03, 0.08), (0.062, 0.05)]


def adjusting(case, write_interval=0.02, end=0.2, **limits):
    """Limits as in controlDict."""
    entries = "".join(f"{key} {value};\n" for key, value in limits.items())
    replace(case, "system/controlDict", "purgeWrite", f"adjustTimeStep yes;\n{entries}purgeWrite")
    control(case, writeControl="adjustableRunTime", writeInterval=write_interval, endTime=end)


def steps(case):
    """Lengths of all steps [s]."""
    return np.diff(ledger(case)["time"], prepend=0)


def governing(case):
    return re.findall(r"deltaT = \S+ s by (\w+)", case.log)


@pytest.mark.parametrize(
    "limits, governs",
    [
        ({"maxGrainDisplacement": 0.02, "maxGrainCo": 10, "maxCo": 10}, "maxGrainDisplacement"),
        ({"maxGrainDisplacement": 10, "maxGrainCo": 0.03, "maxCo": 10}, "maxGrainCo"),
        ({"maxGrainDisplacement": 10, "maxGrainCo": 10, "maxCo": 0.02}, "maxCo"),
        ({"maxGrainDisplacement": 10, "maxGrainCo": 10, "maxDeltaT": 2e-3}, "maxDeltaT"),
    ],
)
def test_steps_keep_to_the_limit_that_governs(clone, limits, governs):
    case = grain_box(clone, PILE, RADIUS)
    adjusting(case, **limits)
    case.run("grainFoam")
    length = steps(case)
    book = ledger(case)
    # From the first time on: at the start the fluid is at rest, and steps grow
    by = governing(case)
    by = by[by.index(governs) :]
    assert by.count(governs) >= 0.5 * len(by)
    assert len(by) >= 0.5 * len(length)
    assert book["time"][-1] == pytest.approx(0.2, rel=1e-12)
    # Longer by a fifth at most, whatever limits do
    assert np.all(length[1:] <= 1.2 * length[:-1] * (1 + 1e-8))
    assert length[0] <= 1e-3

    # A step is taken at the speed of the one before
    speed = np.append(0, book["maxVelocity"][:-1])
    if governs == "maxGrainDisplacement":
        # No more than what the fall under the reduced weight adds
        assert np.all(book["maxVelocity"] * length <= 0.02 * D * (1 + 1e-9))
    if governs == "maxGrainCo":
        # Cells of 0.01 m, a single fast grain that falls straight down
        assert np.all(speed * length / 0.01 <= 0.03 * (1 + 1e-6))
    if governs == "maxCo":
        assert case.logged("Courant number mean ").max() <= 0.03
        assert case.logged(" max ").max() <= 0.02 * 1.3
    if governs == "maxDeltaT":
        assert length.max() <= 2e-3 * (1 + 1e-9)


def test_times_of_writing_are_met_by_shorter_steps(clone):
    case = grain_box(clone, PILE, RADIUS)
    adjusting(case, write_interval=0.0077, end=0.0385)
    case.run("grainFoam")
    assert case.times[1:] == ["0.0077", "0.0154", "0.0231", "0.0308", "0.0385"]
    # The first step is that of controlDict
    assert steps(case)[1:].min() > 0.4 * steps(case).max()


def write_tracks_each(case, interval):
    entries = "writeControl    {};\n        writeInterval   {};"
    replace(
        case,
        "system/controlDict",
        entries.format("timeStep", 1),
        entries.format("adjustableRunTime", interval),
    )


def test_times_of_function_objects_are_met_by_shorter_steps(clone):
    """They are no multiples of each other, and two of them are next to each other at 0.0231."""
    case = grain_box(clone, PILE, RADIUS)
    adjusting(case, write_interval=0.0231, end=0.0462)
    write_tracks_each(case, 0.0077001)
    case.run("grainFoam")
    assert case.times[1:] == ["0.0231", "0.0462"]
    written = np.unique(tracks(case)[:, 0])
    # Those within half of a step of a time of writing are there
    met = [0.0077001, 0.0154002, 0.0231, 0.0308004, 0.0385005, 0.0462]
    np.testing.assert_allclose(written, met, rtol=1e-9)
    assert steps(case)[1:].min() > 0.3 * steps(case).max()


def test_function_objects_alone_have_their_times_met(clone):
    case = grain_box(clone, PILE, RADIUS)
    adjusting(case, end=0.02)
    control(case, writeControl="timeStep", writeInterval=1000)
    write_tracks_each(case, 0.004)
    case.run("grainFoam")
    np.testing.assert_allclose(
        np.unique(tracks(case)[:, 0]), [0.004, 0.008, 0.012, 0.016, 0.02], rtol=1e-9
    )


def test_stop_and_restart_with_times_of_function_objects(clone):
    whole, parts = (grain_box(clone, PILE, RADIUS, name=name) for name in ("a", "b"))
    for case in (whole, parts):
        adjusting(case, end=0.08)
        write_tracks_each(case, 0.008)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.04, end=0.08)
    np.testing.assert_array_equal(ledger(parts)["time"], ledger(whole)["time"])
    assert_same(whole, parts)
    assert track_lines(whole) == track_lines(parts)


def test_stop_and_restart(clone):
    whole, parts = (grain_box(clone, PILE, RADIUS, name=name) for name in ("a", "b"))
    for case in (whole, parts):
        adjusting(case, end=0.08)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.04, end=0.08)
    assert "The grains continue from" in parts.log
    assert len(set(np.round(steps(whole), 7))) > 5
    np.testing.assert_array_equal(ledger(parts)["time"], ledger(whole)["time"])
    assert_same(whole, parts)
    assert track_lines(whole) == track_lines(parts)


def test_a_pile_at_rest_stays_at_rest_while_steps_grow(clone):
    """Impulses of the last step enter the next as forces: nothing moves when its length changes."""
    pile = lattice(10, 3, 0.01, (0.005, 0.005))
    case = grain_box(clone, pile, 0.005)
    adjusting(case, end=0.5, write_interval=0.5, maxDeltaT=4e-3)
    control(case, deltaT=1e-4)
    case.run("grainFoam")
    length = steps(case)
    assert length.max() > 20 * length.min()
    settled = length.cumsum() > 0.05
    # The contact solver's tolerance is 1e-7 m per step
    assert np.all(ledger(case)["maxVelocity"][settled] * length[settled] <= 2e-7)
    assert np.abs(case.grains()["position"] - pile).max() <= 1e-5


@pytest.mark.parametrize("held", [True, False], ids=["fixed", "none"])
def test_steps_grow_without_grains_that_move(clone, held):
    """From that of controlDict by a fifth, to the limit, and go on after a restart."""
    whole, parts = (
        grain_box(clone, PILE if held else [], RADIUS, name=name) for name in ("a", "b")
    )
    for case in (whole, parts):
        replace(case, "constant/grainProperties", "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
        adjusting(case, end=0.04, maxDeltaT=2e-3)
        control(case, deltaT=1e-4)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.02, end=0.04)
    length = steps(whole)
    assert length[0] == pytest.approx(1e-4, rel=1e-2)
    # Whole steps to the next time of writing
    assert 1.8e-3 < length.max() <= 2e-3
    np.testing.assert_array_equal(ledger(parts)["time"], ledger(whole)["time"])


@pytest.mark.parallel
def test_ranks_take_the_same_steps(clone):
    one, many = (grain_box(clone, PILE, RADIUS, name=name) for name in ("one", "many"))
    for case in (one, many):
        adjusting(case, end=0.06)
    one.run("grainFoam")
    many.run("decomposePar")
    many.parallel("grainFoam", 2)
    # What the linear solvers leave of the fluxes and the contact solver of the grains' speeds
    np.testing.assert_allclose(steps(many), steps(one), rtol=1e-5)


def dry_pile(clone, name=None):
    case = dry_box(clone, PILE, RADIUS, dimension=2, name=name)
    adjusting(case, end=0.15, maxGrainDisplacement=0.02)
    return case


def test_dry_steps_keep_to_the_displacement_and_continue(clone):
    whole, parts = dry_pile(clone, "a"), dry_pile(clone, "b")
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.04, end=0.15)
    np.testing.assert_array_equal(ledger(parts)["time"], ledger(whole)["time"])
    for name in ("position", "velocity"):
        np.testing.assert_array_equal(parts.grains()[name], whole.grains()[name])
    length, book = steps(whole), ledger(whole)
    assert governing(whole).count("maxGrainDisplacement") >= 0.5 * len(length)
    # No more than what the fall in the step adds; a fast step follows a slow one at once
    assert np.all(book["maxVelocity"] * length <= 0.02 * D * (1 + 1e-9))
    assert length.max() > 2 * length.min()
    assert np.all(length[1:] <= 1.2 * length[:-1] * (1 + 1e-8))
    assert whole.times[1:] == [f"{0.02 * n:.2g}" for n in range(1, 8)]
    # A free fall from 0.08 m ends on the second row, a quarter of a diameter beside a disc
    end = 3 * RADIUS + np.sqrt(D**2 - (0.03 - 7 * RADIUS) ** 2)
    assert book["maxVelocity"].max() == pytest.approx(np.sqrt(2 * 9.81 * (0.08 - end)), rel=0.01)


@pytest.mark.parametrize("solver", ["dryGrainFoam", "grainFoam"])
def test_steps_are_a_quarter_of_the_period_of_a_wall_at_most(clone, solver):
    """Grains at rest let them grow; the wall, below the floor, touches none."""
    case = {"dryGrainFoam": dry_box, "grainFoam": grain_box}[solver](
        clone, PILE[:6], RADIUS, **({"dimension": 2} if solver == "dryGrainFoam" else {})
    )
    motion = "type oscillation; direction (0 1 0); amplitude 1e-4; frequency 250;"
    wall = f"type plane; point (0 -1e-3 0); normal (0 1 0); material steel; motion {{ {motion} }}"
    replace(case, "constant/grainProperties", "\nwalls\n{", f"\nwalls\n{{ shaker {{ {wall} }}")
    adjusting(case, end=0.02)
    control(case, deltaT=1e-4)
    case.run(solver)
    assert governing(case).count("frequency") >= 0.3 * len(steps(case))
    assert "frequency 0.001 s," in case.log
    assert 0.95e-3 < steps(case).max() <= 1e-3 * (1 + 1e-9)


@pytest.mark.parallel
def test_dry_ranks_take_the_same_steps(clone):
    one, many = dry_pile(clone, "one"), dry_pile(clone, "many")
    one.run("dryGrainFoam")
    many.run("decomposePar")
    many.parallel("dryGrainFoam", 2)
    np.testing.assert_array_equal(steps(many), steps(one))
    assert_same_grains(one, many)
