# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A grain and the fluid around it that move together, SPEED upwards: nothing acts, and cells that
the grain takes and leaves on its way must not push it."""

import numpy as np
from grain_box import control, open_ends, replace, tracks

SPEED = 0.1


def assert_they_go_on(case, density):
    """Of a grain of grain_box that has this speed, in 40 x 40 cells."""
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    replace(case, "constant/grainProperties", "density 2500", f"density {density}")
    case.run("blockMesh")
    # A fifth of the cell size per step
    control(case, deltaT=5e-3, endTime=0.2, writeInterval=40)
    case.run("grainFoam")
    motion = tracks(case)
    # Round-off and the solvers' tolerance
    np.testing.assert_allclose(motion[:, 6], SPEED, rtol=1e-9)
    np.testing.assert_allclose(motion[:, [5, 10]], 0, atol=1e-9 * SPEED)
    np.testing.assert_allclose(case.field("U")[:, 1], SPEED, rtol=1e-8)
