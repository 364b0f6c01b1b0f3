# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulence models around resolved grains of open parts of cells."""

import numpy as np
import pytest
from droplet_box import BOILING, GAS, with_droplets
from grain_box import (
    DEPTH,
    control,
    grain_box,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
    tracks,
)
from heat_box import fix_grains, heat_ledger, stream, with_heat, write_scalar
from test_cutCells import (
    FLUID,
    assert_dye_is_kept,
    assert_ranks_agree,
    choose,
    dyed,
    falling,
    with_cells,
)
from test_heatRuns import assert_books_close
from test_heatRuns import assert_ranks_agree as assert_ranks_agree_on_heat
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


RADIUS, NU, HOT, COLD = 0.02, 1e-6, 400.0, 300.0


def spinning(clone, spin, prandtl):
    """Cold disc of 8 cells in hot fluid at rest: heat in a first, short step, with and without a
    turbulence model."""
    heats = []
    for name, chosen in (("eddies", SMAGORINSKY), ("none", None)):
        case = choose(with_cells(grain_box(clone, [(0.051, 0.0493)], RADIUS, name=name), 20))
        row = f"0.051,0.0493,0.005,{RADIUS},0,0,0,0,0,{spin}\n"
        (case.path / "constant/grains.csv").write_text("x,y,z,radius,vx,vy,vz,wx,wy,wz\n" + row)
        replace(case, "constant/g", "-9.81", "0")
        if chosen:
            eddies(case, chosen)
        replace(case, FLUID, "1e-4;", f"{NU};")
        kappa = 1000 * NU * 1000 / prandtl
        fluid = f"Cp 1000; kappa {kappa};"
        with_heat(case, HOT, COLD, fluid=fluid, ofGlass="heatCapacity 1e6;")
        control(case, deltaT=1e-6, endTime=1e-6, writeInterval=1)
        case.run("grainThermalFoam")
        heats.append(heat_ledger(case)["exchanged"][0])
    return heats


def friction_velocity(slip, y):
    """Of Spalding's profile."""
    low, high = 1e-9, 100.0
    for _ in range(200):
        u = (low + high) / 2
        k = 0.41 * u
        plus = u + (np.exp(k) - 1 - k - k**2 / 2 - k**3 / 6) / 9.8
        low, high = (u, high) if u * plus < slip * y / NU else (low, u)
    return slip / u


def flux(slip, y, prandtl):
    """Kader's [W/m2]."""
    u = friction_velocity(slip, y)
    plus = y * u / NU
    gamma = 0.01 * (prandtl * plus) ** 4 / (1 + 5 * prandtl**3 * plus)
    beta = (3.85 * prandtl ** (1 / 3) - 1.3) ** 2 + 2.12 * np.log(prandtl)
    far = (2.12 * np.log(1 + plus) + beta) * np.exp(-1 / gamma)
    return 1000 * 1000 * u * (HOT - COLD) / (prandtl * plus * np.exp(-gamma) + far)


@pytest.mark.parametrize("prandtl", [0.7, 7])
def test_heat_through_a_turbulent_layer(clone, prandtl):
    """A disc whose surface moves with 2 m/s, y+ of 50 to 400: what it takes is that of a point of
    the profile in the cells that it cuts; conduction alone gives a fifth and a twelfth of it."""
    heat, conducted = spinning(clone, 100.0, prandtl)
    perimeter = 2 * np.pi * RADIUS * DEPTH * 1e-6
    near, far = (flux(100 * RADIUS, y, prandtl) for y in (0.1 * 0.005, 0.75 * 0.005))
    assert far <= heat / perimeter <= near
    assert conducted < heat / 4


def test_heat_is_conducted_where_nothing_moves(clone):
    heat, conducted = spinning(clone, 0.0, 7)
    assert heat == pytest.approx(conducted, rel=1e-9)


def hot_and_falling(clone, name):
    case = with_heat(eddies(falling(clone, name)), T=400, grains=300, fluid="Cp 1000; kappa 0.1;")
    replace(case, FLUID, "1e-4;", "1e-6;")
    control(case, writeInterval=10)
    return case


def test_books_close_and_a_restart_goes_on(clone):
    whole, parts = (hot_and_falling(clone, name) for name in ("whole", "parts"))
    run_whole_and_parts(whole, parts, "grainThermalFoam", stop=0.06, end=0.12)
    assert_same(whole, parts)
    assert_books_close(whole)
    T = whole.field("T")
    assert 300 <= T.min() < 390 and T.max() <= 400 + 1e-9


def test_ranks_agree_on_heat(clone):
    assert_ranks_agree_on_heat(*(hot_and_falling(clone, name) for name in ("one", "many")), 2)


def test_droplets_are_refused(clone):
    """What evaporates has no law for such layers."""
    case = eddies(with_heat(grain_box(clone), T=BOILING, grains=BOILING, fluid=GAS))
    with_droplets(case, [(0.05, 0.05)], 0.022, surface="cutCells")
    assert case.run("grainDropletFoam", check=False) == 1
    for word in ("'surface'", "value cutCells", "with turbulence"):
        assert word in case.log
    assert "\nTime = " not in case.log
