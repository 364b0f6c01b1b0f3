# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of momentum (fvOptions) act on the resolved grains in their cells, too."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, ledger, replace, tracks
from heat_box import fix_grains
from moving_mesh import write
from test_badInput import POROSITY, ZONE
from test_cutCells import choose, with_cells

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
RHO = 1000.0

# Per volume [N/m^3]
FORCE = 10.0
SOURCE = f"""
drive
{{
    type vectorSemiImplicitSource;
    selectionMode all;
    volumeMode specific;
    injectionRateSuSp {{ U (({FORCE} 0 0) 0); }}
}}
"""
KINDS = pytest.mark.parametrize("kind", ["locked", "cutCells"])


def driven_box(clone, kind, centre, radius, n):
    case = with_cells(cyclic_box(clone, [centre], radius), n)
    choose(case, kind)
    write(case, "system/fvOptions", "dictionary", SOURCE)
    return case


@pytest.mark.parametrize(
    "kind, off, beside", [("locked", 0.02, 0.05), ("cutCells", 1e-3, 1e-3)]
)
def test_all_is_accelerated_alike(clone, kind, off, beside):
    """A disc of the fluid's density, in fluid without a wall: v = F t/rho, wherever it cuts cells.

    The locked cells of a disc, which has ten in its diameter, are not quite its volume.
    """
    case = driven_box(clone, kind, (0.0471, 0.0513), 0.0123, 20)
    replace(case, GRAINS, "density 2500", f"density {RHO}")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     8")
    control(case, deltaT=5e-3, endTime=0.5, writeInterval=100)
    case.run("grainFoam")
    speed = FORCE * 5e-3 * np.arange(1, 101) / RHO
    motion = tracks(case)
    np.testing.assert_allclose(motion[20:, 5], speed[20:], rtol=off)
    assert np.abs(motion[:, 6]).max() <= off * speed[-1]
    np.testing.assert_allclose(case.field("U")[:, 0], speed[-1], rtol=beside)
    assert ledger(case)["momentumError"].max() <= 1e-11


@KINDS
def test_a_bed_that_is_held_takes_all_of_the_source(clone, kind):
    """Steady: what the fluid gives is the force over the whole box, grain included."""
    case = driven_box(clone, kind, (0.0471, 0.0513), 0.0213, 20)
    fix_grains(case)
    replace(case, FLUID, "1e-4", "1e-3")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    control(case, deltaT=0.02, endTime=8, writeInterval=400)
    case.run("grainFoam")
    book = ledger(case)
    whole = FORCE * 0.1 * 0.1 * 0.01
    # Locked cells of a held grain yield by 1e-4
    assert book["given_x"][-1] / 0.02 == pytest.approx(whole, rel=3e-4)
    assert tracks(case)[-1, 11] == pytest.approx(whole, rel=3e-4)


@pytest.mark.parametrize("name", ["plug", "p", "eps"])
def test_a_porosity_may_have_any_name(clone, name):
    """Fluid that a force drives through it, from rest, in steps of OpenFOAM's porosity: it has the
    trace of its tensor, three times the drag here, implicit, and what that is too much explicit."""
    case = cyclic_box(clone, [], 0.004)
    darcy = POROSITY[POROSITY.index("plug") :].replace("plug", name, 1)
    write(case, "system/fvOptions", "dictionary", SOURCE + darcy)
    write(case, "system/topoSetDict", "dictionary", ZONE)
    case.run("topoSet")
    replace(case, FLUID, "1e-4;", "1e-4;\ntransportModel Newtonian;")
    delta_t, steps = 0.02, 5
    drag = 1e-4 * 1e5 * delta_t
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    case.run("grainFoam")
    u = 0
    for _ in range(steps):
        u = ((1 + 2 * drag) * u + delta_t * FORCE / RHO) / (1 + 3 * drag)
    # What the linear solvers leave
    np.testing.assert_allclose(case.field("U")[:, 0], u, rtol=1e-8)
