# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat between grains that do not touch: through the fluid between them, and by radiation."""

import numpy as np
import pytest
from dry_box import GRAINS, write_facets
from grain_box import control, grain_box, ledger, make_cyclic, replace
from heat_box import fix_grains, heat_ledger, with_heat
from test_heat import CAPACITY, COLD, DEPTH, DIMENSIONS, HOT, RADIUS, heated_box, mass

K, LENS, SIGMA, EMISSIVITY = 0.5, 0.2, 5.670374419e-8, 0.8
GREY = 1 / (2 / EMISSIVITY - 1)
SHAPE = {2: "cylinders", 3: "spheres"}
STEP = 1e-3


def box(clone, centres, dimension, near, temperatures=None, radius=RADIUS, name=None):
    """Grains at rest without weight above a hot floor."""
    case = heated_box(clone, centres, radius, dimension, name)
    text = (case.path / GRAINS).read_text()
    text = text.replace("conductivity", f"emissivity {EMISSIVITY}; conductivity")
    (case.path / GRAINS).write_text(text)
    replace(case, GRAINS, "heat {}", f"heat {{ conductance none; {near} }}")
    path = case.path / "constant/g"
    path.write_text(path.read_text().replace("-9.81", "0"))
    if temperatures is not None:
        file = case.path / "constant/grains.csv"
        header, *lines = file.read_text().splitlines()
        rows = [f"{line},{T}" for line, T in zip(lines, temperatures, strict=True)]
        file.write_text("\n".join([f"{header},temperature", *rows, ""]))
    control(case, writeInterval=50)
    return case


def through_fluid(dimension, distance, second=RADIUS):
    """Conductance by a sum over the layer of fluid; of a wall 'second' is infinite."""
    wall = np.isinf(second)
    along = distance if wall else distance / 2 + ((1 + LENS) ** 2 - 1) * RADIUS**2 / 2 / distance
    rim = np.sqrt(((1 + LENS) * RADIUS) ** 2 - along**2)
    x = np.linspace(0, rim, 200001)
    x = 0.5 * (x[1:] + x[:-1])
    layer = distance - (1 if wall else 2) * np.sqrt(RADIUS**2 - x**2)
    width = rim / 200000
    area = 2 * np.pi * x if dimension == 3 else 2 * DEPTH
    return K * np.sum(area * width / layer)


def place(*heights):
    return lambda dimension: [[*[0.05] * (dimension - 1), height] for height in heights]


@DIMENSIONS
def test_two_grains_conduct_through_the_fluid_between_them(clone, dimension):
    distance = 2.05 * RADIUS
    gas = f"throughFluid {{ type {SHAPE[dimension]}; conductivity {K}; }}"
    centres = place(0.04, 0.04 + distance)(dimension)
    case = box(clone, centres, dimension, gas, [HOT, COLD])
    case.run("dryGrainFoam")
    T = case.grains()["temperature"]
    ratio = 2 * through_fluid(dimension, distance) * STEP / (CAPACITY * mass(dimension))
    # Implicit Euler
    assert (T[0] - T[1]) / (HOT - COLD) == pytest.approx((1 + ratio) ** -50.0, rel=1e-6)
    assert T.sum() == pytest.approx(HOT + COLD, rel=1e-12)
    assert T[1] > COLD + 1


@DIMENSIONS
def test_floor_warms_a_grain_through_the_fluid(clone, dimension):
    height = 1.03 * RADIUS
    gas = f"throughFluid {{ type {SHAPE[dimension]}; conductivity {K}; }}"
    case = box(clone, place(height)(dimension), dimension, gas)
    case.run("dryGrainFoam")
    ratio = through_fluid(dimension, height, np.inf) * STEP / (CAPACITY * mass(dimension))
    T = case.grains()["temperature"][0]
    assert (HOT - T) / (HOT - COLD) == pytest.approx((1 + ratio) ** -50.0, rel=1e-6)
    book = ledger(case)
    gained = CAPACITY * mass(dimension) * (T - COLD)
    assert book["heatFrom_floor"].sum() == pytest.approx(gained, rel=1e-9)
    assert (book["heatError"] <= 1e-13).all()


@DIMENSIONS
def test_two_grains_radiate_to_each_other(clone, dimension):
    distance = 2.4 * RADIUS
    seen = 2 * np.pi * RADIUS**2 * (1 - np.sqrt(1 - (RADIUS / distance) ** 2))
    if dimension == 2:
        d = distance
        string = np.sqrt(d**2 - 4 * RADIUS**2) + 2 * RADIUS * np.arcsin(2 * RADIUS / d)
        seen = DEPTH * (string - d)
    light = f"radiation {{ type {SHAPE[dimension]}; }}"
    hot, cold = 2000.0, 300.0
    centres = place(0.04, 0.04 + distance)(dimension)
    case = box(clone, centres, dimension, light, [hot, cold])
    case.run("dryGrainFoam")
    capacity = CAPACITY * mass(dimension)
    for _ in range(50):
        h = SIGMA * seen * GREY * (hot**2 + cold**2) * (hot + cold)
        mean, half = (hot + cold) / 2, (hot - cold) / 2 / (1 + 2 * h * STEP / capacity)
        hot, cold = mean + half, mean - half
    np.testing.assert_allclose(case.grains()["temperature"], [hot, cold], rtol=1e-9)
    assert cold > 303


