# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forms A and B of the equations: the same where inertia and stress of the fluid are nothing."""

import numpy as np
import pytest
from foamlib import FoamFieldFile
from grain_box import DEPTH, control, cyclic_box, grain_box, lattice, ledger, replace
from test_flowAndGrains import WALLS
from test_fluidClosures import channel
from test_functionObjects import add_function
from test_motion import RHO, RHO_GRAIN, G, gamma

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
GLASS_AND_FOAM = "glass { density 2500; } foam { density 300; }"


def set_form(case, form):
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    form {form};")


def test_a_fixed_bed_is_the_same(clone):
    """Flow through a bed of heavy grains that fills the channel but for its ends."""
    d, spacing = 0.004, 0.005
    p, u = [], []
    for form in "AB":
        bed = lattice(14, 20, spacing, (0.0175, 0.0025))
        case = channel(clone, bed, d / 2, (10, 10), 10.0, sides="slip", name=form)
        set_form(case, form)
        replace(case, GRAINS, "density 2500", "density 1e16")
        control(case, deltaT=1e-2, endTime=3, writeInterval=300)
        case.run("grainFoam")
        p.append(case.field("p_rgh").reshape(10, 10))
        u.append(case.field("U")[:, 0].reshape(10, 10))
        assert ledger(case)["momentumError"].max() <= 1e-10
    assert u[0].min() > 1e-5
    # Pressure over velocity at the middle of the bed: what its ends disturb has decayed to 1e-5
    resistance = [(x[:, 5] - x[:, 4]) / (y[:, 4] + y[:, 5]) for x, y in zip(p, u, strict=True)]
    np.testing.assert_allclose(resistance[0], resistance[1], rtol=1e-5)
    # At the ends, which add to the resistance, form B lacks inertia and stress of the fluid
    np.testing.assert_allclose(u[0][:, 4:6], u[1][:, 4:6], rtol=1e-3)


def test_a_uniform_suspension_settles_at_the_same_speed(clone):
    """v = (rho_p - rho) g eps^2 / gamma in a closed box."""
    radius, mu = 0.004, RHO * 1e-1
    eps = 1 - np.pi * radius**2 / 0.01**2
    speeds = []
    for form in "AB":
        case = grain_box(clone, lattice(10, 10, 0.01, (0.005, 0.005)), radius, name=form)
        # The filters of the undisturbed flow would reach the floor and the lid
        set_form(case, form)
        replace(case, GRAINS, "    form ", "    undisturbedFlow { type none; }\n    form ")
        replace(case, "0/U", "noSlip", "slip")
        replace(case, FLUID, "1e-4", str(mu / RHO))
        control(case, deltaT=1e-4, endTime=0.01, writeInterval=100)
        case.run("grainFoam")
        speeds.append(-case.grains()["velocity"][:, 1].reshape(10, 10)[3:7].ravel())
    speed = (RHO_GRAIN - RHO) * G * eps**2 / gamma(0.0, 2 * radius, mu, eps)
    np.testing.assert_allclose(speeds[0], speeds[1], rtol=1e-5)
    # Re^1/2 in the law; the floor is four cells away
    np.testing.assert_allclose(speeds[0], speed, rtol=1e-3)


@pytest.mark.parametrize("form", "AB")
def test_grains_of_two_densities_settle_apart_in_each_form(clone, form):
    """A heavy and a light one in each cell: w = (rho_p - rho_m) g/gamma past the fluid in form A,
    with the mixture's density; eps (rho_p - rho) g/gamma in form B: -6.07e-5 and 4.25e-5 m/s,
    -4.50e-5 and 2.68e-5 m/s.  The same for one density."""
    radius, mu = 0.0022, RHO * 1e-1
    density = np.array([2500.0, 300.0])
    phi = np.pi * radius**2 / 0.01**2
    eps = 1 - 2 * phi

    places = [lattice(10, 10, 0.01, (x, 0.005)) for x in (0.0025, 0.0075)]
    case = grain_box(clone, np.vstack(places), radius)
    table = case.path / "constant/grains.csv"
    rows = table.read_text().split()
    kinds = ["material"] + ["glass"] * 100 + ["foam"] * 100
    table.write_text("\n".join(f"{row},{kind}" for row, kind in zip(rows, kinds, strict=True)))
    replace(case, GRAINS, "glass   { density 2500; }", GLASS_AND_FOAM)
    replace(case, GRAINS, "        materials   (glass steel);\n", "")
    replace(case, GRAINS, "glassOnSteel", "default")
    replace(case, GRAINS, "    material    glass;\n", "")
    set_form(case, form)
    replace(case, GRAINS, "    form ", "    undisturbedFlow { type none; }\n    form ")
    replace(case, "0/U", "noSlip", "slip")
    replace(case, FLUID, "1e-4", str(mu / RHO))
    control(case, deltaT=1e-4, endTime=0.01, writeInterval=100)
    case.run("grainFoam")

    v = case.grains()["velocity"][:, 1].reshape(2, 10, 10)[:, 3:7]
    excess = {
        "A": density - eps * RHO - phi * density.sum(),
        "B": eps * (density - RHO),
    }[form]
    w = -excess * G / gamma(0.0, 2 * radius, mu, eps)
    # Nothing passes in the mean; Re^1/2 in the law
    exact = w - phi * w.sum()
    np.testing.assert_allclose(v, exact[:, None, None] * np.ones_like(v), rtol=5e-3)


