# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects of dryGrainFoam: contact problems for other solvers, walls for ParaView."""

import re
import subprocess

import h5py
import numpy as np
import pytest
from dry_box import GRAINS, G, cubic, dry_box
from grain_box import DEPTH, control, lattice, ledger, replace, tracks

RADIUS = 0.005
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


def add_function(case, kind, every=None):
    """A function object 'out', at write times or every so many steps."""
    when = f"timeStep; writeInterval {every}" if every else "writeTime"
    text = f"type {kind}; libs (\"libgrainFunctionObjects.so\"); writeControl {when};"
    replace(case, "system/controlDict", "functions\n{", f"functions\n{{\n    out {{ {text} }}\n")


def pile(dimension):
    """Rows of grains just above each other and the floor."""
    if dimension == 2:
        return lattice(8, 4, 2 * RADIUS + 1e-6, (0.012, RADIUS + 1e-6))
    return cubic(6, 6, 3, 2 * RADIUS + 1e-6, (0.02, 0.02, RADIUS + 1e-6))


def run(case, ranks):
    if ranks == 1:
        case.run("dryGrainFoam")
    else:
        case.run("decomposePar")
        case.parallel("dryGrainFoam", ranks)


@DIMENSIONS
@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=pytest.mark.parallel)])
def test_contact_problem_is_solved_by_solveContactProblem(clone, dimension, ranks):
    case = dry_box(clone, pile(dimension), RADIUS, dimension=dimension)
    add_function(case, "contactProblem", every=10)
    control(case, endTime=0.02, writeInterval=20)
    run(case, ranks)
    folder = case.path / "postProcessing/out"
    assert {p.name for p in folder.iterdir()} == {"problem_0.01.hdf5", "problem_0.02.hdf5"}

    file = folder / "problem_0.02.hdf5"
    book = ledger(case)
    with h5py.File(file) as data:
        ours = data["solution/r"][:].reshape(-1, dimension)
        assert len(ours) == book["contacts"][-1]
        assert np.count_nonzero(ours[:, 0] > 0) == book["active"][-1]
    case.run(f"solveContactProblem {file} -tolerance 1e-9 -output solved.hdf5")
    with h5py.File(case.path / "solved.hdf5") as data:
        theirs = data["solution/r"][:].reshape(-1, dimension)
        velocity = data["solution/u"][:].reshape(-1, dimension)
    mass = case.grains()["mass"][0]
    # Columns: the sum of normal impulses is fixed by the weights, 1 + ... + rows of a column each,
    # and by what the step before left of velocities, up to the tolerance over g dt^2, 1 %
    rows = len(np.unique(np.round(pile(dimension)[:, -1], 4)))
    columns = len(pile(dimension)) / rows
    total = columns * rows * (rows + 1) / 2 * mass * G * 1e-3
    for impulses in (ours, theirs):
        assert impulses[:, 0].sum() == pytest.approx(total, rel=2e-2)
    # Signorini's law, to the tolerance given
    assert theirs[:, 0].min() >= 0
    assert velocity[:, 0].min() >= -1e-8
    assert np.abs(velocity[theirs[:, 0] > 0, 0]).max() <= 1e-8


def test_contact_problem_of_grains_that_fly_is_not_there(clone):
    case = dry_box(clone, [(0.05, 0.05)], dimension=2)
    add_function(case, "contactProblem")
    control(case, endTime=0.002, writeInterval=1)
    case.run("dryGrainFoam")
    assert "out: no contacts in this step" in case.log
    assert not list((case.path / "postProcessing/out").iterdir())


def test_solveContactProblem_refuses_ranks():
    command = "mpirun --oversubscribe -np 2 solveContactProblem some.hdf5"
    done = subprocess.run(command.split(), capture_output=True, text=True, timeout=60)
    assert done.returncode != 0
    assert "start it without mpirun" in done.stderr


def polydata(file):
    """Corners (n, 3) of each cell of a legacy VTK file, and the scalars 'body'."""
    words = file.read_text().split()
    start = words.index("POINTS")
    n_points = int(words[start + 1])
    points = np.array(words[start + 3 : start + 3 + 3 * n_points], dtype=float).reshape(-1, 3)
    start = words.index("LINES" if "LINES" in words else "POLYGONS")
    n_cells, n_words = int(words[start + 1]), int(words[start + 2])
    numbers = [int(word) for word in words[start + 3 : start + 3 + n_words]]
    cells = []
    while numbers:
        count = numbers.pop(0)
        cells.append(points[numbers[:count]])
        del numbers[:count]
    start = words.index("body") + 5
    return cells, [int(word) for word in words[start : start + n_cells]]


