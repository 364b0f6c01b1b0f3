# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets that evaporate, move and take grains in."""

import numpy as np
import pytest
from conftest import ROOT
from droplet_box import (
    BOILING,
    DENSITY,
    DROPLETS,
    FLUID,
    GAS,
    GAS_CP,
    GAS_K,
    LATENT,
    SURFACES,
    WALLS,
    droplet_table,
    in_annulus,
    make_gas,
    open_top,
    with_droplets,
)
from grain_box import (
    DEPTH,
    control,
    grain_box,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
)
from heat_box import GRAIN_CP, heat_ledger, with_heat, with_psi
from sphere_box import sphere_box
from test_cutCells import choose
from test_parallel import decompose


@SURFACES
@pytest.mark.parametrize("B", [0.14, 1.0])
@pytest.mark.parametrize("offset", [(0, 0), (0.3, 0.1)], ids=["centred", "off"])
def test_a_droplet_at_rest_evaporates_as_stefan_says(clone, B, offset, surface):
    """2 pi k/c ln(1 + B)/ln(R_o/R) per length, 8 cells across: 0.3 to 0.7 % were measured."""
    droplet = {"entries": "motion fixed;", "density": 1e9, "surface": surface}
    case = in_annulus(clone, B, 8, offset, **droplet)
    control(case, endTime=0.4, deltaT=2e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    rate = droplet_table(case)["vapour"][-1] / 2e-3
    exact = 2 * np.pi * GAS_K * DEPTH / GAS_CP * np.log1p(B) / np.log(4)
    assert rate == pytest.approx(exact, rel=0.01)


@SURFACES
def test_a_sphere_at_rest_evaporates_as_stefan_says(clone, surface):
    """4 pi R k/c ln(1 + B), 8 cells across, with the exact temperature on the sides of a cube;
    without upwind 0.0 % were measured after 0.3 s."""
    B, radius, side, n = 1.0, 1e-3, 6e-3, 24
    case = sphere_box(clone, n=n, side=side)
    place = side / 2 + 0.3 * side / n
    r = f"mag(pos() - vector({place}, {place}, {place}))"
    rise = f"(exp({np.log1p(B) * radius}*({1 / radius} - 1/{r})) - 1)"
    exact = f"{BOILING} + {LATENT / GAS_CP}*{rise}"
    sides = f'".*" {{ type exprFixedValue; value $internalField; valueExpr "{exact}"; }}'
    with_heat(
        case, T=BOILING, grains=300, patches=sides, fluid=GAS, empty="", convection="linear"
    )
    make_gas(case)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "0/U", "type    noSlip", "type    zeroGradient")
    replace(case, "0/p_rgh", "type    zeroGradient", "type fixedValue; value uniform 0")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     3")
    droplet = {"entries": "motion fixed;", "density": 1e9, "surface": surface}
    with_droplets(case, [(place, place)], radius, **droplet)
    table = f"x,y,z,radius\n{place},{place},{place},{radius}\n"
    (case.path / "constant/droplets.csv").write_text(table)
    control(case, endTime=0.2, deltaT=2e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    rate = droplet_table(case)["vapour"][-1] / 2e-3
    assert rate == pytest.approx(4 * np.pi * radius * GAS_K / GAS_CP * np.log1p(B), rel=0.01)


def test_a_droplet_evaporates_to_the_last(clone):
    """The annulus with R(t); the last 1.5 cells by the law of a sphere at rest."""
    B, radius, outer, density = 1.0, 1e-3, 4e-3, 100
    case = in_annulus(clone, B, 8, (0, 0), density=density)

    def area(y):
        return y * (np.log(outer) - 0.5 * np.log(y) + 0.5)

    life = area(radius**2) / (2 * GAS_K / (density * GAS_CP) * np.log1p(B))
    control(case, endTime=1.05 * life, deltaT=2e-3, writeInterval=10000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    assert book["time"][-1] == pytest.approx(life, rel=0.03)
    mass = density * np.pi * radius**2 * DEPTH
    assert book["vapour"].sum() == pytest.approx(mass, rel=1e-10)
    assert case.logged("Droplets  ")[-1] == 0
    assert heat_ledger(case)["fluidError"].max() < 1e-8


def to_the_last(case, place, radius, side, empty, **box):
    """Hold a light droplet in hot gas until it is gone."""
    hot = BOILING + LATENT / GAS_CP
    sides = f'"left|right|bottom|top|back|front" {{ type fixedValue; value uniform {hot}; }}'
    with_heat(case, T=hot, grains=300, patches=sides, fluid=GAS, empty=empty)
    make_gas(case)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "0/U", "type    noSlip", "type    zeroGradient")
    replace(case, "0/p_rgh", "type    zeroGradient", "type fixedValue; value uniform 0")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    with_droplets(case, [(0, 0)], radius, density=10, entries="motion fixed; from 2;")
    row = ",".join(map(str, [*place, radius]))
    (case.path / "constant/droplets.csv").write_text(f"x,y,z,radius\n{row}\n")
    control(case, endTime=0.2, writeInterval=1000)
    case.run("grainDropletFoam")
    assert case.logged("Droplets  ")[-1] == 0
    return droplet_table(case)["vapour"].sum()


def test_a_sphere_at_a_corner_of_cells_evaporates_to_the_last(clone):
    """From 1.73 to 1.5 cells across it has the centre of none."""
    side, n = 6e-3, 12
    radius = 1.02 * side / n
    vapour = to_the_last(sphere_box(clone, n=n, side=side), 3 * [side / 2], radius, side, "")
    assert vapour == pytest.approx(10 * 4 / 3 * np.pi * radius**3, rel=1e-9)


def test_a_disc_in_slender_cells_evaporates_to_the_last(clone):
    side = 6e-3
    case = grain_box(clone)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(12 48 1)")
    replace(case, "system/blockMeshDict", "vertices", "scale 0.06; vertices")
    case.run("blockMesh")
    radius = 2.04 * side / 24
    place = [side / 2, side / 2, 3e-4]
    vapour = to_the_last(case, place, radius, side, "frontAndBack { type empty; }")
    assert vapour == pytest.approx(10 * np.pi * radius**2 * 6e-4, rel=1e-9)


@SURFACES
@pytest.mark.parametrize("density", [500, 1250, 2500])
def test_without_heat_a_droplet_moves_as_a_resolved_grain(clone, density, surface):
    place, radius = (0.048, 0.055), 0.022
    grain = with_heat(grain_box(clone, [place], radius, name="grain"), T=BOILING, grains=BOILING)
    choose(grain, surface)
    replace(grain, "constant/grainProperties", "density 2500;", f"density {density};")
    grain.run("grainThermalFoam")
    case = with_heat(grain_box(clone, name="droplet"), T=BOILING, grains=BOILING)
    with_droplets(case, [place], radius, density=density, surface=surface)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    fallen = np.array([book["x"][-1], book["y"][-1]]) - place
    # The droplet's file has twelve digits, and its mass is that of the volume in the mesh; in cut
    # cells what flows out of them is another difference of the same first order
    tolerance = {"locked": (1e-6, 1e-9), "cutCells": (2e-5, 5e-8)}[surface]
    moved = grain.grains()["position"][0] - place
    np.testing.assert_allclose(fallen, moved, rtol=tolerance[0], atol=tolerance[1])
    assert np.abs(book["vapour"]).max() < 1e-12


@SURFACES
def test_a_droplet_that_goes_with_a_stream_leaves_it_uniform(clone, surface):
    speed = 0.1
    case = grain_box(clone)
    open_ends(case, speed)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {speed} 0)")
    case.run("blockMesh")
    with_heat(case, T=BOILING, grains=BOILING)
    droplet = {"velocity": [(0, speed)], "density": 2000, "surface": surface}
    with_droplets(case, [(0.048, 0.045)], 0.022, **droplet)
    case.run("grainDropletFoam")
    U = case.field("U")
    np.testing.assert_allclose(U[:, 1], speed, rtol=1e-9)
    np.testing.assert_allclose(U[:, 0], 0, atol=1e-9 * speed)
    np.testing.assert_allclose(case.field("T"), BOILING, rtol=1e-9)


