# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions of grains and fluid that are known in closed form."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, grain_box, lattice, ledger, replace, tracks

G = 9.81
RHO, RHO_GRAIN = 1000.0, 2500.0


def gamma(w, d, mu, eps=1.0):
    """Drag coefficient of a disc after Dallavalle and Di Felice [kg/m^3/s]."""
    reynolds = np.maximum(eps * RHO * w * d / mu, 1e-20)
    exponent = 2.8 - 0.65 * np.exp(-0.5 * (1.5 - np.log10(reynolds)) ** 2)
    return eps**-exponent * 2 / np.pi * (0.63 * np.sqrt(reynolds) + 4.8) ** 2 * mu / d**2


def settling_speed(d, mu):
    """Slip velocity at which drag is the reduced weight, by fixed-point iteration."""
    w = 1e-3
    for _ in range(200):
        w = 0.5 * (w + (RHO_GRAIN - RHO) * G / gamma(w, d, mu))
    return w


@pytest.fixture(params=[1e-4, 1e-5], ids=["viscous", "inertial"])
def small_grain(clone, request):
    """A grain of 1 mm in cells of 0.1 m: the fluid hardly moves."""
    case = grain_box(clone, [(0.45, 0.55)], 0.0005)
    replace(case, "system/blockMeshDict", "vertices", "scale 10;\n\nvertices")
    case.run("blockMesh")
    replace(case, "constant/transportProperties", "1e-4", str(request.param))
    case.mu = RHO * request.param
    return case


# Of the cell that holds it, the grain is the share PHI; it can speed the cell's fluid up by no
# more than PHI times its reduced weight
PHI = np.pi / 4 * 1e-3**2 / 0.1**2


@pytest.mark.parametrize("coarse", [1, 3])
def test_small_grain_settles_at_the_speed_of_the_drag_law(small_grain, coarse):
    """Of a disc that stands for nine alike."""
    small_grain.dict_set("constant/grainProperties", "coupling/coarseGraining", coarse)
    d, mu = 1e-3 / coarse, small_grain.mu
    speed = settling_speed(d, mu)
    end = 10 * RHO_GRAIN / gamma(speed, d, mu)
    control(small_grain, deltaT=end / 100, endTime=end, writeInterval=100)
    small_grain.run("grainFoam")
    fluid = PHI * (RHO_GRAIN / RHO - 1) * G * end
    v = tracks(small_grain)[-1, 6]
    # exp(-10) from the approach; the void fraction acts with a power of less than 3
    assert v == pytest.approx(-speed, abs=fluid + speed * (np.exp(-10) + 3 * PHI))
    assert fluid < 0.01 * speed


def test_small_grain_starts_with_the_analytic_acceleration(small_grain):
    d, mu = 1e-3, small_grain.mu
    damping = gamma(0.0, d, mu) / RHO_GRAIN
    delta_t = 0.001 / damping
    control(small_grain, deltaT=delta_t, endTime=delta_t, writeInterval=1)
    small_grain.run("grainFoam")
    a = tracks(small_grain)[0, 6] / delta_t
    reduced = (1 - RHO / RHO_GRAIN) * G
    # In continuous time, drag has acted for one step; the scheme has it in closed form.  The fluid
    # moves by PHI, which acts with a power of less than 3
    assert a == pytest.approx(-reduced, rel=damping * delta_t + 3 * PHI)
    assert a == pytest.approx(-reduced / (1 + damping * delta_t), rel=3 * PHI)


def test_heavy_grains_fall_freely_in_next_to_nothing(clone):
    case = grain_box(clone, [(0.031, 0.072), (0.064, 0.083)], 0.004)
    replace(case, "constant/transportProperties", "0] 1000", "0] 1e-6")
    replace(case, "constant/transportProperties", "1e-4", "1e-12")
    control(case, endTime=0.02, writeInterval=20)
    case.run("grainFoam")
    track = tracks(case)
    steps = np.repeat(np.arange(1, 21), 2)
    # The fluid's mass over the grains' is 4e-10; it moves with ten times their speed at most
    np.testing.assert_allclose(track[:, 6], -G * 1e-3 * steps, rtol=1e-8)
    np.testing.assert_allclose(track[:, 5], 0, atol=1e-8 * G * 0.02)
    fall = G * 1e-3**2 * steps * (steps + 1) / 2
    start = np.tile([0.072, 0.083], 20)
    np.testing.assert_allclose(start - track[:, 3], fall, rtol=1e-8)


