# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random grains in random fluids: T and psi stay in their range, heat and vapour are kept.

Discs and spheres of 0.2 to 10 cells that move and collide; ratios of the grains' density, heat
capacity and conductivity to the fluid's between 1e-3 and 1e3; steps of 1e-3 to 1e3 times the time
in which the fluid would warm a grain.  Whole: 1e5 steps in 250 boxes.
"""

import re

import numpy as np
import pytest
from grain_box import control, grain_box, make_cyclic, replace
from heat_box import GRAINS, heat_ledger, with_heat, with_psi
from sphere_box import PATCHES, sphere_box

SIDE = 0.1
COLD, HOT = 300.0, 400.0
RHO, CP, KAPPA = 2500.0, 800.0, 1.0  # of the grains


def spread(rng, least, most):
    """Evenly in its logarithm."""
    return 10 ** rng.uniform(np.log10(least), np.log10(most))


def places(rng, dimension, n, radius):
    """Centres of grains that touch neither each other nor the walls."""
    centres = []
    for _ in range(1000):
        x = rng.uniform(1.05 * radius, SIDE - 1.05 * radius, dimension)
        if all(np.linalg.norm(x - other) > 2.05 * radius for other in centres):
            centres.append(x)
            if len(centres) == n:
                break
    return np.array(centres)


def random_box(clone, rng, dimension, steps, smallest=0.2, least_Re=0.1):
    size = spread(rng, smallest, 10)
    cells = max(10 if dimension == 2 else 5, int(1.6 * size))
    h = SIDE / cells
    radius = 0.5 * h * size
    n = int(min(20, max(1, 0.3 * (SIDE / 2 / radius) ** dimension)))
    centres = places(rng, dimension, n, radius)

    rho = RHO / spread(rng, 1e-3, 1e3)
    cp, kappa = CP * spread(rng, 1e-3, 1e3), KAPPA * spread(rng, 1e-3, 1e3)
    # Conduction of a sphere in a fluid at rest: Nu = 2
    deltaT = spread(rng, 1e-3, 1e3) * RHO * CP * (2 * radius) ** 2 / (12 * kappa)
    speed = 0.2 * h / deltaT
    nu = speed * 2 * radius / spread(rng, least_Re, 100)
    velocity = rng.uniform(-speed, speed, centres.shape)

    if dimension == 2:
        case = grain_box(clone, centres, radius, velocity=velocity)
        replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
        case.run("blockMesh")
        names, empty = PATCHES[:4], "frontAndBack { type empty; }"
    else:
        case = sphere_box(clone, centres, radius, n=cells, velocity=velocity)
        names, empty = PATCHES, ""
    given = [rng.choice(["zeroGradient", rng.uniform(0, 1)]) for _ in names]
    inside = rng.choice([0, 1, rng.uniform()], cells**dimension)

    def patches(scale, offset):
        kinds = [
            "zeroGradient"
            if value == "zeroGradient"
            else f"fixedValue; value uniform {offset + scale * float(value)!r}"
            for value in given
        ]
        return " ".join(f"{a} {{ type {kind}; }}" for a, kind in zip(names, kinds, strict=True))

    # Two correctors are too few where nu dt/h^2 > 1 in the gap beside a resolved grain
    replace(case, "system/fvSolution", "nCorrectors     2;", "nCorrectors     4;")
    replace(case, "constant/transportProperties", "1000;", f"{rho!r};")
    replace(case, "constant/transportProperties", "1e-4;", f"{nu!r};")
    with_heat(
        case,
        COLD + (HOT - COLD) * inside,
        rng.choice([COLD, HOT]),
        patches(HOT - COLD, COLD),
        "type RanzMarshall; shape sphere;",
        f"Cp {cp!r}; kappa {kappa!r}; vapour {{ D {kappa / rho / cp!r}; }}",
        "conductance strip;" if dimension == 2 else "conductance spheres;",
        f"heatCapacity {CP}; conductivity {KAPPA}; youngsModulus 1e9;",
        empty=empty,
    )
    replace(case, GRAINS, "density 7800;", "density 7800; conductivity 50; youngsModulus 1e9;")
    with_psi(case, inside, f"{patches(1, 0)} {empty}")
    file = case.path / "constant/g"
    file.write_text(file.read_text().replace("-9.81", "0"))
    control(case, deltaT=repr(deltaT), endTime=repr(steps * deltaT), writeInterval=steps)
    # What diffuses between neighbours in a step, over what a cell of fluid holds
    return case, kappa * deltaT / (rho * cp * h**2)


def assert_bounded_and_kept(case, passing, kept=1e-10):
    """Heat that is not accounted for in a step, over all that there is; vapour likewise, or
    round-off of what passes between cells, up to 1e8 times what they hold."""
    book = heat_ledger(case)
    tolerance = 1e-9 * (HOT - COLD)
    for name in ("leastT", "leastGrainT"):
        assert book[name].min() >= COLD - tolerance
    for name in ("mostT", "mostGrainT"):
        assert book[name].max() <= HOT + tolerance
    left = sum(book[name] for name in book if name.startswith(("convected_", "conducted_")))
    missing = np.diff(book["fluidHeat"]) + (left + book["exchanged"] - book["filled"])[1:]
    total = (book["fluidHeat"] + book["grainHeat"])[1:]
    assert np.abs(missing / total).max() <= kept
    assert book["grainError"].max() <= 1e-10
    vapour = case.table(next(case.path.glob("postProcessing/vapourLedger/*/*.csv")))
    assert vapour["leastPsi"].min() >= -1e-9
    assert vapour["mostPsi"].max() <= 1 + 1e-9
    assert vapour["error"].max() <= max(1e-10, 1e-15 * passing)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("dimension", [2, 3])
def test_bounded_and_kept(clone, dimension, seed):
    case, passing = random_box(clone, np.random.default_rng((dimension, seed)), dimension, 40)
    case.run("grainThermalFoam")
    assert_bounded_and_kept(case, passing)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 225))
@pytest.mark.parametrize("dimension", [2, 3])
def test_1e5_steps(clone, dimension, seed):
    case, passing = random_box(clone, np.random.default_rng((dimension, seed)), dimension, 400)
    case.run("grainThermalFoam")
    assert_bounded_and_kept(case, passing)


# Steps of 350 to 860 times the grain's own time; in the last a resolved grain is alone with a fluid
# that holds 1e-4 of the heat
@pytest.mark.parametrize(("dimension", "seed"), [(2, 131), (3, 214), (2, 223)])
def test_kept_around_resolved_grains_in_long_steps(clone, dimension, seed):
    case, passing = random_box(clone, np.random.default_rng((dimension, seed)), dimension, 40)
    case.run("grainThermalFoam")
    assert re.search(r"grains: ([0-9]+) resolved", case.log)[1] == "1"
    assert_bounded_and_kept(case, passing, 1e-11)
