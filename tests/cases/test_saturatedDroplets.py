# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets below boiling, with saturated vapour at their surface."""

import numpy as np
import pytest
from droplet_box import DROPLETS, GAS_CP, GAS_K, GAS_RHO, LATENT, droplet_table, share_of_water
from grain_box import DEPTH, control, replace
from heat_box import heat_ledger, vapour_ledger
from saturated_box import OUTER, RADIUS, in_humid_box, saturated


def clausius_clapeyron(T):
    moles = np.exp(2.34e6 * 0.018015 / 8.31446 * (1 / 372.76 - 1 / T))
    return 0.622 * moles / (0.622 * moles + 1 - moles)


CURVES = {
    "Antoine": ("", share_of_water),
    "ClausiusClapeyron": (
        "type ClausiusClapeyron; pressure 1e5; temperature 372.76; latentHeat 2.34e6;"
        " molarMass 0.018015;",
        clausius_clapeyron,
    ),
}


@pytest.mark.parametrize("T", [300.0, 345.0])
@pytest.mark.parametrize("entries, share", CURVES.values(), ids=CURVES)
def test_vapour_leaves_as_stefan_says(clone, T, entries, share):
    """2 pi rho D ln(1 + B)/ln(R_o/R) of a droplet that keeps its temperature, that of the gas."""
    case = saturated(clone, T, T, density=1e9, liquid="Cp 1e12;")
    antoine = "type Antoine; A 4.6543; B 1435.264; C -64.848;"
    replace(case, DROPLETS, antoine, entries or antoine)
    control(case, endTime=0.4, deltaT=2e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    rate = droplet_table(case)["vapour"][-1] / 2e-3
    B = share(T) / (1 - share(T))
    exact = 2 * np.pi * GAS_K * DEPTH / GAS_CP * np.log1p(B) / np.log(OUTER / RADIUS)
    assert rate == pytest.approx(exact, rel=0.01)


@pytest.mark.parametrize("gas, start", [(303.15, 303.15), (600.0, 300.0)])
def test_the_temperature_goes_to_the_wet_bulb(clone, gas, start):
    """c (T - T_d)/L = (Y_d - Y)/(1 - Y_d) at Lewis number 1, from above and from below."""
    rim = 0.005
    case = saturated(clone, gas, start, rim, density=100, liquid="Cp 100;")
    control(case, endTime=1.0, deltaT=2e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    T = np.linspace(250, 372, 100001)
    B = (share_of_water(T) - rim) / (1 - share_of_water(T))
    wetBulb = T[np.argmin(np.abs(GAS_CP * (gas - T) / LATENT - B))]
    assert book["temperature"][-1] == pytest.approx(wetBulb, abs=0.1)
    assert heat_ledger(case)["fluidError"].max() < 1e-8


@pytest.mark.parametrize(
    "start, psi", [(340.0, 0.0), (280.0, 0.02)], ids=["evaporates", "condenses"]
)
def test_water_is_kept(clone, start, psi):
    """What the liquid lost, and what has diffused that will be taken from it, is in the gas."""
    case = in_humid_box(clone, 300, psi, start)
    case.run("grainDropletFoam")
    book = droplet_table(case)
    lost = book["liquid"][0] + book["vapour"][0] - book["liquid"][-1]
    assert lost * (1 if psi == 0 else -1) > 0
    assert book["vapour"].sum() == pytest.approx(lost, rel=1e-9)
    before = psi * (0.1**2 - np.pi * 0.022**2) * DEPTH
    gas = vapour_ledger(case)
    gained = gas["vapour"][-1] - before + gas["convected_top"].sum() + gas["diffused_top"].sum()
    assert GAS_RHO * gained == pytest.approx(lost + book["diffused"][-1], rel=1e-8)


@pytest.mark.parametrize("dt", [2e-3, 5e-3])
def test_the_last_of_it_keeps_its_temperature(clone, dt):
    """That of the wet bulb, 328 K, within what half as much vapour again is at its surface."""
    case = saturated(clone, 600.0, 320.0, density=10, liquid="Cp 4200;")
    control(case, endTime=5, deltaT=dt, writeInterval=10000)
    case.run("grainDropletFoam")
    book, gas = droplet_table(case), heat_ledger(case)
    assert book["time"][-1] < 4.9
    late = book["temperature"][book["time"] > 0.2]
    assert 313 < late.min() and late.max() < 343
    assert gas["leastT"].min() > 313
    assert gas["fluidError"].max() < 1e-6


def test_what_condenses_comes_from_the_humid_side(clone):
    """More condenses on the left than evaporates on the right: no cell takes it all."""
    case = saturated(clone, 300.0, 300.0, density=1e9, liquid="Cp 1e12;")
    share = share_of_water(300.0)
    psi = f"{1.75 * share} - {1.25 * share / OUTER}*pos().x()"
    replace(case, "0/psi", "type fixedValue;", f'type exprFixedValue; valueExpr "{psi}";')
    control(case, endTime=0.4, deltaT=2e-3, writeInterval=200)
    case.run("grainDropletFoam")
    rate = -droplet_table(case)["vapour"][-1] / 2e-3
    assert rate > 0
    even = rate / (GAS_RHO * 2 * np.pi * RADIUS * DEPTH)
    assert np.abs(case.field("U")).max() < 4 * even


@pytest.mark.parametrize("start, psi, density", [(371.0, 0.8, 100), (372.0, 0.05, 1000)])
def test_hot_droplets_pass_through_cells(clone, start, psi, density):
    """What newly covered cells take of the vapour makes no flow: that grew by psi_s/(1 - psi_s)
    from step to step, where psi_s is above a half."""
    case = in_humid_box(clone, 373, psi, start, (0.2, 0.05), density=density)
    control(case, endTime=0.03, deltaT=1e-3, writeInterval=1000)
    case.run("grainDropletFoam")
    book, gas = droplet_table(case), vapour_ledger(case)
    assert np.abs(case.field("U")).max() < 1
    assert gas["leastPsi"].min() >= psi - 1e-9
    assert gas["mostPsi"].max() <= share_of_water(start) + 1e-9
    lost = book["liquid"][0] + book["vapour"][0] - book["liquid"][-1]
    before = psi * (0.1**2 - np.pi * 0.022**2) * DEPTH
    gained = gas["vapour"][-1] - before + gas["convected_top"].sum() + gas["diffused_top"].sum()
    assert GAS_RHO * gained == pytest.approx(lost + book["diffused"][-1], rel=1e-8)
