# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in a fluid that leave through outlets: without a trace in flow and books."""

import numpy as np
import pytest
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    lattice,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
    tracks,
)
from sphere_box import decompose
from water_box import level, liquid_ledger, set_water, to_two_fluids, water_box

GRAINS = "constant/grainProperties"
SPEED = 0.1
OUTLETS = {
    "patches": "type patches; patches (top);",
    "beyond": "type beyond; point (0 0.09 0); normal (0 1 0);",
    "box": "type box; box (0 0.05 0) (0.1 0.08 0.01);",
}


def append(case, text):
    path = case.path / GRAINS
    path.write_text(f"{path.read_text()}\n{text}\n")


def channel(clone, centres, radius, outlet, velocity=(0, SPEED), name=None):
    """Fluid that flows up at SPEED between frictionless walls, with an outlet of grains."""
    velocities = np.tile(velocity, (len(centres), 1))
    case = grain_box(clone, centres, radius, velocity=velocities, name=name)
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    case.run("blockMesh")
    append(case, f"outlets {{ top {{ {outlet} }} }}")
    return case


def largest_pressure(case):
    """Of each time written [Pa]."""
    return np.array([np.abs(case.field("p_rgh", time)).max() for time in case.times[1:]])


@pytest.mark.parametrize("kind", OUTLETS)
def test_resolved_grain_that_moves_with_the_fluid_leaves_no_trace(clone, kind):
    """Nothing accelerates: no pressure, and all velocities stay what they are."""
    case = channel(clone, [(0.05, 0.04)], 0.025, OUTLETS[kind])
    control(case, endTime=0.9, deltaT=1e-2, writeInterval=90)
    case.run("grainFoam")

    book = ledger(case)
    # A grain that has reached the mesh's end with its centre goes when all of it has
    leaves = {"patches": 0.85, "beyond": 0.51, "box": 0.11}[kind]
    assert book["time"][book["removed"] > 0] == pytest.approx(leaves, abs=0.0101)
    assert book["removed"].sum() == 1
    np.testing.assert_allclose(book["removedMomentum_y"].sum(), mass(0.025) * SPEED, rtol=1e-9)
    np.testing.assert_allclose(tracks(case)[:, 6], SPEED, rtol=1e-9)
    np.testing.assert_allclose(case.field("U")[:, 1], SPEED, rtol=1e-9)
    assert largest_pressure(case)[-1] <= 1e-9 * 1000 * SPEED**2


def mass(radius, density=2500):
    return density * np.pi * radius**2 * 0.01


# In cells of 10 mm
@pytest.mark.parametrize("radius", [0.001, 0.004, 0.009])
def test_small_grains_that_move_with_the_fluid_leave_no_trace(clone, radius):
    """Neither where they cross cells nor where they leave."""
    centres = np.array([(0.031, 0.071), (0.05, 0.048), (0.072, 0.066)])
    case = channel(clone, centres, radius, OUTLETS["patches"])
    control(case, endTime=0.65, deltaT=1e-2, writeInterval=1)
    case.run("grainFoam")

    book = ledger(case)
    assert book["removed"].sum() == 3
    # They exchange nothing but round-off
    impulse = np.array([book[f"given_{axis}"] for axis in "xy"])
    assert np.abs(impulse).max() <= 1e-9 * mass(radius) * SPEED
    assert book["grainMomentumError"].max() <= 1e-12
    assert book["divergence"].max() <= 1e-9
    assert largest_pressure(case).max() <= 1e-9 * 1000 * SPEED**2
    np.testing.assert_allclose(case.field("U")[:, 1], SPEED, rtol=1e-9)


def open_bottom(clone, centres, radius, name=None):
    """The box with walls but for the bottom, where fluid goes in and out and grains go out."""
    case = grain_box(clone, centres, radius, name=name)
    bottom = "bottom\n    {\n        type    "
    replace(case, "system/blockMeshDict", f"{bottom}wall", f"{bottom}patch")
    walls, others = '"left|right|bottom|top"', '"left|right|top"'
    replace(case, "0/U", walls, f"bottom {{ type zeroGradient; }}\n    {others}")
    pressure = "bottom { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", walls, f"{pressure}\n    {others}")
    replace(case, GRAINS, "(left right bottom top)", "(left right top)")
    append(case, "outlets { hole { type patches; patches (bottom); } }")
    case.run("blockMesh")
    return case


def test_grain_keeps_its_settling_speed_while_it_leaves(clone):
    """What is outside weighs, and feels the fluid as what is inside does."""
    case = open_bottom(clone, [(0.047, 0.02)], 0.002)
    replace(case, GRAINS, "glass   { density 2500; }", "glass   { density 1050; }")
    control(case, endTime=2.5, deltaT=1e-2, writeInterval=250)
    case.run("grainFoam")

    book = ledger(case)
    assert book["removed"].sum() == 1
    assert book["grainMomentumError"].max() <= 1e-12
    moves = tracks(case)
    y, v = moves[:, 3], moves[:, 6]
    settled = v[(y > 0.002) & (y < 0.003)].mean()
    leaving = v[y < 0.002]
    assert len(leaving) >= 10
    # Without a fluid outside, its weight would have added this
    assert abs(settled) <= 0.2 * (1 - 1000 / 1050) * 9.81 * 1e-2 * len(leaving)
    np.testing.assert_allclose(leaving, settled, rtol=0.05)


