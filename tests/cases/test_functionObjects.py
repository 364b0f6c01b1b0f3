# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects of dryGrainFoam: contact problems for other solvers, walls for ParaView."""

import subprocess

import h5py
import numpy as np
import pytest
from dry_box import GRAINS, G, cubic, dry_box
from grain_box import DEPTH, control, lattice, ledger, replace

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