@pytest.mark.parametrize("form", "AB")
def test_slip_without_a_pressure_gradient_shows_what_form_b_leaves_out(clone, form):
    """Fluid that drag accelerates: in form B the slip decays by 1/eps faster."""
    radius = 0.004
    phi = np.pi * radius**2 / 0.01**2
    slip, mu, steps = 1e-11, RHO * 1.0, 20
    case = cyclic_box(clone, lattice(10, 10, 0.01, (0.005, 0.005)), radius)
    set_form(case, form)
    replace(case, FLUID, "1e-4", "1")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {slip} 0)")
    rate = gamma(0.0, 2 * radius, mu, 1 - phi) * (1 / RHO_GRAIN + phi / ((1 - phi) * RHO))
    if form == "B":
        rate /= 1 - phi
    delta_t = 0.1 / rate
    control(case, deltaT=delta_t, endTime=delta_t * (steps + 0.5), timePrecision=12)
    control(case, writeInterval=steps)
    case.run("grainFoam")

    difference = case.field("U")[:, 1].mean() - case.grains()["velocity"][:, 1].mean()
    assert difference == pytest.approx(slip * (1 + rate * delta_t) ** -steps, rel=1e-6)
    assert ledger(case)["momentumError"].max() <= 1e-10


def test_floor_and_lid_carry_a_suspension_that_settles(clone):
    """p at patches has what drag adds from the cell to the wall: half a cell's at either end."""
    radius, number = 0.004, 10
    case = grain_box(clone, lattice(number, number, 0.01, (0.005, 0.005)), radius)
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    undisturbedFlow { type none; }")
    replace(case, "0/U", "noSlip", "slip")
    replace(case, FLUID, "1e-4", "0.1")
    control(case, deltaT=1e-4, endTime=0.01, writeInterval=100)
    case.run("grainFoam")
    p = FoamFieldFile(case.path / case.times[-1] / "p").boundary_field
    carried = np.mean(p["bottom"].value) - np.mean(p["top"].value)
    solid = number**2 * np.pi * radius**2 / 0.1**2
    weight = (RHO + solid * (RHO_GRAIN - RHO)) * G * 0.1
    assert carried == pytest.approx(weight, rel=1e-3)


@pytest.mark.parametrize("cells, number", [(0.2, 12), (0.6, 8)])
def test_walls_carry_weight_and_change_of_momentum_as_grains_land(clone, cells, number):
    """By p and contacts, in each step; without the force of inertia, and with the drag at the
    cell's flux, 0.10 and 0.05 of the reduced weight were wrong as a mean over 0.1 s."""
    delta_t, steps = 1e-3, 200
    radius = 0.005 * cells
    spacing = 2.6 * radius
    centres = lattice(number, number // 2, spacing, (0.05 - (number - 1) / 2 * spacing, 0.02))
    case = grain_box(clone, centres, radius)
    replace(case, "0/U", "noSlip", "slip")
    replace(case, FLUID, "1e-4", "1e-5")
    replace(case, GRAINS, "friction    0.2", "friction 0")
    add_function(case, "wallForces", every=1)
    forces = (
        'type forces; libs ("libforces.so"); patches ("left|right|bottom|top"); rho rhoInf;'
        f" rhoInf {RHO}; CofR (0 0 0); writeControl timeStep; writeInterval 1; log no;"
    )
    replace(case, "system/controlDict", "functions\n{", f"functions\n{{ ofFluid {{ {forces} }}")
    control(case, deltaT=delta_t, endTime=steps * delta_t, writeInterval=steps)
    case.run("grainFoam")
    lines = (case.path / "postProcessing/ofFluid/0/force.dat").read_text().splitlines()
    rows = [line.replace("(", "").split() for line in lines if not line.startswith("#")]
    carried = np.array([float(row[2]) for row in rows])
    carried += case.table("postProcessing/out/0/box.csv")["fy"]
    books = ledger(case)
    momentum = books["fluidMomentum_y"] + books["grainMomentum_y"]
    volume = len(centres) * np.pi * radius**2 * DEPTH
    reduced = volume * (RHO_GRAIN - RHO) * G
    weight = 0.1 * 0.1 * DEPTH * RHO * G + reduced
    error = carried + weight + np.diff(momentum, prepend=0) / delta_t
    # Of two corrections of the pressure: measured 6e-4
    assert np.abs(error[2:]).max() <= 2e-3 * reduced