@DIMENSIONS
def test_light_has_a_range_of_its_own(clone, dimension):
    """Layers of fluid as thick as grains are wide let nothing beyond it."""
    light = f"radiation {{ type {SHAPE[dimension]}; range 1.1; }}"
    layer = f"throughFluid {{ type {SHAPE[dimension]}; conductivity 1e-30; lens 1; }}"
    centres = place(0.04, 0.04 + 2.6 * RADIUS)(dimension)
    case = box(clone, centres, dimension, light + layer, [600, 300])
    case.run("dryGrainFoam")
    np.testing.assert_allclose(case.grains()["temperature"], [600, 300], rtol=1e-12)


# From the line through the centres, in radii: the plate ends before or behind it, or its two
# triangles meet on it
@pytest.mark.parametrize("end", [0.5, 0.01, -0.01, -0.5])
@DIMENSIONS
def test_a_wall_between_two_grains_stops_heat_and_light(clone, dimension, end):
    distance = 2.2 * RADIUS
    near = (
        f"throughFluid {{ type {SHAPE[dimension]}; conductivity {K}; lens 0.5; }}"
        f" radiation {{ type {SHAPE[dimension]}; }}"
    )
    centres = place(0.04, 0.04 + distance)(dimension)
    case = box(clone, centres, dimension, near, [600, 300])
    add_plate(case, 0.05 + end * RADIUS, 0.04 + distance / 2, dimension)
    case.run("dryGrainFoam")
    T = case.grains()["temperature"]
    if end > 0:
        np.testing.assert_allclose(T, [600, 300], rtol=1e-12)
    else:
        assert T[1] > 301


def add_plate(case, end, height, dimension):
    """From x = 0 to an end, adiabatic, without thickness; in 3-D of two triangles."""
    if dimension == 2:
        low, high = [0, height, -0.01], [end, height, 0.02]
        corners = [low, [end, height, -0.01], high, [0, height, 0.02]]
    else:
        corners = [[0, 0, height], [end, 0, height], [end, 0.1, height], [0, 0.1, height]]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*corners[i]) for i in triangle)
        + "endloop\nendfacet\n"
        for triangle in ((0, 1, 2), (0, 2, 3))
    )
    folder = case.path / "constant/triSurface"
    folder.mkdir(exist_ok=True)
    (folder / "plate.stl").write_text(f"solid plate\n{facets}endsolid plate\n")
    plate = 'type surface; file "plate.stl"; material steel;'
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    plate {{ {plate} }}\n")


def bend_floor(case, slope, dimension):
    """The hot floor of two planes that meet below the middle, at the origin's height."""
    middle, facets = 0.05, []

    def corner(x, along):
        height = slope * abs(x - middle)
        return (x, height, along) if dimension == 2 else (x, along, height)

    for a, b in ((0, middle), (middle, 0.1)):
        square = corner(a, -0.01), corner(b, -0.01), corner(b, 0.11), corner(a, 0.11)
        facets += [square[:3], (square[0], *square[2:])]
    write_facets(case, "floor", facets)
    text = (case.path / GRAINS).read_text()
    start = text.index("type patches", text.index("floor {"))
    end = text.index(";", text.index("patches (", start)) + 1
    surface = 'type surface; file "floor.stl";'
    (case.path / GRAINS).write_text(text[:start] + surface + text[end:])


@pytest.mark.parametrize("near", ["throughFluid", "radiation"])
@DIMENSIONS
def test_floor_that_is_bent_next_to_nothing_is_one_wall(clone, dimension, near):
    """Heat taken above the joint, bent by 1e-5, over that above a flat floor of two facets."""
    entry = f"{near} {{ type {SHAPE[dimension]}; "
    entry += f"conductivity {K}; }}" if near == "throughFluid" else "}"
    gained = []
    for slope in (0, 1e-5):
        case = box(clone, place(1.03 * RADIUS)(dimension), dimension, entry, name=f"slope{slope}")
        bend_floor(case, slope, dimension)
        case.run("dryGrainFoam")
        gained.append(case.grains()["temperature"][0] - COLD)
    assert gained[1] / gained[0] == pytest.approx(1, abs=1e-3)


def test_chain_is_in_equilibrium_with_the_floor(clone):
    """Spheres that do not touch; steps so long that all are as warm as the only warm wall."""
    heights = 1.05 * RADIUS + 2.04 * RADIUS * np.arange(9)
    near = f"throughFluid {{ type spheres; conductivity {K}; }} radiation {{ type spheres; }}"
    case = box(clone, [[0.05, 0.05, z] for z in heights], 3, near)
    text = (case.path / GRAINS).read_text()
    (case.path / GRAINS).write_text(text.replace(f"heatCapacity {CAPACITY};", "heatCapacity 1e-6;"))
    case.run("dryGrainFoam")
    np.testing.assert_allclose(case.grains()["temperature"], HOT, rtol=1e-9)


