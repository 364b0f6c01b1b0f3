# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in a fluid between cyclic patches, and the flow through arrays of fixed grains."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, ledger, replace, tracks
from sphere_box import SIDE, cyclic_cube, field

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
METHODS = ["exactOverlap", "satellitePoints", "gaussianKernel; width 2", "diffused; length 0.02"]


def falling(clone, name, centre, cells, method="exactOverlap", pair=False):
    """A grain that is pushed to the right and falls."""
    case = cyclic_box(clone, [centre], 0.009)
    case.path = case.path.rename(case.path.with_name(name))
    replace(case, "constant/g", "(0 0 0)", "(5 -9.81 0)")
    replace(case, GRAINS, "exactOverlap", method)
    if pair:
        shape = "shapes { pair { type cluster; centres ((0 0 0) (2.236 0 0)); radii (2 2); } }\n"
        replace(case, GRAINS, "walls\n{}", shape + "walls\n{}")
        grains = case.path / "constant/grains.csv"
        header, line = grains.read_text().splitlines()
        grains.write_text(f"{header},shape\n{line},pair\n")
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    control(case, deltaT=2e-3, endTime=0.1, writeInterval=50)
    case.run("grainFoam")
    return case


@pytest.mark.parametrize(
    "cells, method, pair",
    [(10, method, False) for method in METHODS] + [(40, METHODS[0], False), (40, METHODS[0], True)],
)
def test_where_the_boundary_is_does_not_matter(clone, cells, method, pair):
    """Of two grains, one passes the boundaries and the other does not."""
    inside = falling(clone, "inside", (0.045, 0.055), cells, method, pair)
    across = falling(clone, "across", (0.095, 0.005), cells, method, pair)
    a, b = tracks(inside), tracks(across)
    assert np.ptp(a[:, 2:4], axis=0).min() > 0.008
    scale = np.abs(a[-1, 5:7]).max()
    # The linear solvers' tolerance
    np.testing.assert_allclose(a[:, 5:7], b[:, 5:7], atol=1e-6 * scale)
    np.testing.assert_allclose(a[:, 2:4] + (0.05, -0.05), b[:, 2:4], atol=1e-6 * scale)
    np.testing.assert_allclose(a[:, 10], b[:, 10], atol=1e-4 * np.abs(a[:, 10]).max() + 1e-6)
    assert ledger(across)["mappingError"].max() <= (1e-8 if pair else 1e-12)


def fixed(case, drop, nu, delta_t, steps):
    """A periodic array of fixed grains, through which a drop of pressure drives the fluid."""
    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    motion  fixed;")
    replace(case, FLUID, "1e-4", str(nu))
    path = case.path / "0/p_rgh"
    jump = "{ type fixedJump; patchType cyclic; value uniform 0;"
    path.write_text(
        path.read_text().replace(
            "boundaryField\n{",
            f"boundaryField\n{{\n    left {jump} jump uniform {drop}; }}\n    right {jump} }}\n",
        )
    )
    control(case, deltaT=delta_t, endTime=(steps + 0.5) * delta_t, writeInterval=steps)
    control(case, timePrecision=12)
    case.run("grainFoam")
    motion = tracks(case)
    assert np.abs(motion[:, 5:11]).max() == 0
    return motion[-1, 11]


# Force over mu U: Sangani and Acrivos, Int. J. Multiphase Flow 8, 193, 1982, table 1
@pytest.mark.parametrize("fraction, exact", [(0.05, 15.56), (0.1, 24.83)])
def test_square_array_of_cylinders(clone, fraction, exact):
    side, depth, nu, drop = 0.1, 0.01, 1.0, -1e-3
    case = cyclic_box(clone, [(0.003, 0.041)], np.sqrt(fraction / np.pi) * side)
    cells = 40
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    replace(case, "0/p_rgh", '"left|right|bottom|top"', '"bottom|top"')
    # Viscous time of a cell, and of the gap
    force = fixed(case, drop, nu, 4 * (side / cells) ** 2 / nu, 320)
    # What drives the fluid is on the grain in the end
    assert force == pytest.approx(-drop * side * depth, rel=1e-3)
    speed = case.field("U")[:, 0].mean()
    # Ten and fourteen cells across: 0.7 and 1.3 % above
    assert force / (1e3 * nu * speed * depth) == pytest.approx(exact, rel=0.03)


def test_flow_through_narrow_gaps_does_not_depend_on_the_time_step(clone):
    """Gaps of two and a half cells: face and cell velocities differ beside the grains."""
    radius, nu, drop, cells = 0.0245, 1e-3, -40.0, 12
    flow = []
    for delta_t in (4e-3, 1e-3):
        case = cyclic_box(clone, [(0.003, 0.041), (0.053, 0.091)], radius)
        case.path = case.path.rename(case.path.with_name(str(delta_t)))
        replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
        case.run("blockMesh")
        replace(case, "0/p_rgh", '"left|right|bottom|top"', '"bottom|top"')
        fixed(case, drop, nu, delta_t, round(1 / delta_t))
        flow.append(case.field("U")[:, 0].mean())
    # With OpenFOAM's ddtCorr 15 % more with the longer step
    assert flow[0] == pytest.approx(flow[1], rel=0.01)


def test_flow_through_an_array_of_few_cells(clone):
    """The fluid beside grains feels the whole pressure gradient along their surface."""
    radius, nu, drop = 0.02, 1e-3, -5.0
    flow = []
    for cells in (10, 40):
        case = cyclic_box(clone, [(0.003, 0.041), (0.053, 0.091)], radius)
        case.path = case.path.rename(case.path.with_name(str(cells)))
        replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
        case.run("blockMesh")
        replace(case, "0/p_rgh", '"left|right|bottom|top"', '"bottom|top"')
        fixed(case, drop, nu, 2e-3, 500)
        flow.append(case.field("U")[:, 0].mean())
    # Four cells in a diameter: 6.7 % less than sixteen; with a gradient that vanishes at the
    # faces of grains 12.5 % less
    assert flow[0] == pytest.approx(flow[1], rel=0.09)


def test_cubic_array_of_spheres(clone):
    """Force over 3 pi mu d U: Zick and Homsy, J. Fluid Mech. 115, 13, 1982, table 2."""
    fraction, exact, nu, drop, cells = 0.064, 2.810, 1.0, -1e-3, 20
    radius = np.cbrt(3 / (4 * np.pi) * fraction) * SIDE
    case = cyclic_cube(clone, [(0.03 * SIDE, 0.5 * SIDE, 0.97 * SIDE)], radius, cells)
    replace(case, "0/p_rgh", '".*"', '"bottom|top|back|front"')
    force = fixed(case, drop, nu, 4 * (SIDE / cells) ** 2 / nu, 80)
    assert force == pytest.approx(-drop * SIDE**2, rel=1e-3)
    speed = field(case, "U")[:, 0].mean()
    # Ten cells across: 0.7 % above
    assert force / (6 * np.pi * 1e3 * nu * radius * speed) == pytest.approx(exact, rel=0.03)