@pytest.mark.parametrize("shift", [0.0, 0.0007], ids=["centred", "offCentre"])
def test_uniform_slip_relaxes_at_the_rate_of_both_inertias(clone, shift):
    """A lattice of one grain a cell in fluid of uniform velocity: w = u - v decays as exp(-l t),
    l = gamma (1/rho_p + phi/(eps rho)), in the scheme as (1 + l dt)^-n."""
    radius = 0.004
    phi = np.pi * radius**2 / 0.01**2
    slip, mu, steps = 1e-11, RHO * 1.0, 20
    case = cyclic_box(clone, lattice(10, 10, 0.01, (0.005 + shift, 0.005)), radius)
    replace(case, "constant/transportProperties", "1e-4", "1")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {slip} 0)")
    rate = gamma(0.0, 2 * radius, mu, 1 - phi) * (1 / RHO_GRAIN + phi / ((1 - phi) * RHO))
    delta_t = 0.1 / rate
    control(case, deltaT=delta_t, endTime=delta_t * (steps + 0.5), timePrecision=12)
    control(case, writeInterval=steps)
    case.run("grainFoam")

    u = case.field("U")[:, 1]
    v = case.grains()["velocity"][:, 1]
    assert np.ptp(u) <= 1e-6 * slip
    assert np.ptp(v) <= 1e-6 * slip
    # The law is linear in w up to sqrt(Re)/4 = 5e-8
    assert u.mean() - v.mean() == pytest.approx(slip * (1 + rate * delta_t) ** -steps, rel=1e-6)
    momentum = (1 - phi) * RHO * u.mean() + phi * RHO_GRAIN * v.mean()
    assert momentum == pytest.approx((1 - phi) * RHO * slip, rel=1e-9)
    assert ledger(case)["momentumError"].max() <= 1e-10


@pytest.mark.parametrize(("radius", "cells"), [(1e-4, 20), (1e-3, 10)])
def test_small_grains_keep_the_spin_of_the_fluid(clone, radius, cells):
    """Carried across the cells with a wave of shear, 0.04 and 0.2 cells large: found 0.12, 0.13 of
    the largest spin off at most, which would be noise over the radius from forces alone."""
    side, shear, drift = 0.1, 0.05, 0.05
    rng = np.random.default_rng(3)
    centres = [(0.004 + 0.004 * i, float(rng.uniform(0.001, 0.099))) for i in range(24)]
    case = cyclic_box(clone, centres, radius)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    wave = 2 * np.pi / side
    height = np.array(centres)[:, 1]
    spin = -0.5 * shear * wave * np.cos(wave * height)
    rows = "".join(
        f"{x},{y},0.005,{radius},{shear * np.sin(wave * y)},{drift},{w}\n"
        for (x, y), w in zip(centres, spin, strict=True)
    )
    (case.path / "constant/grains.csv").write_text("x,y,z,radius,vx,vy,wz\n" + rows)
    middles = np.repeat((np.arange(cells) + 0.5) * side / cells, cells)
    U = " ".join(f"({shear * np.sin(wave * y)} {drift} 0)" for y in middles)
    replace(case, "0/U", "uniform (0 0 0)", f"nonuniform List<vector> {cells**2}({U})")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, "constant/grainProperties", "density 2500", "density 1000")
    control(case, deltaT=1e-3, endTime=0.4, writeInterval=400)
    case.run("grainFoam")
    found = tracks(case)[:, 10].reshape(-1, 24)
    assert np.abs(found - spin).max() <= 0.2 * np.abs(spin).max()
