# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam: motions known in closed form, books, restarts, ranks, outlets."""

import numpy as np
import pytest
from dry_box import GRAINS, G, cubic, dry_box
from grain_box import (
    assert_same_grains,
    control,
    lattice,
    ledger,
    make_cyclic,
    replace,
    run_whole_and_parts,
    tracks,
)

RADIUS = 0.005
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


def down(dimension):
    """Index of the vertical coordinate."""
    return dimension - 1


def pile(dimension, jitter=0.0):
    """Grains that touch each other, the floor and the walls, or nearly."""
    if dimension == 2:
        centres = lattice(10, 6, 2 * RADIUS, (RADIUS, RADIUS))
    else:
        centres = cubic(10, 10, 3, 2 * RADIUS, (RADIUS, RADIUS, RADIUS))
    noise = np.random.default_rng(1).uniform(-jitter, jitter, centres.shape)
    return centres * (1 - 2 * jitter / 0.1) + jitter + noise


@DIMENSIONS
def test_free_fall(clone, dimension):
    """x_n = x_0 + v_0 n dt - g dt^2 n (n + 1)/2 and the parabola's speed, spinning or not."""
    start = np.full(dimension, 0.05)
    velocity = np.full(dimension, 0.2)
    case = dry_box(clone, [start], 0.002, [velocity], dimension)
    case.run("dryGrainFoam")
    n = np.arange(1, 51)
    track = tracks(case)
    axes = [1, 2] if dimension == 2 else [1, 2, 3]
    y = down(dimension) + 2
    across = [a for a in (2, 3, 4)[:dimension] if a != y]
    assert len(axes) == dimension
    for column in across:
        np.testing.assert_allclose(track[:, column], 0.05 + 0.2e-3 * n, rtol=1e-12)
    exact = 0.05 + 0.2e-3 * n - G * 1e-6 * n * (n + 1) / 2
    np.testing.assert_allclose(track[:, y], exact, rtol=1e-12)
    np.testing.assert_allclose(track[:, y + 3], 0.2 - G * 1e-3 * n, rtol=1e-12)

    book = ledger(case)
    mass = 2500 * (np.pi * 0.002**2 * 0.01 if dimension == 2 else 4 / 3 * np.pi * 0.002**3)
    speed2 = (dimension - 1) * 0.2**2 + (0.2 - G * 1e-3 * n) ** 2
    np.testing.assert_allclose(book["kineticEnergy"], 0.5 * mass * speed2, rtol=1e-10)
    np.testing.assert_allclose(book["potentialEnergy"], mass * G * exact, rtol=1e-10)
    assert (book["momentumError"] <= 1e-12).all()
    assert (book["grains"] == 1).all()


def test_gravity_may_leave_the_plane_by_round_off(clone):
    """As it does where a case has been turned: the motion is the same; 1e-9 of it is an error."""
    cases = [dry_box(clone, [(0.05, 0.05)], RADIUS, dimension=2, name=name) for name in "abc"]
    plane, nearly, across = cases
    replace(nearly, "constant/g", "(0 -9.81 0)", "(0 -9.81 -6.01e-16)")
    replace(across, "constant/g", "(0 -9.81 0)", "(0 -9.81 1e-8)")
    for case in (plane, nearly):
        case.run("dryGrainFoam")
    assert_same_grains(plane, nearly)
    assert across.run("dryGrainFoam", check=False) == 1
    assert "constant/g has a component across the mesh" in across.log


@DIMENSIONS
def test_pile_stays_at_rest(clone, dimension):
    start = pile(dimension)
    case = dry_box(clone, start, RADIUS, dimension=dimension)
    case.run("dryGrainFoam")
    # Each of 50 steps of 1 ms may leave an error of the tolerance, 1e-7 m
    grains = case.grains()
    np.testing.assert_allclose(grains["position"], start, rtol=0, atol=50 * 1e-7)
    assert np.abs(grains["velocity"]).max() <= 1e-7 / 1e-3
    # The floor carries the weight, to the tolerance over g dt^2 = 9.8e-6 m
    book = ledger(case)
    weight = len(start) * grains["mass"][0] * G * 1e-3
    vertical = book["impulse_y" if dimension == 2 else "impulse_z"]
    np.testing.assert_allclose(vertical[5:], weight, rtol=1e-2)


