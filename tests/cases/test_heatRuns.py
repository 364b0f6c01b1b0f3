# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat in runs that stop and continue, on several ranks, of clusters and in cyclic boxes."""

import re

import numpy as np
import pytest
from droplet_box import open_top
from grain_box import (
    assert_same_grains,
    control,
    cyclic_box,
    grain_box,
    lattice,
    replace,
    run_whole_and_parts,
)
from heat_box import GRAIN_CP, GRAINS, KAPPA, fix_grains, heat_ledger, with_heat
from sphere_box import decompose

CONTACTS = "conductivity 50; youngsModulus 1e9;"
COLD = '"left|right|top" { type zeroGradient; } bottom { type fixedValue; value uniform 310; }'


def settling(clone, name=None, radius=0.004, cells=10):
    """Grains of 400 K that settle in colder water, and conduct heat where they touch."""
    case = grain_box(clone, lattice(6, 4, 0.012, (0.02, 0.006)), radius, name=name)
    if cells != 10:
        replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
        case.run("blockMesh")
    fluid = "Cp 1000; kappa 0.6; beta 2e-4; TRef 300;"
    material = f"heatCapacity 800; {CONTACTS}"
    with_heat(case, 300, 400, COLD, fluid=fluid, heat="conductance strip;", ofGlass=material)
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure")
    replace(case, GRAINS, "density 7800;", f"density 7800; {CONTACTS}")
    replace(case, GRAINS, "        material    steel;", "        material steel; temperature 310;")
    control(case, deltaT=1e-3, endTime=0.1, writeInterval=10)
    return case


def assert_books_close(case, tolerance=1e-12):
    book = heat_ledger(case)
    assert book["fluidError"].max() <= tolerance
    assert book["grainError"].max() <= tolerance
    assert book["leastT"].min() >= 300 - 1e-9
    assert book["mostT"].max() <= 400 + 1e-9
    assert book["leastGrainT"].min() >= 300 - 1e-9
    assert book["mostGrainT"].max() <= 400 + 1e-9
    return book


# Cells of two diameters and a half, and of an eighth
@pytest.mark.parametrize(("radius", "cells"), [(0.004, 10), (0.005, 40)], ids=["law", "resolved"])
def test_restart_continues_exactly(clone, radius, cells):
    whole, parts = (settling(clone, name, radius, cells) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainThermalFoam", 0.05, 0.1)
    assert_same_grains(whole, parts)
    for name in ("T", "U", "p_rgh"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name))
    book = assert_books_close(whole)
    assert np.abs(book["walls"]).max() > 0


def test_a_killed_run_continues(clone):
    """kill -9 in mid-run: what is on disk is a time from which all is as without it."""
    whole, killed = settling(clone, "whole"), settling(clone, "killed")
    for case in (whole, killed):
        control(case, endTime=0.06, writeInterval=5)
    whole.run("grainThermalFoam")
    killed.kill("grainThermalFoam", "0.01")
    assert killed.times[-1] != whole.times[-1]
    killed.run("grainThermalFoam")
    assert_same_grains(whole, killed)
    for name in ("T", "U", "p_rgh"):
        np.testing.assert_array_equal(killed.field(name), whole.field(name))


def test_steps_that_adjust_themselves_keep_heat_and_restarts(clone):
    cases = [settling(clone, name) for name in ("whole", "parts")]
    for case in cases:
        limits = "adjustTimeStep yes; maxGrainDisplacement 0.05; maxCo 0.2; maxDeltaT 3e-3;"
        replace(case, "system/controlDict", "purgeWrite", f"{limits}\npurgeWrite")
        control(case, writeControl="adjustableRunTime", writeInterval=0.02)
    run_whole_and_parts(*cases, "grainThermalFoam", 0.06, 0.1)
    assert_same_grains(*cases)
    np.testing.assert_array_equal(*(case.field("T") for case in cases))
    book = assert_books_close(cases[0])
    steps = np.diff(book["time"])
    assert steps.max() > 1.5 * steps.min()


def assert_ranks_agree(one, several, ranks):
    for case in (one, several):
        control(case, endTime=0.02)
    one.run("grainThermalFoam")
    decompose(several, ranks)
    several.parallel("grainThermalFoam", ranks)
    several.run("reconstructPar")
    # Linear solvers leave 1e-12 of what they solve for
    np.testing.assert_allclose(one.field("T"), several.field("T"), atol=1e-6)
    np.testing.assert_allclose(
        one.grains()["temperature"], several.grains()["temperature"], atol=1e-6
    )
    assert_books_close(several)


