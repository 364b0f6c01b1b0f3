# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Patch fields of a droplet that a mesh is fitted to."""

import numpy as np
import pytest
from droplet_box import BOILING, GAS, GAS_CP, GAS_K, GAS_RHO, LATENT, make_gas, ring
from grain_box import control, replace
from heat_box import with_heat, with_psi, write_T

RADIUS, OUTER = 1e-3, 4e-3
DIFFUSIVITY = 2e-5
BLOWING = (
    f"type dropletBlowing; latentHeat {LATENT}; vapourDensity {GAS_RHO};"
    " value uniform (0 0 0);"
)
VAPOUR = f"type dropletVapour; D {DIFFUSIVITY}; value uniform 1;"


def distances(case):
    centres = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    return centres, np.linalg.norm(centres, axis=1)


def fitted(clone, B, blowing=BLOWING, vapour=VAPOUR):
    """Gas between a droplet and a circle on which T is given and psi is 0; both as if steady."""
    case = clone("grainBox")
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n")
    ring(case, RADIUS, OUTER, 8, 20, 3)
    a = np.log1p(B) / np.log(OUTER / RADIUS)
    _, r = distances(case)
    T = BOILING + LATENT / GAS_CP * ((r / RADIUS) ** a - 1)
    rim = float(BOILING + LATENT / GAS_CP * B)
    sides = f'"outer|right" {{ type fixedValue; value uniform {rim!r}; }}'
    sides += f" droplet {{ type fixedValue; value uniform {BOILING}; }}"
    fluid = f"{GAS} vapour {{ D {DIFFUSIVITY}; }}"
    with_heat(case, grains=300, patches=sides, fluid=fluid, convection="linear")
    write_T(case, T, f"{sides} frontAndBack {{ type empty; }}")
    make_gas(case)
    none = '"outer|right" { type fixedValue; value uniform 0; }'
    with_psi(case, 0, f"{none} droplet {{ {vapour} }} frontAndBack {{ type empty; }}", "linear")
    walls = '"left|right|bottom|top"\n    {\n        type    '
    replace(
        case,
        "0/U",
        f"{walls}noSlip;",
        f'droplet {{ {blowing} }} "outer|right" {{ type zeroGradient;',
    )
    replace(
        case,
        "0/p_rgh",
        f"{walls}zeroGradient;",
        'droplet { type fixedFluxPressure; } "outer|right" { type fixedValue; value uniform 0;',
    )
    replace(case, "system/controlDict", "functions", 'libs ("libgrainDroplets.so");\n\nfunctions')
    control(case, endTime=0.5, deltaT=2e-3, writeInterval=250)
    return case


@pytest.mark.parametrize("B", [0.14, 1.0])
@pytest.mark.parametrize("blowing", ["local", "uniform"])
def test_vapour_leaves_as_stefan_says(clone, B, blowing):
    """rho u r = k/c ln(1 + B)/ln(R_o/R), and psi = 1 - (r/R_o)^a with a = u r/D: its share at the
    surface is what flow and diffusion make of pure vapour."""
    case = fitted(clone, B, f"{BLOWING} blowing {blowing};")
    case.run("grainThermalFoam")
    x, r = distances(case)
    U = case.field("U")[:, :2]
    flow = np.sum(U * x, axis=1)
    exact = GAS_K / (GAS_CP * GAS_RHO) * np.log1p(B) / np.log(OUTER / RADIUS)
    np.testing.assert_allclose(flow, exact, rtol=0.01)
    psi = 1 - (r / OUTER) ** (exact / DIFFUSIVITY)
    np.testing.assert_allclose(case.field("psi"), psi, atol=0.01)
    T = BOILING + LATENT / GAS_CP * ((r / RADIUS) ** (np.log1p(B) / np.log(OUTER / RADIUS)) - 1)
    # The faces of the surface are chords
    np.testing.assert_allclose(case.field("T"), T, atol=0.01 * B * LATENT / GAS_CP)


BAD = {
    "latent heat": ("latentHeat 2260000.0", "latentHeat -1", "'latentHeat'"),
    "density": ("vapourDensity 1.2", "vapourDensity 0", "'vapourDensity'"),
    "blowing": ("vapourDensity", "blowing x; vapourDensity", "(local uniform)"),
    "missing": ("latentHeat 2260000.0;", "", "'latentHeat'"),
}


@pytest.mark.parametrize("old, new, said", BAD.values(), ids=BAD)
def test_bad_input_is_named(clone, old, new, said):
    case = fitted(clone, 1.0)
    replace(case, "0/U", old, new)
    case.run("grainThermalFoam", check=False)
    assert said in case.log
    assert "Time = " not in case.log


@pytest.mark.parametrize("D, said", [("-1", "'D'"), ("x", "'D'")])
def test_a_bad_diffusivity_is_named(clone, D, said):
    case = fitted(clone, 1.0, vapour=f"type dropletVapour; D {D}; value uniform 1;")
    case.run("grainThermalFoam", check=False)
    assert said in case.log
    assert "Time = " not in case.log
