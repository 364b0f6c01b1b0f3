# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Beads of half the liquid's density float as a raft of which half is immersed, whatever the
cells and steps: each bead in the surface moves as a whole, its parts in water and air do not."""

import numpy as np
import pytest
from grain_box import control, replace
from water_box import level, liquid_ledger, water_box

RADIUS = 0.002
ROWS, COLUMNS = 6, 24
LIQUID, GAS = 5000, 5  # of beads of 2500


@pytest.mark.parametrize(
    "cells, dt, mapping",
    [
        (25, 2e-3, "exactOverlap"),
        (25, 5e-4, "exactOverlap"),
        (12, 2e-3, "exactOverlap"),
        (25, 2e-3, "diffused; length 0.008"),
    ],
)
def test_half_of_a_raft_is_immersed(clone, cells, dt, mapping):
    x, y = np.meshgrid(
        0.05 + 2.05 * RADIUS * (np.arange(COLUMNS) - (COLUMNS - 1) / 2),
        0.05 + 2.05 * RADIUS * (np.arange(ROWS) - (ROWS - 1) / 2),
    )
    case = water_box(
        clone,
        level(0.05),
        np.column_stack([x.ravel(), y.ravel()]),
        radius=RADIUS,
        cells=(cells, cells),
        densities=(LIQUID, GAS),
    )
    replace(case, "constant/grainProperties", "type    exactOverlap;", f"type {mapping};")
    # Water passes between the beads and comes to rest with them within the second
    case.dict_set("constant/grainProperties", "coupling/packingRatio", "0.8165")
    # Held by nothing but the liquid
    case.dict_set("constant/grainProperties", "contactLaws/glassOnSteel/friction", "0")
    control(case, deltaT=dt, endTime=1.2, writeInterval=round(0.1 / dt))
    case.run("grainInterFoam")

    immersed = []
    for time in (t for t in case.times if float(t) > 0.75):
        beads = 1 - case.field("eps", time)
        immersed.append((beads * case.field("alpha.water", time)).sum() / beads.sum())
    assert np.mean(immersed) == pytest.approx(0.5, abs=0.005)
    assert abs(liquid_ledger(case)["unaccounted"]).max() <= 1e-10
