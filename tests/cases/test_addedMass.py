# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Added mass and lift of grains that are small against the cells, against closed forms."""

import numpy as np
import pytest
from grain_box import (
    control,
    cyclic_box,
    grain_box,
    lattice,
    ledger,
    make_cyclic,
    replace,
    tracks,
)
from sphere_box import SIDE, sphere_box
from test_motion import PHI, RHO, RHO_GRAIN, G, gamma

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"


def couple(case, entries):
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    {entries}")


@pytest.mark.parametrize("density", [10.0, 2500.0])
@pytest.mark.parametrize("added", [0.5, 1])
def test_a_released_grain_starts_with_its_own_and_the_added_mass(clone, density, added):
    """(rho_p - rho) g / (rho_p + C rho), a grain of 1 mm in cells of 0.1 m."""
    case = grain_box(clone, [(0.45, 0.55)], 0.0005)
    replace(case, "system/blockMeshDict", "vertices", "scale 10;\n\nvertices")
    case.run("blockMesh")
    replace(case, FLUID, "1e-4", "1e-6")
    replace(case, GRAINS, "density 2500", f"density {density}")
    couple(case, f"addedMass {added};")
    inertia = density + added * RHO
    delta_t = 1e-4 * inertia / gamma(0.0, 1e-3, RHO * 1e-6)
    control(case, deltaT=delta_t, endTime=5 * delta_t, writeInterval=5, timePrecision=12)
    case.run("grainFoam")
    a = np.diff(tracks(case)[:, 6], prepend=0) / delta_t
    exact = -(density - RHO) * G / inertia
    # Drag, also as it grows with the root of the speed, and the fluid of the cell
    np.testing.assert_allclose(a, exact, rtol=5 * 3e-4 + 3 * PHI * RHO / inertia)
    assert ledger(case)["momentumError"].max() <= 1e-9


@pytest.mark.parametrize("delta", [0.1, 2])
def test_uniform_slip_relaxes_with_the_added_mass(clone, delta):
    """w' (1 + C rho s) = -gamma s w, s = 1/rho_p + phi/(eps rho): implicit, for any step."""
    radius, added = 0.004, 0.5
    phi = np.pi * radius**2 / 0.01**2
    slip, mu, steps = 1e-11, RHO * 1.0, 20
    case = cyclic_box(clone, lattice(10, 10, 0.01, (0.005, 0.005)), radius)
    couple(case, f"addedMass {added};")
    replace(case, FLUID, "1e-4", "1")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {slip} 0)")
    mobility = 1 / RHO_GRAIN + phi / ((1 - phi) * RHO)
    rate = gamma(0.0, 2 * radius, mu, 1 - phi) * mobility / (1 + added * RHO * mobility)
    delta_t = delta / rate
    control(case, deltaT=delta_t, endTime=delta_t * (steps + 0.5), timePrecision=12)
    control(case, writeInterval=steps)
    case.run("grainFoam")

    u = case.field("U")[:, 1].mean()
    v = case.grains()["velocity"][:, 1].mean()
    assert u - v == pytest.approx(slip * (1 + delta) ** -steps, rel=1e-5, abs=1e-9 * slip)
    momentum = (1 - phi) * RHO * u + phi * RHO_GRAIN * v
    assert momentum == pytest.approx((1 - phi) * RHO * slip, rel=1e-9)


