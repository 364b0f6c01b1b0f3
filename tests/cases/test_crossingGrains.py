# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that cross a patch of given velocity: the fluid has what they leave of the mixture."""

import numpy as np
import pytest
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    ledger,
    open_ends,
    replace,
    run_whole_and_parts,
)
from heat_box import CP, GRAIN_CP, GRAINS, KAPPA, heat_ledger, with_heat

SPEED, SIDE, RADIUS, SHARE = 0.2, 0.1, 1e-3, 0.1
MIXTURE = SPEED * SIDE * 0.01
COLD, HOT, DENSITY = 300.0, 400.0, 1000.0
PATCHES = (
    f"bottom {{ type fixedValue; value uniform {COLD}; }}"
    ' "left|right|top" { type zeroGradient; }'
)
METHODS = pytest.mark.parametrize(
    ("method", "ratio"), [("exactOverlap;", 1), ("diffused; length 0.01;", 0.8)],
    ids=["exact", "diffused"],
)  # fmt: skip


def append(case, text):
    path = case.path / GRAINS
    path.write_text(f"{path.read_text()}\n{text}\n")


def channel(clone, grains=(), speed=SPEED, radius=RADIUS, method="exactOverlap;", ratio=1, n=10):
    """Cold fluid that comes in below, moves up and leaves at a given pressure; hot grains."""
    case = grain_box(clone, grains, radius)
    open_ends(case, speed)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({n} {n} 1)")
    case.run("blockMesh")
    start = "internalField   uniform (0 "
    replace(case, "0/U", f"{start}0 0)", f"{start}{speed} 0)")
    with_heat(case, COLD, HOT, PATCHES)
    replace(case, GRAINS, "exactOverlap;", method)
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    packingRatio {ratio};")
    return case


def feed(case, patch, velocity):
    """A tenth of a stream of SPEED, were all of a disc seen by the fluid."""
    rate = SHARE * MIXTURE / (np.pi * RADIUS**2 * 0.01)
    append(
        case,
        f"injections {{ feed {{ material glass; type patches; patches ({patch});"
        f" velocity (0 {velocity} 0); numberRate {rate}; temperature {HOT};"
        f" distribution {{ type constant; radius {RADIUS}; }} }} }}\n"
        "outlets { ends { type patches; patches (bottom top); } }",
    )


def volume_that_came_in(book, steps=slice(None)):
    """Of the fluid, through the bottom [m^3]."""
    return -book["convected_bottom"][steps].sum() / (DENSITY * CP * COLD)


# All of the mixture's came in, 1.11 times as much
@METHODS
def test_fluid_that_comes_in_with_grains(clone, method, ratio):
    case = channel(clone, method=method, ratio=ratio)
    feed(case, "bottom", SPEED)
    control(case, deltaT=2e-3, endTime=0.3, writeInterval=150)
    case.run("grainThermalFoam")
    inside = ledger(case)["mappedVolume"][-1]
    assert inside > 0.9 * ratio * SHARE * MIXTURE * 0.3
    book = heat_ledger(case)
    assert volume_that_came_in(book) == pytest.approx(MIXTURE * 0.3 - inside, rel=1e-9)
    assert book["fluidError"].max() <= 1e-12
    assert book["leastT"].min() >= COLD - 1e-9


@pytest.mark.parametrize("radius", [0.003, 0.008])
def test_fluid_takes_the_place_of_a_grain_that_leaves_fluid_at_rest(clone, radius):
    """Of 0.6 and 1.6 cells, which the patch's velocity holds up for a while."""
    case = channel(clone, [(0.043, 0.02)], speed=0, radius=radius)
    replace(case, "constant/g", "(0 0 0)", "(0 -9.81 0)")
    replace(case, "0/p_rgh", '"left|right|bottom"\n    {\n        type    zeroGradient;',
            '"left|right|bottom"\n    {\n        type    fixedFluxPressure; value uniform 0;')
    append(case, "outlets { hole { type patches; patches (bottom); } }")
    control(case, deltaT=1e-3, endTime=1, writeInterval=500)
    case.run("grainThermalFoam")
    assert ledger(case)["grains"][-1] == 0
    volume = np.pi * radius**2 * 0.01
    book = heat_ledger(case)
    assert volume_that_came_in(book) == pytest.approx(volume, rel=1e-8)
    assert book["fluidError"].max() <= 1e-12


