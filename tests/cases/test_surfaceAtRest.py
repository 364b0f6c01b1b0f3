# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water below air at rest, with grains in it, on cells that are not orthogonal.

Density ratio 1000.  A surface that is given by the exact shares of the cells is level.
"""

import numpy as np
import pytest
from grain_box import DEPTH, control, lattice, mesh_triangles, replace, write_csv
from water_box import AIR, SIZE, WATER, set_water, to_two_fluids

GRAINS = "constant/grainProperties"
HEIGHT = 0.0525
SHEAR = np.tan(np.radians(30))
UPRIGHT, TURNED = np.eye(2), np.array([[0.96, -0.28], [0.28, 0.96]])
CORNERS = ("(0   0.1 {z})", "(0.1 0.1 {z})", "(0.1 0   {z})")


def area_below(polygon, height):
    """Of a convex polygon (n, 2)."""
    kept = []
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        if a[1] <= height:
            kept.append(a)
        if (a[1] <= height) != (b[1] <= height):
            kept.append(a + (height - a[1]) / (b[1] - a[1]) * (b - a))
    if len(kept) < 3:
        return 0.0
    x, y = np.array(kept).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def shares(case, height, turn=UPRIGHT):
    """Of each cell below a height in a turned box, round-off of the cutting left out."""
    full = [np.asarray(p)[:, :2] @ turn.T for p in case.mesh().polygons]
    share = np.array([area_below(p, height) / area_below(p, np.inf) for p in full])
    share[share < 1e-12] = 0
    share[share > 1 - 1e-12] = 1
    return share


def moved(mesh, x, y):
    """A place of the square in the sheared box."""
    return (x + SHEAR * y, y) if mesh == "columns" else (x, y + SHEAR * (x - SIZE / 2))


def pool(
    clone, mesh, centres=(), radius=0.003, fixed=True, height=HEIGHT, densities=(WATER, AIR)
):
    """Columns or rows of quads sheared by 30 degrees, turned squares or triangles.

    The heavier fluid, or the first, is up to a height.
    """
    case = clone("grainBox")
    write_csv(case, centres, radius)
    if mesh == "triangles":
        mesh_triangles(case)
    else:
        replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
        for corner in () if mesh == "turned" else CORNERS:
            for z in ("0", "0.01"):
                old = corner.format(z=z)
                x, y = (float(s) for s in old.strip("()").split()[:2])
                dx, dy = (SHEAR * y, 0) if mesh == "columns" else (0, SHEAR * x)
                replace(case, "system/blockMeshDict", old, f"({x + dx:.16g} {y + dy:.16g} {z})")
        case.run("blockMesh")
    turn = TURNED if mesh == "turned" else UPRIGHT
    x, y = -9.81 * turn[1]
    replace(case, "constant/g", "(0 -9.81 0)", f"({x:.16g} {y:.16g} 0)")
    to_two_fluids(case, densities)
    below = shares(case, height, turn)
    first = below if densities[0] >= densities[1] else 1 - below
    set_water(case, lambda low, high: first)
    if fixed:
        replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    case.dict_set("system/fvSolution", "PIMPLE/momentumPredictor", "no")
    case.dict_set("system/fvSolution", "PIMPLE/nNonOrthogonalCorrectors", "60")
    path = case.path / "system/fvSolution"
    path.write_text(path.read_text().replace("1e-12", "1e-16"))
    return case


def assert_rest(case, steps):
    control(case, deltaT=1e-3, endTime=steps * 1e-3, writeInterval=steps)
    case.run("grainInterFoam")
    assert np.abs(case.field("U")).max() <= 1e-8 * np.sqrt(9.81 * HEIGHT)


@pytest.mark.parametrize("mesh", ["columns", "rows", "triangles"])
def test_pool(clone, mesh):
    case = pool(clone, mesh)
    assert_rest(case, 100)
    # What is left of the corrections ends them long before the sixtieth
    assert case.log.count("Solving for p_rgh") < 100 * 2 * 30


@pytest.mark.parametrize("densities", [(AIR, WATER), (WATER, AIR), (WATER, WATER)])
@pytest.mark.parametrize("mesh", ["rows", "turned", "triangles"])
def test_either_fluid_may_be_named_first(clone, mesh, densities):
    """The first was below the levels, however light: 0.02 to 1.3 of sqrt(g h)."""
    assert_rest(pool(clone, mesh, [(0.0513, 0.0533)], 0.012, densities=densities), 40)


@pytest.mark.parametrize("mesh", ["columns", "rows", "triangles"])
def test_bed_in_and_above_the_surface(clone, mesh):
    places = lattice(8, 9, 0.0062, (0.025, 0.025))
    if mesh != "triangles":
        places = np.array([moved(mesh, *x) for x in places])
        places[:, 1] += 0.02 if mesh == "rows" else 0
    assert_rest(pool(clone, mesh, places), 60)


def test_disc_in_the_surface_of_triangles(clone):
    assert_rest(pool(clone, "triangles", [(0.0513, HEIGHT + 0.0008)], 0.025), 200)


STEPS = [250, pytest.param(1000, marks=pytest.mark.slow)]


@pytest.mark.parametrize("steps", STEPS)
@pytest.mark.parametrize("mesh", ["columns", "rows"])
def test_fixed_disc_in_the_surface(clone, mesh, steps):
    """Its cells had densities of their own, by which the gas beside it grew e-fold in 15 steps.

    In rows that slope, the compression of the surface pressed water through dry faces; it grew
    e-fold in 28 steps.
    """
    centre = (0.0513 + SHEAR * HEIGHT, HEIGHT + 0.0008) if mesh == "columns" else (0.0513, 0.0533)
    assert_rest(pool(clone, mesh, [centre], 0.02), steps)


@pytest.mark.parametrize("steps", STEPS)
@pytest.mark.parametrize("mesh", ["columns", "rows"])
def test_floating_disc(clone, mesh, steps):
    """Half in water, of the mean density: cells and disc are symmetric about its centre."""
    x, y = moved(mesh, 0.05, 0.0525) if mesh == "columns" else (0.0475, 0.0525 + SHEAR * 0.0475)
    case = pool(clone, mesh, [(x, y)], 0.02, fixed=False, height=y)
    replace(case, GRAINS, "density 2500", f"density {(WATER + AIR) / 2}")
    assert_rest(case, steps)
    assert case.grains()["position"][0, 1] == pytest.approx(y, abs=1e-9 * DEPTH)


def test_heavy_disc_that_lies_on_the_floor_in_the_surface(clone):
    """Free to move: the fluid took it for falling in the first step, and the air above the surface,
    in cells with a little water from then on, never came to rest (0.02 of sqrt(g h))."""
    case = pool(clone, "turned", [(0.05, 0.03)], 0.03, fixed=False, height=0.0325)
    replace(case, GRAINS, "density 2500", "density 20000")
    replace(case, "constant/g", "(-2.7468 -9.4176 0)", "(0 -9.81 0)")
    set_water(case, lambda low, high: shares(case, 0.0325))
    assert_rest(case, 250)
