# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Beds that reach patches of given pressure: their drag is in all of their cells."""

import numpy as np
import pytest
from grain_box import control, lattice, ledger, replace
from test_fluidClosures import channel

GRAINS = "constant/grainProperties"
SIDE, DEPTH, MU = 0.1, 0.01, 0.1
ROWS, CELLS, PRESSURE, DELTA_T = 40, 5, 300.0, 2e-3


def bed(clone, radius):
    """Columns of discs from patch to patch, a Stokes law of spheres."""
    spacing = SIDE / ROWS
    centres = lattice(ROWS, ROWS, spacing, (spacing / 2, spacing / 2))
    case = channel(clone, centres, radius, (CELLS, 4), PRESSURE, sides="slip")
    replace(case, GRAINS, "DallavalleDiFelice", "Stokes")
    replace(case, GRAINS, "        shape   disc;", "        shape   sphere;")
    replace(case, "constant/g", "(0 0 0)", "(-9.81 0 0)")
    control(case, deltaT=DELTA_T, endTime=100 * DELTA_T, writeInterval=100)
    return case


def assert_holds_the_pressure(case, radius, bound):
    phi = ROWS**2 * np.pi * radius**2 / SIDE**2
    gamma = 18 * MU / (2 * radius) ** 2
    darcy = PRESSURE / SIDE * (1 - phi) ** 2 / (phi * gamma) * SIDE * DEPTH
    assert case.flux("right") == pytest.approx(darcy, rel=bound)
    p = case.field("p_rgh").reshape(4, CELLS)
    middles = (np.arange(CELLS) + 0.5) / CELLS
    np.testing.assert_allclose(p, np.tile(PRESSURE * (1 - middles), (4, 1)), rtol=bound)


def test_fixed_bed_between_given_pressures(clone):
    radius = 0.0009
    case = bed(clone, radius)
    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    motion fixed;")
    case.run("grainFoam")
    # What linear solvers leave; the start is over after a hundredth of the time
    assert_holds_the_pressure(case, radius, 1e-8)
    given = ledger(case)["given_x"][-1] / DELTA_T
    buoyancy = 1000 * 9.81 * ROWS**2 * np.pi * radius**2 * DEPTH
    assert given == pytest.approx(PRESSURE * SIDE * DEPTH + buoyancy, rel=1e-8)


def test_bed_that_rests_on_a_porous_bottom(clone):
    """A quarter of its weight is borne by the fluid, the rest by the wall that grains see."""
    radius = SIDE / ROWS / 2
    case = bed(clone, radius)
    replace(case, GRAINS, "(bottom top)", "(left right bottom top)")
    replace(case, GRAINS, "tolerance   1e-7", "tolerance   1e-12")
    case.run("grainFoam")
    # What contacts leave, which hold 40 grains in each column
    assert_holds_the_pressure(case, radius, 1e-4)
