# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""checkGrains looks at a state as its solver goes on from it."""

import re

import numpy as np
import pytest
from dry_box import GRAINS, dry_box, write_facets
from grain_box import control, grain_box, make_cyclic, open_ends, replace
from test_dryWalls import add_wall


def corners(case, label):
    """Two points that stand behind a label in the log, as six numbers."""
    line = next(line for line in case.log.splitlines() if line.startswith(label))
    return [float(number) for point in re.findall(r"\(([^)]*)\)", line) for number in point.split()]


def test_check_grains_finds_those_that_passed_a_period(clone):
    """Solvers do not wrap positions; where a grain is in the mesh is what counts."""
    velocity = [(1.15, 0), (1.15, 0)]
    case = dry_box(clone, [(0.03, 0.03), (0.08, 0.07)], 0.005, velocity, dimension=2)
    make_cyclic(case, ("left", "right"))
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    case.run("blockMesh")
    control(case, endTime=0.2, writeInterval=200)
    case.run("dryGrainFoam")
    assert (case.grains()["position"][:, 0] > 0.2).all()
    case.run("checkGrains")
    assert "Outside the mesh        0 grains" in case.log
    # 0.03 + 0.23 and 0.08 + 0.23, less two and three periods of 0.1
    box = [0.005, 0.025, 0, 0.065, 0.075, 0]
    np.testing.assert_allclose(corners(case, "Bounding box"), box, atol=1e-9)
    fraction = 2 * np.pi * 0.005**2 / (0.06 * 0.05)
    assert case.logged("Packing fraction        ") == pytest.approx(fraction, rel=1e-6)


def test_check_grains_has_walls_where_they_have_moved(clone):
    """A plate that falls faster than the grain above it, which passes the plate's first place."""
    case = dry_box(clone, [(0.05, 0.04)], 0.005, dimension=2)
    (x, y), z = (0.02, 0.08), 0.03
    write_facets(
        case,
        "plate",
        [[(x, z, 0), (y, z, 0), (y, z, 0.01)], [(x, z, 0), (y, z, 0.01), (x, z, 0.01)]],
    )
    motion = "motion { type translation; velocity (0 -2 0); }"
    add_wall(case, "plate", f'type surface; file "plate.stl"; {motion}')
    control(case, endTime=0.05)
    case.run("dryGrainFoam")
    assert case.grains()["position"][0, 1] == pytest.approx(0.0275, abs=1e-3)
    case.run("checkGrains")
    # Numbers of STL have seven digits
    ends = [0.02, -0.07, 0.005, 0.08, -0.07, 0.005]
    np.testing.assert_allclose(corners(case, "Wall plate:"), ends, atol=1e-8)
    assert "Overlaps                0, worst 0 m" in case.log
    assert "Grains OK." in case.log


def test_check_grains_takes_grains_that_stick_out_at_an_opening(clone):
    case = grain_box(clone, [(0.05, 0.05)], 0.005, velocity=[(0, 1)])
    open_ends(case, 1)
    replace(case, "0/U", "uniform (0 0 0)", "uniform (0 1 0)")
    path = case.path / GRAINS
    path.write_text(path.read_text() + "outlets { end { type patches; patches (top); } }\n")
    case.run("blockMesh")
    control(case, endTime=0.052, writeInterval=52)
    case.run("grainFoam")
    assert case.grains()["position"][0, 1] > 0.1
    case.run("checkGrains")
    assert "Outside the mesh        1 grains" in case.log
    assert "Grains OK." in case.log