def in_shear(clone, law, velocity, spin=0.0, rate=2.0, nu=1e-4):
    """A sphere of 1 mm in cells of 1 cm, u = (0, 0, rate y) between lids that move."""
    d = 1e-3
    centre = (0.05, 0.055, 0.05)
    case = sphere_box(clone, [centre], d / 2)
    make_cyclic(case, ("left", "right"), ("back", "front"))
    case.run("blockMesh")
    top = f"top {{ type fixedValue; value uniform (0 0 {rate * SIDE}); }}"
    sides = '"left|right|back|front" { type cyclic; } '
    lids = f"bottom {{ type noSlip; }} {top}"
    replace(case, "0/U", '".*"\n    {\n        type    noSlip;\n    }', sides + lids)
    replace(case, "0/p_rgh", '".*"', f'{sides} "bottom|top"')
    y = np.tile(np.repeat((np.arange(10) + 0.5) / 10 * SIDE, 10), 10)
    rows = "\n".join(f"(0 0 {float(rate * value)!r})" for value in y)
    uniform = f"nonuniform List<vector> 1000\n(\n{rows}\n)"
    replace(case, "0/U", "uniform (0 0 0)", uniform)
    replace(case, FLUID, "1e-4", str(nu))
    replace(case, GRAINS, '(".*")', "(bottom top)")
    replace(case, GRAINS, "DallavalleDiFelice;\n        shape   sphere;", "Stokes;")
    replace(case, "constant/g", "-9.81", "0")
    # The drag is known then, and what is left is the lift
    couple(case, f"undisturbedFlow {{ type none; }} lift {{ one {{ type {law}; }} }}")
    u = rate * centre[1]
    row = (*centre, d / 2, *velocity(u), spin)
    header = "x,y,z,radius,vx,vy,vz,wx"
    line = ",".join(str(float(value)) for value in row)
    (case.path / "constant/grains.csv").write_text(f"{header}\n{line}\n")
    control(case, deltaT=1e-4, endTime=1e-4, writeInterval=1)
    case.run("grainFoam")
    assert ledger(case)["momentumError"].max() <= 1e-9
    damping = 18 * RHO * nu / d**2 / RHO_GRAIN
    acceleration = (tracks(case)[0, 5:8] - np.array(row[4:7])) / 1e-4 * (1 + damping * 1e-4)
    return acceleration * RHO_GRAIN * np.pi / 6 * d**3, d


@pytest.mark.parametrize("lag", [0.02, -0.02])
def test_a_sphere_that_lags_goes_to_the_faster_fluid(clone, lag):
    nu, rate = 1e-4, 2.0
    force, d = in_shear(clone, "SaffmanMei", lambda u: (0, 0, u - lag), rate=rate, nu=nu)
    reynolds, beta = abs(lag) * d / nu, rate * d / 2 / abs(lag)
    mei = (1 - 0.3314 * beta**0.5) * np.exp(-reynolds / 10) + 0.3314 * beta**0.5
    saffman = 1.615 * RHO * (nu * rate) ** 0.5 * d**2 * lag
    # The sphere is 5e-4 of its cell
    assert force[1] == pytest.approx(saffman * mei, rel=2e-3)
    assert abs(force[0]) <= 1e-9 * abs(force[1])


def test_a_sphere_that_spins_is_driven_across_its_way(clone):
    """Spin about x, way along z at the speed of the fluid but for 0.02 m/s: force along y."""
    rate, lag, spin = 2.0, 0.02, 30.0
    force, d = in_shear(clone, "Magnus", lambda u: (0, 0, u - lag), spin=spin, rate=rate)
    # The fluid turns at half its vorticity, (rate, 0, 0) for u = (0, 0, rate y)
    exact = np.pi * (d / 2) ** 3 * RHO * lag * (spin - rate / 2)
    assert force[1] == pytest.approx(exact, rel=2e-3)
    assert abs(force[0]) <= 1e-9 * abs(force[1])


def test_light_grains_that_touch_are_not_pressed_together_in_the_first_step(clone):
    """Four vortices that draw two discs of 2 mm apart; what contacts would do in that step had but
    a part of the added mass, and they met at 0.04 m/s."""
    k, speed = 2 * np.pi / 0.1, 0.1
    case = cyclic_box(clone, [(0.08, 0.06), (0.082, 0.06)], 0.001)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    x, y = k * (np.meshgrid(np.arange(20), np.arange(20)) + np.array(0.5)) * 0.005
    u = speed * np.array([np.sin(x) * -np.cos(y), np.cos(x) * np.sin(y)])
    rows = " ".join(f"({a:.9g} {b:.9g} 0)" for a, b in u.reshape(2, -1).T)
    replace(case, "0/U", "uniform (0 0 0)", f"nonuniform List<vector> 400 ({rows})")
    replace(case, GRAINS, "density 2500", "density 1.2")
    couple(case, "addedMass 0.5;")
    control(case, deltaT=1e-3, endTime=3e-3)
    case.run("grainFoam")
    apart = np.diff(tracks(case)[:, 5].reshape(-1, 2))
    assert apart.min() > 0 and apart.max() < 0.1 * speed
