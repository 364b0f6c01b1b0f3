# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small grains see the flow where they are in their cell (doc/theory, eq. 4.37)."""

import numpy as np
import pytest
from grain_box import control, grain_box, make_cyclic, replace

SPEED, HEIGHT = 0.1, 0.1  # of the lid; between the plates
WALLS = '"left|right|bottom|top"'


@pytest.mark.parametrize("grading", ["1", "4"])
def test_discs_in_a_shear_flow_have_the_speed_of_its_lines(clone, grading):
    """Discs of 0.04 to 0.17 of a cell and of the fluid's density, between a plate at rest and one
    that slides.  With the velocity of the cells all discs of a cell had one speed, and beside
    the plate five times that of the fluid there."""
    heights = np.array([0.001, 0.004, 0.009, 0.031, 0.033, 0.035, 0.037, 0.039, 0.052, 0.0985])
    case = grain_box(clone, [(0.05, y) for y in heights], 4e-4)
    make_cyclic(case, ("left", "right"))
    replace(case, "system/blockMeshDict", "simpleGrading (1 1", f"simpleGrading (1 {grading}")
    sides = '"left|right" { type cyclic; }'
    lid = f"top {{ type fixedValue; value uniform ({SPEED} 0 0); }}"
    replace(case, "0/U", WALLS, f"{sides} {lid} bottom")
    replace(case, "0/p_rgh", WALLS, f'{sides} "bottom|top"')
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/transportProperties", "1e-4", "1e-2")
    replace(case, "constant/grainProperties", "density 2500", "density 1000")
    replace(case, "constant/grainProperties", "(left right bottom top)", "(bottom top)")
    control(case, endTime=3, deltaT=0.01, writeInterval=300)
    case.run("blockMesh")
    case.run("grainFoam")
    track = case.table("postProcessing/tracks/0/grains.csv")
    last = track["time"] == track["time"].max()
    # The flow develops as exp(-pi^2 nu t/H^2), so that a 1e-13 of it is missing
    speed = SPEED * track["y"][last] / HEIGHT
    np.testing.assert_allclose(track["vx"][last], speed, rtol=0, atol=1e-3 * SPEED)
