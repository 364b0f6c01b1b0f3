# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water beside open sides of a tank: what their conditions give counts from the first step on,
whatever stands as 'value' in the file, as in interFoam."""

import numpy as np
import pytest
from grain_box import DEPTH, control, lattice, replace
from water_box import AIR, SIZE, WATER, level, set_water, water_box

GRAINS = "constant/grainProperties"
WALLS = '"left|right|bottom|top"'
N, HEIGHT = 20, 0.05
OPEN = "type pressureInletOutletVelocity; value uniform (0 0 0);"
AIR_ABOVE = "top { type inletOutlet; inletValue uniform 0; value uniform 0; }"


def tank(clone, sides, velocities):
    """Slip walls, a top and sides that are open, fixed grains in the lower half of the water."""
    bed = lattice(20, 5, 0.005, (0.0025, 0.0025))
    case = water_box(clone, level(HEIGHT), bed, radius=0.002, cells=(N, N))
    for patch in (*sides, "top"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    set_water(case, level(HEIGHT))
    replace(
        case,
        "0/U",
        f"{WALLS}\n    {{\n        type    noSlip;\n    }}",
        f'"left|right|bottom" {{ type slip; }} top {{ {OPEN} }} {velocities}',
    )
    replace(case, GRAINS, "(left right bottom top)", "(bottom)")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    case.dict_set("system/fvSolution", "PIMPLE/momentumPredictor", "no")
    return case


def faces(below, above):
    """Of the right side, below and above the level."""
    values = [below if (i + 0.5) * SIZE / N < HEIGHT else above for i in range(N)]
    return f"nonuniform List<scalar> {N} ({' '.join(map(repr, values))})"


@pytest.mark.parametrize(("value", "flux"), [(0, ""), (1, ""), (1, "phi phiFluid;")])
def test_a_pool_rests_beside_an_open_side(clone, value, flux):
    """Hydrostatic pressure there. With the density of the value water had 0.26 m/s after one
    step, and air 690 m/s. Conditions may go by the flux that carries."""
    case = tank(clone, ["right"], f"right {{ {OPEN} }}")
    head = faces((WATER - AIR) * 9.81 * HEIGHT, 0.0)
    ends = f"right {{ type fixedValue; value {head}; }} top {{ type fixedValue; value uniform 0; }}"
    replace(case, "0/p_rgh", WALLS, ends + ' "left|bottom"')
    share = f"{flux} inletValue {faces(1, 0)}; value uniform {value};"
    side = f"right {{ type inletOutlet; {share} }}"
    replace(case, "0/alpha.water", WALLS, f'{side} {AIR_ABOVE} "left|bottom"')
    control(case, deltaT=1e-3, endTime=0.02, writeInterval=20)
    case.run("grainInterFoam")
    assert np.abs(case.field("U")).max() <= 1e-8 * np.sqrt(9.81 * HEIGHT)


def test_a_flow_rate_comes_in_at_the_height_of_the_water(clone):
    """And leaves at the mean velocity of the water. The rate was divided by no water at all."""
    speed = 0.04
    rate = speed * HEIGHT * DEPTH
    case = tank(
        clone,
        ["left", "right"],
        f"left {{ type variableHeightFlowRateInletVelocity; flowRate {rate}; alpha alpha.water;"
        " value uniform (0 0 0); } right { type outletPhaseMeanVelocity; alpha alpha.water;"
        f" Umean {speed}; value uniform (0 0 0); }}",
    )
    replace(case, "0/p_rgh", WALLS, f'top {{ type fixedValue; value uniform 0; }} {WALLS}')
    side = "left { type variableHeightFlowRate; lowerBound 0; upperBound 1; value uniform 0; }"
    replace(case, "0/alpha.water", WALLS, f'{side} {AIR_ABOVE} "right|bottom"')
    control(case, deltaT=1e-3, endTime=0.05, writeInterval=1)
    case.run("grainInterFoam")
    assert case.flux("left") == pytest.approx(-rate, rel=1e-9)
    # The water's part of the outlet: what of the air is drawn along is not the rate's
    water = case.field("alpha.water").sum() - case.field("alpha.water", "0").sum()
    assert abs(water) * (SIZE / N) ** 2 * DEPTH <= 0.1 * rate * 0.05