@pytest.mark.parametrize("cells_per_step, mean", [(0.05, 0.01), (0.2, 0.025)])
def test_evaporation_in_a_frame_that_moves(clone, cells_per_step, mean):
    """A droplet and hot gas that move together against both at rest, 8 cells across: 0.0 and
    1.9 % more evaporates, as what cells hold when they change sides changes its temperature."""
    radius, dt = 1e-3, 1e-3
    h = radius / 4
    rates = []
    for speed in (0.0, cells_per_step * h / dt):
        case = grain_box(clone, name=f"at{speed:g}")
        file = case.path / "system/blockMeshDict"
        mesh = file.read_text().replace("vertices", "scale 0.1; vertices")
        mesh = mesh.replace("(10 10 1)", "(40 64 1)").replace("0.01)", "0.1)")
        mesh = mesh.replace("(0   0.1 ", "(0 0.16 ").replace("(0.1 0.1 ", "(0.1 0.16 ")
        file.write_text(mesh)
        open_ends(case, speed)
        replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {speed} 0)")
        case.run("blockMesh")
        hot = BOILING + 0.14 * LATENT / GAS_CP
        inlet = f"type inletOutlet; inletValue uniform {hot}; value uniform {hot};"
        patches = f'bottom {{ {inlet} }} "left|right|top" {{ type zeroGradient; }}'
        with_heat(case, T=hot, grains=300, patches=patches, fluid=GAS, convection="linear")
        make_gas(case)
        with_droplets(case, [(5e-3 + 0.1 * h, 4.5e-3)], radius, velocity=[(0, speed)])
        control(case, deltaT=dt, endTime=60 * dt, writeInterval=1000)
        case.run("grainDropletFoam")
        rates.append(droplet_table(case)["vapour"][5:])
    assert np.mean(rates[1] / rates[0]) == pytest.approx(1, abs=mean)
    # The first hot gas cools by 8 % of the rate in a step
    assert np.abs(np.diff(rates[1]) / rates[1][1:]).max() < 0.1


