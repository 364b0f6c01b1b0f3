# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cold droplets in humid gas and in steam."""

import numpy as np
import pytest
from droplet_box import GAS_CP, GAS_K, GAS_RHO, droplet_table, share_of_water
from grain_box import DEPTH, control, replace, run_whole_and_parts
from heat_box import heat_ledger, vapour_ledger
from saturated_box import OUTER, RADIUS, in_humid_box, saturated
from test_parallel import decompose


@pytest.mark.parametrize("psi", [0.1, 0.4, 0.7, 0.9])
def test_vapour_condenses_as_stefan_says(clone, psi):
    """2 pi rho D ln((1 - psi_s)/(1 - psi))/ln(R_o/R) of a droplet that keeps its temperature."""
    T, dt = 300.0, 2e-3
    case = saturated(clone, T, T, psi, density=1e9, liquid="Cp 1e12;")
    control(case, endTime=0.4, deltaT=dt, writeInterval=1000)
    case.run("grainDropletFoam")
    rate = -droplet_table(case)["vapour"][-1] / dt
    film = np.log((1 - share_of_water(T)) / (1 - psi))
    exact = 2 * np.pi * GAS_K * DEPTH / GAS_CP * film / np.log(OUTER / RADIUS)
    assert rate == pytest.approx(exact, rel=0.02)


@pytest.mark.parametrize("dt", [2e-4, 2e-3])
@pytest.mark.parametrize("psi", [0.1, 0.6, 0.9, 1.0])
def test_gas_that_condenses_stays_in_its_range(clone, psi, dt):
    """Gas of 400 K around a droplet of 300 K that moves through it; water is kept."""
    case = in_humid_box(clone, 400, psi, 300, (0.3, 0))
    control(case, endTime=0.04, deltaT=dt, writeInterval=1000)
    case.run("grainDropletFoam")
    book, heat, gas = droplet_table(case), heat_ledger(case), vapour_ledger(case)
    assert heat["leastT"].min() >= 300 - 1e-6 and heat["mostT"].max() <= 400 + 1e-6
    assert gas["leastPsi"].min() >= share_of_water(300) - 1e-9
    assert gas["mostPsi"].max() <= psi + 1e-9
    assert heat["fluidError"].max() < 1e-8

    condensed = book["liquid"][-1] - book["liquid"][0] - book["vapour"][0]
    before = psi * (0.1**2 - np.pi * 0.022**2) * DEPTH
    lost = before - gas["vapour"][-1] - gas["convected_top"].sum() - gas["diffused_top"].sum()
    assert condensed > 0
    assert GAS_RHO * lost == pytest.approx(condensed - book["diffused"][-1], rel=1e-8)


def test_steam_that_streams_to_a_droplet_is_steady(clone):
    """By its diffusion as fast as to one of 0.4 mm: gas that left with the surface's velocity
    made the rest of it faster, and the droplet was thrown away."""
    case = in_humid_box(clone, 373, 1.0, 300, D=2e-3, nu=1.6e-3)
    replace(case, "constant/g", "-9.81", "0")
    control(case, endTime=0.1, deltaT=5e-4, writeInterval=1000)
    case.run("grainDropletFoam")
    book, gas = droplet_table(case), vapour_ledger(case)
    assert book["liquid"][-1] > 1.01 * book["liquid"][0]
    assert np.hypot(book["vx"], book["vy"]).max() < 0.2
    # That of the film, which has 0.05 of air at least
    fastest = 2e-3 / 0.01 * np.log(1 / 0.05)
    assert np.abs(case.field("U")).max() < 5 * fastest
    assert gas["mostPsi"].max() <= 1 + 1e-9


def test_restart_and_ranks(clone):
    def steaming(name):
        case = in_humid_box(clone, 400, 0.9, 300, (0.3, 0), name)
        control(case, endTime=0.04, deltaT=1e-3, writeInterval=20)
        return case

    whole, parts, ranks = (steaming(name) for name in ("whole", "parts", "ranks"))
    run_whole_and_parts(whole, parts, "grainDropletFoam", 0.02, 0.04)
    for name in ("U", "T", "psi", "p_rgh"):
        np.testing.assert_array_equal(parts.field(name), whole.field(name))
    decompose(ranks, 2)
    ranks.parallel("grainDropletFoam", 2)
    one, two = droplet_table(whole), droplet_table(ranks)
    for column in ("y", "liquid", "temperature"):
        np.testing.assert_allclose(two[column], one[column], rtol=1e-8)
