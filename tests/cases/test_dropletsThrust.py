# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Momentum of vapour that leaves droplets, and of liquid that accelerates with grains inside."""

import foamlib
import numpy as np
import pytest
from droplet_box import (
    BOILING,
    GAS,
    GAS_CP,
    GAS_K,
    GAS_RHO,
    LATENT,
    annulus,
    droplet_table,
    make_gas,
    open_top,
    with_droplets,
)
from grain_box import DEPTH, control, grain_box, ledger, replace
from heat_box import with_heat, write_T

WALLS = '"left|right|bottom|top"'
LIQUID_RHO = 10.0
RADIUS, OUTER = 1e-3, 4e-3
WARM, GRADIENT = 100.0, 2e4  # K per e-fold of the radius; K/m


def open_box(case):
    """Fluid crosses all sides."""
    replace(case, "0/U", "noSlip", "zeroGradient")
    replace(case, "0/p_rgh", "zeroGradient", "fixedValue; value uniform 0")
    replace(case, "constant/g", "-9.81", "0")


def vapour_of_cells(case, n_cells):
    """What comes into them [kg/s]; wrong at the sides, whose fluxes are left out."""
    mesh = case.path / "constant/polyMesh"
    owner = np.asarray(foamlib.FoamFile(mesh / "owner")[()])
    neighbour = np.asarray(foamlib.FoamFile(mesh / "neighbour")[()])
    phi = np.asarray(foamlib.FoamFieldFile(case.path / case.times[-1] / "phi").internal_field)
    out = np.bincount(owner[: len(phi)], phi, n_cells) - np.bincount(neighbour, phi, n_cells)
    return out / (1 / GAS_RHO - 1 / LIQUID_RHO)


def momentum_of_step(case, place, radius, dt):
    """Of droplet and gas at the end, and what the gas lost of it as it took the vapour to its
    cells' velocity [N s]: it would have left with the flow, which there was not yet."""
    book = droplet_table(case)
    centres = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    r = np.linalg.norm(centres - place, axis=1)
    isGas, isNear = r > radius, r < 1.7 * radius
    U = case.field("U")[:, :2]
    gas = GAS_RHO * (case.mesh().areas * DEPTH * isGas) @ U
    taken = dt * (vapour_of_cells(case, len(U)) * isGas * isNear) @ U
    return gas + taken + book["liquid"][-1] * np.array([book["vx"][-1], book["vy"][-1]])


def test_vapour_takes_the_momentum_that_the_droplet_loses(clone):
    """A box that is hot on one side; before the gas moves no momentum leaves the box, and that of
    droplet and gas together stays nil."""
    case = grain_box(clone)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    x = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    place, radius = np.array([0.051, 0.053]), 0.021
    above = np.maximum(np.linalg.norm(x - place, axis=1) - radius, 0)
    with_heat(
        case, T=BOILING + above * (3e6 * x[:, 0] + 1e6 * x[:, 1]), grains=300, fluid=GAS
    )
    # What viscosity does at the open sides would count
    make_gas(case, 1e-14)
    open_box(case)
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     20")
    text = (case.path / "system/fvSolution").read_text().replace("1e-12", "1e-16")
    (case.path / "system/fvSolution").write_text(text)
    with_droplets(case, [place], radius, density=LIQUID_RHO)
    # The heat of the first step gives vapour in the second one
    control(case, endTime=2e-3, writeInterval=2)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    thrust = 1e-3 * np.array([book["tx"][-1], book["ty"][-1]])
    assert thrust[0] < 0 and thrust[1] < 0
    assert book["vapour"][-1] > 0
    left = momentum_of_step(case, place, radius, 1e-3)
    force = 1e-3 * np.array([book["fx"][-1], book["fy"][-1]])
    # Of the force on the droplet, most of which is the pressure of gas that starts to flow, 4e-9
    assert np.linalg.norm(left) < 1e-8 * np.linalg.norm(force)
    assert np.linalg.norm(left) < 1e-4 * np.linalg.norm(thrust)


def beside_heat(clone, cells, offset, entries):
    """A droplet that is held in an annulus of gas with the exact temperature of one in a gradient,
    A ln(r/R) + G x (1 - R^2/r^2), in which vapour is too little to be felt."""
    case = clone("grainBox")
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n")
    h = 2 * RADIUS / cells
    across = round(1.6 * cells)
    annulus(case, across * h / 2, OUTER, across, round((OUTER - 1.8 * RADIUS) / h))
    place = np.array(offset) * h
    r = f"max(sqrt(sqr(pos().x() - {place[0]}) + sqr(pos().y() - {place[1]})), {RADIUS})"
    exact = (
        f"{BOILING} + {WARM}*log({r}/{RADIUS})"
        f" + {GRADIENT}*(pos().x() - {place[0]})*(1 - sqr({RADIUS}/{r}))"
    )
    side = f'outer {{ type exprFixedValue; value uniform 400; valueExpr "{exact}"; }}'
    with_heat(case, grains=300, patches=side, fluid=GAS, convection="linear")
    centres = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    d = centres - place
    far = np.maximum(np.linalg.norm(d, axis=1), RADIUS)
    T = BOILING + WARM * np.log(far / RADIUS) + GRADIENT * d[:, 0] * (1 - (RADIUS / far) ** 2)
    assert T.min() >= BOILING
    write_T(case, T, f"{side} frontAndBack {{ type empty; }}")
    make_gas(case)
    replace(case, "0/U", f"{WALLS}\n    {{\n        type    noSlip;", "outer { type zeroGradient;")
    replace(
        case,
        "0/p_rgh",
        f"{WALLS}\n    {{\n        type    zeroGradient;",
        "outer { type fixedValue; value uniform 0;",
    )
    with_droplets(
        case,
        [place],
        RADIUS,
        density=1e9,
        latent=100 * LATENT,
        entries=f"motion fixed; {entries}",
    )
    return case


