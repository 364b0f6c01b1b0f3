# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How well scalars and vapour diffuse through beds, over what they would in the fluid alone."""

import numpy as np
import pytest
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    lattice,
    replace,
    run_whole_and_parts,
    write_csv,
)
from heat_box import GRAINS, fix_grains, vapour_ledger, with_psi, write_scalar
from sphere_box import decompose
from test_bedConductivity import SIDE, bed, disordered, maxwell
from test_carried import (
    add_dye,
    amount,
    assert_books_close,
    assert_bounded,
    assert_kept,
    set_cells,
    settling,
)
from test_heatBadInput import assert_refused

DEPTH = 0.01
D = 1e-5
TIME = SIDE**2 / D
MAXWELL = "type Maxwell;"
PACKED = "type ZehnerSchluender; shape sphere;"


def with_law(case, law):
    if law:
        replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ diffusivity {{ {law} }}")
    return case


def between_walls(case):
    """Vapour, from a wall that has it to one that has none."""
    file = case.path / "constant/transportProperties"
    file.write_text(f"{file.read_text()} vapour {{ D {D}; }}\n")
    with_psi(
        case,
        0.5,
        "left { type fixedValue; value uniform 1; } right { type fixedValue; value uniform 0; }"
        ' "bottom|top" { type zeroGradient; } frontAndBack { type empty; }',
    )
    return case


def diffusivity(case):
    """Of the steady state, over that of the fluid alone."""
    deltaT, steps = TIME / 3, 60
    control(case, deltaT=repr(deltaT), endTime=repr(steps * deltaT), writeInterval=steps)
    case.run("grainThermalFoam")
    book = vapour_ledger(case)
    through = book["diffused_right"][-1]
    assert -book["diffused_left"][-1] == pytest.approx(through, rel=1e-9)
    return through / (deltaT * D * DEPTH)


@pytest.mark.parametrize("law", [None, MAXWELL])
@pytest.mark.parametrize("cells", [5, 10, 20])
def test_vapour_diffuses_through_a_bed_as_the_law_says(clone, cells, law):
    """Half of the plane in discs without order; the fluid's part alone would be 0.497."""
    centres, radius = disordered()
    found = diffusivity(between_walls(with_law(bed(clone, centres, radius, cells), law)))
    phi = len(centres) * np.pi * radius**2 / SIDE**2
    # Cells differ (fluid fractions of 0.24 to 0.79 in those of a diameter), the more the smaller
    assert found == pytest.approx(maxwell(phi, 0) if law else 1 - phi, rel=0.05)


def even(rows):
    """Columns of discs that begin at the left wall, and their share of the plane there."""
    radius = 0.0022
    centres = lattice(rows, 20, SIDE / 20, (SIDE / 40, SIDE / 40))
    return centres, radius, np.pi * radius**2 / (SIDE / 20) ** 2


@pytest.mark.parametrize("columns", [10, 20])
def test_a_bed_and_fluid_beside_it_are_in_series(clone, columns):
    """Where half of the box, or all of it, is an even bed."""
    centres, radius, phi = even(columns)
    found = diffusivity(between_walls(with_law(bed(clone, centres, radius, 10), PACKED)))
    inBed = 1 - phi**0.5
    share = columns / 20
    assert found == pytest.approx(1 / (share / inBed + 1 - share), rel=1e-6)


def dye_from_a_wall(case, cells, end):
    sides = (
        'left { type fixedValue; value uniform 1; } "right|bottom|top" { type zeroGradient; }'
        " frontAndBack { type empty; }"
    )
    add_dye(case, cells**2, D)
    write_scalar(case, "dye", "0 0 0 0 0 0 0", 0, sides)
    fix_grains(case)
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))
    steps = 200
    control(case, deltaT=repr(end / steps), endTime=repr(end), writeInterval=steps)
    case.run("grainFoam")
    return amount(case, case.times[-1])


def test_a_dye_soaks_into_a_bed_as_the_law_says(clone):
    """Content is that of the fluid's part, as without a law."""
    centres, radius, phi = even(20)
    case = grain_box(clone)
    write_csv(case, centres, radius)
    set_cells(case, 20)
    end = 0.1 * TIME
    found = dye_from_a_wall(with_law(case, MAXWELL), 20, end)
    eps, law = 1 - phi, maxwell(phi, 0)
    exact = 2 * SIDE * DEPTH * np.sqrt(eps * law * D * end / np.pi)
    # Half-space; steps of Euler, and cells of a tenth of the way it has gone
    assert found == pytest.approx(exact, rel=0.01)


def test_resolved_grains_are_not_counted_by_the_law(clone):
    found = []
    for law in (None, MAXWELL):
        case = grain_box(clone, [(0.047, 0.052)], 0.0125, name=str(law)[:4])
        set_cells(case, 20)
        found.append(dye_from_a_wall(with_law(case, law), 20, 0.1 * TIME))
    assert found[1] == pytest.approx(found[0], rel=1e-12)


@pytest.mark.parallel
def test_grains_that_settle_keep_what_there_is_with_restart_and_ranks(clone):
    cases = [with_law(settling(clone, "unresolved", D, name=name), MAXWELL) for name in "abc"]
    whole, parts, ranks = cases
    for case in cases:
        control(case, endTime=0.2, writeInterval=25)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.1, end=0.2)
    assert_same_grains(whole, parts)
    np.testing.assert_array_equal(whole.field("dye"), parts.field("dye"))
    assert_books_close(whole)
    assert_bounded(whole)
    assert_kept(whole)

    decompose(ranks, 2)
    ranks.parallel("grainFoam", 2)
    assert_books_close(ranks)
    ranks.run("reconstructPar -latestTime")
    # Contacts leave 1e-7 of a grain's way uncertain, a cell of 5 mm has 2e-5 of it
    np.testing.assert_allclose(whole.field("dye"), ranks.field("dye"), rtol=0, atol=1e-4)


@pytest.mark.parametrize("application", ["grainFoam", "checkGrains"])
def test_a_law_that_is_not_there_is_told(clone, application):
    case = with_law(grain_box(clone, [(0.05, 0.05)], 0.0025), "type Bruggeman;")
    words = [GRAINS, "diffusivity", "'type'", "Bruggeman", "Maxwell ZehnerSchluender"]
    assert_refused(case, words, application)
