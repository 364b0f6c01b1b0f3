# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets in steps that become shorter."""

import numpy as np
import pytest
from droplet_box import BOILING, GAS, make_gas, open_top, with_droplets
from grain_box import control, grain_box
from heat_box import with_heat
from saturated_box import in_humid_box


def boiling(clone):
    """With a hot grain inside."""
    case = grain_box(clone, [(0.05, 0.055)], 0.004)
    with_heat(case, T=600, grains=BOILING + 50, fluid=GAS)
    make_gas(case)
    open_top(case)
    with_droplets(case, [(0.05, 0.055)], 0.02)
    return case


def saturated(clone):
    return in_humid_box(clone, 400, 0.0, 345)


@pytest.mark.parametrize("make", [boiling, saturated])
def test_vapour_leaves_as_fast_as_its_heat_came(clone, make):
    """All of a long step's in the next one, 20 times shorter, was a jet of 20 times the flow."""
    case = make(clone)
    control(case, endTime=0.02, deltaT=1e-3, writeInterval=20)
    case.run("grainDropletFoam")
    control(case, endTime=0.021, deltaT=5e-5)
    case.run("grainDropletFoam")
    before = case.table("postProcessing/droplets/0/droplets.csv")["vapour"] / 1e-3
    after = case.table("postProcessing/droplets/0.02/droplets.csv")["vapour"] / 5e-5
    assert len(after) == 20
    # The liquid gets what newly covered cells took at once, as it is no flow
    first = 1 if make is saturated else 0
    np.testing.assert_allclose(after[first:], before[-1], rtol=0.15)
