# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A developed state that is divided through a pair of cyclic patches goes on as on one rank.

decomposePar leaves there values of a rank's own cells, for those on the other side."""

import shutil

import numpy as np
import pytest
from grain_box import control, cyclic_box, grain_box, lattice, make_cyclic, replace
from heat_box import with_heat, write_scalar
from test_turbulence import EPSILON, MODELS, SCHEMES, SOLVER, K, set_model
from water_box import column, set_water, to_two_fluids

pytestmark = pytest.mark.parallel

GRAINS = "constant/grainProperties"
CENTRES = lattice(4, 4, 0.025, (0.011, 0.013))
FLUID = "constant/transportProperties"
CYCLIC = '"left|right|bottom|top" { type cyclic; }'
SIDES, LIDS = '"left|right" { type cyclic; }', '"bottom|top"'


def stirred(clone, name="whole"):
    """Grains that fall in a box without boundaries, across which the fluid differs."""
    case = cyclic_box(clone, CENTRES[:9], 0.004)
    case.path = case.path.rename(case.path.with_name(name))
    replace(case, "constant/g", "(0 0 0)", "(3 -9.81 0)")
    return case


def falling(clone):
    """The same between a floor and a lid: weight that is not even is across the pair."""
    case = grain_box(clone, CENTRES[:9], 0.004, name="whole")
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    for field in ("U", "p_rgh"):
        replace(case, f"0/{field}", '"left|right|bottom|top"', f"{SIDES}\n    {LIDS}")
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    return case


def fluid(clone):
    case = stirred(clone)
    replace(case, "system/fvSchemes", "Euler", "backward")
    return case, "grainFoam", ["U"]


def turbulent(clone):
    case = stirred(clone)
    patches = f"{CYCLIC} frontAndBack {{ type empty; }}"
    write_scalar(case, "k", "0 2 -2 0 0 0 0", K, patches)
    write_scalar(case, "epsilon", "0 2 -3 0 0 0 0", EPSILON, patches)
    write_scalar(case, "nut", "0 2 -1 0 0 0 0", 0, patches)
    replace(case, "system/fvSchemes", "    div(tau)", SCHEMES + "    div(tau)")
    replace(case, "system/fvSolution", "    U\n", f'    "(k|epsilon)" {SOLVER}\n    U\n')
    replace(case, FLUID, "1e-4;", "1e-4;\ntransportModel Newtonian;")
    set_model(case, MODELS["kEpsilon"])
    return case, "grainFoam", ["U", "k", "nut"]


def heated(clone):
    case = falling(clone)
    T = 300 + 100 * np.random.default_rng(3).random(100)
    with_heat(
        case,
        T=T,
        patches=f"{SIDES} {LIDS} {{ type zeroGradient; }}",
        fluid="Cp 1000; kappa table ((300 0.6) (400 6)); beta 1e-3; TRef 300;",
    )
    replace(case, "0/p_rgh", "zeroGradient;", "fixedFluxPressure; value uniform 0;")
    return case, "grainThermalFoam", ["U", "T"]


def of_two_fluids(clone):
    """A column of water that falls over at the boundary."""
    case = falling(clone)
    to_two_fluids(case, sigma=0.07)
    set_water(case, column(0.04, 0.1))
    walls = '"left|right|bottom|top"'
    replace(case, "0/alpha.water", walls, f"{SIDES} {LIDS}")
    return case, "grainInterFoam", ["U", "alpha.water"]


@pytest.mark.parametrize("make", [fluid, turbulent, heated, of_two_fluids])
def test_divided_state_goes_on(clone, make):
    case, application, fields = make(clone)
    control(case, deltaT=1e-3, endTime=0.02, writeInterval=20)
    case.run(application)
    many = clone("grainBox", "many")
    shutil.rmtree(many.path)
    shutil.copytree(case.path, many.path)

    for one in (case, many):
        control(one, endTime=0.022, writeInterval=1)
    case.run(application)
    many.run("decomposePar -latestTime")
    many.parallel(application, 2)
    many.run("reconstructPar -latestTime")
    for name in fields:
        a, b = case.field(name), many.field(name)
        # The linear solvers' tolerance
        np.testing.assert_allclose(a, b, rtol=0, atol=1e-7 * np.ptp(a))
