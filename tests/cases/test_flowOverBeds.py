# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A stream along a fixed bed: Brinkman's layers at its surface and at walls, thinner than cells."""

import numpy as np
import pytest
from grain_box import control, lattice, ledger, replace
from test_fluidClosures import channel

GRAINS = "constant/grainProperties"
SIDE, DEPTH = 0.1, 0.01
PITCH, RADIUS, MU, GRADIENT = 2e-3, 0.9e-3, 0.1, 10.0
PHI = np.pi * (RADIUS / PITCH) ** 2
EPS = 1 - PHI
# Drag of Stokes, eq. 4.8, per volume; thickness of the layer; speed deep in the bed
DRAG = PHI * 18 * MU / (2 * RADIUS) ** 2
LAYER = np.sqrt(EPS * MU / DRAG)
DEEP = EPS * GRADIENT / DRAG


def over_bed(clone, rows, entries=""):
    """Cells of 5 mm between plates, the lower rows of grains in them."""
    centres = lattice(50, rows, PITCH, (PITCH / 2, PITCH / 2))
    case = channel(clone, centres, RADIUS, (20, 20), GRADIENT * SIDE)
    replace(case, GRAINS, "DallavalleDiFelice", "Stokes")
    replace(case, GRAINS, "        shape   disc;", "        shape   sphere;")
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{ motion fixed; {entries}")
    # Viscosity has passed the clear half twice
    control(case, deltaT=0.25, endTime=50, writeInterval=200)
    case.run("grainFoam")
    return case, case.flux("right") / DEPTH


def closed(depth):
    """Flux over and through a bed: velocity and stress are continuous, no slip at the plates."""
    clear = SIDE - depth
    faster = (GRADIENT * clear**2 / (2 * MU) - DEEP) / (1 + EPS * clear / LAYER)
    over = -GRADIENT * clear**3 / (6 * MU) + EPS * faster / LAYER * clear**2 / 2
    return over + (DEEP + faster) * clear + EPS * (DEEP * (depth - LAYER) + faster * LAYER)


@pytest.mark.parametrize("entries", ["", "form B;"])
def test_flux_over_a_bed(clone, entries):
    """With stress across half of the bed's first cell 1.22 of it, of which the slip is 0.05."""
    case, flux = over_bed(clone, 25, entries)
    # Ten cells across the clear part: half of a hundredth of a parabola's; measured 1.023, 0.998
    assert flux == pytest.approx(closed(25 * PITCH), rel=0.04)
    given = ledger(case)["given_x"][-1] / 0.25
    u = case.field("U").reshape(20, 20, 3)[-1, 10, 0]
    # Bed and upper plate bear the pressure; the lower one a layer of the bed
    plates = (MU * u / (SIDE / 40) + MU * EPS * DEEP / LAYER) * SIDE * DEPTH
    assert given + plates == pytest.approx(GRADIENT * SIDE * SIDE * DEPTH, rel=1e-3)


@pytest.mark.parametrize("rows, bound", [(26, 0.03), (27, 0.06)])
def test_surface_within_cells(clone, rows, bound):
    """At 0.4 and 0.8 of a cell: 0.986, 1.044 (half of the cell's: 0.969, 1.139; none: 0.88)."""
    assert over_bed(clone, rows)[1] == pytest.approx(closed(rows * PITCH), rel=bound)


def test_flux_through_a_bed_between_plates(clone):
    """Their layers take 2 LAYER of the height, 0.6 % of the flux; before 0.06 %."""
    exact = EPS * DEEP * (SIDE - 2 * LAYER)
    assert over_bed(clone, 50)[1] == pytest.approx(exact, rel=0.003)
