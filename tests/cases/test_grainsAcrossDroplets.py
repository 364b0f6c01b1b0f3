# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains of a third of a cell to four cells that lie across the surface of a droplet of eight."""

import numpy as np
import pytest
from droplet_box import BOILING, GAS, droplet_table, make_gas, open_top, with_droplets
from grain_box import DEPTH, control, grain_box, ledger, open_ends, replace, tracks
from heat_box import heat_ledger, with_heat

H = 0.0025
RADIUS = 4 * H
PLACE = np.array([0.051, 0.0503])
CELLS = [0.3, 1, 2.4, 3.9]
# Larger ones would fill cells at the surface
OF_BOTH = [(cells, "locked") for cells in CELLS] + [(cells, "cutCells") for cells in (0.3, 0.7, 1)]


def across(clone, cells, grain=None, velocity=(0, 0), stream=None, heat=None, **options):
    """A droplet in gas with a grain of some cells in a diameter whose centre is on its surface, or
    elsewhere; both, and the gas if there is a stream, move."""
    if grain is None:
        angle = np.radians(37)
        grain = PLACE + RADIUS * np.array([np.cos(angle), np.sin(angle)])
    ofGrain = (0, 0) if stream is None else velocity
    case = grain_box(clone, [grain], cells * H / 2, velocity=[ofGrain])
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    if stream is not None:
        open_ends(case, stream)
        replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {stream} 0)")
    case.run("blockMesh")
    with_heat(case, **{"T": BOILING, "grains": BOILING, "fluid": GAS} | (heat or {}))
    make_gas(case)
    if stream is None:
        open_top(case)
    with_droplets(case, [PLACE], RADIUS, velocity=[velocity], **options)
    return case


@pytest.mark.parametrize("cells, surface", OF_BOTH)
def test_what_moves_together_stays_together(clone, cells, surface):
    """Droplet, grain and gas, a tenth of a cell in a step: cells change sides."""
    speed = 0.25
    case = across(clone, cells, velocity=(0, speed), stream=speed, surface=surface)
    control(case, endTime=0.02, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    np.testing.assert_allclose(tracks(case)[:, 5:7], [[0, speed]] * 20, atol=2e-4 * speed)
    np.testing.assert_allclose(book["vy"], speed, rtol=2e-4)
    np.testing.assert_allclose(book["vx"], 0, atol=2e-4 * speed)


@pytest.mark.parametrize("cells, surface", OF_BOTH)
def test_what_falls_together_has_the_same_speed(clone, cells, surface):
    """In free fall there is no buoyancy, and gas is nothing."""
    case = across(clone, cells, surface=surface)
    control(case, endTime=0.02, writeInterval=1000)
    case.run("grainDropletFoam")
    book, grain = droplet_table(case), tracks(case)
    fallen = -9.81 * book["time"]
    np.testing.assert_allclose(grain[:, 6], fallen, rtol=5e-3)
    np.testing.assert_allclose(book["vy"], fallen, rtol=5e-3)
    np.testing.assert_allclose(grain[:, 5], 0, atol=2e-3 * 0.2)
    assert ledger(case)["momentumError"].max() < 1e-9


@pytest.mark.parametrize("cells, surface", OF_BOTH[1:4] + OF_BOTH[5:])
def test_a_droplet_that_hits_a_grain_takes_it_along(clone, cells, surface):
    """What it loses of its momentum the grain has, but for 0.3 % that is the gas's."""
    grain = PLACE + [7e-4, -(RADIUS + 0.6 * cells * H)]
    case = across(clone, cells, grain, velocity=(0, -0.4), surface=surface)
    replace(case, "constant/g", "-9.81", "0")
    control(case, endTime=0.03, deltaT=5e-4, writeInterval=1000)
    case.run("grainDropletFoam")
    book, track = droplet_table(case), tracks(case)
    ratio = 2500 * (cells * H / 2) ** 2 / (1000 * RADIUS**2)
    assert np.all(np.diff(track[:, 6]) < 1e-4)
    assert -0.4 < book["vy"][-1] < track[-1, 6] < -0.005
    np.testing.assert_allclose(track[:, 5], 0, atol=1e-3)
    np.testing.assert_allclose(book["vy"] + ratio * track[:, 6], -0.4, rtol=5e-3)
    inside = np.pi * (cells * H / 2) ** 2 * DEPTH
    assert book["inside"].max() <= inside * (1 + 1e-9)


@pytest.mark.parametrize("cells, surface", OF_BOTH)
def test_heat_of_a_hot_grain_that_a_droplet_takes_in_closes(clone, cells, surface):
    """Henry's law in cells that the grain and the droplet fill."""
    grain = PLACE + [7e-4, -(RADIUS + 0.6 * cells * H)]
    law = "type Henry; shape sphere;"
    heat = {"T": BOILING + 30, "grains": BOILING + 230, "law": law}
    case = across(clone, cells, grain, velocity=(0, -0.4), heat=heat, surface=surface)
    control(case, endTime=0.03, deltaT=5e-4, writeInterval=1000)
    case.run("grainDropletFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() < 1e-8
    assert book["leastT"].min() > BOILING - 1e-6
    assert book["mostT"].max() < BOILING + 230
    assert droplet_table(case)["fromGrains"].min() > -1e-12


def lens(inside, outer, distance):
    """Area common to two circles."""
    if distance >= inside + outer:
        return 0.0
    if distance <= abs(outer - inside):
        return np.pi * min(inside, outer) ** 2
    part = 0.0
    for a, b in ((inside, outer), (outer, inside)):
        x = (distance**2 + a**2 - b**2) / (2 * distance)
        part += a**2 * np.arccos(x / a) - x * np.sqrt(a**2 - x**2)
    return part


@pytest.mark.parametrize("cells", [0.3, 0.7, 1])
def test_grains_are_in_the_liquid_where_they_are(clone, cells):
    """Of 16 grains around a droplet that has just begun to move, what lies within its circle is
    inside, and one that lies outside has no drag of a viscous liquid, though it shares its cell."""
    size = cells * H
    above = np.tile([-0.7, -0.5, -0.25, 0, 0.25, 0.5, 0.55, 0.7], 2)
    angle = np.radians(11 + 22.5 * np.arange(16))
    ray = np.column_stack([np.cos(angle), np.sin(angle)])
    centres = PLACE + (RADIUS + above * size)[:, None] * ray
    case = grain_box(clone, centres, size / 2)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    replace(case, "constant/g", "-9.81", "0")
    case.run("blockMesh")
    with_heat(case, T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    open_top(case)
    with_droplets(case, [PLACE], RADIUS, velocity=[(0, 0.2)], surface="cutCells")
    replace(case, "constant/dropletProperties", "mu 2.8e-4", "mu 1")
    control(case, endTime=1e-4, deltaT=1e-4, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    radius = book["radius"][-1]
    exact = [lens(size / 2, radius, RADIUS + z * size) for z in above]
    np.testing.assert_allclose(book["inside"][-1], DEPTH * sum(exact), rtol=0.02)
    speed = tracks(case)[:16, 6].reshape(2, 8).mean(0) / 0.2
    assert np.all(np.abs(speed[above[:8] >= 0.5]) < 1e-3)
    assert np.all(np.diff(speed[1:6]) < -0.01)