@DIMENSIONS
def test_walls_are_drawn_where_they_are(clone, dimension):
    centre = np.full(dimension, 0.05)
    case = dry_box(clone, [centre], 0.001, dimension=dimension)
    motion = "motion { type translation; velocity (0 0.5 0); }"
    plate = f"type plane; point (0 0.01 0); normal (0 1 0); material steel; {motion}"
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    plate {{ {plate} }}\n")
    add_function(case, "wallSurfaces")
    control(case, endTime=0.02, writeInterval=10)
    case.run("dryGrainFoam")
    for time in ("0.01", "0.02"):
        cells, bodies = polydata(case.path / f"postProcessing/out/walls_{time}.vtk")
        (moving,) = (cell for cell, body in zip(cells, bodies, strict=True) if body == 0)
        np.testing.assert_allclose(moving[:, 1], 0.01 + 0.5 * float(time), atol=1e-9)
        fixed = np.concatenate([c for c, body in zip(cells, bodies, strict=True) if body == -1])
        depth = 0.1 if dimension == 3 else DEPTH / 2
        low = [0, 0, 0 if dimension == 3 else depth]
        np.testing.assert_allclose(fixed.min(axis=0), low, atol=1e-9)
        np.testing.assert_allclose(fixed.max(axis=0), [0.1, 0.1, depth], atol=1e-9)


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=pytest.mark.parallel)])
@DIMENSIONS
def test_walls_carry_what_lies_on_them(clone, dimension, ranks):
    """Force and moment of grains at rest on a plane, one of two walls."""
    place = [(0.03, RADIUS), (0.08, RADIUS)] if dimension == 2 else [(0.03, 0.06, RADIUS)]
    case = dry_box(clone, place, RADIUS, dimension=dimension)
    up = "(0 1 0)" if dimension == 2 else "(0 0 1)"
    floor = f"type plane; point (0 0 0); normal {up}; material steel;"
    box = "(left right top)" if dimension == 2 else '(".*")'
    if dimension == 2:
        replace(case, GRAINS, "(left right bottom top)", box)
    else:
        floor = floor.replace("point (0 0 0)", "point (0 0 1e-3)")
        text = (case.path / "constant/grains.csv").read_text()
        (case.path / "constant/grains.csv").write_text(text.replace("0.005,", "0.006,", 1))
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    floor {{ {floor} }}\n")
    add_function(case, "wallForces", every=1)
    origin = np.array([0.01, 0.02, 0.0])
    control(case, endTime=0.02, writeInterval=20)
    kind = "type wallForces;"
    replace(case, "system/controlDict", kind, f"{kind} origin (0.01 0.02 0);")
    run(case, ranks)

    table = case.table("postProcessing/out/0/floor.csv")
    grains = case.grains()
    weight = grains["mass"] * G
    down = "fy" if dimension == 2 else "fz"
    np.testing.assert_allclose(table["time"], np.arange(1, 21) * 1e-3, rtol=1e-9)
    # 1e-7 m in a step of 1 ms is 1e-4 m/s, 1 % of what gravity adds in it
    np.testing.assert_allclose(table[down][5:], -weight.sum(), rtol=1e-2)
    assert (table["contacts"][5:] == len(place)).all()
    position = np.full((len(place), 3), DEPTH / 2)
    position[:, :dimension] = grains["position"]
    force = np.zeros(3)
    force[dimension - 1] = -1
    moment = (np.cross(position - origin, force) * weight[:, None]).sum(axis=0)
    last = np.array([table[name][-1] for name in ("mx", "my", "mz")])
    np.testing.assert_allclose(last, moment, rtol=1e-2, atol=1e-12)
    other = case.table("postProcessing/out/0/box.csv")
    assert (other["contacts"] == 0).all()
    assert (other[down] == 0).all()


@pytest.mark.parametrize("restitution", [0.0, 0.5])
@DIMENSIONS
def test_moments_hold_the_resistance_to_rolling(clone, dimension, restitution):
    """What a wall takes of a grain that rolls on it, or hits it: angular momentum is kept."""
    axis = 2 if dimension == 2 else 1
    centre = np.array([0.03, 0.03, RADIUS]) if dimension == 3 else np.array([0.03, RADIUS, 0])
    centre[dimension - 1] += 1.05e-3 if restitution else 0
    case = dry_box(clone, [centre[:dimension]], RADIUS, dimension=dimension)
    spin = np.eye(3)[axis] * (-0.5 if dimension == 2 else 0.5) / RADIUS
    row = [*centre, RADIUS, 0.5, 0, 0, *spin]
    columns = "x,y,z,radius,vx,vy,vz,wx,wy,wz"
    values = ",".join(repr(float(value)) for value in row)
    (case.path / "constant/grains.csv").write_text(f"{columns}\n{values}\n")
    laws = f"friction 0.5; rolling 0.2; restitution {restitution};"
    replace(case, GRAINS, "friction    0.2;", laws)
    add_function(case, "wallForces", every=1)
    control(case, endTime=0.02, writeInterval=20)
    case.run("dryGrainFoam")
    table = case.table("postProcessing/out/0/box.csv")
    lines = np.vstack([[0, 0, *row[:3], *row[4:]], tracks(case)[:, :11]])
    place, velocity, turning = lines[:, 2:5], lines[:, 5:8], lines[:, 8:11]
    mass = case.grains()["mass"][0]
    inertia = (0.5 if dimension == 2 else 0.4) * mass * RADIUS**2
    gravity = -G * np.eye(3)[dimension - 1]
    gained = mass * np.cross(place[1:], np.diff(velocity, axis=0))
    gained += inertia * np.diff(turning, axis=0)
    given = (mass * np.cross(place[1:], gravity) - gained / 1e-3)[:, axis]
    taken = table["mz" if dimension == 2 else "my"]
    load = np.abs(table["fy" if dimension == 2 else "fz"])
    assert np.count_nonzero(load) == (1 if restitution else 20)
    # The place is that at the end of the step: of an impact up to 0.5 mm beyond it and
    # 0.15 mm, with half of the force, above it; the moment of rolling is that of 1 mm
    off = 0.575e-3 if restitution else 1e-9
    assert (np.abs(taken - given) <= off * load + 1e-12).all()


