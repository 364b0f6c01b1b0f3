# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's conditions that ask the solver for density, gravity or a reference height."""

import numpy as np
import pytest
from foamlib import FoamFieldFile
from grain_box import control, grain_box, open_ends, replace

SPEED = 0.1
SLOW = 1e-3
GIVEN = f"type fixedValue; value uniform (0 {SPEED} 0);"
OUTLETS = {
    "totalPressure": "p0 uniform 0;",
    "uniformTotalPressure": "p0 0;",
    "prghPressure": "p uniform -981;",
    "prghTotalPressure": "p0 uniform -976;",
    "fixedMean": "meanValue 0;",
}
INLETS = {
    "volume": f"volumetricFlowRate {SPEED * 1e-3};",
    "mass": f"massFlowRate {SPEED * 1e-3 * 1000};",
}


def channel(clone, centre=(0.05, 0.03), radius=0.004):
    case = grain_box(clone, [centre], radius)
    open_ends(case, SPEED)
    case.run("blockMesh")
    control(case, endTime=0.003, writeInterval=3)
    return case


def upwards(case):
    """Flux through the top over that of the given speed."""
    U = case.field("U")[:, 1].reshape(10, 10)
    return U[-1].mean() / SPEED


@pytest.mark.parametrize("kind", OUTLETS)
def test_outlet(clone, kind):
    case = channel(clone)
    entries = f"type {kind}; {OUTLETS[kind]} value uniform 0;"
    replace(case, "0/p_rgh", "top { type fixedValue; value uniform 0; }", f"top {{ {entries} }}")
    case.run("grainFoam")
    assert upwards(case) == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize("kind", INLETS)
def test_inlet(clone, kind):
    case = channel(clone)
    entries = f"type flowRateInletVelocity; {INLETS[kind]} value uniform (0 0 0);"
    replace(case, "0/U", GIVEN, entries)
    case.run("grainFoam")
    assert upwards(case) == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize("kind", ["locked", "cutCells"])
def test_inlet_that_starts_has_its_flux_beside_a_resolved_grain(clone, kind):
    """From the first step, where the field at the start is at rest."""
    case = channel(clone, centre=(0.05, 0.05), radius=0.021)
    entries = "type uniformFixedValue; value uniform (0 0 0); uniformValue table"
    replace(case, "0/U", GIVEN, f"{entries} ((0 (0 0 0)) (1 (0 {SPEED} 0)));")
    resolved = f"resolvedGrains {{ type {kind}; }}"
    replace(case, "constant/grainProperties", "coupling\n{", f"coupling\n{{\n    {resolved}")
    control(case, deltaT=1e-3, endTime=2e-3, writeInterval=1, writeFormat="ascii")
    case.run("grainFoam")
    for time in ("0.001", "0.002"):
        flux = FoamFieldFile(case.path / time / "phi").boundary_field["bottom"].value
        np.testing.assert_allclose(flux, -SPEED * float(time) * 1e-4, rtol=1e-9)


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
@pytest.mark.parametrize("centres", [[], [(0.045, 0.055)]], ids=["alone", "grain"])
def test_fluid_is_accelerated_with_an_inlet_in_all_cells(clone, centres, scheme):
    """To and fro between frictionless walls, a grain of a fortieth of a cell in it."""
    case = grain_box(clone, centres, radius=1.25e-4)
    open_ends(case, SPEED)
    case.run("blockMesh")
    times = np.linspace(0, 0.3, 31)
    speeds = SLOW * np.sin(30 * times)
    table = " ".join(f"({t:.12g} (0 {u:.12g} 0))" for t, u in zip(times, speeds, strict=True))
    entries = f"type uniformFixedValue; value uniform (0 0 0); uniformValue table ({table});"
    replace(case, "0/U", GIVEN, entries)
    replace(case, "0/U", "top { type zeroGradient; }", f"top {{ {entries} }}")
    outlet = "top { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", outlet, "top { type zeroGradient; }")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, "system/fvSchemes", "Euler", scheme)
    control(case, deltaT=0.01, endTime=0.3, writeInterval=5)
    case.run("grainFoam")
    for time in case.times[1:]:
        speed = np.interp(float(time), times, speeds)
        # Of the grain's drag in its cell; without the pressure at the ends 0.35 there, 0.1 inside
        np.testing.assert_allclose(case.field("U", time)[:, 1], speed, atol=2e-3 * SLOW)


def test_height_of_reference_is_read(clone):
    """p and p_rgh are the same there."""
    case = channel(clone)
    replace(case, "constant/g", "(0 0 0)", "(0 -9.81 0)")
    (case.path / "constant/hRef").write_text(
        "FoamFile { version 2.0; format ascii;"
        " class uniformDimensionedScalarField; object hRef; }\n"
        "dimensions [0 1 0 0 0 0 0]; value 0.1;\n"
    )
    entries = "top { type prghPressure; p uniform 0; value uniform 0; }"
    replace(case, "0/p_rgh", "top { type fixedValue; value uniform 0; }", entries)
    case.run("grainFoam")
    p_rgh, p = case.field("p_rgh"), case.field("p")
    heights = np.repeat(np.arange(10) * 0.01 + 0.005, 10)
    np.testing.assert_allclose(p - p_rgh, 9810 * (0.1 - heights), rtol=1e-6)


def test_pressure_of_a_patch_is_that_of_its_height(clone):
    case = channel(clone)
    replace(case, "constant/g", "(0 0 0)", "(0 -9.81 0)")
    case.run("grainFoam")
    p = FoamFieldFile(case.path / case.times[-1] / "p").boundary_field["top"].value
    np.testing.assert_allclose(p, -981, rtol=1e-9)