@DIMENSIONS
@pytest.mark.parametrize("solver", ["queue", "nesterov"])
def test_solvers_agree(clone, dimension, solver):
    """A pile that settles under its weight comes to lie where plain sweeps have it lie."""
    start = pile(dimension)
    sweeps, other = (dry_box(clone, start, RADIUS, dimension=dimension, name=n) for n in "ab")
    replace(other, GRAINS, "maxSweeps   200;", f"maxSweeps 200; solver {solver};")
    for case in (sweeps, other):
        case.run("dryGrainFoam")
    # Either may be off by the tolerance, 1e-7 m in each of 50 steps
    one, two = sweeps.grains(), other.grains()
    np.testing.assert_allclose(one["position"], two["position"], rtol=0, atol=2 * 50 * 1e-7)
    # and by the tolerance over dt in velocity
    np.testing.assert_allclose(one["velocity"], two["velocity"], rtol=0, atol=2 * 1e-7 / 1e-3)
    vertical = "impulse_y" if dimension == 2 else "impulse_z"
    book, books = ledger(sweeps), ledger(other)
    weight = len(start) * one["mass"][0] * G * 1e-3
    np.testing.assert_allclose(book[vertical][5:], weight, rtol=1e-2)
    np.testing.assert_allclose(books[vertical][5:], weight, rtol=1e-2)
    # The residual, not the limit of sweeps, ended them
    assert books["residual"][5:].max() <= 1e-7 / 1e-3


@DIMENSIONS
def test_sphere_stops_on_the_floor_without_rebound(clone, dimension):
    start = np.full(dimension, 0.05)
    start[down(dimension)] = RADIUS + 1e-4
    case = dry_box(clone, [start], RADIUS, dimension=dimension)
    case.run("dryGrainFoam")
    end = case.grains()["position"][0]
    assert end[down(dimension)] == pytest.approx(RADIUS, abs=1e-7)
    np.testing.assert_allclose(np.delete(end, down(dimension)), 0.05, atol=1e-12)


@DIMENSIONS
def test_restart_is_the_uninterrupted_run(clone, dimension):
    start = pile(dimension, 2e-4) + np.eye(dimension)[down(dimension)] * 5e-3
    radius = RADIUS - 5e-4
    cases = [dry_box(clone, start, radius, dimension=dimension, name=name) for name in "ab"]
    for case in cases:
        control(case, endTime=0.06, writeInterval=30)
    whole, parts = cases
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.03, end=0.06)
    assert "The grains continue from" in parts.log
    assert whole.logged("Contacts  ").max() >= 30
    assert_same_grains(whole, parts)


@pytest.mark.parallel
@pytest.mark.parametrize("ranks", [2, 4])
@DIMENSIONS
def test_ranks_agree(clone, dimension, ranks):
    start = pile(dimension, 2e-4) + np.eye(dimension)[down(dimension)] * 5e-3
    radius = RADIUS - 5e-4
    one, many = (dry_box(clone, start, radius, dimension=dimension, name=n) for n in "ab")
    for case in (one, many):
        control(case, endTime=0.05, writeInterval=25)
    one.run("dryGrainFoam")
    replace(many, "system/decomposeParDict", "numberOfSubdomains 2", f"numberOfSubdomains {ranks}")
    replace(many, "system/decomposeParDict", "(2 1 1)", f"(2 {ranks // 2} 1)")
    many.run("decomposePar")
    many.parallel("dryGrainFoam", ranks)
    assert ledger(one)["active"].max() > 50
    # Without a fluid nothing depends on the decomposition: the same, bit for bit
    for name in ("position", "velocity", "spin", "id"):
        np.testing.assert_array_equal(one.grains("0.05")[name], many.grains("0.05")[name])


@DIMENSIONS
def test_written_cloud_is_read_by_foamToVTK(clone, dimension):
    case = dry_box(clone, pile(dimension), RADIUS, dimension=dimension)
    control(case, endTime=0.002, writeInterval=2)
    case.run("dryGrainFoam")
    case.run("foamToVTK -latestTime")
    (file,) = (case.path / "VTK").rglob("lagrangian/**/*.vtp")
    assert f"NumberOfPoints='{len(pile(dimension))}'".encode() in file.read_bytes()


OUTLETS = {
    "patches": "type patches; patches (bottom);",
    "beyond": "type beyond; point (0 0 0); normal (0 -1 0);",
    "box": "type box; box (0 -0.01 0) (0.1 0 0.01);",
}


def add_outlet(case, entries):
    path = case.path / GRAINS
    path.write_text(f"{path.read_text()}\noutlets\n{{\n    floor {{ {entries} }}\n}}\n")


