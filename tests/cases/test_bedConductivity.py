# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What beds at rest conduct between a hot and a cold wall, over what their fluid would."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace, write_csv
from heat_box import GRAIN_CP, GRAINS, KAPPA, fix_grains, heat_ledger, with_heat, write_T
from sphere_box import sphere_box
from test_carried import set_cells
from test_heatBadInput import assert_refused

SIDE = 0.1
FLUID_TIME = 1e6 * SIDE**2 / KAPPA
BETTER = 10

# Of the fluid alone [W]
ACROSS = KAPPA * 100 * 0.01
WALLS = "left { type fixedValue; value uniform 400; } right { type fixedValue; value uniform 300; }"
BETWEEN_WALLS = f'{WALLS} "bottom|top" {{ type zeroGradient; }}'


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


def maxwell(phi, k, n=2):
    """In n dimensions."""
    return (k + n - 1 + (n - 1) * phi * (k - 1)) / (k + n - 1 - phi * (k - 1))


@pytest.mark.parametrize("k", [0.01, 10, 1000])
@pytest.mark.parametrize("cells", [5, 10, 20])
def test_a_bed_conducts_as_its_law_says_in_cells_of_a_diameter_and_more(clone, cells, k):
    centres, radius = disordered()
    law = "type Maxwell;"
    found = conductivity(bed(clone, centres, radius, cells, law, k * KAPPA), 30, 600)
    phi = len(centres) * np.pi * radius**2 / SIDE**2
    # Cells differ (fluid fractions of 0.24 to 0.79 in those of a diameter), and 1.66 to 0.91 are
    # added by grains across faces where they hand heat on
    assert found == pytest.approx(maxwell(phi, k), rel=0.07)


@pytest.mark.parametrize(("k", "cells"), [(0.01, 6), (1000, 6), (10, 12)])
def test_a_bed_of_spheres_conducts_as_its_law_says(clone, k, cells):
    radius, n = 0.0041, 10
    centres = lattice_of_spheres(n)
    case = sphere_box(clone, centres, radius, n=cells)
    fix_grains(case)
    others = '"bottom|top|back|front" { type zeroGradient; }'
    with_heat(
        case,
        350,
        350,
        f"{WALLS} {others}",
        ofGlass=f"heatCapacity {GRAIN_CP}; conductivity {k * KAPPA};",
        empty="",
    )
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ conductivity { type Maxwell; }")
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))
    found = conductivity(case, 30, 300) * ACROSS / (KAPPA * 100 * SIDE)
    phi = len(centres) * 4 / 3 * np.pi * radius**3 / SIDE**3
    # Cells differ, the more the smaller they are and the better the grains conduct
    assert found == pytest.approx(maxwell(phi, k, 3), rel=0.025)


def lattice_of_spheres(n):
    """Without order, 0.29 of a cube with radii of 4.1 mm."""
    places = (np.arange(n) + 0.5) * SIDE / n
    centres = np.array(np.meshgrid(places, places, places)).reshape(3, -1).T
    return centres + np.random.default_rng(3).uniform(-8e-4, 8e-4, centres.shape)


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


@pytest.mark.parametrize("step", [0.1, 1])
def test_a_wall_warms_a_bed_in_gas_without_fluxes_to_and_fro(clone, step):
    """Steps of 170 and 1700 times what the grains take to warm the gas between them."""
    centres, radius = disordered()
    case = bed(clone, centres, radius, 20, "type Maxwell;")
    replace(case, "constant/transportProperties", " 1000;", " 1.2;")
    set_temperatures(case)
    phi = len(centres) * np.pi * radius**2 / SIDE**2
    # Nu 2 of spheres
    deltaT = step * 2500 * GRAIN_CP * (2 * radius) ** 2 / (12 * KAPPA)
    steps = int(50 / step)
    control(case, deltaT=repr(deltaT), endTime=repr(steps * deltaT), writeInterval=steps)
    case.run("grainThermalFoam")
    ledger = heat_ledger(case)
    flux = -ledger["conducted_left"]
    capacity = phi * 2500 * GRAIN_CP + (1 - phi) * 1.2 * 1000
    time = steps * deltaT
    area = SIDE * 0.01
    exact = 2 * 100 * area * np.sqrt(maxwell(phi, BETTER) * KAPPA * capacity * time / np.pi)
    # Half-space; row of cells at the wall has less solid
    assert flux.sum() == pytest.approx(exact, rel=0.04)
    later = flux[steps // 2 :]
    # Its own bend is 5e-4 and less; 1.8 and more where grains answer a step late
    assert np.abs(np.diff(later, 2)).max() < 0.01 * later.mean()
    for name in ("leastT", "leastGrainT"):
        assert ledger[name].min() >= 300 - 1e-7
    assert ledger["mostT"].max() <= 400 + 1e-7


def set_temperatures(case):
    write_T(
        case,
        300,
        'left { type fixedValue; value uniform 400; } "right|bottom|top" { type zeroGradient; }'
        " frontAndBack { type empty; }",
    )
    replace(case, GRAINS, "temperature 350;", "temperature 300;")


WITHOUT = [GRAINS, "materials", "'conductivity'", "missing", "[1 1 -3 -1 0 0 0]"]
UNKNOWN = [GRAINS, "conductivity", "'type'", "Bruggeman", "Maxwell ZehnerSchluender"]


@pytest.mark.parametrize(
    "law, words, application",
    [
        ("type Maxwell;", WITHOUT, "grainThermalFoam"),
        ("type Bruggeman;", UNKNOWN, "grainThermalFoam"),
        ("type Bruggeman;", UNKNOWN, "checkGrains"),
    ],
)
def test_laws_and_conductivities_that_are_not_there_are_told(clone, law, words, application):
    case = bed(clone, [(0.05, 0.05)], 0.0025, 10, law, conductivity=None)
    assert_refused(case, words, application)


@pytest.mark.parametrize(
    "law, lacks", [(None, "heatCapacity"), ("type Maxwell;", "conductivity")]
)
def test_grains_to_come_have_what_heat_asks_for(clone, law, lacks):
    """Before the first step, not when they come."""
    case = bed(clone, [], 0.0025, 10, law)
    replace(case, GRAINS, "motion fixed;", "")
    pairs = "default { type Coulomb; friction 0.3; }"
    replace(case, GRAINS, "contactLaws\n{", f"contactLaws\n{{ {pairs}")
    has = {"heatCapacity": "conductivity 1;", "conductivity": "heatCapacity 800;"}[lacks]
    replace(case, GRAINS, "materials\n{", f"materials\n{{\n    clay {{ density 2000; {has} }}\n")
    where = "type box; box (0.01 0.06 0) (0.09 0.09 0.01); seed 3; numberRate 1;"
    sizes = "distribution { type constant; radius 2e-3; }"
    feed = f"feed {{ material clay; temperature 300; {where} {sizes} }}"
    file = case.path / GRAINS
    file.write_text(f"{file.read_text()}\ninjections {{ {feed} }}\n")
    assert_refused(case, [GRAINS, "clay", f"'{lacks}'", "missing"])


def test_a_solver_without_heat_refuses_the_law(clone):
    case = grain_box(clone)
    law = "conductivity { type Maxwell; }"
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ {law}")
    assert case.run("grainFoam", check=False) != 0
    for text in ("'conductivity'", "grainThermalFoam"):
        assert text in case.log
