# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact angles on resolved grains: the meniscus at a fixed cylinder, half in water."""

import numpy as np
import pytest
from grain_box import control, halve_height, replace, write_csv
from water_box import AIR, SIZE, WATER, level, set_water, to_two_fluids

GRAINS = "constant/grainProperties"
RADIUS, HEIGHT = 0.01, SIZE / 4

# sqrt(sigma/(rho g)) [m]: the walls are 3.3 of it away from the cylinder
CAPILLARY = 0.012
SIGMA = (WATER - AIR) * 9.81 * CAPILLARY**2


def cylinder(clone, n, angle, above=0.0):
    """In a box of half the height, n cells wide, of fluids that are viscous enough to rest soon."""
    case = clone("grainBox")
    write_csv(case, [(SIZE / 2, HEIGHT + above)], RADIUS)
    halve_height(case)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({n} {n // 2} 1)")
    case.run("blockMesh")
    to_two_fluids(case, sigma=SIGMA)
    set_water(case, level(HEIGHT))
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    replace(case, GRAINS, "density 2500;", f"density 2500; contactAngle {angle};")
    for nu in ("1e-6", "1.48e-5"):
        replace(case, "constant/transportProperties", f"nu {nu}", "nu 1e-3")
    return case


def surface(case, n):
    """Heights of the surface in the columns of cells."""
    h = SIZE / n
    y = (np.arange(n // 2) + 0.5) * h
    heights = []
    for alpha in case.field("alpha.water").reshape(n // 2, n).T:
        i = np.flatnonzero((alpha[:-1] >= 0.5) & (alpha[1:] < 0.5))
        i = i[np.argmin(np.abs(y[i] - HEIGHT))] if len(i) else 0
        heights.append(y[i] + h * (alpha[i] - 0.5) / max(alpha[i] - alpha[i + 1], 1e-9))
    return np.array(heights)


def angle_of_meniscus(case, n):
    """From the height z at which surface and circle meet: a meniscus in two dimensions has there
    the slope phi of z = 2 a sin(phi/2), a the capillary length."""
    h = SIZE / n
    heights = surface(case, n)
    distance = (np.arange(n) + 0.5) * h - SIZE / 2
    places = np.linspace(-1.5, 1.5, 3001)
    contact = RADIUS
    for _ in range(20):
        near = (distance > contact + h) & (distance < contact + 6 * h)
        fit = np.polyfit(distance[near], heights[near], 2)
        gap = np.polyval(fit, RADIUS * np.cos(places)) - HEIGHT - RADIUS * np.sin(places)
        crossings = places[np.flatnonzero(gap[:-1] * gap[1:] <= 0)]
        place = crossings[np.argmin(np.abs(crossings))]
        contact = RADIUS * np.cos(place)
    z = HEIGHT + RADIUS * np.sin(place) - 0.5 * (heights[1] + heights[-2])
    return 90 - np.degrees(place + 2 * np.arcsin(z / (2 * CAPILLARY)))


@pytest.mark.parametrize(
    "n, angle",
    [
        (40, 60),
        (40, 120),
        *(pytest.param(80, angle, marks=pytest.mark.slow) for angle in (60, 90, 120)),
    ],
)
def test_meniscus(clone, n, angle):
    """8 and 16 cells in a diameter; the surface rises or falls to it from a level."""
    case = cylinder(clone, n, angle)
    step = 3e-4 * (80 / n) ** 1.5
    control(case, deltaT=step, endTime=0.3, writeInterval=round(0.3 / step))
    case.run("grainInterFoam")
    assert angle_of_meniscus(case, n) == pytest.approx(angle, abs=5)


def test_a_right_angle_leaves_a_pool_level(clone):
    """The cylinder is upright where the level meets it."""
    case = cylinder(clone, 40, 90)
    control(case, deltaT=5e-4, endTime=0.05, writeInterval=100)
    case.run("grainInterFoam")
    assert np.ptp(surface(case, 40)[[1, 5, 10, 30, 35, 38]]) <= 1e-3 * SIZE / 40
