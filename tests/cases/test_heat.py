# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam with conduction of heat: exact histories, closed books, restarts, ranks."""

import csv

import numpy as np
import pytest
from dry_box import GRAINS, G, cubic, dry_box
from grain_box import (
    DEPTH,
    assert_same_grains,
    control,
    lattice,
    ledger,
    replace,
    run_whole_and_parts,
)

RADIUS = 0.005
HOT, COLD = 373.0, 293.0
# A metal soft enough and of little heat capacity: temperatures change within 50 ms
CONDUCTIVITY, CAPACITY, MODULUS, POISSON = 400.0, 2.0, 1e7, 0.3
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


def heated_box(clone, centres, radius=RADIUS, dimension=3, name=None, velocity=None):
    """A dry box whose floor is hot, other walls are adiabatic."""
    case = dry_box(clone, centres, radius, velocity, dimension, name)
    thermal = (
        f"conductivity {CONDUCTIVITY}; heatCapacity {CAPACITY}; youngsModulus {MODULUS};"
        f" poissonRatio {POISSON};"
    )
    for material, density in (("glass", 2500), ("steel", 7800)):
        old = f"{material}   {{ density {density}; }}"
        replace(case, GRAINS, old, f"{material} {{ density {density}; {thermal} }}")
    floor = "bottom" if dimension == 2 else "frontAndBack"
    others = {"left", "right", "bottom", "top", "frontAndBack"} - {floor}
    if dimension == 2:
        others.remove("frontAndBack")
    old = "(left right bottom top)" if dimension == 2 else '(".*")'
    replace(case, GRAINS, old, f"({' '.join(sorted(others))})")
    hot = f"type patches; patches ({floor}); material steel; temperature {HOT};"
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    floor {{ {hot} }}\n")
    text = (case.path / GRAINS).read_text()
    text = text.replace("initialGrains\n{", f"initialGrains\n{{\n    temperature {COLD};")
    (case.path / GRAINS).write_text(f"{text}\nheat {{}}\n")
    return case


def pile(dimension):
    """Grains that fall and come to lie on each other and on the floor, in disorder."""
    if dimension == 2:
        centres = lattice(10, 6, 2 * RADIUS, (RADIUS, RADIUS + 1e-3))
    else:
        centres = cubic(10, 10, 3, 2 * RADIUS, (RADIUS, RADIUS, RADIUS + 1e-3))
    noise = np.random.default_rng(1).uniform(-4e-4, 4e-4, centres.shape)
    return centres + noise


def mass(dimension, radius=RADIUS):
    return 2500 * (np.pi * radius**2 * DEPTH if dimension == 2 else 4 / 3 * np.pi * radius**3)


def conductance(dimension, force):
    """Of a grain and a flat wall of its material: Hertz, and the constriction of the flow."""
    modulus = MODULUS / (1 - POISSON**2) / 2
    if dimension == 3:
        return 2 * CONDUCTIVITY * np.cbrt(3 * force * RADIUS / (4 * modulus))
    half_width = np.sqrt(4 * force / DEPTH * RADIUS / (np.pi * modulus))
    half = (np.log(2 * RADIUS / half_width) + 1 / 8) / (np.pi * CONDUCTIVITY * DEPTH)
    return 1 / (2 * half)


@DIMENSIONS
def test_grain_on_a_hot_floor_warms_up_as_its_weight_lets_it(clone, dimension):
    """Implicit Euler: T = T_w - (T_w - T_0)/(1 + H dt/C)^n, H that of the weight."""
    start = np.full(dimension, 0.05)
    start[-1] = RADIUS
    case = heated_box(clone, [start], dimension=dimension)
    replace(case, GRAINS, "tolerance   1e-7", "tolerance   1e-14")
    control(case, writeInterval=10)
    case.run("dryGrainFoam")
    capacity = CAPACITY * mass(dimension)
    ratio = conductance(dimension, mass(dimension) * G) * 1e-3 / capacity
    n = np.arange(1, 51)
    exact = HOT - (HOT - COLD) / (1 + ratio) ** n
    assert exact[-1] > COLD + 20
    # Sums of weights and impulses: 1e-14 m over g dt^2 is 1e-9 of the force
    np.testing.assert_allclose(ledger(case)["heat"] / capacity, exact, rtol=1e-9)
    for time in case.times[1:]:
        index = round(float(time) / 1e-3) - 1
        assert case.grains(time)["temperature"][0] == pytest.approx(exact[index], rel=1e-9)


@DIMENSIONS
def test_books_of_heat_are_closed(clone, dimension):
    case = heated_box(clone, pile(dimension), RADIUS - 5e-4, dimension)
    case.run("dryGrainFoam")
    book = ledger(case)
    assert book["active"].max() > 50
    given = book["heatFrom_floor"]
    assert given.sum() > 1e-3 * book["heat"][0]
    # Round-off of the sum over the grains
    assert (book["heatError"] <= 1e-13).all()
    # The file has 12 digits: a difference is off by less than twice 5e-12 of the heat
    atol = 1e-11 * book["heat"][0]
    np.testing.assert_allclose(np.diff(book["heat"]), given[1:], rtol=0, atol=atol)
    grains = case.grains()
    heat = CAPACITY * (grains["mass"] * grains["temperature"]).sum()
    assert heat == pytest.approx(book["heat"][-1], rel=1e-11)
    assert grains["temperature"].min() >= COLD
    assert grains["temperature"].max() <= HOT
    assert np.ptp(grains["temperature"]) > 1


