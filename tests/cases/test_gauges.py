# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Function objects of free surfaces and slides: levels, run-up, granular front."""

import h5py
import numpy as np
import pytest
from dry_box import dry_box
from grain_box import control, grain_box, replace
from water_box import column, level, water_box

LIBRARY = 'libs ("libgrainFunctionObjects.so"); writeControl timeStep; writeInterval 1;'


def watch(case, entries, name="watch"):
    text = f"functions\n{{\n    {name} {{ {LIBRARY} {entries} }}\n"
    replace(case, "system/controlDict", "functions\n{", text)


def gauges(case, stations, others=""):
    points = " ".join(f"({x} 0.03 0.005)" for x in stations)
    watch(case, f"type liquidGauges; stations ({points}); {others}")


def columns(case, file):
    table = case.table(f"postProcessing/watch/0/{file}.csv")
    return {name: np.atleast_1d(values) for name, values in table.items()}


@pytest.mark.parametrize("height", [0.05, 0.0537, 0.0462])
def test_level_of_a_pool(clone, height):
    """Exact for the sharp surface of the start, wherever it cuts the cells; with grains the
    liquid is less and the level the same."""
    case = water_box(clone, level(height), [(0.055, 0.03)], radius=0.004, cells=(10, 20))
    gauges(case, [0.02, 0.055])
    control(case, endTime=1e-4, deltaT=1e-4)
    case.run("grainInterFoam")
    levels, thicknesses = columns(case, "levels"), columns(case, "thicknesses")
    assert levels["station0"][0] == pytest.approx(height, abs=1e-5)
    assert levels["station1"][0] == pytest.approx(height, abs=1e-5)
    assert thicknesses["station0"][0] == pytest.approx(height, abs=1e-5)
    # A disc of 8 mm in cells 10 mm wide
    covered = np.pi * 0.004**2 / 0.01
    assert thicknesses["station1"][0] == pytest.approx(height - covered, rel=0.02)


def test_run_up_is_that_of_water_that_is_thick_enough(clone):
    """A column and a film beside it; on two ranks the same."""

    def make(name):
        def water(low, high):
            return np.maximum(column(0.04, 0.08)(low, high), level(0.01)(low, high))

        case = water_box(clone, water, cells=(10, 10), name=name)
        gauges(case, [0.025, 0.075], "thickness 0.02; origin (0 0.01 0);")
        control(case, endTime=2e-5, deltaT=1e-5)
        return case

    one, two = make("one"), make("two")
    one.run("grainInterFoam")
    run_up, levels = columns(one, "runUp"), columns(one, "levels")
    assert run_up["runUp"][0] == pytest.approx(0.07, abs=1e-4)
    assert levels["station1"][0] == pytest.approx(0, abs=1e-4)
    two.run("decomposePar")
    two.parallel("grainInterFoam", 2)
    np.testing.assert_allclose(columns(two, "levels")["station0"], levels["station0"], atol=1e-9)


def test_front(clone):
    """One grain on another, and one ahead that is alone and falls."""
    r = 0.005
    centres = [(0.02, r), (0.02 + 0.1 * r, 2.994 * r), (0.06, 0.05)]
    case = grain_box(clone, centres, r, velocity=[(0, 0), (0, 0), (0.3, 0)])
    entries = "type granularFront; origin (0.01 0 0); direction (2 0 0); depth 0.05; level 0.05;"
    watch(case, entries)
    control(case, endTime=0.01, writeInterval=1)
    case.run("dryGrainFoam")
    front = case.table("postProcessing/watch/0/front.csv")
    last = case.grains()
    assert front["grains"][-1] == pytest.approx(last["position"][2, 0] + r - 0.01, rel=1e-9)
    x, y = last["position"][2, :2]
    at_level = x + np.sqrt(r**2 - (y - 0.05) ** 2) - 0.01
    assert front["level"][-1] == pytest.approx(at_level, rel=1e-9)
    speed = np.diff(front["level"])[-1] / np.diff(front["time"])[-1]
    assert front["speed"][-1] == pytest.approx(speed, rel=1e-6)
    # Less than its 0.3 m/s, as the chord of a disc that falls becomes shorter
    assert 0.28 < front["speed"][-1] < 0.3
    assert front["Froude"][-1] == pytest.approx(front["speed"][-1] / np.sqrt(9.81 * 0.05), rel=1e-9)
    assert front["size"][-1] == 2
    assert front["network"][-1] == pytest.approx(last["position"][1, 0] + r - 0.01, rel=1e-9)


