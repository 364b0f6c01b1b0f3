# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A dye in a fluid with grains that move: kept to round-off and within its bounds."""

import re

import numpy as np
import pytest
from grain_box import (
    assert_same_grains,
    control,
    cyclic_box,
    grain_box,
    lattice,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
    write_csv,
)
from sphere_box import SIDE, decompose
from test_restart import assert_same

GRAINS = "constant/grainProperties"
SPEED = 0.1
DEPTH = 0.01
LEAST = 1e-9
LOW, HIGH, INLET = 0.2, 0.9, 0.95
WALLS = '"left|right|bottom|top"'
TOLERANCE = 1e-12
DIFFUSIVITIES = [0, 1e-5]

# Cells per side, and radius: half a cell in a diameter, and five cells
SIZES = {"unresolved": (10, 0.0025), "resolved": (20, 0.0125)}


def add_dye(case, cells, D=0, patches=f"{WALLS} {{ type zeroGradient; }}"):
    """Random values between LOW and HIGH, to be called after blockMesh."""
    values = np.random.default_rng(8).uniform(LOW, HIGH, cells)
    inside = "\n".join(repr(float(value)) for value in values)
    (case.path / "0/dye").write_text(
        "FoamFile { version 2.0; format ascii; class volScalarField; object dye; }\n"
        "dimensions [0 0 0 0 0 0 0];\n"
        f"internalField nonuniform List<scalar> {cells}(\n{inside}\n);\n"
        f"boundaryField {{ {patches} frontAndBack {{ type empty; }} }}\n"
    )
    file = case.path / "constant/transportProperties"
    file.write_text(f"{file.read_text()}\nscalars {{ dye {{ D {D}; }} }}\n")
    replace(
        case,
        "system/fvSchemes",
        "    div(tau)",
        "    div(phiFluid,dye) Gauss upwind;\n    div(tau)",
    )
    # What the solution leaves counts as not accounted for
    solver = "{ solver PBiCGStab; preconditioner DILU; tolerance 1e-15; relTol 0; maxIter 200; }"
    replace(case, "system/fvSolution", "    U\n", f"    dye {solver}\n    U\n")


def set_cells(case, cells):
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")


def amount(case, time):
    """Of dye in the fluid, to whose fraction in each cell the scalar's equation adds the least."""
    volume = case.mesh().areas * DEPTH
    return np.sum(volume * (case.field("eps", time) + LEAST) * case.field("dye", time))


def assert_bounded(case, low=LOW, high=HIGH):
    for time in case.times:
        dye = case.field("dye", time)
        assert dye.min() >= low - TOLERANCE, time
        assert dye.max() <= high + TOLERANCE, time


def assert_books_close(case):
    book = ledger(case)
    assert book["transportDefect"].max() <= TOLERANCE
    assert book["carriedUnaccounted"].max() <= TOLERANCE
    return book


def assert_kept(case):
    """But for the volume that fluid without an opening has no room for, or too much of."""
    book = ledger(case)
    amounts = np.array([amount(case, time) for time in case.times[1:]])
    # Digits of a step, and of what the ledger shows
    round_off = TOLERANCE * len(book["time"]) * amounts[0]
    spread = np.abs(book["volumeWithoutRoom"]).sum()
    np.testing.assert_allclose(amounts, amounts[0], rtol=0, atol=HIGH * spread + round_off)
    return spread


def solutions(case):
    """Solvers of the potential and their iterations."""
    return set(re.findall(r"(\w+):  Solving for transportPotential,.* (\d+)\n", case.log))


def assert_solved_by_factors(case):
    """Those of the mesh's own matrix, at once."""
    assert solutions(case) == {("CholeskyPCG", "1")}


def settling(clone, size, D=0, name=None):
    """Grains that settle on each other and on the floor."""
    cells, radius = SIZES[size]
    if size == "unresolved":
        centres = lattice(6, 5, 0.012, (0.02, 0.006))
        centres += np.random.default_rng(1).uniform(-1e-3, 1e-3, centres.shape)
    else:
        centres = [(0.047, 0.03)]
    case = grain_box(clone, centres, radius, name=name)
    set_cells(case, cells)
    add_dye(case, cells**2, D)
    control(case, deltaT=2e-3, endTime=0.3, writeInterval=5)
    return case


@pytest.mark.parametrize("D", DIFFUSIVITIES)
@pytest.mark.parametrize("size", SIZES)
def test_closed_box(clone, size, D):
    case = settling(clone, size, D)
    case.run("grainFoam")
    book = assert_books_close(case)
    assert_bounded(case)
    assert book["transportCorrection"].max() > 1e-6
    assert book["active"].max() >= 1
    # Contacts let grains into the floor by their tolerance, 1e-7 of 0.1 m
    assert assert_kept(case) <= 1e-6 * SIDE**2 * DEPTH
    # Where all cells have room
    if size == "unresolved":
        assert_solved_by_factors(case)
    else:
        assert "DICPCG" in dict(solutions(case))


@pytest.mark.parametrize("D", DIFFUSIVITIES)
@pytest.mark.parametrize("size", SIZES)
def test_periodic_box(clone, size, D):
    """Grains meet on their way through the boundaries; overfull cells apart, none is outside."""
    cells, radius = SIZES[size]
    rng = np.random.default_rng(5)
    if size == "unresolved":
        centres = lattice(6, 6, 0.016, (0.005, 0.005)) + rng.uniform(-2e-3, 2e-3, (36, 2))
    else:
        centres = np.array([(0.01, 0.03), (0.06, 0.07)])
    case = cyclic_box(clone, centres, radius)
    write_csv(case, centres, radius, rng.uniform(-0.3, 0.3, centres.shape))
    set_cells(case, cells)
    patches = "".join(f"{name} {{ type cyclic; }} " for name in ("left", "right", "bottom", "top"))
    add_dye(case, cells**2, D, patches)
    control(case, deltaT=2e-3, endTime=0.3, writeInterval=5)
    case.run("grainFoam")
    assert_books_close(case)
    assert_bounded(case)
    # Round-off of each step's sum
    steps = len(ledger(case)["time"])
    assert assert_kept(case) <= np.finfo(float).eps * steps * SIDE**2 * DEPTH
    if size == "unresolved":
        assert_solved_by_factors(case)


