# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small grains beside a resolved one: together they leave cells with next to no fluid."""

import numpy as np
import pytest
from grain_box import control, grain_box, replace

CELL, RESOLVED = 0.0025, 0.0105


def ring(radius, gap, seed):
    """A disc of 8.4 cells, somewhere, and six around it."""
    random = np.random.default_rng(seed)
    centre = random.uniform(0.045, 0.055, 2) + [0, 0.02]
    angles = random.uniform(0, 2 * np.pi) + np.arange(6) * np.pi / 3
    away = (RESOLVED + radius + gap) * np.column_stack([np.cos(angles), np.sin(angles)])
    return np.vstack([centre, centre + away]), [RESOLVED, *[radius] * 6]


# Of the small ones in cells: they cover one to four, never whole.  With central convection in
# those the fluid had 4e5 m/s after 60 steps.
@pytest.mark.parametrize("cells", [1.4, 1.52, 1.84])
@pytest.mark.parametrize("gap, dt", [(0, 1e-3), (0.1, 1e-3), (0.3, 5e-4)])
def test_fluid_falls_no_faster_than_the_grains(clone, cells, gap, dt):
    for seed in (12, 15, 20):
        centres, radii = ring(cells * CELL / 2, gap * CELL, seed)
        case = grain_box(clone, centres, radii, name=f"seed{seed}")
        replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
        case.run("blockMesh")
        replace(case, "constant/transportProperties", "1e-4", "1e-6")
        control(case, deltaT=dt, endTime=0.06, writeInterval=round(0.01 / dt))
        case.run("grainFoam")
        fastest = np.linalg.norm(case.grains()["velocity"], axis=1).max()
        assert fastest <= 9.81 * (1 - 1 / 2.5) * 0.06
        for time in case.times[1:]:
            # Beside grains that fall it goes up, through gaps faster than they
            fluid = np.linalg.norm(case.field("U", time), axis=1)
            assert fluid.max() <= 2 * fastest
