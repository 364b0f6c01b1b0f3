# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid and unresolved grains keep the sum of their momentum where nothing acts on them."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, ledger, replace, write_csv
from heat_box import with_heat
from sphere_box import cyclic_cube

SIDE = 0.1
STEPS = 100
CYCLIC = '"left|right|bottom|top" { type cyclic; }'


def crowd(sites, rng):
    """Centres of grains of up to 0.4 cells near the sites of a lattice, and their radii."""
    return (
        np.mod(sites + rng.uniform(-0.003, 0.003, sites.shape), SIDE),
        rng.uniform(0.001, 0.002, len(sites)),
    )


def discs(clone, speed):
    """60 discs on their way through a still fluid of 0.4 times their density."""
    sites = (np.mgrid[:8, :8].reshape(2, -1).T + 0.5) * SIDE / 8
    centres, radius = crowd(sites[:60], np.random.default_rng(5))
    case = cyclic_box(clone, centres, radius)
    write_csv(case, centres, radius, np.tile([speed, 0.3 * speed], (len(centres), 1)))
    return step(case, speed)


def step(case, speed):
    """A tenth of a cell."""
    deltaT = 0.1 * SIDE / 10 / speed
    control(case, deltaT=deltaT, endTime=STEPS * deltaT, writeInterval=STEPS)
    return case


def correct_pressure(case, times, closes):
    controls = f"nCorrectors {times}; closeMomentum {closes}"
    replace(case, "system/fvSolution", "nCorrectors     2", controls)


def change(case):
    """What the sum differs by from that of the first step, the largest, over it."""
    data = ledger(case)
    sums = np.array([data[f"fluidMomentum_{x}"] + data[f"grainMomentum_{x}"] for x in "xyz"]).T
    assert len(sums) == STEPS
    return np.abs(sums - sums[0]).max() / np.linalg.norm(sums[0])


# Of 100 steps of the projection of the flux; the pressure is solved for to a tolerance, too
CLOSED = 1e-9


@pytest.mark.parametrize("speed", [0.05, 0.25, 1])
@pytest.mark.parametrize(
    # What two corrections of the pressure leave is 2e-5 at 0.05 m/s
    "corrections, closes, bound",
    [(2, "yes", CLOSED), (12, "no", CLOSED), (2, "no", 5e-5)],
)
def test_discs(clone, speed, corrections, closes, bound):
    case = discs(clone, speed)
    correct_pressure(case, corrections, closes)
    case.run("grainFoam")
    assert change(case) <= bound


def test_discs_with_heat(clone):
    case = with_heat(discs(clone, 0.25), patches=CYCLIC)
    correct_pressure(case, 2, "yes")
    case.run("grainThermalFoam")
    assert change(case) <= CLOSED


def test_spheres(clone):
    speed = 0.25
    sites = (np.mgrid[:6, :6, :6].reshape(3, -1).T + 0.5) * SIDE / 6
    centres, radius = crowd(sites, np.random.default_rng(6))
    velocity = np.tile([speed, 0.3 * speed, -0.2 * speed], (len(centres), 1))
    case = step(cyclic_cube(clone, centres, radius, 10, velocity), speed)
    correct_pressure(case, 2, "yes")
    case.run("grainFoam")
    assert change(case) <= CLOSED


def test_a_time_step_that_changes(clone):
    """What the flux of mass moved in its step it moves in the next one."""
    case = discs(clone, 0.25)
    correct_pressure(case, 2, "yes")
    file = case.path / "system/controlDict"
    file.write_text(f"{file.read_text()}\nadjustTimeStep yes; maxCo 0.5; maxGrainCo 0.1;\n")
    control(case, deltaT=1e-3)
    case.run("grainFoam")
    data = ledger(case)
    assert len(set(np.diff(data["time"]).round(9))) > 3
    sums = data["fluidMomentum_x"] + data["grainMomentum_x"]
    assert np.abs(sums - sums[0]).max() <= CLOSED * sums[0]


@pytest.mark.parametrize("speed", [0.05, 0.25, 1])
def test_discs_with_backward(clone, speed):
    """It carries the momentum of 3/2 of the velocity less 1/2 of that before, to the order of the
    step.  With a fluid that was at rest in the step before the start, three steps later."""
    case = discs(clone, speed)
    replace(case, "system/fvSchemes", "Euler", "backward")
    correct_pressure(case, 2, "yes")
    case.run("grainFoam")
    data = ledger(case)
    fluid, grains = (data[f"{name}Momentum_x"][3:] for name in ("fluid", "grain"))
    sums = (1.5 * fluid[1:] - 0.5 * fluid[:-1]) + grains[1:]
    # 2e-4 at 1 m/s; 1e-3, 2.5e-3, 3.3e-3 with the flux that is not corrected
    assert np.abs(sums - sums[0]).max() <= 3e-4 * sums[0]


@pytest.mark.parametrize("cells", [0.2, 0.6, 1.2])
def test_a_grain_that_is_put_into_the_fluid_adds_its_own(clone, cells):
    """A light disc at 0.5 m/s into fluid at rest: the cell that it comes into had more mass in the
    next step than in the first, and the sum was 1.058, 1.008 and 1.020 of what came."""
    radius, density, speed = 0.005 * cells, 100.0, 0.5
    case = cyclic_box(clone, [(0.012, 0.013)], radius)
    correct_pressure(case, 2, "yes")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    file = "constant/grainProperties"
    replace(case, file, "density 2500", f"density {density}")
    source = (
        f"type box; box (0.02 0.02 0) (0.08 0.08 0.01); velocity (0 {speed} 0); material glass;"
        f" numberRate 1000; total 1; distribution {{ type constant; radius {radius}; }}"
    )
    replace(case, file, "initialGrains", f"injections {{ rain {{ {source} }} }}\n\ninitialGrains")
    control(case, deltaT=1e-3, endTime=0.01, writeInterval=10)
    case.run("grainFoam")
    data = ledger(case)
    fluid = data["fluidMomentum_y"]
    sums = (fluid + data["grainMomentum_y"]) / data["injectedMomentum_y"].sum()
    step = np.flatnonzero(data["injected"])[0]
    np.testing.assert_allclose(sums[step], 1, atol=CLOSED)
    # Fluid that has no room for it any more leaves with the velocity that it has
    leaves = np.pi * radius**2 / SIDE**2 * fluid[step] / data["injectedMomentum_y"].sum()
    assert 1 - 1.2 * leaves <= sums[step + 1] <= 1
    np.testing.assert_allclose(sums[step + 1 :], sums[step + 1], atol=CLOSED)