@pytest.mark.parametrize("cells, near", [(8, 0.08), (16, 0.04)])
def test_heat_from_one_side_pushes_a_droplet(clone, cells, near):
    """The thrust is that of the vapour of q = k (A/R + 2 G cos t): 4 pi R (k/L)^2 A/R G/rho."""
    case = beside_heat(clone, cells, (0.3, 0.1), "")
    control(case, endTime=0.01, deltaT=1e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    exact = -4 * np.pi * WARM * (GAS_K / LATENT / 100) ** 2 * GRADIENT / GAS_RHO * DEPTH
    assert book["tx"][-1] == pytest.approx(exact, rel=near)
    assert abs(book["ty"][-1]) < 0.03 * abs(exact)


@pytest.mark.parametrize(
    "offset, most", [((0, 0), 1e-9), ((0.3, 0.1), 5e-3)], ids=["centred", "off"]
)
def test_even_blowing_pushes_nothing(clone, offset, most):
    """Wherever the heat comes from."""
    case = beside_heat(clone, 8, offset, "blowing uniform;")
    control(case, endTime=0.01, deltaT=1e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    rate = book["vapour"][-1] / 1e-3
    speed = rate / (2 * np.pi * RADIUS * DEPTH * GAS_RHO)
    assert np.hypot(book["tx"][-1], book["ty"][-1]) < most * rate * speed
    whole = 2 * np.pi * WARM * GAS_K / LATENT / 100 * DEPTH
    assert rate == pytest.approx(whole, rel=0.02)


def test_gas_at_the_surface_has_the_speed_of_the_vapour(clone):
    """Around a droplet at rest the gas flows as u r = rate/(2 pi rho) from the first cell on."""
    case = beside_heat(clone, 8, (0, 0), "blowing uniform;")
    control(case, endTime=0.05, deltaT=1e-3, writeInterval=50)
    case.run("grainDropletFoam")
    rate = droplet_table(case)["vapour"][-1] / 1e-3
    x = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    r = np.linalg.norm(x, axis=1)
    U = case.field("U")[:, :2]
    radial = np.sum(U * x, axis=1) / r
    flow = radial * r / (rate / (2 * np.pi * GAS_RHO * DEPTH))
    away = (r > 1.5 * RADIUS) & (r < 3.5 * RADIUS)
    np.testing.assert_allclose(flow[away], 1, atol=0.05)


def in_liquid(clone, density, law, mu, name=None):
    """A grain in a droplet that falls in a gas, both of one temperature."""
    case = grain_box(clone, [(0.052, 0.057)], 0.003, name=name)
    with_heat(case, T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    open_top(case)
    replace(case, "constant/grainProperties", "density 2500;", f"density {density};")
    shape = "sphere" if law == "Stokes" else "disc"
    replace(
        case,
        "constant/grainProperties",
        "DallavalleDiFelice;\n        shape   disc;",
        f"{law};\n        shape   {shape};",
    )
    with_droplets(case, [(0.05, 0.055)], 0.02, liquid=f"mu {mu};")
    text = (case.path / "constant/dropletProperties").read_text().replace("mu 2.8e-4; ", "", 1)
    (case.path / "constant/dropletProperties").write_text(text)
    return case


def test_a_grain_as_dense_as_the_liquid_goes_with_it(clone):
    """Whatever drags it: weight less buoyancy is nil, and the liquid takes it along."""
    case = in_liquid(clone, 1000, "DallavalleDiFelice", 1e-3)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    grain = case.grains()
    fallen = 0.055 - book["y"][-1]
    assert fallen > 0.008
    np.testing.assert_allclose(
        grain["velocity"][0], [book["vx"][-1], book["vy"][-1]], atol=1e-8
    )
    np.testing.assert_allclose(grain["position"][0, 1], 0.057 - fallen, atol=1e-9)
    assert ledger(case)["momentumError"].max() < 1e-10


@pytest.mark.parametrize("density", [500, 2500])
def test_a_grain_without_drag_feels_weight_and_the_liquid(clone, density):
    """v = (1 - r) g t + r u with r the ratio of the densities, step by step."""
    case = in_liquid(clone, density, "Stokes", 1e-12)
    control(case, endTime=0.02, writeInterval=20)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    r = 1000 / density
    exact = -(1 - r) * 9.81 * 0.02 + r * book["vy"][-1]
    assert case.grains()["velocity"][0, 1] == pytest.approx(exact, rel=1e-5)
    assert ledger(case)["momentumError"].max() < 1e-10
