# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets that leave the mesh through outlets."""

import numpy as np
import pytest
from droplet_box import BOILING, GAS, droplet_table, make_gas, with_droplets
from grain_box import DEPTH, control, grain_box, ledger, open_ends, replace
from heat_box import CP, GRAINS, heat_ledger, with_heat

SPEED = 0.1
OUTLET = "outlets { above { type patches; patches (top); } }\n"


def channel(clone, place, radius, gas=BOILING, speed=SPEED, fluid=None, name=None, **droplet):
    """Gas that flows up at SPEED between frictionless walls with droplets at a speed."""
    case = grain_box(clone, name=name)
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    case.run("blockMesh")
    velocity = np.tile((0, speed), (len(place), 1))
    with_heat(case, T=gas, grains=gas, **({"fluid": fluid} if fluid else {}))
    with_droplets(case, place, radius, velocity=velocity, entries=OUTLET, **droplet)
    return case


def test_one_that_goes_with_the_gas_leaves_no_trace(clone):
    case = channel(clone, [(0.048, 0.055)], 0.022, density=2000)
    control(case, endTime=0.8, deltaT=1e-2, writeInterval=5)
    case.run("grainDropletFoam")
    for time in case.times[1:]:
        U = case.field("U", time)
        np.testing.assert_allclose(U[:, 1], SPEED, rtol=1e-9)
        np.testing.assert_allclose(U[:, 0], 0, atol=1e-9 * SPEED)
    book = droplet_table(case)
    np.testing.assert_allclose(book["vy"], SPEED, rtol=1e-9)
    # Its lower end leaves, and the step is the last in which it is there
    assert book["time"][-1] == pytest.approx((0.1 - 0.055 + 0.022) / SPEED, abs=0.0101)
    left = case.table("postProcessing/discharge.droplets/0/discharge.dat")
    assert left["removed"].sum() == 1
    assert left["totalMass"][-1] == pytest.approx(2000 * np.pi * 0.022**2 * DEPTH, rel=1e-9)


def hot(clone, name):
    """Two that evaporate in hot gas; one leaves, and the other begins to."""
    case = channel(
        clone, [(0.03, 0.07), (0.07, 0.045)], 0.02, BOILING + 500, 0.5, GAS, name, density=100
    )
    make_gas(case)
    control(case, endTime=0.14, deltaT=1e-3, writeInterval=20)
    return case


def test_those_that_evaporate_leave_with_the_rest(clone):
    whole, parts, ranks = (hot(clone, name) for name in ("whole", "parts", "ranks"))
    whole.run("grainDropletFoam")
    book = droplet_table(whole)
    assert heat_ledger(whole)["fluidError"].max() < 1e-8
    first = {name: column[book["droplet"] == 0] for name, column in book.items()}
    left = whole.table("postProcessing/discharge.droplets/0/discharge.dat")
    assert left["removed"].sum() == 1 and len(first["time"]) < 140
    assert left["totalMass"][-1] == pytest.approx(first["liquid"][-1], rel=1e-9)
    assert "Droplet 0 has left through an outlet" in whole.log
    # Where it passes its speed jumps no more than where cells of the gas become its own
    assert np.all(np.diff(first["radius"]) <= 0)
    jumps, passes = np.abs(np.diff(first["vy"])), first["y"][1:] + 0.02 > 0.1
    assert jumps[passes].max() <= jumps[~passes].max()

    for end in (0.06, 0.14):
        control(parts, endTime=end)
        parts.run("grainDropletFoam")
    for name in ("U", "T", "p_rgh"):
        np.testing.assert_array_equal(parts.field(name), whole.field(name))

    ranks.run("decomposePar")
    ranks.parallel("grainDropletFoam", 2)
    other = ranks.table("postProcessing/discharge.droplets/0/discharge.dat")
    np.testing.assert_allclose(other["totalMass"], left["totalMass"], rtol=1e-8)


# The mixture's speed was the gas's, and up to 1.44 times the stream came in below
@pytest.mark.parametrize("inside", [0, 2], ids=["alone", "with grains"])
def test_gas_at_a_patch_of_given_velocity_is_what_liquid_and_grains_leave(clone, inside):
    """All go at one speed; as much comes in below as went up before."""
    place = [(0.048, 0.055)]
    grains = [(0.045, 0.05), (0.05, 0.06)][:inside]
    case = grain_box(clone, grains, 0.003, velocity=[(0, SPEED)] * inside)
    open_ends(case, SPEED)
    case.run("blockMesh")
    given, top = f"type fixedValue; value uniform (0 {SPEED} 0);", "type zeroGradient;"
    below = "type pressureInletOutletVelocity; value $internalField;"
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    replace(case, "0/U", f"bottom {{ {given} }}", f"bottom {{ {below} }}")
    replace(case, "0/U", f"top {{ {top} }}", f"top {{ {given} }}")
    replace(case, "0/p_rgh", "top { type fixed", "bottom { type fixed")
    replace(case, "0/p_rgh", '"left|right|bottom"', '"left|right|top"')
    with_heat(case, T=BOILING, grains=BOILING)
    with_droplets(case, place, 0.022, [(0, SPEED)], entries=OUTLET, density=2000)
    properties = case.path / GRAINS
    properties.write_text(properties.read_text() + OUTLET)
    control(case, endTime=0.8, deltaT=1e-2, writeInterval=80)
    case.run("grainDropletFoam")
    assert droplet_table(case)["time"][-1] < 0.7
    assert ledger(case)["grains"][-1] == 0
    book = heat_ledger(case)
    stream = 1000 * CP * BOILING * SPEED * 0.1 * DEPTH * 1e-2
    # It swells by the grains in the first step.  Grains inside are taken as even there
    each, whole = (0.04, 1e-4) if inside else (1e-9, 1e-9)
    np.testing.assert_allclose(book["convected_bottom"][1:], -stream, rtol=each)
    assert book["convected_bottom"][1:].sum() == pytest.approx(-79 * stream, rel=whole)
    left = 80 - np.pi * (0.022**2 + inside * 0.003**2) / (0.1 * SPEED * 1e-2)
    assert book["convected_top"].sum() == pytest.approx(left * stream, rel=whole)


def test_one_that_leaves_where_there_is_no_outlet_is_called_a_droplet(clone):
    case = channel(clone, [(0.048, 0.07)], 0.022)
    replace(case, "constant/dropletProperties", OUTLET, "")
    control(case, endTime=0.8, deltaT=1e-2, writeInterval=80)
    assert case.run("grainDropletFoam", check=False) == 1
    assert "Droplet 0 at " in case.log
    assert "has left the mesh at time " in case.log
    assert "Grain 0" not in case.log
