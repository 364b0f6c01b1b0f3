# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random grains in random fluids: temperatures stay in their range, heat is kept."""

import numpy as np
import pytest
from grain_box import control, grain_box, replace
from heat_box import heat_ledger, with_heat

SIDE = 0.1
RANGE = 100.0
STEPS = 40


def places(rng, n, radius):
    """Centres of discs that touch neither each other nor the walls."""
    centres = []
    while len(centres) < n:
        x = rng.uniform(1.05 * radius, SIDE - 1.05 * radius, 2)
        if all(np.hypot(*(x - other)) > 2.05 * radius for other in centres):
            centres.append(x)
    return np.array(centres)


def ratio(rng):
    """Between 1e-3 and 1e3, evenly in its logarithm."""
    return 10 ** rng.uniform(-3, 3)


# Diameters of 0.2 to 10 cells
@pytest.mark.parametrize("seed", range(12))
def test_bounded_and_kept(clone, seed):
    rng = np.random.default_rng(seed)
    cells = int(rng.choice([10, 20, 30]))
    h = SIDE / cells
    radius = min(0.5 * h * 10 ** rng.uniform(np.log10(0.2), 1), 0.02)
    n = int(min(30, max(1, 0.3 * (SIDE / 2 / radius) ** 2)))
    speed = 0.5 * h / 1e-3
    velocity = rng.uniform(-speed, speed, (n, 2)) / 2
    case = grain_box(clone, places(rng, n, radius), radius, velocity=velocity)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    with_heat(
        case,
        rng.uniform(300, 400, cells**2),
        rng.choice([300, 400]),
        fluid=f"Cp {1000 * ratio(rng)}; kappa {0.6 * ratio(rng)};",
        ofGlass=f"heatCapacity {800 * ratio(rng)};",
    )
    (case.path / "constant/g").write_text(
        (case.path / "constant/g").read_text().replace("-9.81", "0")
    )
    control(case, deltaT=1e-3, endTime=STEPS * 1e-3, writeInterval=STEPS)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    tolerance = 1e-9 * RANGE
    for name in ("leastT", "leastGrainT"):
        assert book[name].min() >= 300 - tolerance
    for name in ("mostT", "mostGrainT"):
        assert book[name].max() <= 400 + tolerance
    assert book["fluidError"].max() <= 1e-10
    assert book["grainError"].max() <= 1e-10
    total = book["fluidHeat"] + book["grainHeat"]
    assert np.abs(np.diff(total) - book["filled"][1:]).max() <= 1e-10 * total[0]
