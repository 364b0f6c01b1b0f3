# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulence models around resolved grains of open parts of cells."""

import numpy as np
import pytest
from grain_box import control, grain_box, ledger, open_ends, replace, run_whole_and_parts, tracks
from heat_box import fix_grains, stream, with_heat, write_scalar
from test_cutCells import (
    FLUID,
    assert_dye_is_kept,
    assert_ranks_agree,
    choose,
    dyed,
    falling,
    refused,
    with_cells,
)
from test_parallel import decompose
from test_restart import assert_same
from test_turbulence import set_model

SMAGORINSKY = (
    "simulationType LES; LES { LESModel Smagorinsky; turbulence on; printCoeffs off;"
    " delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; } }"
)
WITHOUT = 'frontAndBack { type empty; } ".*" { type zeroGradient; }'


def eddies(case, model=SMAGORINSKY):
    """With that model of turbulence."""
    replace(case, FLUID, "1e-4;", "1e-4;\ntransportModel Newtonian;")
    write_scalar(case, "nut", "0 2 -1 0 0 0 0", 0, WITHOUT)
    set_model(case, model)
    return case


def test_fluid_and_grain_that_move_together_go_on(clone):
    speed = 0.1
    case = choose(grain_box(clone, [(0.047, 0.04)], 0.01, velocity=[(0, speed)]))
    open_ends(case, speed)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {speed} 0)")
    eddies(with_cells(case, 40))
    control(case, deltaT=5e-3, endTime=0.2, writeInterval=40)
    case.run("grainFoam")
    # Round-off and the solvers' tolerance
    np.testing.assert_allclose(tracks(case)[:, 6], speed, rtol=1e-9)
    np.testing.assert_allclose(case.field("U")[:, 1], speed, rtol=1e-8)


def test_a_model_that_has_nothing_to_do_changes_nothing(clone):
    """Re 40, 8 cells in the diameter: y+ is below 2 in the cells of the surface."""
    drag = []
    for model in (None, SMAGORINSKY.replace("printCoeffs off;", "SmagorinskyCoeffs { Ck 1e-9; }")):
        case = choose(grain_box(clone, [(0.0371, 0.0511)], 0.00625, name=f"{model is None}"))
        with_cells(case, 64)
        stream(case, 0.1)
        if model:
            eddies(case, model)
        replace(case, FLUID, "1e-4", repr(0.1 * 0.0125 / 40))
        fix_grains(case)
        control(case, deltaT=2e-3, endTime=0.4, writeInterval=200)
        case.run("grainFoam")
        drag.append(tracks(case)[-1, 11])
    assert drag[1] == pytest.approx(drag[0], rel=1e-3)


def test_momentum_is_kept_and_scalars_have_their_range(clone):
    """A disc falls through dyed fluid that it stirs."""
    case = dyed(eddies(falling(clone)))
    replace(case, FLUID, "1e-4", "1e-6")
    case.run("grainFoam")
    assert case.field("nut").max() > 1e-5
    assert_dye_is_kept(case)
    assert ledger(case)["momentumError"].max() <= 1e-10


def test_stop_and_restart(clone):
    whole, parts = (eddies(falling(clone, name)) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.06, end=0.12)
    assert_same(whole, parts)


def test_ranks_agree(clone):
    one, many = (eddies(falling(clone, name)) for name in ("one", "many"))
    decompose(many, 2)
    assert_ranks_agree(one, many, 2)


def test_heat_is_refused(clone):
    """The layer at the surface that turbulence leaves has no law for heat."""
    case = with_heat(eddies(falling(clone)))
    refused(case, "grainThermalFoam", "turbulence and heat")