@DIMENSIONS
def test_restart_is_the_uninterrupted_run(clone, dimension):
    whole, parts = (
        heated_box(clone, pile(dimension), RADIUS - 5e-4, dimension, name) for name in "ab"
    )
    for case in (whole, parts):
        control(case, endTime=0.04, writeInterval=20)
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.02, end=0.04)
    assert np.ptp(whole.grains("0.04")["temperature"]) > 1
    assert_same_grains(whole, parts)


@pytest.mark.parallel
@DIMENSIONS
def test_ranks_agree(clone, dimension):
    one, many = (
        heated_box(clone, pile(dimension), RADIUS - 5e-4, dimension, name) for name in "ab"
    )
    for case in (one, many):
        control(case, endTime=0.04, writeInterval=20)
    one.run("dryGrainFoam")
    many.run("decomposePar")
    many.parallel("dryGrainFoam", 2)
    for name in ("position", "temperature"):
        np.testing.assert_array_equal(one.grains("0.04")[name], many.grains("0.04")[name])
    np.testing.assert_array_equal(ledger(one)["heatFrom_floor"], ledger(many)["heatFrom_floor"])


def test_contact_network_has_the_heat_of_the_last_step(clone):
    case = heated_box(clone, pile(2), RADIUS - 5e-4, 2)
    text = (case.path / "system/controlDict").read_text()
    network = "type contactNetwork; libs (\"libgrainFunctionObjects.so\"); writeControl writeTime;"
    text = text.replace("functions\n{", f"functions\n{{\n    network {{ {network} }}\n")
    (case.path / "system/controlDict").write_text(text)
    case.run("dryGrainFoam")
    file = case.path / f"postProcessing/network/contacts_{case.times[-1]}.vtk"
    words = file.read_text().split()
    count = int(words[words.index("LINES") + 1])

    def values(name):
        start = words.index(name) + 5
        return np.array(words[start : start + count], dtype=float)

    flow, second = values("heatFlow"), values("second")
    # Implicit Euler: what the floor gave is the flow at the step's end
    given = ledger(case)["heatFrom_floor"][-1]
    assert -flow[second == -1].sum() * 1e-3 == pytest.approx(given, rel=1e-8)
    assert np.abs(flow[second >= 0]).max() > 0


def test_grains_that_leave_take_their_heat_along(clone):
    case = heated_box(clone, lattice(10, 2, 0.01, (0.005, 0.0105)), 0.004, 2)
    text = (case.path / GRAINS).read_text()
    text = text.replace("(bottom)", "(top)").replace("(left right top)", "(left right)")
    text += "\noutlets\n{\n    hole { type patches; patches (bottom); }\n}\n"
    (case.path / GRAINS).write_text(text)
    control(case, endTime=0.08, writeInterval=80)
    case.run("dryGrainFoam")
    book = ledger(case)
    assert book["grains"][-1] == 0
    removed = book["removed"] * CAPACITY * mass(2, 0.004) * COLD
    np.testing.assert_allclose(book["removedHeat"], removed, rtol=1e-10)
    assert (book["heatError"] <= 1e-13).all()


def test_temperature_of_packed_grains_is_that_of_the_dictionary(clone):
    case = heated_box(clone, [(0.05, 0.05)], dimension=2)
    box = "type lattice; box (0.02 0.02 0) (0.08 0.08 0); radius 4e-3; material glass;"
    header = "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }"
    for entry, expected in (("temperature 350;", 350.0), ("", COLD)):
        (case.path / "system/packGrainsDict").write_text(f"{header}\n{box} {entry}\n")
        case.run("packGrains")
        with open(case.path / "constant/grains.csv") as file:
            assert ("temperature" in next(csv.reader(file))) == bool(entry)
        control(case, endTime=0.001, writeInterval=1)
        case.run("dryGrainFoam")
        np.testing.assert_array_equal(case.grains("0.001")["temperature"], expected)
        (case.path / "0.001/grains.h5").unlink()
        (case.path / "0.001").rename(case.path / f"seen{expected}")


def test_fluid_refuses_heat(clone):
    case = clone("grainBox")
    case.run("blockMesh")
    path = case.path / GRAINS
    thermal = "conductivity 1; heatCapacity 1; youngsModulus 1e9;"
    text = path.read_text().replace("density 2500;", f"density 2500; {thermal}")
    text = text.replace("density 7800;", f"density 7800; {thermal}")
    text = text.replace("initialGrains\n{", "initialGrains\n{\n    temperature 300;")
    path.write_text(f"{text}\nheat {{}}\n")
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n0.05,0.05,0,0.004\n")
    assert case.run("grainFoam", check=False, timeout=60) == 1
    for fragment in (GRAINS, "'heat'", "allowed: in dryGrainFoam"):
        assert fragment in case.log