@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks_agree(clone, ranks):
    assert_ranks_agree(settling(clone, "one"), settling(clone, "several"), ranks)


def test_cyclic_boxes_keep_their_heat(clone):
    case = cyclic_box(clone, lattice(4, 4, 0.025, (0.003, 0.003)), 0.004)
    patches = '"left|right|bottom|top" { type cyclic; }'
    with_heat(case, 300, 400, patches)
    (case.path / "constant/g").write_text(
        (case.path / "constant/g").read_text().replace("(0 0 0)", "(0 -1 0)")
    )
    control(case, deltaT=1e-3, endTime=0.1, writeInterval=100)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    total = book["fluidHeat"] + book["grainHeat"]
    np.testing.assert_allclose(total, total[0], rtol=1e-12 * len(total))


def test_steady_state_does_not_depend_on_the_time_step(clone):
    """Of fixed grains, each in one cell, in a fluid between a hot and a cold wall."""
    patches = (
        "left { type fixedValue; value uniform 400; } right { type fixedValue; value uniform 300; }"
        ' "bottom|top" { type zeroGradient; }'
    )
    found = []
    for deltaT in (1e4, 1e5):
        case = grain_box(clone, lattice(6, 6, 0.01, (0.025, 0.015)), 0.004, name=f"dt{deltaT:g}")
        fix_grains(case)
        with_heat(case, 350, 350, patches)
        (case.path / "constant/g").write_text(
            (case.path / "constant/g").read_text().replace("-9.81", "0")
        )
        control(case, deltaT=deltaT, endTime=200 * deltaT, writeInterval=200)
        case.run("grainThermalFoam")
        assert_books_close(case)
        found.append(case.field("T", case.times[-1]))
    assert found[0].max() > found[0].min() + 50
    np.testing.assert_allclose(*found, rtol=1e-8)


def test_pressure_without_gradient_at_walls_is_refused(clone):
    case = settling(clone)
    replace(case, "0/p_rgh", "fixedFluxPressure", "zeroGradient")
    assert case.run("grainThermalFoam", check=False) != 0
    for text in ("0/p_rgh", "zeroGradient", "allowed: fixedFluxPressure"):
        assert text in case.log


def without_weight(case):
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))


STRETCHED = (
    "left { type fixedValue; value uniform 400; } right { type fixedValue; value uniform 300; }"
    ' "bottom|top" { type zeroGradient; }'
)


@pytest.mark.parametrize(
    "method", ["exactOverlap;", "diffused; length 0.02;"], ids=["exact", "diffused"]
)
def test_steady_heat_through_grains_does_not_depend_on_the_time_step(clone, method):
    """Grains across several cells carry heat; what steps of 1e4 time constants found stays."""
    case = grain_box(clone, lattice(6, 6, 0.013, (0.017, 0.019)), 0.006)
    replace(case, GRAINS, "exactOverlap;", method)
    fix_grains(case)
    with_heat(case, 350, 350, STRETCHED)
    without_weight(case)
    constant = 2500 * GRAIN_CP * 0.012**2 / (6 * 2 * KAPPA)
    end = 0.0
    found = []
    for steps, deltaT in ((60, 1e4), (100, 0.1), (30, 10)):
        end += steps * deltaT * constant
        control(case, deltaT=deltaT * constant, endTime=end, writeInterval=steps)
        case.run("grainThermalFoam")
        found.append((case.field("T", case.times[-1]), case.grains()["temperature"]))
    # Round-off of what is exchanged to and fro in so long a step
    assert_books_close(case, 1e-10)
    for later in found[1:]:
        for one, other in zip(found[0], later, strict=True):
            assert np.ptp(one) > 20
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-6)


def test_steady_heat_through_contacts_does_not_depend_on_the_time_step(clone):
    """Two grains on a hot floor in colder water; of so little heat that they follow at once."""
    case = grain_box(clone, [(0.05, 0.004), (0.05, 0.012)], 0.004)
    # Motion of the start decays at once
    replace(case, "constant/transportProperties", "1e-4;", "1e-2;")
    little = 1e-3
    material = f"heatCapacity {little}; {CONTACTS}"
    fluid = f"Cp {little}; kappa {KAPPA};"
    with_heat(case, 310, 310, COLD, fluid=fluid, heat="conductance strip;", ofGlass=material)
    replace(case, GRAINS, "density 7800;", f"density 7800; {CONTACTS}")
    replace(case, GRAINS, "        material    steel;", "        material steel; temperature 400;")
    replace(case, GRAINS, "tolerance   1e-7", "tolerance   1e-14")
    constant = 2500 * little * 0.008**2 / (4 * 2 * KAPPA)
    found, end = [], 0.0
    for steps, deltaT in ((600, 60), (50, 0.3)):
        end += steps * deltaT * constant
        control(case, deltaT=deltaT * constant, endTime=end, writeInterval=steps)
        case.run("grainThermalFoam")
        found.append((case.field("T", case.times[-1]), case.grains()["temperature"]))
    assert_books_close(case, 1e-10)
    assert heat_ledger(case)["walls"][-1] > 0
    for one, other in zip(*found, strict=True):
        assert np.ptp(one) > 5
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-6)


