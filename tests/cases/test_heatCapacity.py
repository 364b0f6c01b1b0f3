# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid whose heat capacity depends on its temperature keeps its enthalpy."""

import numpy as np
import pytest
from grain_box import assert_same_grains, control, grain_box, lattice, replace, run_whole_and_parts
from heat_box import fix_grains, heat_ledger, stream, with_heat

RHO, A, B = 1000.0, 200.0, 3.0
LINEAR = f"Cp polynomial (({A} 0) ({B} 1)); kappa 0.6;"
# Jumps from one to ten between 349 and 351 K
STEEP = "Cp table ((300 400) (349 400) (351 4000) (400 4000)); kappa 0.6;"
BOX = 0.1 * 0.1 * 0.01


def h(T):
    """Enthalpy of LINEAR [J/kg]."""
    return A * T + B * T**2 / 2


def h_printed(T):
    """As the ledger counts it: of the capacity at 300 K below that."""
    return h(T) - h(300) + (A + B * 300) * 300


def without_weight(case):
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))


@pytest.mark.parametrize("schemes", ["Euler", "CrankNicolson"])
def test_hot_and_cold_fluid_mix_to_the_mean_enthalpy(clone, schemes):
    """Halves of 300 and 400 K in a closed box, with a grain too small to matter."""
    case = grain_box(clone, [(0.055, 0.055)], 1e-6)
    fix_grains(case)
    T = np.where(np.arange(100) % 10 < 5, 300.0, 400.0)
    with_heat(case, T, 350, fluid=LINEAR)
    without_weight(case)
    replace(case, "system/fvSchemes", "ddtSchemes\n{", f"ddtSchemes\n{{\n    ddt(T) {schemes};")
    # In units of the time that conduction takes across the box
    unit = RHO * 1200 * 0.1**2 / 0.6
    control(case, deltaT=0.02 * unit, endTime=2 * unit, writeInterval=100)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-13
    mean = (h(300) + h(400)) / 2
    expected = (-A + np.sqrt(A**2 + 2 * B * mean)) / B
    assert abs(expected - 350) > 1
    np.testing.assert_allclose(case.field("T"), expected, atol=1e-4)


def test_stream_between_plates_gains_what_they_give(clone):
    case = grain_box(clone, [(0.055, 0.055)], 1e-6)
    fix_grains(case)
    speed = 0.01
    stream(case, speed)
    sides = '"right|bottom|top" { type zeroGradient; } left { type fixedValue; value uniform 300; }'
    plates = "HeleShaw { gap 0.01; heatTransfer 500; temperature 400; }"
    with_heat(case, 300, 350, sides, fluid=f"{LINEAR} {plates}")
    control(case, deltaT=5, endTime=1000, writeInterval=200)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-12
    came = -book["convected_left"][-1]
    gain = book["convected_right"][-1] - came
    assert book["plates"][-1] - book["conducted_left"][-1] == pytest.approx(gain, rel=1e-9)
    mass = RHO * speed * 0.1 * 0.01 * 5
    assert came == pytest.approx(mass * h_printed(300), rel=1e-12)
    # The grain bends the stream a little
    T = case.field("T").reshape(10, 10)[:, -1]
    assert T.mean() > 350
    assert gain == pytest.approx(mass * np.mean(h(T) - h(300)), rel=2e-4)


def moving(clone, fluid, name=None):
    """Grains that settle in a fluid of random temperatures."""
    case = grain_box(clone, lattice(5, 4, 0.014, (0.02, 0.02)), 0.005, name=name)
    T = np.random.default_rng(5).choice([300.0, 400.0], 100)
    with_heat(case, T, 400, fluid=fluid)
    control(case, deltaT=2e-3, endTime=0.1, writeInterval=25)
    return case


def test_temperatures_stay_in_their_range_with_a_steep_capacity(clone):
    case = moving(clone, STEEP)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-12
    assert book["grainError"].max() <= 1e-12
    assert book["leastT"].min() >= 300 - 1e-9
    assert book["mostT"].max() <= 400 + 1e-9
    total = book["fluidHeat"] + book["grainHeat"]
    np.testing.assert_allclose(np.diff(total), book["filled"][1:], atol=1e-11 * total[0])
    # It moved through the jump
    assert book["leastGrainT"].min() < 399


FILE = 'file "constant/Cp.dat"; outOfBounds clamp;'
CONSTANT = {
    "table": "Cp table ((300 1000) (400 1000));",
    "coefficients": f"Cp tableFile; CpCoeffs {{ {FILE} }}",
    "dictionary": f"Cp {{ type tableFile; {FILE} }}",
}


@pytest.mark.parametrize("form", CONSTANT)
def test_a_function_that_is_constant_is_a_number(clone, form):
    """In each form that OpenFOAM has for functions, and for checkGrains."""
    found = []
    for name, Cp in (("number", "Cp 1000;"), ("function", CONSTANT[form])):
        case = moving(clone, f"{Cp} kappa 0.6;", name)
        (case.path / "constant/Cp.dat").write_text("((300 1000) (400 1000))")
        case.run("checkGrains")
        case.run("grainThermalFoam")
        found.append((case.field("T"), case.grains()["temperature"]))
    for one, other in zip(*found, strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)


def test_restart_continues_exactly(clone):
    whole, parts = moving(clone, STEEP, "whole"), moving(clone, STEEP, "parts")
    run_whole_and_parts(whole, parts, "grainThermalFoam", 0.05, 0.1)
    assert_same_grains(whole, parts)
    np.testing.assert_array_equal(whole.field("T"), parts.field("T"))


@pytest.mark.parametrize("width, most, deltaT", [(10, 2e4, 3e5), (2, 5e4, 3e3)])
def test_a_peak_of_the_capacity_keeps_the_enthalpy(clone, width, most, deltaT):
    """As of what melts: tangents alone go to and fro about it; a half of the heat was lost."""
    case = grain_box(clone, [(0.055, 0.055)], 1e-6)
    fix_grains(case)
    peak = f"({330 - width} 1000) (330 {most}) ({330 + width} 1000)"
    fluid = f"Cp table ((200 1000) {peak} (500 1000)); kappa 0.6;"
    with_heat(case, np.where(np.arange(100) % 10 < 5, 300, 400), 350, fluid=fluid)
    without_weight(case)
    control(case, deltaT=deltaT, endTime=100 * deltaT, writeInterval=100)
    case.run("grainThermalFoam")
    assert np.abs(heat_ledger(case)["fluidError"]).max() < 1e-10
    T = case.field("T")
    assert 300 <= T.min() and T.max() <= 400
    if deltaT > 1e5:
        # Where the enthalpy is the mean of that at 300 and 400 K
        knots = [300, 320, 330, 340, 400], [1e3, 1e3, most, 1e3, 1e3]
        held = np.cumsum(np.interp(np.linspace(300, 400, 100001), *knots))
        mean = 300 + 1e-3 * np.searchsorted(held, held[-1] / 2)
        np.testing.assert_allclose(T, mean, atol=0.05)
