# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A stream along a fixed bed: Brinkman's layers at its surface and at walls, thinner than cells."""

import numpy as np
import pytest
from grain_box import control, lattice, ledger, replace
from test_fluidClosures import channel
from test_turbulence import MODELS, SCHEMES, SOLVER, set_model, write_field

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


def test_wall_beside_a_bed_in_turbulence_holds_the_fluid(clone):
    """Of even viscosity 40 times the wall's own; the bed begins within the cell at the wall."""
    pitch, side, gradient = 2.5e-4, 0.01, 1.0
    centres = lattice(40, 34, pitch, (pitch / 2, 1.5e-3 + pitch / 2))
    case = channel(clone, centres, 1e-4, (2, 5), gradient * side)
    case.run("transformPoints -scale '(0.1 0.1 1)'")
    walls = "bottom { type noSlip; } top { type slip; }"
    replace(case, "0/U", '"bottom|top" { type noSlip; }', walls)
    replace(case, GRAINS, "DallavalleDiFelice", "Stokes")
    replace(case, GRAINS, "        shape   disc;", "        shape   sphere;")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    replace(case, "constant/transportProperties", "1e-4;", "1e-4;\ntransportModel Newtonian;")
    replace(case, "system/fvSchemes", "    div(tau)", SCHEMES + "    div(tau)")
    replace(case, "system/fvSolution", "    U\n", f'    "(k|epsilon)" {SOLVER}\n    U\n')
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     20")
    write_field(case, "k", "[0 2 -2 0 0 0 0]", 1, "zeroGradient")
    write_field(case, "epsilon", "[0 2 -3 0 0 0 0]", 0.09 / 4e-3, "zeroGradient")
    write_field(case, "nut", "[0 2 -1 0 0 0 0]", 0, "fixedValue")
    set_model(case, MODELS["kEpsilon"].replace("turbulence on", "turbulence off"))
    control(case, deltaT=0.01, endTime=1, writeInterval=100)
    case.run("grainFoam")
    # The wall's viscosity is not negative; by the cell's the bed had 1.0057 of the pressure
    bed = ledger(case)["given_x"][-1] / 0.01 / (gradient * side**2 * DEPTH)
    assert 0.99 < bed < 1 + 1e-6
