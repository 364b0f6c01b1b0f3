# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres of liquid that are held in a stream, 8 cells across and in a cube of 6 radii."""

import numpy as np
import pytest
from droplet_box import (
    ANTOINE,
    BOILING,
    GAS_CP,
    GAS_RHO,
    LATENT,
    droplet_table,
    make_gas,
    share_of_water,
    with_droplets,
)
from grain_box import control, replace
from heat_box import with_heat, with_psi
from sphere_box import sphere_box

PRANDTL = 0.7
CELLS = 24


def in_stream(clone, radius, speed, nu, T, fluid, psi=None, entries="", **droplet):
    """Beside the centre of cells; the stream of temperature T goes along y."""
    side = 6 * radius
    case = sphere_box(clone, n=CELLS, side=side)
    x, y, z = side / 2 + np.array([0.3, 0.1, 0.2]) * side / CELLS
    inlet = 'bottom {{ type fixedValue; value uniform {}; }} ".*" {{ type zeroGradient; }}'
    with_heat(
        case,
        T=T,
        grains=300,
        patches=inlet.format(T),
        fluid=fluid,
        empty="",
        convection="linearUpwind grad(T)",
    )
    if psi is not None:
        with_psi(case, psi, inlet.format(psi), "linearUpwind grad(psi)")
    make_gas(case, nu)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {speed} 0)")
    ends = (
        "bottom { type fixedValue; value $internalField; }"
        " top { type pressureInletOutletVelocity; value $internalField; }"
    )
    replace(case, "0/U", '".*"\n    {\n        type    noSlip;', f'{ends} ".*" {{ type slip;')
    top = "top { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", '".*"', f'{top} ".*"')
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     3")
    with_droplets(case, [(x, y)], radius, entries=f"motion fixed; {entries}", **droplet)
    table = f"x,y,z,radius\n{x},{y},{z},{radius}\n"
    (case.path / "constant/droplets.csv").write_text(table)
    return case


@pytest.mark.parametrize("Re", [10, 100])
def test_boiling_in_a_stream(clone, Re):
    """Ranz and Marshall's law with Spalding's ln(1 + B): 0.93 and 1.00 of it were measured."""
    B, radius, speed = 1.0, 1e-3, 1.0
    nu = speed * 2 * radius / Re
    kappa = GAS_RHO * GAS_CP * nu / PRANDTL
    gas = BOILING + B * LATENT / GAS_CP
    fluid = f"Cp {GAS_CP}; kappa {kappa};"
    case = in_stream(clone, radius, speed, nu, gas, fluid, density=1e9)
    dt = radius / 16 / speed
    control(case, endTime=5e-3, deltaT=dt, writeInterval=1000)
    case.run("grainDropletFoam")
    rate = droplet_table(case)["vapour"][-1] / dt
    nusselt = 2 + 0.6 * np.sqrt(Re) * PRANDTL ** (1 / 3)
    law = np.pi * 2 * radius * nusselt * kappa / GAS_CP * np.log1p(B)
    assert rate == pytest.approx(law, rel=0.1)


def test_water_in_moist_air(clone):
    """1 mm, 30 C, 3 m/s, Y 0.013135: the wet bulb of 21.76 C of MFiX's deck DEM06, where
    21.8 C was measured; Ranz and Marshall's Sherwood number, 0.99 of it.  The liquid's heat
    capacity and density, which only set the time that it takes, are less than water's."""
    radius, speed, nu, D, Y = 0.5e-3, 3.0, 1.6e-5, 2.52e-5, 0.013135
    fluid = f"Cp 1005; kappa 0.0265; vapour {{ D {D}; }}"
    case = in_stream(
        clone,
        radius,
        speed,
        nu,
        303.15,
        fluid,
        psi=Y,
        entries=ANTOINE.format(pressure=101325, temperature=303.15),
        density=70,
        liquid="Cp 20;",
        latent=2.45e6,
    )
    dt = 2e-5
    control(case, endTime=2e-3, deltaT=dt, writeInterval=10000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    T = book["temperature"][-1]
    assert T == pytest.approx(273.15 + 21.76, abs=0.3)
    surface = share_of_water(T, 101325)
    sherwood = 2 + 0.6 * np.sqrt(speed * 2 * radius / nu) * np.cbrt(nu / D)
    B = (surface - Y) / (1 - surface)
    law = np.pi * 2 * radius * GAS_RHO * D * sherwood * np.log1p(B)
    assert book["vapour"][-1] / dt == pytest.approx(law, rel=0.05)
