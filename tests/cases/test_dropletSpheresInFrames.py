# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres of liquid, 8 cells across, seen from frames that move."""

import numpy as np
import pytest
from droplet_box import (
    BOILING,
    GAS,
    GAS_CP,
    GAS_RHO,
    LATENT,
    droplet_table,
    make_gas,
    with_droplets,
)
from grain_box import control, replace
from heat_box import with_heat
from sphere_box import SIDE, cyclic_cube
from test_dropletsInStream import CELLS, PRANDTL, in_stream


def drag(clone, name, gas, droplet):
    """Force along x on a very heavy droplet, speeds over a cell in a step along (1 0.6 0.3)."""
    dt, h = 1e-3, SIDE / CELLS
    along = np.array([1, 0.6, 0.3]) * h / dt
    case = cyclic_cube(clone, [], 0.004, CELLS, name=name)
    with_heat(
        case, T=BOILING, grains=BOILING, patches='".*" { type cyclic; }', fluid=GAS, empty=""
    )
    make_gas(case, 2e-3)
    replace(case, "0/U", "uniform (0 0 0)", "uniform ({} {} {})".format(*gas * along))
    with_droplets(case, [(0.05, 0.05)], 4 * h, density=5e3)
    values = ",".join(str(x) for x in (0.051, 0.052, 0.047, 4 * h, *droplet * along))
    (case.path / "constant/droplets.csv").write_text(f"x,y,z,radius,vx,vy,vz\n{values}\n")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    control(case, endTime=50 * dt, deltaT=dt, writeInterval=1000)
    case.run("grainDropletFoam")
    return droplet_table(case)["fx"][15:]


def test_force_does_not_know_which_of_both_moves(clone):
    passes, moves = drag(clone, "passes", 0.15, 0), drag(clone, "moves", 0, -0.15)
    jumps = np.abs(np.diff(moves) / moves[1:])
    print("force", np.mean(moves) / np.mean(passes), "jumps", jumps.max())
    assert np.mean(moves) / np.mean(passes) == pytest.approx(1, abs=0.02)
    assert jumps.max() < 0.1


def boiling(clone, speed):
    """Vapour of each of 40 steps in hot gas that moves as the droplet does, from its first step
    on; cells in a step."""
    radius, dt, nu = 1e-3, 5e-5, 2e-4
    v = speed * 6 * radius / CELLS / dt
    kappa = GAS_RHO * GAS_CP * nu / PRANDTL
    hot = BOILING + LATENT / GAS_CP
    fluid = f"Cp {GAS_CP}; kappa {kappa};"
    case = in_stream(clone, radius, v, nu, hot, fluid, density=5e3)
    replace(case, "constant/dropletProperties", "motion fixed;", "")
    file = case.path / "constant/droplets.csv"
    x = [float(word) for word in file.read_text().split("\n")[1].split(",")]
    values = ",".join(str(value) for value in (x[0], x[1] - 0.001, *x[2:], v))
    file.write_text(f"x,y,z,radius,vy\n{values}\n")
    case.path = case.path.rename(case.path.with_name(f"speed{speed}"))
    control(case, endTime=40 * dt, deltaT=dt, writeInterval=1000)
    case.run("grainDropletFoam")
    return droplet_table(case)["vapour"]


def test_it_boils_in_gas_that_moves_with_it_as_at_rest(clone):
    rest, moves = boiling(clone, 0), boiling(clone, 0.15)
    ratio = moves[10:].sum() / rest[10:].sum()
    print("vapour", ratio)
    assert ratio == pytest.approx(1, abs=0.02)
