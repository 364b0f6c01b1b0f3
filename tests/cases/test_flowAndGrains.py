# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow through grains that do not move, and grains that a shear flow turns."""

import numpy as np
import pytest
from grain_box import (
    control,
    grain_box,
    lattice,
    make_cyclic,
    mesh_triangles,
    open_ends,
    replace,
    tracks,
)
from test_motion import gamma

WALLS = '"left|right|bottom|top"'


def test_pressure_drop_and_velocity_of_a_fixed_bed(clone):
    """Three rows of cells full of fixed grains, clear fluid on both sides."""
    d, spacing, height, speed, nu = 0.004, 0.005, 0.03, 1e-3, 1e-4
    case = grain_box(clone, lattice(20, 6, spacing, (0.0025, 0.0425)), d / 2)
    open_ends(case, speed)
    case.run("blockMesh")
    replace(case, "constant/transportProperties", "1e-4", str(nu))
    replace(case, "constant/grainProperties", "coupling\n{", "coupling\n{\n    motion  fixed;")
    control(case, deltaT=1e-2, endTime=3, writeInterval=300)
    case.run("grainFoam")

    eps = 1 - np.pi / 4 * (d / spacing) ** 2
    slip = speed / eps
    law = (1 - eps) / eps * gamma(slip, d, 1000 * nu, eps) * slip * height
    p = case.field("p_rgh").reshape(10, 10)
    # The face between bed and clear fluid sees both: nothing of the bed is lost
    assert p[0].mean() - p[-1].mean() == pytest.approx(law, rel=0.01)

    u = case.field("U")[:, 1].reshape(10, 10)
    np.testing.assert_allclose(u[4:7], slip, rtol=0.01)
    # A jump of eps over one cell is all that the coarse mesh has
    np.testing.assert_allclose(u[[0, 1, 2, 3, 7, 8, 9]], speed, rtol=0.05)


@pytest.mark.parametrize(
    "cells, radius, low, high",
    [
        # Half of the vorticity of its cells, which it holds back a little: found -0.467, -0.469
        (4, 0.005, -0.5, -0.45),
        (10, 0.005, -0.5, -0.45),
        # Freely turning at Re -> 0: half the shear rate, 3 % at eight cells across the grain
        (40, 0.01, -0.515, -0.485),
    ],
)
def test_shear_turns_a_grain(clone, cells, radius, low, high):
    case = grain_box(clone, [(0.05, 0.05)], radius)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    speed = 0.005
    replace(
        case,
        "0/U",
        f"{WALLS}\n    {{\n        type    noSlip;\n    }}",
        '"left|right" { type cyclic; }'
        f" top {{ type fixedValue; value uniform ({speed} 0 0); }}"
        f" bottom {{ type fixedValue; value uniform (-{speed} 0 0); }}",
    )
    replace(case, "0/p_rgh", WALLS, '"left|right" { type cyclic; }\n "bottom|top"')
    replace(case, "constant/transportProperties", "1e-4", "1e-2")
    replace(case, "constant/grainProperties", "density 2500", "density 1000")
    replace(case, "constant/grainProperties", "(left right bottom top)", "(bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    # Four times the height's diffusion time
    control(case, endTime=1, writeInterval=1000)
    case.run("grainFoam")

    spin = tracks(case)[-1, 10] / (2 * speed / 0.1)
    assert low <= spin <= high


def test_a_grain_that_covers_cells_falls_smoothly(clone):
    """Eight cells across: the fluid inside the grain moves with it, that around it stays slow."""
    case = grain_box(clone, [(0.05, 0.07)], 0.005)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(80 80 1)")
    case.run("blockMesh")
    replace(case, "constant/grainProperties", "density 2500", "density 1010")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    control(case, deltaT=5e-3, endTime=1, writeInterval=200)
    case.run("grainFoam")

    path = tracks(case)
    speed = -path[:, 6]
    # From rest, faster in every step of the first half second
    assert np.all(np.diff(speed[:100]) > 0)
    # Never faster than a body whose added mass is that of its own volume of fluid, which cells
    # of an eighth of its diameter know to an eighth; drag takes its part later
    free = (0.01 / 2.01) * 9.81 * path[:, 0]
    assert np.all(speed < (1 + 1 / 8) * free)
    assert speed[-1] > 0.5 * free[-1]
    assert np.linalg.norm(case.field("U"), axis=1).max() < 2.5 * speed[-1]


@pytest.mark.parametrize("cells, surface", [(2, 0.06), (3, 0.02)])
def test_a_disc_that_settles_between_triangles_does_not_spin(clone, cells, surface):
    """At Re 24; speed of its surface over its own was 0.24 and 0.044 where moments turned it."""
    radius = 0.003
    h = 2 * radius / cells
    case = grain_box(clone, [(0.05 + 0.13 * h, 0.085)], radius)
    replace(case, "box.geo", "h = 0.01;", f"h = {1.52 * h};")
    mesh_triangles(case)
    replace(case, "system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 2")
    replace(case, "constant/transportProperties", "1e-4", "2e-5")
    replace(case, "constant/grainProperties", "density 2500", "density 1200")
    control(case, deltaT=1e-3, endTime=0.5, writeInterval=500)
    case.run("grainFoam")
    path = tracks(case)
    later = path[path[:, 0] > 0.15]
    speed = radius * np.sqrt(np.mean(later[:, 10] ** 2))
    assert speed <= surface * abs(later[:, 6].mean())