# Upwind differences are half a cell late; rise of the fluid's temperature over the closed form's
# was 0.88
@METHODS
def test_exchanger_of_heat(clone, method, ratio):
    """Fluid and grains side by side, NTU 0.55 and 0.66."""
    cells, bins = 20, 10
    case = channel(clone, method=method, ratio=ratio, n=cells)
    feed(case, "bottom", SPEED)
    control(case, deltaT=2e-3, endTime=1, writeInterval=50)
    case.run("grainThermalFoam")
    share = ratio * SHARE
    diameter = 2 * RADIUS * np.sqrt(ratio)
    h = 2 * KAPPA / diameter * 6 / diameter * share
    fluid, grains = (1 - share) * DENSITY * CP * SPEED, share * 2500 * GRAIN_CP * SPEED
    mean = (fluid * COLD + grains * HOT) / (fluid + grains)

    def left(y):
        return np.exp(-h * (1 / fluid + 1 / grains) * y)

    times = case.times[-4:]
    y = (np.arange(cells) + 0.5) * SIDE / cells
    late = SIDE / cells / 2
    found = np.mean(
        [case.field("T", t).reshape(cells, cells).mean(axis=1) for t in times], axis=0
    )
    exact = mean + (COLD - mean) * left(y + late)
    np.testing.assert_allclose(found - COLD, exact - COLD, rtol=0.03)

    middles = (np.arange(bins) + 0.5) * SIDE / bins
    sums, counts = np.zeros(bins), np.zeros(bins)
    for t in times:
        state = case.grains(t)
        height = state["position"][:, 1]
        bin_of = np.clip((height / SIDE * bins).astype(int), 0, bins - 1)
        np.add.at(sums, bin_of, state["temperature"].ravel())
        np.add.at(counts, bin_of, 1)
    np.testing.assert_allclose(sums / counts, mean + (HOT - mean) * left(middles), atol=0.8)


def test_grains_that_leave_against_the_fluid(clone):
    """Of a density that makes drag of no account."""
    case = channel(clone)
    feed(case, "top", -SPEED)
    replace(case, GRAINS, "density 2500;", "density 2.5e7;")
    control(case, deltaT=2e-3, endTime=1, writeInterval=500)
    case.run("grainThermalFoam")
    steps = slice(-150, None)
    flux = volume_that_came_in(heat_ledger(case), steps) / (150 * 2e-3)
    assert flux == pytest.approx((1 + SHARE) * MIXTURE, rel=0.01)


@pytest.mark.parallel
def test_ranks_that_share_the_patch_agree_and_a_restart_continues(clone):
    cases = []
    for name in ("whole", "parts", "several"):
        case = channel(clone, method="diffused; length 0.01;", ratio=0.8)
        case.path = case.path.rename(case.path.with_name(name))
        feed(case, "bottom", SPEED)
        control(case, deltaT=2e-3, endTime=0.1, writeInterval=25)
        cases.append(case)
    whole, parts, several = cases
    run_whole_and_parts(whole, parts, "grainThermalFoam", 0.05, 0.1)
    assert_same_grains(whole, parts)
    np.testing.assert_array_equal(whole.field("T"), parts.field("T"))
    several.run("decomposePar")
    several.parallel("grainThermalFoam", 2)
    several.run("reconstructPar")
    np.testing.assert_allclose(whole.field("T"), several.field("T"), rtol=0, atol=1e-6)
    books = [volume_that_came_in(heat_ledger(case)) for case in (whole, several)]
    assert books[1] == pytest.approx(books[0], rel=1e-12)
