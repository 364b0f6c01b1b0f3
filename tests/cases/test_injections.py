# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that come in at a rate: the rate, the books, room, restarts, ranks, the flow."""

import numpy as np
import pytest
from conftest import ROOT
from dry_box import dry_box
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
    tracks,
)
from sphere_box import decompose, sphere_box

GRAINS = "constant/grainProperties"
DENSITY = 2500
DEPTH = 0.01
SPEED = 0.1
SIZES = "distribution { type uniform; minRadius 1e-3; maxRadius 2e-3; }"


def append(case, text):
    path = case.path / GRAINS
    path.write_text(f"{path.read_text()}\n{text}\n")


def inject(case, text, name="feed"):
    append(case, f"injections {{ {name} {{ material glass; {text} }} }}")


def injected(case, name="feed", start="0"):
    return case.table(f"postProcessing/injection/{start}/{name}.dat")


def discharged(case, start="0"):
    return case.table(f"postProcessing/discharge/{start}/discharge.dat")


def largest_overlap(grains):
    x, r = grains["position"], grains["radius"].ravel()
    i, j = np.triu_indices(len(r), 1)
    return np.max(r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1), initial=0)


BOX = {
    2: "type box; box (0.01 0.06 0) (0.09 0.095 0.01); seed 3;",
    3: "type box; box (0.01 0.01 0.06) (0.09 0.09 0.095); seed 3;",
}


def rain(clone, rate, name=None, dimension=2):
    """Dry grains that appear above and fall out below."""
    case = dry_box(clone, [], dimension=dimension, name=name)
    inject(case, f"{BOX[dimension]} {rate} {SIZES}")
    return case


def test_a_rate_that_is_a_function_may_have_its_coefficients_beside_it(clone):
    file = 'massRate tableFile; massRateCoeffs { file "constant/rate.dat"; outOfBounds clamp; }'
    number, function = rain(clone, "massRate 0.05;", "a"), rain(clone, file, "b")
    (function.path / "constant/rate.dat").write_text("((0 0.05) (1 0.05))")
    for case in (number, function):
        control(case, endTime=0.1, writeInterval=50)
        case.run("dryGrainFoam")
    assert len(number.grains()["radius"]) > 3
    assert_same_grains(number, function)


@pytest.mark.parametrize("dimension", [2, 3])
def test_mean_rate_is_exact_and_books_close(clone, dimension):
    rate = {2: 0.05, 3: 0.006}[dimension]
    case = rain(clone, f"massRate {rate};", dimension=dimension)
    control(case, endTime=0.3, deltaT=1e-3, writeInterval=50)
    case.run("dryGrainFoam")

    table, book = injected(case), ledger(case)
    mass = np.cumsum(table["injectedMass"])
    np.testing.assert_allclose(mass + table["owed"], rate * table["time"], rtol=1e-9, atol=1e-15)
    # Never more than is due, and no more is due than the largest grain weighs
    largest = DENSITY * {2: np.pi * 0.002**2 * DEPTH, 3: 4 / 3 * np.pi * 0.002**3}[dimension]
    assert table["owed"].min() >= -1e-9 * largest
    assert table["owed"].max() <= largest
    assert table["total"][-1] == book["injected"].sum() == book["grains"][-1]
    assert book["grains"][-1] >= 40
    np.testing.assert_allclose(book["injectedMass"].sum(), mass[-1], rtol=1e-9)
    assert book["momentumError"].max() <= 1e-10

    final = case.grains()
    assert len(set(final["id"].ravel())) == len(final["id"])
    assert final["radius"].min() >= 1e-3 and final["radius"].max() <= 2e-3
    np.testing.assert_allclose(final["mass"].sum(), mass[-1], rtol=1e-9)
    assert max(largest_overlap(case.grains(time)) for time in case.times[1:]) <= 1e-6


def test_what_finds_no_room_stays_owed(clone):
    """A box that is filled at once: 0.1 m x 0.02 m of discs of 2 mm."""
    case = dry_box(clone, [], dimension=2)
    replace(case, "constant/g", "-9.81", "0")
    sizes = "distribution { type constant; radius 2e-3; }"
    inject(case, f"type box; box (0 0 0) (0.1 0.02 0.01); numberRate 20000; {sizes}")
    control(case, endTime=0.02, writeInterval=20)
    case.run("dryGrainFoam")
    table = injected(case)
    np.testing.assert_allclose(table["total"] + table["owed"], 20000 * table["time"], atol=1e-6)
    # Random sequential addition of discs jams at 0.547 of the area
    fraction = table["total"][-1] * np.pi * 0.002**2 / (0.1 * 0.02)
    assert 0.3 <= fraction <= 0.547
    assert largest_overlap(case.grains()) == 0


