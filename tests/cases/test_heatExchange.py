# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat that fluid and grains exchange, against closed forms."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, open_ends, replace
from heat_box import (
    CP,
    GRAIN_CP,
    GRAINS,
    KAPPA,
    SOLVER,
    fix_grains,
    heat_ledger,
    stream,
    with_heat,
)
from sphere_box import sphere_box

RHO, RHO_P = 1000.0, 2500.0
DEPTH = 0.01


def assert_books_close(case, tolerance=1e-12):
    book = heat_ledger(case)
    assert book["fluidError"].max() <= tolerance
    assert book["grainError"].max() <= tolerance
    return book


def settling(clone, **heat):
    centres = lattice(6, 5, 0.012, (0.02, 0.03))
    case = grain_box(clone, centres, 0.004)
    with_heat(case, **heat)
    control(case, deltaT=2e-3, endTime=0.2, writeInterval=10)
    return case


def test_closed_box_keeps_its_heat(clone):
    case = settling(clone)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    total = book["fluidHeat"] + book["grainHeat"]
    np.testing.assert_allclose(total, total[0], rtol=1e-12 * len(total))
    for name in ("leastT", "leastGrainT"):
        assert book[name].min() >= 300 - 1e-9
    for name in ("mostT", "mostGrainT"):
        assert book[name].max() <= 400 + 1e-9
    assert book["grainHeat"][-1] < book["grainHeat"][0]


def test_solverInfo_has_the_residuals_of_heat(clone):
    """Of fluid and grains together, as the log."""
    case = with_heat(grain_box(clone, [(0.05, 0.05)]))
    control(case, endTime=2e-3, writeInterval=2)
    info = 'info { type solverInfo; libs ("libutilityFunctionObjects.so"); fields (T); }'
    replace(case, "system/controlDict", "functions\n{", f"functions\n{{\n    {info}\n")
    case.run("grainThermalFoam")
    lines = (case.path / "postProcessing/info/0/solverInfo.dat").read_text().splitlines()
    residuals = [float(line.split()[2]) for line in lines[2:]]
    found = case.logged("cellsAndBodies:  Solving for T, Initial residual = ")
    assert len(found) == 2
    np.testing.assert_allclose(residuals, found, rtol=1e-10)


def test_one_temperature_stays(clone):
    case = settling(clone, T=350, grains=350)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    for name in ("leastT", "leastGrainT", "mostT", "mostGrainT"):
        np.testing.assert_allclose(book[name], 350, atol=1e-9)


def Ranz_Marshall(Re, Pr):
    return 2 + 0.6 * np.sqrt(Re) * np.cbrt(Pr)


@pytest.mark.parametrize("coarse, time", [(1, 1.8402), (2, 0.6270)])
def test_lone_hot_grain_cools_exponentially(clone, coarse, time):
    """The deck of MFiX and CFDEMcoupling, 1.84 s; in cells so large that the stream stays cold.
    The same grain as eight of half the diameter."""
    U, d, rho, mu, k, cp = 6.0, 3.6e-3, 1.1854, 1.85e-5, 0.026, 1007.0
    T_0, T_f = 373.15, 298.15
    case = sphere_box(clone, [(5000.0, 5000.0, 5000.0)], d / 2, n=4, side=1e4)
    d /= coarse
    fix_grains(case)
    stream(case, U)
    fluid = f"Cp {cp}; kappa {k};"
    replace(case, "constant/transportProperties", "1000;", f"{rho};")
    replace(case, "constant/transportProperties", "1e-4;", f"{mu / rho};")
    patches = f"left {{ type fixedValue; value uniform {T_f}; }} \".*\" {{ type zeroGradient; }}"
    law = "type RanzMarshall;"
    with_heat(case, T_f, T_0, patches, law, fluid, ofGlass="heatCapacity 55;", empty="")
    replace(case, GRAINS, "density 2500;", "density 8850;")
    case.dict_set(GRAINS, "coupling/coarseGraining", coarse)
    control(case, deltaT=0.05, endTime=5, writeInterval=100)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    Nu = Ranz_Marshall(rho * U * d / mu, mu * cp / k)
    tau = 8850 * 55 * d**2 / (6 * k * Nu)
    assert tau == pytest.approx(time, abs=1e-4)
    expected = T_f + (T_0 - T_f) * np.exp(-book["time"] / tau)
    np.testing.assert_allclose(book["meanGrainT"], expected, atol=1e-6 * (T_0 - T_f))