def falling_out(clone, name):
    """Grains of three sizes that fall on each other and out at the bottom."""
    centres = lattice(4, 4, 0.021, (0.02, 0.015))
    case = open_bottom(clone, centres, np.resize([0.002, 0.005, 0.008], 16), name=name)
    control(case, endTime=0.4, deltaT=2e-3, writeInterval=50)
    return case


def test_outlet_after_a_restart_and_on_two_ranks(clone):
    whole, parts, ranks = (falling_out(clone, name) for name in ("a", "b", "c"))
    # Grains of the list have left when it starts again
    everyone = " ".join(map(str, range(16)))
    kind = "type            grainTracks;"
    replace(parts, "system/controlDict", kind, f"{kind} grains ({everyone});")
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.2, end=0.4)
    assert_same_grains(whole, parts)
    book = ledger(whole)
    assert book["removed"].sum() >= 8
    assert book["grains"][-1] == 16 - book["removed"].sum()
    assert book["grainMomentumError"].max() <= 1e-10
    assert book["divergence"].max() <= 1e-8
    np.testing.assert_array_equal(book["removed"], ledger(parts)["removed"])
    discharge = whole.table("postProcessing/discharge/0/discharge.dat")
    np.testing.assert_array_equal(book["removed"], discharge["removed"])

    decompose(ranks, 2)
    ranks.parallel("grainFoam", 2)
    np.testing.assert_array_equal(book["removed"], ledger(ranks)["removed"])
    assert ranks.grains()["position"] == pytest.approx(whole.grains()["position"], abs=1e-7)


def drained(clone, side, cells):
    """A pool with two resolved grains that leaves through a side, air coming in at the top."""
    grains = [(0.03, 0.03), (0.07, 0.035)]
    case = water_box(clone, level(0.06), grains, 0.015, (cells, cells))
    for patch in (side, "top"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", f"{begin}wall", f"{begin}patch")
    case.run("blockMesh")

    walls = '"left|right|bottom|top"'
    others = [patch for patch in ("left", "right", "bottom") if patch != side]
    open_ends = {
        "0/U": "{ type pressureInletOutletVelocity; value uniform (0 0 0); }",
        "0/p_rgh": "{ type fixedValue; value uniform 0; }",
        "0/alpha.water": "{ type inletOutlet; inletValue uniform 0; value uniform 0; }",
    }
    for field, condition in open_ends.items():
        ends = f'"{side}|top" {condition}\n    "{"|".join(others)}"'
        replace(case, field, walls, ends)
    replace(case, GRAINS, "(left right bottom top)", f"({' '.join(others)})")
    replace(case, GRAINS, "density 2500", "density 1000")
    append(case, f"outlets {{ out {{ type patches; patches ({side} top); }} }}")
    return case


@pytest.mark.parametrize("side, cells", [("right", 20), ("right", 40), ("bottom", 20)])
def test_liquid_is_kept_where_resolved_grains_leave(clone, side, cells):
    """All that is lost has passed the patches; 3e-13 of the most there was is left."""
    case = drained(clone, side, cells)
    control(case, deltaT=5e-4, endTime=0.15, writeInterval=300)
    case.run("grainInterFoam")
    assert ledger(case)["removed"].sum() >= 1
    book = liquid_ledger(case)
    assert book["liquid"][-1] <= 0.6 * book["liquid"].max()
    # Round-off of 300 steps, and the tolerance of the flux that carries, 1e-12 of a cell
    assert np.abs(book["unaccounted"]).max() <= 1e-10
    assert book["leastAlpha"].min() >= -1e-8
    assert book["mostAlpha"].max() <= 1 + 1e-8


@pytest.mark.parametrize("cells", [20, 40])
def test_liquid_is_kept_where_resolved_grains_come_in_and_leave(clone, cells):
    """Two fluids side by side move with the grains from one end to the other."""
    case = channel(clone, [], 0.015, OUTLETS["patches"])
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    to_two_fluids(case)
    set_water(case, lambda low, high: np.clip((0.0531 - low[:, 0]) * cells / 0.1, 0, 1))
    append(
        case,
        f"injections {{ feed {{ type patches; patches (bottom); velocity (0 {SPEED} 0);"
        " numberRate 4; material glass; distribution { type constant; radius 0.015; } } }",
    )
    control(case, deltaT=1e-2, endTime=2, writeInterval=200)
    case.run("grainInterFoam")
    book = ledger(case)
    assert book["injected"].sum() >= 4
    assert book["removed"].sum() >= 2
    assert np.abs(liquid_ledger(case)["unaccounted"]).max() <= 1e-10
    np.testing.assert_allclose(case.field("U")[:, 1], SPEED, rtol=1e-9)