def test_rate_of_time_start_end_and_total(clone):
    case = dry_box(clone, [], dimension=2)
    replace(case, "constant/g", "-9.81", "0")
    sizes = "distribution { type constant; radius 1e-3; }"
    place = "material glass; type box; box (0 0 0) (0.1 0.1 0.01);"
    ramp = "numberRate table ((0 0) (0.1 2000)); start 0.02; end 0.06;"
    append(
        case,
        f"injections {{ ramp {{ {place} {sizes} {ramp} }}"
        f" few {{ {place} {sizes} numberRate 1000; total 17; seed 2; }} }}",
    )
    control(case, endTime=0.1, writeInterval=100)
    case.run("dryGrainFoam")
    ramp, few = injected(case, "ramp"), injected(case, "few")
    t = np.clip(ramp["time"], 0.02, 0.06)
    due = 1e4 * (t**2 - 0.02**2)
    np.testing.assert_array_equal(ramp["total"], np.floor(due + 1e-6))
    due = np.round(1000 * few["time"])
    np.testing.assert_array_equal(few["total"], np.minimum(due, 17))
    assert np.abs(few["owed"]).max() <= 1e-9


def test_dry_restart_and_ranks(clone):
    whole, parts, ranks = (rain(clone, "massRate 0.2;", name) for name in "abc")
    for case in (whole, parts, ranks):
        control(case, endTime=0.2, writeInterval=50)
        replace(case, GRAINS, "(left right bottom top)", "(left right top)")
        append(case, "outlets { floor { type patches; patches (bottom); } }")
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.15, end=0.2)
    book = ledger(whole)
    assert book["removed"].sum() >= 10
    assert_same_grains(whole, parts)
    whole_run, after = discharged(whole), discharged(parts, "0.15")
    assert after["removed"].sum() < after["total"][-1] == book["removed"].sum()
    for name in ("total", "totalMass"):
        np.testing.assert_array_equal(after[name], whole_run[name][-len(after[name]) :])
    assert f"in all {book['removed'].sum():.0f}\n" in parts.log
    # OpenFOAM's tools look at every file of a time
    parts.run("foamToVTK")
    assert "injections" not in parts.log and "outlets" not in parts.log
    decompose(ranks, 2)
    ranks.parallel("dryGrainFoam", 2)
    assert_same_grains(whole, ranks)


def test_start_without_their_state(clone):
    """As from a state that a case without injections has written."""
    case = rain(clone, "massRate 0.2;")
    control(case, endTime=0.1, writeInterval=50)
    case.run("dryGrainFoam")
    assert "injections count from zero" not in case.log
    (case.path / case.times[-1] / "injections").unlink()
    append(case, "outlets { floor { type beyond; point (0 0 0); normal (0 -1 0); } }")
    control(case, endTime=0.2)
    case.run("dryGrainFoam")
    assert "injections count from zero" in case.log
    assert "outlets count from zero" in case.log


def test_patch_without_fluid(clone):
    case = dry_box(clone, [], dimension=2)
    replace(case, GRAINS, "(left right bottom top)", "(right bottom top)")
    inject(case, f"type patches; patches (left); velocity (0.5 0 0); numberRate 300; {SIZES}")
    control(case, endTime=0.1, writeInterval=1)
    case.run("dryGrainFoam")
    book = ledger(case)
    assert book["injected"].sum() == 29
    assert book["momentumError"].max() <= 1e-10
    first = [case.grains(time) for time in case.times[1:]]
    seen = set()
    for grains in first:
        new = [k for k, i in enumerate(grains["id"].ravel()) if i not in seen]
        seen.update(grains["id"].ravel())
        for x, r in zip(grains["position"][new], grains["radius"].ravel()[new], strict=True):
            # At the patch's inside, a step ago
            assert x[0] == pytest.approx(r + 0.5 * 1e-3, abs=1e-6)
            assert r <= x[1] + 1e-4 and x[1] <= 0.1 - r


