# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid and beds that are accelerated: the cells at their surfaces (doc/theory, eq. 2.45)."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, open_ends, replace
from test_functionObjects import add_function
from test_movingMesh import accelerate

ACCELERATION = 5.0
STILL = "type fixedValue; value uniform (0 0.0 0)"
GRAINS = "constant/grainProperties"


def layer(clone, nu, delta_t, steps, fixed):
    """Discs of a fifth of a cell, half of rows 4 to 6 of 10, in a stream that starts."""
    case = grain_box(clone, lattice(40, 12, 0.0025, (0.00125, 0.04125)), 0.001)
    open_ends(case, 0.0)
    table = f"uniformValue table ((0 (0 0 0)) (1 (0 {ACCELERATION} 0)))"
    replace(case, "0/U", STILL, f"type uniformFixedValue; {table}")
    replace(case, "constant/transportProperties", "1e-4", nu)
    if fixed:
        replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")
    case.run("blockMesh")
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    case.run("grainFoam")
    return case


def rows(case, name):
    """Of the cells in the middle, from the inlet on."""
    return case.field(name)[:, 1].reshape(10, 10)[:, 5]


def test_a_stream_that_starts_passes_a_fixed_layer_by_its_fluid_fraction(clone):
    """By one force for both cells of a face the first and last row of the layer had 0.91 of it."""
    delta_t, steps = 1e-3, 20
    case = layer(clone, "1e-6", delta_t, steps, fixed=True)
    eps = case.field("eps").reshape(10, 10)[:, 5]
    speed = rows(case, "U") / (ACCELERATION * delta_t * steps)
    # Convection, of the first order in the cells: measured 0.017
    np.testing.assert_allclose(eps * speed, 1, atol=0.02)


def test_a_suspension_that_fluid_carries_along_is_accelerated_evenly(clone):
    """Drag holds grains to the fluid within a step; those at the surface had 1.005 of its speed."""
    delta_t, steps = 1e-3, 20
    case = layer(clone, "1e-2", delta_t, steps, fixed=False)
    velocity = case.grains()["velocity"][:, 1].reshape(40, 12)
    stream = ACCELERATION * delta_t * steps
    np.testing.assert_allclose(velocity[5:-5, 1:-1], stream, rtol=2e-3)
    np.testing.assert_allclose(rows(case, "U")[2:], stream, rtol=2e-3)


@pytest.mark.parametrize("cells", [0.2, 0.8, 1.6])
def test_heaps_press_on_a_floor_that_rises_ever_faster_as_in_more_gravity(clone, cells):
    """By (m - m_w) (g + a): 0.83, 0.978 and 0.988 by one force for both cells of a face."""
    delta_t, steps = 2.5e-4, 80
    radius = 0.005 * cells
    places = lattice(int(0.049 / radius), 3, 2 * radius, (0.001 + radius, radius))
    case = grain_box(clone, places, radius)
    accelerate(case, ACCELERATION, delta_t, steps, way=(0, 1))
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    add_function(case, "wallForces", every=1)
    case.run("grainFoam")
    force = -case.table("postProcessing/out/0/box.csv")["fy"]
    reduced = case.grains()["mass"].sum() * (1 - 1000 / 2500)
    # Where cells cut discs each in its own way some fluid moves: measured 0.0041
    np.testing.assert_allclose(force[-20:].mean(), reduced * (9.81 + ACCELERATION), rtol=5e-3)
