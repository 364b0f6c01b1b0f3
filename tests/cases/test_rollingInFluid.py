# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small grains that roll under a viscous fluid, whose torque contacts pass on to their way."""

import numpy as np
import pytest
from dry_box import GRAINS
from grain_box import control, grain_box, replace, tracks
from sphere_box import sphere_box

RHO, RHO_GRAIN, NU, RADIUS = 1000.0, 2500.0, 1e-5, 5e-4
WEIGHT = np.array([4.0, -9.0])  # along the floor and down [m/s2]
# Of Stokes' law, and of (2.40) of the theory [1/s]
DRAG = 18 * RHO * NU / (RHO_GRAIN * (2 * RADIUS) ** 2)
TURNING = {2: 32 / 18 * DRAG, 3: 60 / 18 * DRAG}
INERTIA = {2: 1 / 2, 3: 2 / 5}  # over mass and radius squared


def on_a_floor(clone, dimension, floor=""):
    """A grain of 1 mm in cells of 0.1 m: the fluid hardly moves."""
    if dimension == 2:
        case = grain_box(clone, [(0.45, RADIUS)], RADIUS)
        replace(case, "system/blockMeshDict", "vertices", "scale 10;\n\nvertices")
        replace(case, GRAINS, "        shape   disc;", "        shape   sphere;")
        replace(case, GRAINS, "patches     (left right bottom top);", "POINT")
        weight, normal = (*WEIGHT, 0), "(0 1 0)"
        case.run("blockMesh")
    else:
        case = sphere_box(clone, [(0.45, 0.45, RADIUS)], RADIUS, side=1.0)
        replace(case, GRAINS, 'patches     (".*");', "POINT")
        weight, normal = (WEIGHT[0], 0, WEIGHT[1]), "(0 0 1)"
    replace(case, GRAINS, "POINT", f"point (0 0 0); normal {normal}; {floor}")
    replace(case, GRAINS, "type        patches;", "type        plane;")
    replace(case, GRAINS, "DallavalleDiFelice", "Stokes")
    replace(case, GRAINS, "friction    0.2;", "friction    1;")
    replace(case, GRAINS, "tolerance   1e-7", "tolerance   1e-13")
    down = "(0 -9.81 0)" if dimension == 2 else "(0 0 -9.81)"
    replace(case, "constant/g", down, f"({weight[0]} {weight[1]} {weight[2]})")
    replace(case, "constant/transportProperties", "1e-4", str(NU))
    return case


@pytest.mark.parametrize("step", [0.3, 3.0])
@pytest.mark.parametrize("dimension, ratio", [(2, 1), (2, 0.5), (3, 1)])
def test_grain_rolls_at_the_speed_that_drag_and_torque_let_it(clone, dimension, ratio, step):
    """No step is too long: friction holds the spin that the fluid would take."""
    case = on_a_floor(clone, dimension)
    replace(case, GRAINS, "coupling\n{", f"coupling\n{{\n    packingRatio {ratio};")
    turning = TURNING[dimension]
    control(case, deltaT=step / turning, endTime=60 / turning, writeInterval=1000)
    control(case, timePrecision=12)
    case.run("grainFoam")
    last = tracks(case)[-1]
    # The friction's work on the way is nothing: both resistances act at one speed
    reduced = (1 - RHO / RHO_GRAIN) * WEIGHT[0]
    # The smaller disc that the fluid sees has more drag, and as much torque, for its mass
    speed = reduced / (DRAG / ratio + INERTIA[dimension] * turning)
    # The fluid of the cell moves with a part of that
    assert last[5] == pytest.approx(speed, rel=5e-3)
    spin = -last[10] if dimension == 2 else last[9]
    assert spin * RADIUS == pytest.approx(last[5], rel=1e-6)


@pytest.mark.parametrize("dimension", [2, 3])
def test_belt_carries_a_grain_by_as_much_as_the_fluid_holds_its_spin(clone, dimension):
    belt = 0.02
    motion = f"motion {{ type translation; velocity ({belt} 0 0); }}"
    case = on_a_floor(clone, dimension, motion)
    replace(case, "constant/g", f"({WEIGHT[0]} ", "(0 ")
    turning = TURNING[dimension]
    control(case, deltaT=1 / turning, endTime=60 / turning, writeInterval=1000, timePrecision=12)
    case.run("grainFoam")
    spun = INERTIA[dimension] * turning
    assert tracks(case)[-1, 5] == pytest.approx(belt * spun / (DRAG + spun), rel=5e-3)
