# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vapour in the fluid, and cohesion where there is little of it."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace
from heat_box import GRAINS, with_heat, with_psi

RADIUS = 0.004


def with_vapour(case, value, law=""):
    """psi of a value, or one per cell; and a law between grain and wall."""
    with_heat(case, fluid="Cp 1000; kappa 0.6; vapour { D 1e-5; }")
    with_psi(
        case,
        value,
        '"left|right|bottom|top" { type zeroGradient; } frontAndBack { type empty; }',
    )
    if law:
        replace(case, GRAINS, "type        Coulomb;\n        friction    0.2;", law)


@pytest.mark.parametrize(("psi", "holds"), [(0.85, True), (0.95, False)])
def test_cohesion_where_there_is_little_vapour(clone, psi, holds):
    """A grain that lay on the floor is pulled off by gravity that turns, or not."""
    case = grain_box(clone, [(0.05, RADIUS)], RADIUS)
    with_vapour(case, psi, "type cohesive; friction 0.2; cohesion 1; psi0 0.9;")
    control(case, deltaT=1e-3, endTime=0.02, writeInterval=20)
    case.run("grainThermalFoam")
    replace(case, "constant/g", "-9.81", "9.81")
    control(case, endTime=0.1)
    case.run("grainThermalFoam")
    height = case.grains()["position"][0, 1]
    assert (height < 1.01 * RADIUS) == holds


def test_vapour_stays_between_none_and_all(clone):
    """Around grains that settle; what the fluid has of it is kept."""
    case = grain_box(clone, lattice(6, 5, 0.012, (0.02, 0.03)), RADIUS)
    with_vapour(case, np.random.default_rng(3).integers(0, 2, 100))
    control(case, deltaT=2e-3, endTime=0.2, writeInterval=10)
    case.run("grainThermalFoam")
    least = 1e-9
    amounts = []
    for time in case.times:
        psi = case.field("psi", time)
        assert psi.min() >= -1e-12
        assert psi.max() <= 1 + 1e-12
        amounts.append(np.sum((case.field("eps", time) + least) * psi) if time != "0" else None)
    np.testing.assert_allclose(amounts[1:], amounts[1], rtol=1e-9)


def test_vapour_around_a_resolved_grain_is_that_outside(clone):
    """Its locked cells keep what was there before it: the gas around it lets go."""
    x, y = np.meshgrid(*2 * [(np.arange(20) + 0.5) * 0.005])
    inside = np.hypot(x - 0.05, y - 0.02) < 0.015
    case = grain_box(clone, [(0.05, 0.02)], 0.02)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    law = "type cohesive; friction 0.2; cohesion 100; psi0 0.9;"
    with_vapour(case, np.where(inside, 0.2, 0.95).ravel(), law)
    replace(case, "constant/transportProperties", "D 1e-5", "D 1e-12")
    replace(case, "constant/g", "-9.81", "9.81")
    control(case, deltaT=1e-3, endTime=0.05)
    case.run("grainThermalFoam")
    assert case.grains()["position"][0, 1] > 0.0203
