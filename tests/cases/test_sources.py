# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of momentum (fvOptions): beside beds, and on resolved grains in their cells."""

import numpy as np
import pytest
from grain_box import control, cyclic_box, lattice, ledger, replace, tracks, write_csv
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


PUMP = """
pump
{{
    type {};
    selectionMode cellZone;
    cellZone pump;
    {}
}}
"""
PUSH = PUMP.format(
    "vectorSemiImplicitSource", "volumeMode specific; injectionRateSuSp { U ((100 0 0) 0); }"
)
PLUG = POROSITY[POROSITY.index("plug") :].replace("1e5", "1e7").replace("porous", "plug")
KEEP = PUMP.format("meanVelocityForce", "fields (U); Ubar (1e-4 0 0);")


def zone(name, begin, end):
    """What topoSet makes a zone of the cells between two places along x of."""
    cells = f"source boxToCell; box ({begin} -1 -1) ({end} 1 1);"
    return (
        f"{{ name {name}; type cellSet; action new; {cells} }}\n"
        f"{{ name {name}; type cellZoneSet; action new; source setToCellZone; set {name}; }}\n"
    )


def endless_pipe(clone, pump, sources, bed=True, name=None):
    """Of 40 by 4 cells, round and round; its right half has a bed of discs for which Stokes' law
    stands, four in a cell, or cells of the zone plug."""
    h = 0.1 / 40
    case = cyclic_box(clone, [], 0.001, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 4 1)")
    for z in ("0", "0.01"):
        for x in ("0.1", "0  "):
            replace(case, "system/blockMeshDict", f"({x} 0.1 {z})", f"({x} {4 * h} {z})")
    case.run("blockMesh")
    write_csv(case, lattice(40, 8, h / 2, (0.05 + h / 4, h / 4)) if bed else [], BEAD / 2)
    law = "type    DallavalleDiFelice;\n        shape   disc;"
    replace(case, GRAINS, law, "type Stokes; shape sphere;")
    replace(case, FLUID, "1e-4;", "1e-4;\ntransportModel Newtonian;")
    zones = zone("pump", *pump) + zone("plug", 0.05, 0.1)
    write(case, "system/topoSetDict", "dictionary", f"actions\n(\n{zones});\n")
    case.run("topoSet")
    write(case, "system/fvOptions", "dictionary", sources)
    control(case, deltaT=0.02, endTime=1, writeInterval=50)
    return case


BEAD = 8.75e-4
EPS = 1 - np.pi * BEAD**2 / 1.25e-3**2 / 4
# Gradient of the pressure over the flux per area: (1 - eps) gamma/eps^2 [kg/m^3/s]
RESISTANCE = (1 - EPS) * 18 * 1e-4 * RHO / BEAD**2 / EPS**2
PLACES = pytest.mark.parametrize(
    "pump",
    [(0.01, 0.03), (0.045, 0.05), (0.05, 0.0525), (0.04, 0.06)],
    ids=["away", "before", "first cell", "across"],
)
# In steps that end in it
WHILE = "    timeStart 0.105; duration 0.2; selection"


@PLACES
def test_a_pump_drives_a_bed_alike_wherever_it_is(clone, pump):
    """By its pressure, the force over the fluid fraction where it is among grains.  The flux was
    0.61 to 1.19 of the law's, the velocity in cells at the ends of the pump up to 87 times it."""
    case = endless_pipe(clone, pump, PUSH)
    fix_grains(case)
    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    undisturbedFlow { type none; }")
    case.run("grainFoam")
    outside = max(0, min(pump[1], 0.05) - pump[0])
    pressure = 100 * (outside + (pump[1] - pump[0] - outside) / EPS)
    law = pressure / 0.05 / RESISTANCE
    # Shear between the bed and the fluid before it, which is not in the law, has 2e-4
    assert case.flux("right") / 1e-4 == pytest.approx(law, rel=5e-4)
    # The same makes 0.08 in the first cells of the bed and beside them
    along = (case.field("U")[:, 0] * case.field("eps")).reshape(4, 40)
    np.testing.assert_allclose(along, law, rtol=0.1)
    near = [0, 1, 2, 17, 18, 19, 20, 21, 22, 37, 38, 39]
    np.testing.assert_allclose(np.delete(along, near, 1), law, rtol=2e-3)
    assert ledger(case)["given_x"][-1] / 0.02 == pytest.approx(100 * (pump[1] - pump[0]) * 1e-4)


@PLACES
def test_a_pump_drives_a_porous_plug_by_Darcys_law(clone, pump):
    """Cells at the ends of pump and plug have the velocity of all others."""
    case = endless_pipe(clone, pump, PUSH + PLUG, bed=False)
    case.run("grainFoam")
    law = 100 * (pump[1] - pump[0]) / (RHO * 1e-4 * 1e7 * 0.05)
    # Steady to exp(-t nu d), of the plug's half of the mass: nothing; linear solvers leave this
    np.testing.assert_allclose(case.field("U")[:, 0], law, rtol=1e-8)


def test_a_pump_that_keeps_a_velocity_has_the_force_of_the_bed(clone):
    """After 2 s it had 0.17 of it, 0.79 with faces that see the source; here it is steady."""
    case = endless_pipe(clone, (0.01, 0.03), KEEP)
    fix_grains(case)
    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    undisturbedFlow { type none; }")
    control(case, endTime=20, writeInterval=1000)
    case.run("grainFoam")
    force = case.logged("pressure gradient = ")[-1]
    assert case.flux("right") / 1e-4 == pytest.approx(1e-4, rel=2e-4)
    assert force * 0.02 == pytest.approx(1e-4 * RESISTANCE * 0.05, rel=5e-4)


def test_free_grains_and_fluid_have_the_momentum_of_a_pump_that_starts_and_stops(clone):
    case = endless_pipe(clone, (0.04, 0.06), PUSH.replace("    selection", WHILE))
    replace(case, "system/fvSolution", "nCorrectors     2;", "nCorrectors 2; closeMomentum yes;")
    control(case, deltaT=0.01, endTime=0.4, writeInterval=40)
    case.run("grainFoam")
    book = ledger(case)
    time = np.round(book["time"], 6)
    given = 100 * 0.02 * 1e-4 * np.clip(time - 0.1, 0, 0.2)
    got = book["fluidMomentum_x"] + book["grainMomentum_x"]
    # What the linear solvers leave
    np.testing.assert_allclose(got, given, atol=1e-9 * given[-1])
