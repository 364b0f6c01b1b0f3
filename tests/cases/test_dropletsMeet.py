# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets that are released at a time, and that touch and merge."""

import numpy as np
import pytest
from droplet_box import (
    ANTOINE,
    BOILING,
    DENSITY,
    GAS,
    droplet_table,
    make_gas,
    open_top,
    with_droplets,
)
from grain_box import DEPTH, control, grain_box, replace
from heat_box import heat_ledger, with_heat, with_psi

RADIUS = 0.008
RELEASE = 'releases { late { time %s; droplets { type csv; file "constant/late.csv"; } } }'


def box(clone, droplets, name=None, T=BOILING + 100, entries="", **others):
    """A fine box of gas with droplets of liquid in it, and without weight."""
    case = grain_box(clone, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    case.run("blockMesh")
    with_heat(case, T=T, grains=BOILING, fluid=f"{GAS} {others.pop('vapour', '')}")
    make_gas(case)
    open_top(case)
    replace(case, "constant/g", "-9.81", "0")
    return with_droplets(case, droplets, RADIUS, entries=entries, **others)


def rows(book, number):
    return {name: values[book["droplet"] == number] for name, values in book.items()}


def test_two_that_meet_become_one(clone):
    """With their liquid, momentum and angular momentum; the larger one gives the number."""
    case = box(
        clone,
        [(0.035, 0.05), (0.058, 0.055)],
        velocity=[(0.4, 0), (-0.2, 0)],
        T=BOILING,
    )
    control(case, endTime=0.06)
    file = case.path / "constant/droplets.csv"
    file.write_text(file.read_text().replace("0.008", "0.01", 1))
    case.run("grainDropletFoam")
    assert "Droplets 0 and 1 touch and merge" in case.log
    book = droplet_table(case)
    first, second = rows(book, 0), rows(book, 1)
    n = len(second["time"])
    assert 5 < n < len(first["time"]) - 5
    both = first["liquid"][n - 1] + second["liquid"][n - 1]
    np.testing.assert_allclose(first["liquid"][n:], both, rtol=1e-10)
    assert both == pytest.approx(DENSITY * np.pi * (0.01**2 + RADIUS**2) * DEPTH, rel=1e-10)
    assert first["radius"][n] == pytest.approx(np.hypot(0.01, RADIUS), rel=1e-9)
    # The gas takes some of it
    for axis in "xy":
        before = sum(d["liquid"][n - 1] * d["v" + axis][n - 1] for d in (first, second))
        after = both * first["v" + axis][n]
        assert after == pytest.approx(before, abs=1e-3 * both * 0.2)
        place = sum(d["liquid"][n - 1] * d[axis][n - 1] for d in (first, second)) / both
        assert first[axis][n] == pytest.approx(place, abs=2e-3 * 0.1)
    assert book["volumeError"].max() < 1e-12


def test_temperature_and_heat_of_those_that_merge(clone):
    """Of saturated droplets, of which one is later and colder; water and heat are kept."""
    case = box(
        clone,
        [(0.05, 0.02)],
        T=400,
        velocity=[(0, 0.3)],
        vapour="vapour { D 2e-5; }",
        entries=ANTOINE.format(pressure=1e5, temperature=340) + RELEASE % 0.01,
    )
    late = "x,y,z,radius\n0.05,0.05,0.005,0.008\n"
    (case.path / "constant/late.csv").write_text(late)
    sides = '"left|right|bottom|top" { type zeroGradient; } frontAndBack { type empty; }'
    with_psi(case, 0, sides)
    control(case, endTime=0.06, writeInterval=60)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    assert len(rows(book, 1)["time"]) + len(rows(book, 0)["time"]) > 50
    assert case.logged("Droplets  ")[-1] == 1
    assert book["vapour"].sum() > 0
    last = book["liquid"][-1]
    assert last + book["vapour"].sum() == pytest.approx(
        2 * DENSITY * np.pi * RADIUS**2 * DEPTH, rel=1e-9
    )
    volume = case.field("eps") * 0.0025**2 * DEPTH
    # The gas that the second one displaces when it comes leaves through the top
    gained = 1.2 * volume @ case.field("psi")
    assert gained == pytest.approx(book["vapour"].sum() + book["diffused"][-1], rel=3e-6)
    assert heat_ledger(case)["fluidError"].max() < 1e-8


@pytest.mark.parametrize("y", [0.0559, 0.047, 0.04])
def test_one_that_comes_where_another_is_brings_its_temperature(clone, y):
    """A saturated droplet released at the surface of one that is as warm as it, or inside it."""
    case = box(
        clone,
        [(0.05, 0.04)],
        T=400,
        vapour="vapour { D 2e-5; }",
        entries=ANTOINE.format(pressure=1e5, temperature=340) + RELEASE % 0.01,
    )
    (case.path / "constant/late.csv").write_text(f"x,y,z,radius\n0.05,{y},0.005,0.008\n")
    with_psi(case, 0, '"left|right|bottom|top" { type zeroGradient; } frontAndBack { type empty; }')
    control(case, endTime=0.02)
    case.run("grainDropletFoam")
    assert "touch and merge" in case.log
    book = droplet_table(case)
    np.testing.assert_allclose(book["temperature"], 340, atol=0.1)
    assert book["radius"][-1] == pytest.approx(np.sqrt(2) * RADIUS, rel=1e-3)


def test_a_cell_between_two_serves_both(clone):
    """Whichever is on its left: a light liquid, whose surfaces go back with the vapour."""
    books = []
    for side in (1, -1):
        places = [(0.05 + side * x, 0.0505) for x in (-0.0113, 0.0112)]
        case = box(clone, places, name=f"side{side}", density=12, entries="motion fixed;")
        file = case.path / "constant/droplets.csv"
        file.write_text(file.read_text()[::-1].replace("800.0", "5010.0", 1)[::-1])
        control(case, endTime=0.01)
        case.run("grainDropletFoam")
        books.append(droplet_table(case))
    one, other = books
    for column, sign in (("fx", -1), ("tx", -1), ("fy", 1), ("radius", 1)):
        scale = np.abs(one[column]).max()
        np.testing.assert_allclose(other[column], sign * one[column], atol=1e-7 * scale)


def test_release_restart_and_ranks(clone):
    """The release falls on the time of the restart, in a run of its own before it."""

    def case_of(name, end):
        case = box(clone, [(0.05, 0.02)], name=name, velocity=[(0, 0.3)], entries=RELEASE % 0.02)
        late = "x,y,z,radius\n0.05,0.05,0.005,0.008\n"
        (case.path / "constant/late.csv").write_text(late)
        control(case, endTime=end, writeInterval=5)
        return case

    whole, parts, ranks = case_of("whole", 0.1), case_of("parts", 0.02), case_of("ranks", 0.1)
    whole.run("grainDropletFoam")
    for end in (0.03, 0.1):
        parts.run("grainDropletFoam")
        control(parts, endTime=end)
    parts.run("grainDropletFoam")
    for name in ("U", "T", "p_rgh"):
        np.testing.assert_array_equal(parts.field(name), whole.field(name))
    book = droplet_table(whole)
    assert len(rows(book, 1)["time"]) and "touch and merge" in whole.log
    assert rows(book, 1)["time"][0] == pytest.approx(0.021)

    ranks.run("decomposePar")
    ranks.parallel("grainDropletFoam", 2)
    np.testing.assert_allclose(droplet_table(ranks)["radius"], book["radius"], rtol=1e-8)


def test_fixed_droplets_are_released_once(clone):
    """Released at 0.0105 s, in a run to 0.02 s that continues, and in one without a stop."""

    def case_of(name, end):
        entries = RELEASE % 0.0105 + "motion fixed;"
        case = box(clone, [(0.05, 0.02)], name=name, entries=entries)
        late = "x,y,z,radius\n0.05,0.05,0.005,0.008\n"
        (case.path / "constant/late.csv").write_text(late)
        control(case, endTime=end, writeInterval=5)
        return case

    whole, parts = case_of("whole", 0.03), case_of("parts", 0.02)
    whole.run("grainDropletFoam")
    parts.run("grainDropletFoam")
    control(parts, endTime=0.03)
    parts.run("grainDropletFoam")
    assert whole.logged("Droplets  ")[-1] == parts.logged("Droplets  ")[-1] == 2
    for name in ("U", "T"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name))