def test_documented_example_with_heat(clone):
    text = (ROOT / "etc/caseDicts/grainProperties").read_text()
    shapes = text[text.index("\nshapes\n") : text.index("// Where grains leave")]
    injections = text[text.index("\ninjections\n") : text.index("// Used if there is no")]
    case = dry_box(clone, [], dimension=2)
    replace(case, GRAINS, "(left right bottom top)", "(left right top)")
    replace(case, "constant/g", "-9.81", "0")
    thermal = "conductivity 1; heatCapacity 800; youngsModulus 1e9;"
    for density in ("density 2500;", "density 7800;"):
        replace(case, GRAINS, density, f"{density} {thermal}")
    append(case, f"{shapes} {injections} heat {{}}")
    append(case, "outlets { floor { type patches; patches (bottom); } }")
    control(case, endTime=0.6, deltaT=1e-2, writeInterval=60)
    case.run("dryGrainFoam")
    assert injected(case, "feed")["total"][-1] > 0
    assert injected(case, "rain")["total"][-1] > 0
    book = ledger(case)
    np.testing.assert_allclose(book["injectedHeat"], 800 * 293 * book["injectedMass"], rtol=1e-9)
    # Of the heat before the step; there is none before the first grain
    heat = book["heat"] + book["removedHeat"]
    assert (book["heatError"][1:] <= 1e-12)[heat[:-1] > 0].all()


def channel(clone, feed, name=None, outlet="type patches; patches (top);"):
    """Fluid that flows up at SPEED between frictionless walls; grains come in below."""
    case = grain_box(clone, [], name=name)
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    inject(case, feed)
    append(case, f"outlets {{ top {{ {outlet} }} }}")
    case.run("blockMesh")
    return case


@pytest.mark.parametrize(
    "place",
    [
        f"type patches; patches (bottom); velocity (0 {SPEED} 0);",
        "type box; box (0.01 0.01 0) (0.09 0.07 0.01);",
    ],
)
def test_resolved_grains_that_come_in_with_the_fluid_leave_no_trace(clone, place):
    """They have its velocity, given or not: nothing accelerates, there is no pressure."""
    sizes = "distribution { type uniform; minRadius 0.022; maxRadius 0.025; }"
    case = channel(clone, f"{place} numberRate 2; {sizes}")
    control(case, endTime=2.6, deltaT=1e-2, writeInterval=20)
    case.run("grainFoam")
    book = ledger(case)
    assert book["injected"].sum() >= 2
    assert book["removed"].sum() >= 1
    np.testing.assert_allclose(tracks(case)[:, 6], SPEED, rtol=1e-9)
    assert book["divergence"].max() <= 1e-10
    assert book["grainMomentumError"].max() <= 1e-12
    for time in case.times[1:]:
        np.testing.assert_allclose(case.field("U", time)[:, 1], SPEED, rtol=1e-9)
        assert np.abs(case.field("p_rgh", time)).max() <= 1e-9 * 1000 * SPEED**2


def test_through_flow(clone):
    """As many come in as leave, in the mean, and the books close in every step."""
    rate = 40
    sizes = "distribution { type uniform; minRadius 0.001; maxRadius 0.002; }"
    feed = f"type patches; patches (bottom); velocity (0 {SPEED} 0); numberRate {rate}; {sizes}"
    case = channel(clone, feed)
    control(case, endTime=3, deltaT=1e-2, writeInterval=1)
    case.run("grainFoam")
    book = ledger(case)
    assert book["injected"].sum() == rate * 3 - 1
    assert book["grainMomentumError"].max() <= 1e-12
    given = np.hypot(book["given_x"], book["given_y"])
    assert (book["momentumError"] * given).max() <= 1e-10 * given.max()
    assert book["divergence"].max() <= 1e-9

    # They take 0.1 m plus a diameter at SPEED to get through
    inside = rate * (0.1 + 0.003) / SPEED
    later = book["time"] > 1.5
    assert book["grains"][later].mean() == pytest.approx(inside, abs=3)
    removed = book["removed"][later].sum()
    assert removed == pytest.approx(rate * later.sum() * 1e-2, abs=6)
    volume = np.cumsum(book["injectedVolume"] - book["removedVolume"])
    np.testing.assert_allclose(book["grainVolume"], volume, rtol=1e-9)

    # Grains that cross cells make a pressure of w rho v^2 or so; coming and going adds nothing
    largest = np.array([np.abs(case.field("p_rgh", time)).max() for time in case.times[1:]])
    assert largest.max() <= 0.1 * 1000 * SPEED**2
    at_work = (book["injected"] + book["removed"] > 0) & later
    assert largest[at_work].max() <= 1.5 * largest[~at_work & later].max()


