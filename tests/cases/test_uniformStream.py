"""Grains and fluid of one velocity keep it, whatever the grains' size and density."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, replace, write_csv

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