@pytest.mark.parametrize("kind", OUTLETS)
def test_block_that_falls_out_is_counted(clone, kind):
    """Rows of ten grains leave as their centres pass the bottom: when, follows from the fall."""
    rows, dt = 4, 1e-3
    start = lattice(10, rows, 0.01, (0.005, 0.0105)) * np.array([1, 1])
    case = dry_box(clone, start, 0.004, dimension=2)
    replace(case, GRAINS, "(left right bottom top)", "(left right top)")
    add_outlet(case, OUTLETS[kind])
    control(case, endTime=0.12, writeInterval=60)
    case.run("dryGrainFoam")

    table = case.table("postProcessing/discharge/0/discharge.dat")
    n = np.arange(1, 121)
    fall = G * dt**2 * n * (n + 1) / 2
    expected = sum(10 * np.diff(fall > 0.0105 + 0.01 * row, prepend=False) for row in range(rows))
    np.testing.assert_array_equal(table["removed"], expected)
    assert table["total"][-1] == 10 * rows
    mass = 2500 * np.pi * 0.004**2 * 0.01
    np.testing.assert_allclose(table["massFlowRate"], expected * mass / dt, rtol=1e-10)
    np.testing.assert_allclose(table["totalMass"], mass * np.cumsum(expected), rtol=1e-10)

    book = ledger(case)
    np.testing.assert_array_equal(book["grains"], 10 * rows - np.cumsum(expected))
    assert (book["momentumError"] <= 1e-10).all()
    assert len(case.grains("0.12")["id"]) == 0
    assert len(case.grains("0.06")["id"]) == 10 * rows - expected[:60].sum()


@pytest.mark.parametrize("dt", [5e-3, 5e-4])
@DIMENSIONS
def test_fast_grains_do_not_jump_over_a_box(clone, dimension, dt):
    """At 3 m/s, 15 mm in the longer steps, each passes a box 5 mm high once."""
    if dimension == 2:
        start = lattice(8, 2, 0.012, (0.008, 0.08))
    else:
        start = cubic(8, 8, 2, 0.012, (0.008, 0.008, 0.08))
    velocity = np.tile(-3.0 * np.eye(dimension)[down(dimension)], (len(start), 1))
    case = dry_box(clone, start, 1e-3, velocity, dimension)
    box = "(0 0.05 0) (0.1 0.055 0.01)" if dimension == 2 else "(0 0 0.05) (0.1 0.1 0.055)"
    add_outlet(case, f"type box; box {box};")
    control(case, deltaT=dt, endTime=0.02, writeInterval=round(0.02 / dt))
    case.run("dryGrainFoam")
    book = ledger(case)
    assert book["removed"].sum() == len(start)
    assert len(case.grains()["id"]) == 0
    assert (book["momentumError"] <= 1e-10).all()
    # Those of a row leave in the step in which they reach the box from above
    n = np.arange(1, round(0.02 / dt) + 1)
    fall = 3 * n * dt + G * dt**2 * n * (n + 1) / 2
    reached = sum(np.diff(fall >= height - 0.055, prepend=False) for height in (0.08, 0.092))
    np.testing.assert_array_equal(book["removed"], reached * len(start) / 2)


@DIMENSIONS
def test_box_takes_grains_that_cross_a_periodic_side(clone, dimension):
    """15 mm in a step: a box at the side is met from both sides, one off the ways is not."""
    up = 0.02 * np.eye(dimension)[1]
    start = 0.05 * np.ones((3, dimension)) + np.outer([-1, 0, 1], up)
    start[:, 0] = [0.09, 0.09, 0.01]
    velocity = np.zeros((3, dimension))
    velocity[:, 0] = [3, 3, -3]
    case = dry_box(clone, start, 1e-3, velocity, dimension)
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    walls = "(left right bottom top)" if dimension == 2 else '(".*")'
    replace(case, GRAINS, walls, "(bottom top)")
    gravity = "(0 -9.81 0)" if dimension == 2 else "(0 0 -9.81)"
    replace(case, "constant/g", gravity, "(0 0 0)")
    add_outlet(case, "type box; box (0.098 0.04 0) (0.099 0.1 0.1);")
    control(case, deltaT=5e-3, endTime=5e-3, writeInterval=1)
    case.run("dryGrainFoam")
    # The lowest flies below it; of the others one meets the box, one its image at -1 mm
    np.testing.assert_array_equal(case.grains()["id"], [0])


