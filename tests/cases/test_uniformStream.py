# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains and fluid of one velocity keep it, whatever the grains' size and density."""

import foamlib
import numpy as np
import pytest
from grain_box import control, cyclic_box, replace, write_csv
from sphere_box import sphere_box

SPEED, CELL = 0.25, 0.01


def stream(clone, diameter, density, centres=((0.043, 0.052),)):
    """A periodic box of 10 x 10 cells without weight; the fluid has 1000 kg/m3."""
    case = cyclic_box(clone, centres, diameter / 2)
    write_csv(case, centres, diameter / 2, [(SPEED, 0)] * len(centres))
    replace(case, "0/U", "uniform (0 0 0)", f"uniform ({SPEED} 0 0)")
    case.dict_set("constant/grainProperties", "materials/glass/density", str(density))
    control(case, deltaT=0.1 * CELL / SPEED, endTime=4 * CELL / SPEED, writeInterval=40)
    return case


# In cells
@pytest.mark.parametrize("diameter", [0.3, 1, 2.4, 3.9])
@pytest.mark.parametrize("density", [2500, 1000, 250, 1e5])
def test_one_grain(clone, diameter, density):
    case = stream(clone, diameter * CELL, density)
    case.run("grainFoam")
    U = case.field("U")
    np.testing.assert_allclose(U, np.broadcast_to([SPEED, 0, 0], U.shape), atol=1e-9 * SPEED)


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
@pytest.mark.parametrize("diameter", [1, 1.3, 3.9])
@pytest.mark.parametrize("density", [500, 250, 100])
def test_light_grains_in_thin_fluid_for_long(clone, diameter, density, scheme):
    """Aslant, without a viscosity to speak of: what a face remembers grew by a third a step."""
    velocity = (SPEED, 0.6 * SPEED)
    case = stream(clone, diameter * CELL, density)
    write_csv(case, [(0.043, 0.052)], diameter * CELL / 2, [velocity])
    replace(case, "0/U", f"uniform ({SPEED} 0 0)", f"uniform ({SPEED} {0.6 * SPEED} 0)")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, "system/fvSchemes", "Euler", scheme)
    control(case, deltaT=0.1 * CELL / SPEED, endTime=30 * CELL / SPEED, writeInterval=300)
    case.run("grainFoam")
    U = case.field("U")
    np.testing.assert_allclose(U, np.broadcast_to([*velocity, 0], U.shape), atol=1e-11 * SPEED)


@pytest.mark.parametrize("mesh", ["tetrahedra", "warped"])
# In edges of cells, the last one resolved
@pytest.mark.parametrize("diameter", [0.7, 1.5, 5])
def test_a_sphere_in_cells_of_other_kinds(clone, mesh, diameter):
    velocity = np.array([SPEED, 0.4 * SPEED, -0.3 * SPEED])
    side, n = 0.1, 8
    case = sphere_box(
        clone, [(0.051, 0.047, 0.055)], diameter * side / n / 2, mesh, n, velocity=[velocity]
    )
    text = " ".join(map(repr, velocity.tolist()))
    replace(case, "0/U", "uniform (0 0 0)", f"uniform ({text})")
    replace(case, "0/U", "noSlip", f"fixedValue; value uniform ({text})")
    replace(case, "constant/g", "(0 0 -9.81)", "(0 0 0)")
    control(case, deltaT=0.1 * side / n / SPEED, endTime=side / n / SPEED, writeInterval=10)
    case.run("grainFoam")
    U = np.asarray(foamlib.FoamFieldFile(case.path / case.times[-1] / "U").internal_field)
    np.testing.assert_allclose(U, np.broadcast_to(velocity, U.shape), atol=1e-8 * SPEED)