FEEDS = {
    "patch": f"type patches; patches (bottom); velocity (0 {2 * SPEED} 0); numberRate 40;",
    "inside": "type box; box (0.01 0.01 0) (0.09 0.07 0.01); numberRate 40;",
}


def through(clone, feed, D=0, name=None):
    """Grains that come in with the fluid, or faster, and leave at a pressure outlet."""
    case = grain_box(clone, [], name=name)
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    case.run("blockMesh")
    sizes = "distribution { type uniform; minRadius 0.001; maxRadius 0.003; }"
    file = case.path / GRAINS
    file.write_text(
        f"{file.read_text()}\ninjections {{ feed {{ material glass; {FEEDS[feed]} {sizes} }} }}\n"
        "outlets { top { type patches; patches (top); } }\n"
    )
    patches = (
        '"left|right" { type zeroGradient; }'
        f" bottom {{ type fixedValue; value uniform {INLET}; }}"
        f" top {{ type inletOutlet; phi phiFluid; inletValue uniform {LOW};"
        f" value uniform {LOW}; }}"
    )
    add_dye(case, 100, D, patches)
    control(case, deltaT=1e-2, endTime=2.6, writeInterval=5)
    return case


@pytest.mark.parametrize("D", DIFFUSIVITIES)
@pytest.mark.parametrize("feed", FEEDS)
def test_inlet_and_outlet(clone, feed, D):
    case = through(clone, feed, D)
    case.run("grainFoam")
    book = assert_books_close(case)
    assert book["injected"].sum() >= 2 and book["removed"].sum() >= 1
    assert_bounded(case, high=INLET)
    # With an outlet there is room
    assert np.all(book["volumeWithoutRoom"] == 0)
    # What comes in has filled the box
    assert case.field("dye").mean() > HIGH


@pytest.mark.parallel
@pytest.mark.parametrize("scheme", ["Euler", "backward"])
@pytest.mark.parametrize("make", ["unresolved", "resolved", "patch"])
def test_restart_and_ranks(clone, make, scheme):
    cases = [
        (through if make == "patch" else settling)(clone, make, 1e-5, name=name) for name in "abc"
    ]
    whole, parts, ranks = cases
    end, dt = (1, 1e-2) if make == "patch" else (0.2, 2e-3)
    for case in cases:
        replace(case, "system/fvSchemes", "Euler", scheme)
        control(case, endTime=end, writeInterval=25)
    run_whole_and_parts(whole, parts, "grainFoam", stop=end / 2, end=end)
    assert (whole.path / whole.times[-1] / "phiShare").exists() == (scheme == "backward")
    assert_same_grains(whole, parts)
    for name in ("dye", "eps", "U", "transportPotential"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)
    assert_books_close(whole)
    assert_bounded(whole, high=INLET if make == "patch" else HIGH)

    decompose(ranks, 2)
    ranks.parallel("grainFoam", 2)
    assert_books_close(ranks)
    if make == "unresolved":
        assert_solved_by_factors(ranks)
    ranks.run("reconstructPar -latestTime")
    # Contacts leave 1e-7 of a grain's way uncertain, a cell of 5 mm has 2e-5 of it
    np.testing.assert_allclose(whole.field("dye"), ranks.field("dye"), rtol=0, atol=1e-4)


@pytest.mark.parallel
def test_four_ranks(clone):
    one, many = (settling(clone, "resolved", 1e-5, name=name) for name in ("one", "many"))
    for case in (one, many):
        control(case, endTime=0.1, writeInterval=50)
    one.run("grainFoam")
    decompose(many, 4)
    many.parallel("grainFoam", 4)
    assert_books_close(many)
    many.run("reconstructPar -latestTime")
    # As of two
    np.testing.assert_allclose(one.field("dye"), many.field("dye"), rtol=0, atol=1e-4)


@pytest.mark.parametrize("name", ["p", "eps", "kappa", "transportPotential"])
def test_scalars_have_names_of_their_own(clone, name):
    case = settling(clone, "unresolved", 1e-5)
    replace(case, "constant/transportProperties", "dye {", f"{name} {{")
    assert case.run("grainFoam", check=False) == 1
    for fragment in (f"'{name}'", "a field of the solver", "other than", "transportPotential"):
        assert fragment in case.log


@pytest.mark.parametrize("kind", ["locked", "cutCells"])
def test_a_dye_does_not_change_the_flow(clone, kind):
    """Around a resolved disc that falls, not by a digit."""
    plain, dyed = (grain_box(clone, [(0.052, 0.06)], 0.006, name=name) for name in ("a", "b"))
    for case in (plain, dyed):
        set_cells(case, 25)
        options = f"coupling\n{{\n    resolvedGrains {{ type {kind}; from 3; }}"
        replace(case, GRAINS, "coupling\n{", options)
        replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
        control(case, deltaT=1e-3, endTime=0.04, writeInterval=40)
    add_dye(dyed, 625)
    for case in (plain, dyed):
        case.run("grainFoam")
    assert_same(plain, dyed)
    assert np.ptp(dyed.field("dye")) > 0.1