def test_grain_that_turns_back_above_a_box_stays(clone):
    """It bounces off a floor: the way of the step does not reach the box below."""
    case = dry_box(clone, [(0.05, 0.03)], 0.005, [(0, -3.0)], 2)
    replace(case, GRAINS, "friction    0.2;", "friction 0.2; restitution 0.9;")
    floor = "type plane; point (0 0.02 0); normal (0 1 0); material steel;"
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    floor {{ {floor} }}\n")
    add_outlet(case, "type box; box (0 0 0) (0.1 0.02 0.01);")
    control(case, deltaT=5e-3, endTime=5e-3, writeInterval=1)
    case.run("dryGrainFoam")
    assert case.grains()["velocity"][0, 1] > 2
    assert len(case.grains()["id"]) == 1


def test_restart_after_grains_have_left(clone):
    start = lattice(10, 4, 0.01, (0.005, 0.0105))
    cases = [dry_box(clone, start, 0.004, dimension=2, name=name) for name in "ab"]
    for case in cases:
        replace(case, GRAINS, "(left right bottom top)", "(left right top)")
        add_outlet(case, OUTLETS["patches"])
        control(case, endTime=0.08, writeInterval=60)
    whole, parts = cases
    control(whole, writeInterval=20)
    whole.run("dryGrainFoam")
    control(parts, endTime=0.06)
    parts.run("dryGrainFoam")
    control(parts, endTime=0.08, writeInterval=20)
    parts.run("dryGrainFoam")
    assert 0 < len(whole.grains("0.08")["id"]) < 40
    assert_same_grains(whole, parts)


@DIMENSIONS
def test_lost_grain_stops_the_run(clone, dimension):
    start = np.full(dimension, 0.05)
    start[down(dimension)] = 0.006
    case = dry_box(clone, [start], 0.004, dimension=dimension)
    open_side = "bottom" if dimension == 2 else "frontAndBack"
    names = " ".join(n for n in ("left", "right", "bottom", "top") if n != open_side)
    old = "(left right bottom top)" if dimension == 2 else '(".*")'
    replace(case, GRAINS, old, f"({names})")
    control(case, endTime=0.2, writeInterval=10)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    assert "Grain 0" in case.log
    assert "has left the mesh" in case.log
    assert "printStack" not in case.log
    # It falls 6 mm in 35 ms: complete states are there until then, and one for a look
    assert case.times[-2:] == ["0.03", "0.035"]
    assert (case.path / "0.035/grains.h5.failed").exists()


def test_table_of_a_spreadsheet_is_read(clone):
    """With a byte order mark, quotes and the line ends of Windows."""
    case = dry_box(clone, dimension=2)
    rows = '\ufeff"x","y","z","radius"\r\n0.05,0.05,0,0.004\r\n'
    (case.path / "constant/grains.csv").write_bytes(rows.encode())
    case.run("dryGrainFoam")
    assert case.grains()["radius"] == [0.004]


@DIMENSIONS
def test_contacts_take_the_energy_that_the_ledger_lacks(clone, dimension):
    """Grains fall on each other and come to rest; contactWork has what weight gives in a step.

    E(t) - E(0) = sum contactWork - dt g.(p(t) - p(0)) + n M g^2 dt^2/2, but for overlaps, which
    are taken away without work (1e-5).
    """
    spread = np.random.default_rng(2).uniform(-3e-4, 3e-4, (48, dimension))
    shape = (6, 8) if dimension == 2 else (4, 4, 3)
    places = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), -1).reshape(-1, dimension)
    case = dry_box(clone, 0.0107 * places + 0.006 + spread, RADIUS, dimension=dimension)
    dt = 5e-4
    control(case, deltaT=dt, endTime=0.5, writeInterval=10000)
    case.run("dryGrainFoam")
    book = ledger(case)
    g = np.array([0, -G, 0]) if dimension == 2 else np.array([0, 0, -G])
    momentum = np.stack([book[f"momentum_{axis}"] for axis in "xyz"], -1)
    energy = book["kineticEnergy"] + book["potentialEnergy"]
    volume = np.pi * RADIUS**2 * 0.01 if dimension == 2 else 4 / 3 * np.pi * RADIUS**3
    total = 48 * 2500 * volume
    n = np.arange(len(energy))
    work = np.concatenate([[0], np.cumsum(book["contactWork"][1:])])
    lacking = energy - energy[0] - work + dt * (momentum - momentum[0]) @ g
    lacking -= n * total * G**2 * dt**2 / 2
    lost = energy[0] - energy[-1]
    assert np.abs(lacking).max() < 1e-4 * lost
    assert (book["contactWork"] <= 1e-12 * lost).all()