def members(case, dimension):
    """Centres (n, 3) and radii of the discs or spheres of all clusters, which are of one shape."""
    grains = case.grains()
    with h5py.File(case.path / case.times[-1] / "grains.h5") as file:
        arms, sizes = (file[f"clusters/{name}"][()] for name in ("centre", "radius"))
    centres = []
    for place, radius, turn in zip(
        grains["position"], grains["radius"], grains["orientation"], strict=True
    ):
        if dimension == 2:
            cos, sin = np.cos(turn).item(), np.sin(turn).item()
            axes = np.array([[cos, -sin], [sin, cos]])
        else:
            w, x, y, z = turn
            cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
            axes = np.eye(3) + 2 * w * cross + 2 * cross @ cross
        centres.append(place + radius * arms @ axes.T)
    return np.concatenate(centres), np.outer(grains["radius"], sizes).ravel()


@pytest.mark.parametrize("dimension", [2, 3])
def test_front_of_clusters_is_that_of_their_members(clone, dimension):
    """Rods of five, anyhow: the farthest point of their discs or spheres, not of what is around."""
    case = dry_box(clone, dimension=dimension)
    rod = "type cluster; centres ((0 0 0) (2 0 0) (4 0 0) (6 0 0) (8 0 0)); radii (1 1 1 1 1);"
    path = case.path / "constant/grainProperties"
    path.write_text(f"{path.read_text()}\nshapes {{ rod {{ {rod} }} }}\n")
    header = "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }\n"
    corner = "(0.08 0.1 0)" if dimension == 2 else "(0.08 0.1 0.1)"
    (case.path / "system/packGrainsDict").write_text(
        f"{header}type lattice; box (0 0 0) {corner}; radius 0.015; shape rod; material glass;"
    )
    case.run("packGrains")
    watch(case, "type granularFront; direction (1 0 0); level 0.033;")
    control(case, endTime=0.05, writeInterval=50)
    case.run("dryGrainFoam")
    front = case.table("postProcessing/watch/0/front.csv")
    centre, radius = members(case, dimension)
    assert front["grains"][-1] == pytest.approx((centre[:, 0] + radius).max(), rel=1e-9)
    off = np.abs(centre[:, dimension - 1] - 0.033)
    there = off < radius
    at_level = centre[there, 0] + np.sqrt(radius[there] ** 2 - off[there] ** 2)
    assert front["level"][-1] == pytest.approx(at_level.max(), rel=1e-9)
    # The circles around the rods are farther
    around = case.grains()["position"][:, 0] + case.grains()["radius"]
    assert around.max() > front["grains"][-1] + 1e-4


BAD = {
    "unknown": ("type contactNetwork; colour red;", "'colour'"),
    "no direction": ("type granularFront;", "'direction'"),
    "zero": ("type granularFront; direction (0 0 0);", "'direction'"),
    "depth": ("type granularFront; direction (1 0 0); depth 0;", "'depth'"),
    "no stations": ("type liquidGauges;", "'stations'"),
    "empty": ("type liquidGauges; stations ();", "'stations'"),
    "outside": ("type liquidGauges; stations ((0.05 0 0.005) (7 0 0.005));", "(7 0 0.005)"),
    "thickness": ("type liquidGauges; stations ((0.05 0 0.005)); thickness -1;", "'thickness'"),
    "fraction": ("type refinementIndicator; fluidFraction 2;", "'fluidFraction'"),
    "margin": ("type refinementIndicator; margin -1;", "'margin'"),
    "upper alpha": ("type refinementIndicator; upperAlpha 2;", "'upperAlpha'"),
    "no alpha": ("type refinementIndicator; alpha alpha.oil;", "value alpha.oil"),
    "number": ("type refinementIndicator; alpha 7;", "'alpha'"),
    "taken": ("type refinementIndicator; result eps;", "'result'"),
    "no such share": ("type liquidGauges; stations ((0.05 0 0.005)); alpha oil;", "value oil"),
}


@pytest.mark.parametrize("entries, said", BAD.values(), ids=BAD)
def test_bad_entries_are_named(clone, entries, said):
    case = water_box(clone, level(0.05), [(0.05, 0.03)])
    watch(case, entries)
    case.run("grainInterFoam", check=False)
    assert said in case.log
    assert "FATAL" in case.log and "printStack" not in case.log
