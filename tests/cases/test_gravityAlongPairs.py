# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gravity along the way from a cyclic patch to its neighbour: no height is that of a cell there."""

import pytest
from grain_box import control, cyclic_box, replace
from heat_box import with_heat
from test_parallel import decompose
from water_box import AIR, WATER, column, set_water, to_two_fluids

CYCLIC = '"left|right|bottom|top" { type cyclic; }'
REFUSED = ["constant/g", "(3 0 0)", "cyclic", "allowed: gravity across it"]


def box(clone, gravity):
    case = cyclic_box(clone, [(0.05, 0.05)], 0.004)
    replace(case, "constant/g", "(0 0 0)", gravity)
    control(case, endTime=0.002, writeInterval=2)
    return case


def warm(clone, gravity="(3 0 0)", beta=1e-3):
    case = box(clone, gravity)
    with_heat(case, patches=CYCLIC, fluid=f"Cp 1000; kappa 0.6; beta {beta}; TRef 300;")
    return case, "grainThermalFoam"


def two_fluids(clone, gravity="(3 0 0)", densities=(WATER, AIR)):
    case = box(clone, gravity)
    to_two_fluids(case, densities)
    set_water(case, column(0.04, 0.1), walls="cyclic")
    return case, "grainInterFoam"


@pytest.mark.parametrize("make", [warm, two_fluids])
def test_it_is_refused(clone, make):
    case, application = make(clone)
    assert case.run(application, check=False) != 0
    for fragment in REFUSED:
        assert fragment in case.log
    assert "Time = " not in case.log


@pytest.mark.parallel
def test_it_is_refused_where_ranks_cut_the_pair(clone):
    case, application = two_fluids(clone)
    decompose(case, 2)
    assert case.parallel(application, 2, check=False) != 0
    assert "allowed: gravity across it" in case.log


@pytest.mark.parametrize(
    "make, options",
    [
        (warm, {"gravity": "(0 0 0)"}),
        (warm, {"beta": 0}),
        (two_fluids, {"gravity": "(0 0 0)"}),
        (two_fluids, {"densities": (WATER, WATER)}),
    ],
)
def test_a_fluid_of_one_weight_is_not(clone, make, options):
    case, application = make(clone, **options)
    case.run(application)