AIR = {"rho": 1.2, "mu": 1.8e-5, "Cp": 1000.0, "kappa": 0.025}
SPEED, SIDE, GRAIN_D, SPACING = 20.0, 0.1, 2e-3, 2.5e-3
LENGTH = 10 * SPACING


def packed_bed(clone, capacity):
    """Ten columns of fixed discs, as spheres, in a stream of air along x: one for each cell."""
    centres = lattice(10, 40, SPACING, (SPACING / 2, SPACING / 2))
    case = grain_box(clone, centres, GRAIN_D / 2)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 1 1)")
    case.run("blockMesh")
    fix_grains(case)
    stream(case, SPEED)
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    undisturbedFlow { type none; }")
    replace(case, "constant/transportProperties", "1000;", f"{AIR['rho']};")
    replace(case, "constant/transportProperties", "1e-4;", f"{AIR['mu'] / AIR['rho']};")
    with_heat(
        case,
        300,
        400,
        'left { type fixedValue; value uniform 300; } "right|bottom|top" { type zeroGradient; }',
        "type WakaoKaguei; shape sphere;",
        f"Cp {AIR['Cp']}; kappa {AIR['kappa']};",
        ofGlass=f"heatCapacity {capacity};",
        convection="limitedLinear 1",
    )
    return case


def transfer_units(length=LENGTH):
    """Number of them along a bed, and h/(rho_p c_p) of grains of heat capacity 1 [1/s]."""
    phi = np.pi * GRAIN_D**2 / 4 / SPACING**2
    Re = AIR["rho"] * SPEED * GRAIN_D / AIR["mu"]
    Pr = AIR["mu"] * AIR["Cp"] / AIR["kappa"]
    Nu = 2 + 1.1 * Re**0.6 * np.cbrt(Pr)
    h = 6 * Nu * AIR["kappa"] / GRAIN_D**2
    return h * phi * length / (AIR["rho"] * AIR["Cp"] * SPEED), h / RHO_P


def test_bed_of_given_temperature(clone):
    """Outlet 1 - exp(-NTU), as the grains' heat capacity is so large that they stay hot."""
    case = packed_bed(clone, capacity=1e9)
    control(case, deltaT=2e-4, endTime=0.04, writeInterval=200)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    outlet = book["convected_right"][-1] / (AIR["rho"] * AIR["Cp"] * SPEED * SIDE * DEPTH * 2e-4)
    NTU, _ = transfer_units()
    assert 2 < NTU < 3
    assert (outlet - 300) / 100 == pytest.approx(1 - np.exp(-NTU), rel=0.01)


def test_heavy_grains_do_not_end_the_solution_early(clone):
    """What linear solvers compare residuals with is not the heat that grains hold."""
    case = packed_bed(clone, capacity=1e12)
    replace(case, "system/fvSolution", SOLVER, SOLVER.replace("1e-15", "1e-10"))
    control(case, deltaT=2e-4, endTime=2e-3, writeInterval=10)
    case.run("grainThermalFoam")
    book = assert_books_close(case, 1e-8)
    assert book["exchanged"].max() < -1e-2 * book["fluidHeat"][0]


def Schumann(x, y):
    """1 - exp(-y) int_0^x exp(-t) I_0(2 sqrt(y t)) dt, by the trapezoidal rule."""
    t = np.linspace(0, np.sqrt(x), 401) ** 2
    root = 2 * np.sqrt(y * t)
    f = np.exp(-y - t) * np.i0(root)
    return 1 - np.sum(0.5 * (f[1:] + f[:-1]) * np.diff(t))


def test_break_through_of_a_bed(clone):
    """A step at the inlet of a bed: Schumann (1929), within 2 % of the step."""
    capacity = 100.0
    case = packed_bed(clone, capacity)
    NTU, rate = transfer_units()
    rate /= capacity
    end = 6 / rate
    steps = 800
    control(case, deltaT=end / steps, endTime=end, writeInterval=steps)
    case.run("grainThermalFoam")
    book = assert_books_close(case)
    per_time = AIR["rho"] * AIR["Cp"] * SPEED * SIDE * DEPTH * end / steps
    outlet = (book["convected_right"] / per_time - 300) / 100
    phi = np.pi * GRAIN_D**2 / 4 / SPACING**2
    dwell = (LENGTH * (1 - phi) + SIDE - LENGTH) / SPEED
    expected = [
        1 - Schumann(NTU, rate * (t - dwell)) if t > dwell else np.nan for t in book["time"]
    ]
    # The closed form is of fluid that begins with the grains' temperature
    compared = book["time"] > 2 * dwell
    np.testing.assert_allclose(outlet[compared], np.array(expected)[compared], atol=0.02)