def test_chain_between_walls_has_the_steady_state_of_its_resistances(clone):
    heights = 1.05 * RADIUS + 2.04 * RADIUS * np.arange(9)
    lid = float(heights[-1] + 1.05 * RADIUS)
    near = f"throughFluid {{ type spheres; conductivity {K}; }}"
    case = box(clone, [[0.05, 0.05, z] for z in heights], 3, near)
    plane = f"type plane; point (0 0 {lid!r}); normal (0 0 -1); material steel; temperature {COLD};"
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    lid {{ {plane} }}\n")
    text = (case.path / GRAINS).read_text()
    (case.path / GRAINS).write_text(text.replace(f"heatCapacity {CAPACITY};", "heatCapacity 1e-6;"))
    case.run("dryGrainFoam")
    wall = 1 / through_fluid(3, 1.05 * RADIUS, np.inf)
    pair = 1 / through_fluid(3, 2.04 * RADIUS)
    share = (wall + pair * np.arange(9)) / (2 * wall + 8 * pair)
    expected = HOT - (HOT - COLD) * share
    np.testing.assert_allclose(case.grains()["temperature"], expected, rtol=1e-6)


def test_fluid_and_near_grains_keep_their_heat(clone):
    """Fixed grains of two temperatures in air, near each other and a wall; ranges and books."""
    centres = [(0.02 + 0.0084 * i, 0.0042 + 0.0084 * j) for i in range(4) for j in range(4)]
    case = grain_box(clone, centres, 0.004)
    fix_grains(case)
    near = "throughFluid { type rowOfSpheres; conductivity 0.6; } radiation { type cylinders; }"
    material = "heatCapacity 800; emissivity 0.9;"
    with_heat(case, 300, 400, heat=f"conductance none; {near}", ofGlass=material)
    replace(case, GRAINS, "density 7800;", "density 7800; emissivity 0.9;")
    replace(case, GRAINS, "        material    steel;", "        material steel; temperature 350;")
    file = case.path / "constant/grains.csv"
    header, *lines = file.read_text().splitlines()
    rows = [f"{line},{300 + 100 * (i % 2)}" for i, line in enumerate(lines)]
    file.write_text("\n".join([f"{header},temperature", *rows, ""]))
    control(case, deltaT=10, endTime=1000, writeInterval=100)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-12
    assert book["grainError"].max() <= 1e-12
    assert book["walls"].max() > 0
    assert book["leastGrainT"].min() >= 300 - 1e-9
    assert book["mostGrainT"].max() <= 400 + 1e-9
    assert book["mostGrainT"][-1] - book["leastGrainT"][-1] < 50


def test_ledger_has_the_heat_of_each_wall(clone):
    """Steady, through a disc in a corner, as far from a hot floor as from a cold side."""
    height, step = 1.03 * RADIUS, 1e4
    case = grain_box(clone, [(height, height)], RADIUS)
    fix_grains(case)
    gas = f"throughFluid {{ type cylinders; conductivity {K}; }}"
    # Fluid that all but insulates
    with_heat(case, 300, 325, heat=f"conductance none; {gas}", fluid="Cp 1e-3; kappa 1e-12;")
    walls = "".join(
        f"    {name} {{ type patches; patches ({patch}); material steel; temperature {T}; }}\n"
        for name, patch, T in (("floor", "bottom", 350), ("side", "left", 300))
    )
    replace(case, GRAINS, "(left right bottom top)", "(right top)")
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n{walls}")
    control(case, deltaT=step, endTime=10 * step, writeInterval=10)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    passes = 0.5 * through_fluid(2, height, np.inf) * 50 * step
    assert book["heatFrom_floor"][-1] == pytest.approx(passes, rel=1e-6)
    assert book["heatFrom_side"][-1] == pytest.approx(-passes, rel=1e-6)
    np.testing.assert_allclose(
        book["walls"], book["heatFrom_floor"] + book["heatFrom_side"], atol=1e-12 * passes
    )


@pytest.mark.parametrize("reach", [3, 5])
def test_box_narrower_than_the_range_is_one_of_many(clone, reach):
    """Discs that see several images of each other, and their own, as in a box of three periods."""
    period, places = 0.1, np.array([[0.02, 0.03], [0.064, 0.05], [0.03, 0.085]])
    near = f"radiation {{ type cylinders; range {reach}; }}"
    temperatures = {}
    for periods in (1, 3):
        centres = np.concatenate([places + [i * period, 0] for i in range(periods)])
        start = periods * [2000.0, 300.0, 900.0]
        case = box(clone, centres, 2, near, start, 0.015, f"periods{periods}")
        replace(case, GRAINS, "(left right top)", "(top)")
        blocks = case.path / "system/blockMeshDict"
        blocks.write_text(blocks.read_text().replace("(0.1 ", f"({periods * period!r} "))
        make_cyclic(case, ("left", "right"))
        case.run("blockMesh")
        case.run("dryGrainFoam")
        temperatures[periods] = case.grains()["temperature"]
    np.testing.assert_allclose(temperatures[3], np.tile(temperatures[1], 3), rtol=1e-12)
    assert temperatures[1][0] < 1999