@pytest.mark.parametrize("mesh", ["hexahedra", "tetrahedra"])
def test_spheres_through_a_channel(clone, mesh):
    """In cells of any shape, on one rank and on two."""
    one, two = (sphere_channel(clone, mesh, name) for name in ("one", "two"))
    one.run("grainFoam")
    book = ledger(one)
    assert book["injected"].sum() == 47
    assert book["removed"].sum() >= 5
    assert book["grainMomentumError"].max() <= 1e-10
    assert book["divergence"].max() <= 1e-8
    volume = np.cumsum(book["injectedVolume"] - book["removedVolume"])
    np.testing.assert_allclose(book["grainVolume"], volume, rtol=1e-9)
    # What alpha's jumps between cells leave of the fluid's velocity: less in hexahedra, in
    # tetrahedra 24 % in the first cell and 11 % in the others
    moves = tracks(one)
    change = np.abs(moves[:, 7] / SPEED - 1)
    assert change.max() <= {"hexahedra": 0.1, "tetrahedra": 0.3}[mesh]
    assert change[moves[:, 4] > 0.02].max() <= {"hexahedra": 0.1, "tetrahedra": 0.15}[mesh]

    decompose(two, 2)
    two.parallel("grainFoam", 2)
    np.testing.assert_array_equal(book["injected"], ledger(two)["injected"])
    np.testing.assert_array_equal(book["removed"], ledger(two)["removed"])
    assert two.grains()["position"] == pytest.approx(one.grains()["position"], abs=1e-7)


def sphere_channel(clone, mesh, name):
    """Spheres that come in with the fluid behind the cube and leave in front."""
    case = sphere_box(clone, [], mesh=mesh, n=8, name=name)
    for patch in ("back", "front"):
        case.dict_set("constant/polyMesh/boundary", f"entry0/{patch}/type", "patch")
    walls = '"left|right|bottom|top"'
    replace(
        case,
        "0/U",
        '".*"\n    {\n        type    noSlip;\n    }',
        f"{walls} {{ type slip; }} front {{ type zeroGradient; }}"
        f" back {{ type fixedValue; value uniform (0 0 {SPEED}); }}",
    )
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 0 {SPEED})")
    outlet = "front { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", '".*"', f'{outlet} "left|right|bottom|top|back"')
    replace(case, GRAINS, '(".*")', "(left right bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    feed = f"type patches; patches (back); velocity (0 0 {SPEED}); numberRate 30;"
    inject(case, f"{feed} distribution {{ type uniform; minRadius 2e-3; maxRadius 6e-3; }}")
    append(case, "outlets { out { type patches; patches (front); } }")
    control(case, endTime=1.6, deltaT=2e-2, writeInterval=80)
    return case


def test_box_that_is_filled_through_its_lid(clone):
    """Sand into water at rest, faster than it sinks: what is pushed back is taken away."""
    case = grain_box(clone, [])
    top = "top\n    {\n        type    "
    replace(case, "system/blockMeshDict", f"{top}wall", f"{top}patch")
    replace(case, GRAINS, "(left right bottom top)", "(left right bottom)")
    inject(case, f"type patches; patches (top); velocity (0 -0.1 0); massRate 0.1; {SIZES}")
    control(case, endTime=1.5, deltaT=5e-3, writeInterval=300)
    case.run("blockMesh")
    case.run("grainFoam")
    book = ledger(case)
    assert book["removed"].sum() >= 10
    assert book["grains"][-1] == book["injected"].sum() - book["removed"].sum()
    assert book["grainMomentumError"].max() <= 1e-10
    # What comes in as grains goes out as fluid: U of the lid is the mixture's, zero
    assert book["divergence"].max() <= 1e-9
    assert largest_overlap(case.grains()) <= 1e-5


def test_restart_and_ranks_with_fluid(clone):
    feed = f"type patches; patches (bottom); velocity (0 {SPEED} 0); volumeRate 2e-5; {SIZES}"
    cases = [channel(clone, feed, name) for name in "abc"]
    whole, parts, ranks = cases
    for case in cases:
        control(case, endTime=1.6, deltaT=1e-2, writeInterval=20)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.8, end=1.6)
    assert ledger(whole)["removed"].sum() >= 5
    assert_same_grains(whole, parts)
    for name in ("U", "p_rgh", "eps"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)

    decompose(ranks, 2)
    ranks.parallel("grainFoam", 2)
    np.testing.assert_array_equal(ledger(whole)["injected"], ledger(ranks)["injected"])
    assert ranks.grains()["position"] == pytest.approx(whole.grains()["position"], abs=1e-7)


def test_more_grains_than_can_come_in_are_refused(clone):
    """A mass rate in kg/s with radii in metres that were meant in other units."""
    case = dry_box(clone, [], dimension=2)
    inject(case, f"{BOX[2]} massRate 1; distribution {{ type constant; radius 1e-9; }}")
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in (GRAINS, "feed", "'massRate'", "value 1", "at most 1e5 grains"):
        assert fragment in case.log
