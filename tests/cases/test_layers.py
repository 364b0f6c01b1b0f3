# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of fixed grains between clear fluid, in cells about as large as a grain."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, open_ends, replace

GRAINS = "constant/grainProperties"
SPEED, SPACING, DIAMETER = 0.01, 0.005, 0.0042
EPS = 1 - np.pi * DIAMETER**2 / 4 / SPACING**2


def drop_over_law(clone, rows, n, Re, flow="filtered"):
    """Pressure drop of rows of discs over that of the law of the thesis in a bed of their kind."""
    nu = SPEED * DIAMETER / Re
    corner = (SPACING / 2, 0.04 + SPACING / 2)
    case = grain_box(clone, lattice(20, rows, SPACING, corner), DIAMETER / 2, name=flow)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({n} {n} 1)")
    replace(case, "constant/transportProperties", "1e-4", repr(nu))
    open_ends(case, SPEED)
    options = f"motion fixed; resolvedGrains {{ type none; }} undisturbedFlow {{ type {flow}; }}"
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    {options}\n")
    case.run("blockMesh")
    control(case, deltaT=0.01, endTime=0.5, writeInterval=50)
    case.run("grainFoam")
    p = case.field("p_rgh").reshape(n, n).mean(axis=1)
    voidage = EPS ** (-2.8 + 0.65 * np.exp(-((1.5 - np.log10(Re)) ** 2) / 2))
    lone = 2 / np.pi * (0.63 * np.sqrt(Re) + 4.8) ** 2 * 1000 * nu / DIAMETER**2
    law = (1 - EPS) * lone * voidage / EPS**2 * SPEED * rows * SPACING
    return (p[1] - p[-2]) / law


@pytest.mark.parametrize("Re", [0.1, 50])
@pytest.mark.parametrize("rows, n, low", [(8, 20, 0.9), (8, 40, 0.9), (3, 20, 0.83)])
def test_the_surface_of_a_bed_has_the_drag_of_the_bed(clone, rows, n, low, Re):
    """A filter that mixes it with the clear fluid outside left 0.74 of eight rows, 0.4 of three."""
    assert low < drop_over_law(clone, rows, n, Re) < 1.01


def test_the_flow_of_the_cells_has_the_law(clone):
    assert drop_over_law(clone, 8, 20, 0.1, "none") == pytest.approx(1, abs=0.005)