SPEED = 5.0
LAWS = {
    "bouncing": "type Coulomb; friction 0.2; restitution 0.6; rolling 0.05;",
    "plastic": "type Coulomb; friction 0.2;",
    # Several times their weight
    "cohesive": "type cohesive; cohesion 0.1; friction 0.2; restitution 0.6;",
}


@pytest.mark.parametrize("law", LAWS)
@DIMENSIONS
def test_walls_are_given_what_grains_lose(clone, dimension, law):
    """Forces times the step are the momentum that contacts take of the grains in it."""
    rng = np.random.default_rng(3)
    centres = pile(dimension) * 0.9 + 0.005
    velocity = rng.uniform(-SPEED, SPEED, centres.shape)
    case = dry_box(clone, centres, 0.8 * RADIUS, velocity, dimension)
    replace(case, GRAINS, "type        Coulomb;\n        friction    0.2;", LAWS[law])
    up = "(0 1 0)" if dimension == 2 else "(0 0 1)"
    motion = f"motion {{ type oscillation; direction {up}; amplitude 1e-3; frequency 20; }}"
    plate = f"type plane; point (0 0.001 0.001); normal {up}; material steel; {motion}"
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    plate {{ {plate} }}\n")
    add_function(case, "wallForces", every=1)
    control(case, deltaT=2e-3, endTime=0.1, writeInterval=50)
    case.run("dryGrainFoam")
    assert max(int(n) for n in re.findall(r"(\d+) sub-steps", case.log)) > 1
    book = ledger(case)
    walls = [case.table(f"postProcessing/out/0/{name}.csv") for name in ("plate", "box")]
    axes = "xyz"[:dimension]
    taken = 2e-3 * np.array([sum(table[f"f{a}"] for table in walls) for a in axes])
    given = np.array([book[f"impulse_{a}"] for a in axes])
    # Contacts between grains cancel; tables have 12 digits
    np.testing.assert_allclose(taken, -given, rtol=0, atol=1e-10 * np.abs(given).max())


def test_walls_that_are_none_are_refused(clone):
    case = dry_box(clone, [(0.05, 0.05)], RADIUS, dimension=2)
    add_function(case, "wallForces", every=1)
    replace(case, "system/controlDict", "type wallForces;", "type wallForces; walls (drum);")
    assert case.run("dryGrainFoam", check=False) == 1
    for fragment in ("'walls'", "value drum", "(box)"):
        assert fragment in case.log


def cloud(case, time, name):
    """Values of a field of the lagrangian output, a list for each grain."""
    text = (case.path / time / "lagrangian/grains" / name).read_text()
    body = text[text.index("// *") :].split("\n", 1)[1]
    number = r"-?\d[\d.e+-]*"
    n, bracket, values = re.search(r"(\d+)([({])([^/]*)", body).groups()
    rows = re.findall(r"\(([^()]*)\)", values) or re.findall(number, values)
    return [[float(v) for v in re.findall(number, r)] for r in rows] * (
        int(n) if bracket == "{" else 1
    )


def test_cloud_has_contacts_and_begins_at_time_0(clone):
    """A disc on another on the floor: one and two contacts, forces that balance the weight."""
    case = dry_box(clone, [(0.05, RADIUS), (0.05, 3 * RADIUS)], RADIUS, dimension=2)
    control(case, endTime=0.05, writeInterval=50, writeFormat="ascii")
    case.run("dryGrainFoam")
    assert "ExecutionTime = " in case.log
    assert "ClockTime = " in case.log
    assert cloud(case, "0", "id") == [[0], [1]]
    assert cloud(case, "0.05", "contacts") == [[2], [1]]
    force = np.array(cloud(case, "0.05", "contactForce"))
    weight = case.grains()["mass"] * G
    np.testing.assert_allclose(force[:, 1], weight, rtol=2e-2)
    case.run("foamToVTK")
    assert len(list((case.path / "VTK").rglob("lagrangian/grains/*.vtp"))) == 2
    assert not (case.path / "0/grains.h5").exists()
