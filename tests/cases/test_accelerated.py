# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid and beds that are accelerated: the cells at their surfaces (doc/theory, eq. 2.45)."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, open_ends, replace
from test_functionObjects import add_function
from test_movingMesh import accelerate
from water_box import water_box

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
    """By (m - m_w) (g + a): 0.89, 0.976 and 0.998 by one force for both cells of a face."""
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
    # Some fluid moves in the first steps, in which contacts are not known: measured 0.0006
    np.testing.assert_allclose(force[-20:].mean(), reduced * (9.81 + ACCELERATION), rtol=2e-3)


def test_water_among_large_grains_has_the_speed_of_their_floor(clone):
    """Grains give way to the gradient besides that of inertia, too: by three sweeps for it, which
    is not enough in cells that they fill, the fluid was 0.05 off after any time."""
    delta_t, steps, radius = 2.5e-4, 80, 0.004
    case = grain_box(clone, lattice(12, 3, 2 * radius, (0.001 + radius, radius)), radius)
    accelerate(case, ACCELERATION, delta_t, steps, way=(0, 1))
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, GRAINS, "tolerance   1e-7", "tolerance 1e-12")
    replace(case, GRAINS, "maxSweeps   200", "maxSweeps 3000")
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    case.run("grainFoam")
    # Most of it from the first steps, in which contacts are not known: measured 0.0015
    stream = ACCELERATION * delta_t * steps
    np.testing.assert_allclose(case.field("U")[:, 1], stream, rtol=4e-3)


def test_a_suspension_that_falls_with_its_water_through_air_is_not_torn_apart(clone):
    """By all of a cell's density for what grains gain, beside faces to air, 0.050 sideways."""

    def block(low, high):
        least, most = np.maximum(low, (0.03, 0.05)), np.minimum(high, (0.07, 0.09))
        return np.clip((most - least) / (high - low), 0, 1).prod(axis=1)

    delta_t, steps, spacing = 5e-4, 100, 2.88e-3
    places = lattice(12, 12, spacing, (0.05 - 5.5 * spacing, 0.07 - 5.5 * spacing))
    case = water_box(clone, block, places, 0.0012, (20, 20))
    replace(case, "0/U", "noSlip", "slip")
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    case.run("grainInterFoam")
    velocity = case.grains()["velocity"][:, :2] / (9.81 * delta_t * steps)
    # Air holds the surface back: measured 0.034, 0.9982 (0.034 and 0.9987 by (2.16) alone)
    assert np.abs(velocity[:, 0]).max() <= 0.042
    np.testing.assert_allclose(-velocity[:, 1].mean(), 1, atol=3e-3)


@pytest.mark.parametrize("scheme", ["Gauss linear", "Gauss linearUpwind grad(U)"])
def test_a_steady_stream_has_the_speed_of_its_flux_on_both_sides_of_a_beds_surface(clone, scheme):
    """With convection as inertia up to 0.15 of it was missing or too much there."""
    speed, n = 0.02, 40
    case = grain_box(clone, lattice(40, 16, 0.0025, (0.00125, 0.03125)), 0.001)
    open_ends(case, speed)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"(1 {n} 1)")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, "system/fvSchemes", "div(phiEps,U)   Gauss linear", f"div(phiEps,U) {scheme}")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")
    case.run("blockMesh")
    control(case, deltaT=2e-3, endTime=1, writeInterval=500)
    case.run("grainFoam")
    # Viscous stress at the surfaces is left: measured 0.0104 and 0.0028
    np.testing.assert_allclose(case.field("eps") * case.field("U")[:, 1], speed, rtol=0.015)
