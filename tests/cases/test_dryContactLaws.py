# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam: attraction and resistance to rolling of grains that move."""

import numpy as np
import pytest
from dry_box import GRAINS, G, dry_box, write_facets
from grain_box import DEPTH, assert_same_grains, control, ledger, replace, tracks

RADIUS = 0.004
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


def weight(dimension):
    volume = np.pi * RADIUS**2 * DEPTH if dimension == 2 else 4 / 3 * np.pi * RADIUS**3
    return 2500 * volume * G


def set_law(case, law):
    """The same for all contacts."""
    text = (case.path / GRAINS).read_text()
    begin, end = text.index("contactLaws"), text.index("walls\n{")
    laws = f"contactLaws\n{{\n    default {{ {law} }}\n}}\n\n"
    (case.path / GRAINS).write_text(text[:begin] + laws + text[end:])


def set_gravity(case, dimension, up):
    down = "(0 -9.81 0)" if dimension == 2 else "(0 0 -9.81)"
    value = np.zeros(3)
    value[dimension - 1] = up
    replace(case, "constant/g", down, "({} {} {})".format(*value))


def write_spinning(case, rows):
    """constant/grains.csv of x, y, z, vx, vy, vz, wx, wy, wz."""
    lines = ["x,y,z,vx,vy,vz,wx,wy,wz,radius"]
    lines += [",".join(repr(float(value)) for value in [*row, RADIUS]) for row in rows]
    (case.path / "constant/grains.csv").write_text("\n".join([*lines, ""]))


@pytest.mark.parametrize("spin", [10.0, 40.0])
@pytest.mark.parametrize("dt", [1e-3, 2.5e-4])
@DIMENSIONS
def test_pair_that_attracts_turns_as_one(clone, dimension, dt, spin):
    """Whatever the step, up to 0.04 rad: it goes round as often as its spin says.

    The attraction is 23 times the centrifugal force and more.
    """
    case = dry_box(clone, [(0.05,) * dimension], RADIUS, dimension=dimension)
    set_gravity(case, dimension, 0.0)
    set_law(case, "type cohesive; friction 1; cohesion 0.1;")
    half = np.array([RADIUS * (1 + 1e-4), 0, 0])
    centre = np.array([0.05, 0.05, 0.05 if dimension == 3 else DEPTH / 2])
    approach = np.array([0.01, 0, 0])   # a contact attracts once it has carried a load
    turning = np.array([0, spin * RADIUS, 0])
    rows = [(*(centre + s * half), *(s * (turning - approach)), 0, 0, spin) for s in (-1, 1)]
    write_spinning(case, rows)
    control(case, deltaT=dt, endTime=0.2, writeInterval=round(0.2 / dt))
    case.run("dryGrainFoam")
    book = ledger(case)
    assert (book["active"][2:] == 1).all()
    lines = tracks(case)
    apart = (lines[1::2] - lines[::2])[:, 2:4]
    gap = np.hypot(*apart.T) / RADIUS - 2
    # The gap beyond which there is no attraction
    assert gap.max() <= 5e-3
    angle = np.unwrap(np.arctan2(apart[:, 1], apart[:, 0]))
    # The gap takes 0.5 % of the rate at most, the first impact none
    assert angle[-1] - angle[0] == pytest.approx(spin * (0.2 - dt), rel=6e-3)
