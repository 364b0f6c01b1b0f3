# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force of surface tension on a fixed sphere with a contact angle, without weight."""

import numpy as np
import pytest
from grain_box import control, replace, tracks
from moving_mesh import write
from sphere_box import sphere_box
from test_meniscus import RADIUS, SIGMA
from water_box import to_two_fluids

GRAINS = "constant/grainProperties"
SIDE = 4 * RADIUS


def below(height):
    """Volume of a sphere of radius 1 below a height over its centre."""
    return np.pi * (2 / 3 + height - height**3 / 3)


def force(angle, depth):
    """Upwards, over tension and radius, in a round tank of upright angle at its wall.  The surface
    has one curvature and little slope; its pressure times the tank's section is the force."""
    section = (SIDE / RADIUS) ** 2
    tank = np.sqrt(section / np.pi)

    def meniscus(contact):
        """What it has more of water, and the force, if the sphere is wet up to a height."""
        r = np.linspace(np.sqrt(1 - contact**2), tank, 2001)
        slope = np.tan(angle - np.arccos(contact))
        curvature = 2 * r[0] * slope / (r[0] ** 2 - section / np.pi)
        z = contact + curvature * ((r**2 - r[0] ** 2) / 4 - section / np.pi * np.log(r / r[0]) / 2)
        ring = 2 * np.pi * np.sum((r * z)[1:] + (r * z)[:-1]) / 2 * (r[1] - r[0])
        water = ring + np.pi * r[0] ** 2 * contact - below(contact)
        return water - (section * depth - below(depth)), -curvature * section

    low, high = depth - 0.3, depth + 0.3
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if meniscus(middle)[0] < 0 else (low, middle)
    return meniscus(middle)[1]


@pytest.mark.parametrize("angle, depth", [(60, 0.3), (110, -0.2)])
def test_fixed_sphere(clone, angle, depth):
    """8 cells in the diameter, the centre so many radii below a level that is flat at first."""
    n = 16
    middle = SIDE / 2
    centre = (middle, middle, middle - depth * RADIUS)
    case = sphere_box(clone, [centre], RADIUS, n=n, side=SIDE)
    to_two_fluids(case, sigma=SIGMA)
    values = "\n".join(["1"] * (n**3 // 2) + ["0"] * (n**3 // 2))
    write(
        case,
        "0/alpha.water",
        "volScalarField",
        f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar> {n**3}\n({values});\n"
        'boundaryField { ".*" { type zeroGradient; } }\n',
    )
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    replace(case, GRAINS, "density 2500;", f"density 2500; contactAngle {angle};")
    replace(case, "constant/g", "-9.81", "0")
    for nu in ("1e-6", "1.48e-5"):
        replace(case, "constant/transportProperties", f"nu {nu}", "nu 1e-3")
    steps = 100
    control(case, deltaT=8e-4, endTime=8e-4 * steps, writeInterval=steps)
    case.run("grainInterFoam")
    found = tracks(case)[-1, 11:14] / (SIGMA * RADIUS)
    # Two degrees
    np.testing.assert_allclose(found, [0, 0, force(np.radians(angle), depth)], atol=0.17)
