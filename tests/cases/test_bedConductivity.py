# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What beds at rest conduct between a hot and a cold wall, over what their fluid would."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace, write_csv
from heat_box import GRAIN_CP, GRAINS, KAPPA, fix_grains, heat_ledger, with_heat
from test_carried import set_cells

SIDE = 0.1
FLUID_TIME = 1e6 * SIDE**2 / KAPPA
BETTER = 10

# Of the fluid alone [W]
ACROSS = KAPPA * 100 * 0.01
BETWEEN_WALLS = (
    "left { type fixedValue; value uniform 400; } right { type fixedValue; value uniform 300; }"
    ' "bottom|top" { type zeroGradient; }'
)


def bed(clone, centres, radius, cells, law=None, conductivity=BETTER * KAPPA):
    case = grain_box(clone)
    set_cells(case, cells)
    write_csv(case, centres, radius)
    fix_grains(case)
    glass = f"heatCapacity {GRAIN_CP};"
    if conductivity:
        glass += f" conductivity {conductivity};"
    with_heat(case, 350, 350, BETWEEN_WALLS, ofGlass=glass)
    if law:
        replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ conductivity {{ {law} }}")
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))
    return case


def conductivity(case, perTime=3, steps=60):
    """Of the steady state, over the fluid's."""
    deltaT = FLUID_TIME / perTime
    control(case, deltaT=deltaT, endTime=steps * deltaT, writeInterval=steps)
    case.run("grainThermalFoam")
    ledger = heat_ledger(case)
    through = [ledger[f"conducted_{side}"][-1] for side in ("left", "right")]
    # Round-off of the heat of long steps
    np.testing.assert_allclose(-through[0], through[1], rtol=1e-7)
    return through[1] / deltaT / ACROSS


def disordered():
    """Half of the plane in discs of 5 mm."""
    centres = lattice(16, 16, SIDE / 16, (SIDE / 32, SIDE / 32))
    return centres + np.random.default_rng(3).uniform(-6e-4, 6e-4, centres.shape), 0.0025


def maxwell(phi, k):
    return (k + 1 + phi * (k - 1)) / (k + 1 - phi * (k - 1))


@pytest.mark.parametrize("k", [0.01, 10])
@pytest.mark.parametrize("cells", [5, 10, 20])
def test_a_bed_conducts_as_its_law_says_in_cells_of_a_diameter_and_more(clone, cells, k):
    centres, radius = disordered()
    law = "type Maxwell;"
    found = conductivity(bed(clone, centres, radius, cells, law, k * KAPPA), 30, 600)
    phi = len(centres) * np.pi * radius**2 / SIDE**2
    # Cells differ (fluid fractions of 0.24 to 0.79 in those of a diameter), and 1.66 to 0.91 are
    # added by grains across faces where they hand heat on
    assert found == pytest.approx(maxwell(phi, k), rel=0.05)


def test_an_even_bed_conducts_as_its_law_says(clone):
    radius = 0.0022
    centres = lattice(20, 20, SIDE / 20, (SIDE / 40, SIDE / 40))
    law = "type ZehnerSchluender; shape sphere;"
    found = conductivity(bed(clone, centres, radius, 10, law))
    phi = np.pi * radius**2 / (SIDE / 20) ** 2
    B = 1.25 * (phi / (1 - phi)) ** (10 / 9)
    y = B / BETTER
    inside = (B - y) / (1 - y) ** 2 * np.log(1 / y) - (B + 1) / 2 - (B - 1) / (1 - y)
    # What is left of 60 steps of a third of the time that heat takes
    expected = 1 - phi**0.5 + 2 * phi**0.5 / (1 - y) * inside
    assert found == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("cells", [5, 10, 20])
def test_grains_across_faces_hand_no_heat_on_from_cell_to_cell(clone, cells):
    """1.66, 1.28 and 0.91 times the fluid's conductivity, if they did."""
    centres, radius = disordered()
    found = conductivity(bed(clone, centres, radius, cells))
    # The fluid's part is 0.497; grains with their middle at a face do
    assert found == pytest.approx(0.497, rel=0.05)


@pytest.mark.parametrize("law", [None, "type Maxwell;"])
def test_what_is_steady_does_not_depend_on_the_time_step(clone, law):
    """Steps of 800, 80 and 0.8 time constants of the grains' exchange."""
    centres, radius = disordered()
    case = bed(clone, centres, radius, 10, law)
    found = [conductivity(case)]
    for perTime, steps in ((30, 100), (3000, 200)):
        deltaT = FLUID_TIME / perTime
        end = float(case.times[-1])
        control(case, deltaT=deltaT, endTime=end + steps * deltaT, writeInterval=steps)
        case.run("grainThermalFoam")
        found.append(heat_ledger(case)["conducted_right"][-1] / deltaT / ACROSS)
    assert found[1:] == pytest.approx([found[0]] * 2, rel=1e-7)


def test_materials_have_the_conductivity_that_the_law_asks_for(clone):
    case = bed(clone, [(0.05, 0.05)], 0.0025, 10, "type Maxwell;", conductivity=None)
    assert case.run("grainThermalFoam", check=False) != 0
    for text in ("grainProperties", "'conductivity'", "allowed: values > 0", "material"):
        assert text in case.log
    assert "Time = " not in case.log


def test_a_solver_without_heat_refuses_the_law(clone):
    case = grain_box(clone)
    law = "conductivity { type Maxwell; }"
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ {law}")
    assert case.run("grainFoam", check=False) != 0
    for text in ("'conductivity'", "grainThermalFoam"):
        assert text in case.log