def test_steady_heat_around_resolved_grains_does_not_depend_on_the_time_step(clone):
    """Fixed discs of 16 cells between a hot and a cold side: what long steps found stays."""
    case = grain_box(clone, [(0.031, 0.05), (0.067, 0.047)], 0.012)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(60 60 1)")
    case.run("blockMesh")
    fix_grains(case)
    with_heat(case, 350, 350, STRETCHED, fluid="Cp 1; kappa 0.6;", ofGlass="heatCapacity 1;")
    without_weight(case)
    found, end = [], 0.0
    for steps, deltaT in ((30, 1e2), (30, 0.1)):
        end += steps * deltaT
        control(case, deltaT=deltaT, endTime=end, writeInterval=steps)
        case.run("grainThermalFoam")
        found.append((case.field("T", case.times[-1]), case.grains()["temperature"]))
    assert_books_close(case, 1e-8)
    for one, other in zip(*found, strict=True):
        assert np.ptp(one) > 20
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-6)


def test_good_conductors_that_touch_cost_few_iterations(clone):
    """9 to 11 with incomplete factors of what touches, 27 to 33 with its diagonal alone."""
    case = grain_box(clone, lattice(12, 6, 0.008, (0.006, 0.004)), 0.004)
    material = "heatCapacity 800; conductivity 2e5; youngsModulus 1e9;"
    with_heat(case, 310, 400, COLD, heat="conductance strip;", ofGlass=material)
    replace(case, GRAINS, "density 7800;", f"density 7800; {CONTACTS}")
    control(case, deltaT=1e-2, endTime=0.2, writeInterval=20)
    case.run("grainThermalFoam")
    found = [int(n) for n in re.findall(r"Solving for T,.* No Iterations (\d+)", case.log)]
    assert len(found) == 20 and max(found) <= 15


def beside_an_outlet(clone, order, name):
    """A hot disc at rest in an outlet and one that passes by; in an order, under an open top."""
    centres, velocities = [(0.02, 0.02), (0.0455, 0.05)], [(0, 0), (0.5, 0.2)]
    case = grain_box(
        clone,
        [centres[i] for i in order],
        0.0045,
        velocity=[velocities[i] for i in order],
        name=name,
    )
    with_heat(case, 300, 400)
    without_weight(case)
    open_top(case)
    replace(case, GRAINS, "\ncoupling\n{", f"\noutlets {{ o {{ {HOLE} }} }}\ncoupling\n{{")
    control(case, deltaT=1e-3, endTime=0.01, writeInterval=1)
    return case


HOLE = "type box; box (0 0 0) (0.03 0.03 0.01);"


def test_grains_that_leave_do_not_change_the_heat_of_others(clone):
    """Those behind them in the list got what belonged to the one before."""
    drops = []
    for order, name in (([0, 1], "first"), ([1, 0], "last")):
        case = beside_an_outlet(clone, order, name)
        case.run("grainThermalFoam")
        grains = [case.grains(time) for time in case.times[1:]]
        assert [len(one["id"]) for one in grains] == [1] * 10
        drops.append([400 - float(one["temperature"][0]) for one in grains])
    np.testing.assert_allclose(drops[0], drops[1], rtol=1e-9)
    assert drops[0][-1] > 5 * drops[0][0] > 0


def test_ranks_agree_where_grains_leave_and_where_they_come(clone):
    """The disc comes into the cells of the second rank while the other one leaves."""
    one = beside_an_outlet(clone, [0, 1], "one")
    one.run("grainThermalFoam")
    two = beside_an_outlet(clone, [0, 1], "two")
    decompose(two, 2)
    two.parallel("grainThermalFoam", 2)
    two.run("reconstructPar")
    for time in one.times[1:]:
        np.testing.assert_allclose(
            one.grains(time)["temperature"], two.grains(time)["temperature"], rtol=0, atol=1e-7
        )
        np.testing.assert_allclose(one.field("T", time), two.field("T", time), rtol=0, atol=1e-7)
