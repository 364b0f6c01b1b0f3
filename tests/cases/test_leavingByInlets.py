# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water and air that leave through a patch of given fraction, as a wave's inlet is in its
trough: the fraction there is that of what comes in, and what leaves has that of its cells."""

import numpy as np
import pytest
from grain_box import DEPTH, control, replace
from water_box import level, liquid_ledger, water_box

SPEED, HEIGHT, STEP = 0.05, 0.053, 2e-3
WALLS = '"left|right|bottom|top"'


def basin(clone, swing):
    """Fluid goes through the left side as `swing` of its greatest speed has it, and air through
    the top."""
    case = water_box(clone, level(HEIGHT), [(0.07, 0.03)], cells=(20, 20))
    for patch in ("left", "top"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    for field, left, top in (
        (
            "U",
            f"uniformFixedValue; uniformValue {swing}; value uniform (0 0 0);",
            "pressureInletOutletVelocity; value uniform (0 0 0);",
        ),
        ("p_rgh", "fixedFluxPressure; value uniform 0;", "fixedValue; value uniform 0;"),
        (
            "alpha.water",
            "fixedValue; value uniform 1;",
            "inletOutlet; inletValue uniform 0; value uniform 0;",
        ),
    ):
        patches = f'left {{ type {left} }} top {{ type {top} }} "right|bottom"'
        replace(case, f"0/{field}", WALLS, patches)
    replace(case, "constant/grainProperties", "(left right bottom top)", "(right bottom)")
    control(case, deltaT=STEP, endTime=0.4, writeInterval=200)
    return case


@pytest.mark.parametrize(
    "swing",
    [
        f"constant ({-SPEED} 0 0)",
        f"table ((0 ({-SPEED} 0 0)) (0.2 ({-SPEED} 0 0)) (0.21 ({SPEED} 0 0)))",
    ],
)
def test_what_leaves_has_the_fraction_of_its_cells(clone, swing):
    """Without that, air left as water: fractions below zero from the first step on."""
    case = basin(clone, swing)
    case.run("grainInterFoam")
    book = liquid_ledger(case)
    assert book["leastAlpha"].min() >= -1e-10
    assert book["mostAlpha"].max() <= 1 + 1e-10
    assert np.abs(book["unaccounted"]).max() <= 1e-12
    # The surface moves by a fiftieth of a cell in the first step
    first = -SPEED * HEIGHT * DEPTH * STEP
    assert book["broughtIn"][0] == pytest.approx(first, rel=0.01)
