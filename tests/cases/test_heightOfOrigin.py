# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where heights are counted from is of no account, with a momentum predictor, too."""

import numpy as np
import pytest
from grain_box import control, grain_box, replace
from heat_box import with_heat, write_scalar
from water_box import AIR, WATER, level, set_water, water_box

G = 9.81


def lift(case, dy):
    case.run(f'transformPoints -translate "(0 {dy} 0)"')
    file = case.path / "constant/grains.csv"
    header, *lines = file.read_text().splitlines()
    rows = [line.split(",") for line in lines]
    moved = [",".join([x, repr(float(y) + dy), *others]) for x, y, *others in rows]
    file.write_text("\n".join([header, *moved, ""]))


def finish(case, solver, loop):
    case.dict_set("system/fvSolution", f"{loop}/momentumPredictor", "yes")
    for end in (0.01, 0.02) if "parts" in case.path.name else (0.02,):
        control(case, deltaT=1e-3, endTime=end, writeInterval=10)
        case.run(solver)
    return case.field("U"), case.grains()["velocity"]


def hot(clone, radius, dy, name="hot"):
    case = grain_box(clone, [(0.05, 0.05)], radius, name=f"{name}{dy}")
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    case.run("blockMesh")
    fluid = "Cp 4180; kappa 0.6; beta 2e-3; TRef 300;"
    with_heat(case, T=300, grains=380, fluid=fluid)
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure; value uniform 0")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    lift(case, dy)
    return finish(case, "grainThermalFoam", "PISO")


def in_surface(clone, radius, dy, name="surface"):
    case = water_box(clone, level(0.05), [(0.05, 0.052)], radius, (40, 40), name=f"{name}{dy}")
    alpha = case.field("alpha.water", "0")
    lift(case, dy)
    set_water(case, level(0.05 + dy))
    weight = (AIR + (WATER - AIR) * alpha) * G * dy
    walls = '"left|right|bottom|top" { type fixedFluxPressure; value uniform 0; }'
    write_scalar(case, "p_rgh", "1 -1 -2 0 0 0 0", weight, walls + " frontAndBack { type empty; }")
    return finish(case, "grainInterFoam", "PIMPLE")


# Locked, and 1.2 cells; of the speeds, which are 0.03 to 1 m/s, what the pressure's solver leaves
# at 1e8 Pa.  At 100 m the locked ones had other velocities by 0.5 to 44 m/s.
@pytest.mark.parametrize("radius", [0.0125, 0.0015])
@pytest.mark.parametrize("scene", [hot, in_surface])
def test_the_origin_of_heights_may_be_anywhere(clone, scene, radius):
    near, far = scene(clone, radius, 0), scene(clone, radius, 100)
    for one, other in zip(near, far, strict=True):
        assert np.abs(one).max() > 0.02
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-5)


@pytest.mark.parametrize("scene", [hot, in_surface])
def test_a_run_in_two_parts_is_the_same(clone, scene):
    for one, other in zip(
        scene(clone, 0.0125, 100), scene(clone, 0.0125, 100, "parts"), strict=True
    ):
        # p, and so p_rgh, is that of the step but for round-off, of 1e6 Pa
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)