def hot_grains_inside(clone, name=None, surface="locked", **heat):
    """Four hot grains that fall through a droplet in gas."""
    centres = [(0.045 + 0.01 * i, 0.05 + 0.0101 * j) for i in range(2) for j in range(2)]
    case = with_heat(
        grain_box(clone, centres, 0.002, name=name),
        T=BOILING,
        grains=BOILING + 100,
        fluid=GAS,
        **heat,
    )
    make_gas(case)
    return with_droplets(case, [(0.05, 0.055)], 0.02, surface=surface)


@SURFACES
def test_books_of_a_droplet_with_hot_grains_inside(clone, surface):
    """Volume, water, heat and momentum."""
    case = hot_grains_inside(clone, surface=surface)
    open_top(case)
    case.run("grainDropletFoam")
    book, momentum, heat = droplet_table(case), ledger(case), heat_ledger(case)
    assert book["inside"][0] == pytest.approx(4 * np.pi * 0.002**2 * DEPTH, rel=1e-9)
    assert book["volumeError"].max() < 1e-12
    water = book["liquid"][-1] + book["vapour"].sum()
    assert water == pytest.approx(DENSITY * np.pi * 0.02**2 * DEPTH, rel=1e-9)
    # The heat of a step gives vapour in the next one, or waits
    gained = (book["fromFluid"] + book["fromGrains"]).sum()
    used = LATENT * book["vapour"].sum() + book["waiting"][-1]
    assert used == pytest.approx(gained, rel=1e-9)
    assert momentum["momentumError"].max() < 1e-10
    assert heat["fluidError"].max() < 1e-8
    assert heat["grainError"].max() < 1e-10
    # What grains lose the droplet gets but for what is left in its cells
    lost = -heat["exchanged"].sum()
    assert book["fromGrains"].sum() == pytest.approx(lost, rel=2e-3)


@SURFACES
def test_grains_inside_cool_as_lumps(clone, surface):
    """Held in a droplet that is held they follow exp(-t Nu k S/(V rho c d)) with Nu = 2."""
    law = "type RanzMarshall; shape sphere;"
    case = hot_grains_inside(clone, surface=surface, law=law)
    open_top(case)
    replace(case, "constant/grainProperties", "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")
    file = case.path / DROPLETS
    file.write_text(file.read_text() + "motion fixed;\n")
    case.run("grainDropletFoam")
    d = 0.004
    rate = 2 * 0.68 / d * 6 / d / (2500 * GRAIN_CP)
    T = case.grains()["temperature"] - BOILING
    np.testing.assert_allclose(T, 100 * np.exp(-rate * 0.05), rtol=0.01)


def falling(clone, name, surface="locked"):
    case = hot_grains_inside(clone, name, surface)
    open_top(case)
    control(case, endTime=0.04, writeInterval=20)
    return case


@SURFACES
def test_restart_and_ranks(clone, surface):
    whole, parts = (falling(clone, name, surface) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainDropletFoam", 0.02, 0.04)
    for name in ("U", "T", "p_rgh"):
        np.testing.assert_array_equal(parts.field(name), whole.field(name))

    one = droplet_table(whole)
    for number in (2, 4):
        ranks = falling(clone, f"ranks{number}", surface)
        decompose(ranks, number)
        ranks.parallel("grainDropletFoam", number)
        many = droplet_table(ranks)
        for column in ("y", "liquid", "radius"):
            np.testing.assert_allclose(many[column], one[column], rtol=1e-8)


def test_adjustable_steps_follow_the_droplet(clone):
    case = falling(clone, "adjusting")
    entries = "adjustTimeStep yes; maxCo 10; maxGrainCo 10; maxDropletCo 0.05;\n\nfunctions"
    replace(case, "system/controlDict", "functions", entries)
    control(case, endTime=0.1, deltaT=2e-3)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    way, h = np.abs(np.diff(book["y"])), 0.01
    # What grains inside add to its fall is not known before the step
    assert way.max() < 0.05 * h * 1.02
    assert np.median(way) > 0.02 * h
    assert book["vapour"].sum() + book["liquid"][-1] == pytest.approx(book["liquid"][0], rel=1e-9)


def test_the_example_has_every_entry(clone):
    case = hot_grains_inside(clone)
    open_top(case)
    (case.path / DROPLETS).write_text((ROOT / "etc/caseDicts/dropletProperties").read_text())
    file = case.path / FLUID
    file.write_text(f"{file.read_text()} vapour {{ D 2e-5; }}\n")
    with_psi(case, 0, f"{WALLS} {{ type zeroGradient; }} frontAndBack {{ type empty; }}")
    # The box's top is open
    replace(case, DROPLETS, '(".*")', "(bottom left right)")
    control(case, endTime=2e-3)
    case.run("grainDropletFoam")


def test_resolved_grains_are_refused(clone):
    case = with_heat(grain_box(clone, [(0.05, 0.025)], 0.021), T=BOILING, grains=BOILING)
    with_droplets(case, [(0.05, 0.075)], 0.022)
    case.run("grainDropletFoam", check=False)
    assert "resolved around droplets" in case.log
