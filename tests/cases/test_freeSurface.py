# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains at and across the surface between water and air."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from grain_box import (
    DEPTH,
    assert_same_grains,
    control,
    cyclic_box,
    lattice,
    ledger,
    replace,
    run_whole_and_parts,
    write_csv,
)
from water_box import SIZE, column, level, liquid_ledger, set_water, to_two_fluids, water_box

GRAINS = "constant/grainProperties"
H = SIZE / 20


def hold(case):
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")


def without_predictor(case):
    """The velocity of the first step is then that of a pressure that has been solved for."""
    case.dict_set("system/fvSolution", "PIMPLE/momentumPredictor", "no")


def write_label_list(case, name, labels):
    head = f"FoamFile {{ version 2.0; format ascii; class labelList; object {Path(name).name}; }}"
    body = "\n".join(map(str, labels))
    (case.path / name).write_text(f"{head}\n{len(labels)}\n(\n{body}\n)\n")


def crossing(clone, seed, name=None):
    """Grains of 0.2 to 9 cells at random places, up to half a cell a step, any density."""
    rng = np.random.default_rng(seed)
    d = [0.2, 0.7, 1.3, 3, 6, 9][seed % 6] * H
    centres = []
    for x in rng.uniform(d / 2, SIZE - d / 2, (int(rng.integers(2, 12)), 2)):
        if all(np.hypot(*(x - y)) > d for y in centres):
            centres.append(x)
    velocity = rng.uniform(-2.5, 2.5, (len(centres), 2))
    sigma = 0.07 * (seed % 2)
    case = water_box(
        clone, level(0.052), centres, d / 2, (20, 20), sigma=sigma, velocity=velocity, name=name
    )
    replace(case, GRAINS, "density 2500", f"density {10 ** rng.uniform(2, 4)}")
    return case


@pytest.mark.parametrize("seed", [*range(6), *(pytest.param(s, marks=pytest.mark.slow)
                                               for s in range(6, 60))])
def test_fluids_are_kept_and_bounded(clone, seed):
    case = crossing(clone, seed)
    control(case, deltaT=1e-3, endTime=0.15, writeInterval=150)
    case.run("grainInterFoam")
    liquid = liquid_ledger(case)
    # Round-off of 150 steps, and the tolerance of the flux that carries, 1e-12 of a cell
    assert np.abs(liquid["unaccounted"]).max() <= 1e-10
    assert liquid["leastAlpha"].min() >= -1e-8
    assert liquid["mostAlpha"].max() <= 1 + 1e-8
    assert ledger(case)["momentumError"].max() <= 1e-10


@pytest.mark.parametrize(
    "height, grains, closes",
    [
        (0.05, "none", "no"),
        (0.052, "bed", "no"),
        (0.052, "bed", "yes"),
        (0.05, "disc", "no"),
        (0.052, "disc", "no"),
    ],
)
def test_rest(clone, height, grains, closes):
    """A pool, a bed in and above it, and a disc that the flow is resolved around."""
    case = water_box(clone, level(height), cells=(20, 20))
    if grains == "bed":
        write_csv(case, lattice(12, 15, 0.0062, (0.0142, 0.0075)), 0.003)
        hold(case)
    if grains == "disc":
        write_csv(case, [(0.0513, 0.0508)], 0.02)
        hold(case)
    without_predictor(case)
    case.dict_set("system/fvSolution", "PIMPLE/closeMomentum", closes)
    path = case.path / "system/fvSolution"
    path.write_text(path.read_text().replace("1e-12", "1e-16"))
    control(case, deltaT=1e-3, endTime=1, writeInterval=1000)
    case.run("grainInterFoam")
    assert np.abs(case.field("U")).max() <= 1e-8 * np.sqrt(9.81 * height)


@pytest.mark.parametrize("delta_t", [1e-3, 2.5e-4])
def test_a_disc_at_rest_leaves_the_fluids_beside_it(clone, delta_t):
    """Without weight, in the middle of them: it carries nothing that could change places."""
    case = water_box(clone, column(0.047, 1), [(0.05, 0.052)], 0.01, (30, 30))
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=delta_t, endTime=0.01, writeInterval=round(0.01 / delta_t))
    case.run("grainInterFoam")
    beside = case.field("eps") > 0.5
    change = case.field("alpha.water") - case.field("alpha.water", "0")
    assert np.abs(change[beside]).max() <= 1e-10


def test_level_rises_by_what_is_immersed(clone):
    """Grains that start dry, too slow to bring air with them, end on the floor."""
    radius = 0.002
    centres = lattice(12, 1, 0.006, (0.017, 0.0425))
    case = water_box(clone, level(0.04), centres, radius, (20, 20))
    replace(case, "constant/transportProperties", "nu 1e-6", "nu 1e-4")
    control(case, deltaT=1e-3, endTime=1.5, writeInterval=1500)
    case.run("grainInterFoam")
    assert case.grains()["position"][:, 1].max() < 0.02
    volume = len(centres) * np.pi * radius**2 * DEPTH
    full = case.field("alpha.water").sum() * (SIZE / 20) ** 2 * DEPTH
    rise = full - 0.04 * SIZE * DEPTH
    assert rise == pytest.approx(volume, rel=1e-3)
    assert np.abs(liquid_ledger(case)["unaccounted"]).max() <= 1e-10


@pytest.mark.parametrize("corrections, closes", [(2, "yes"), (12, "no")])
def test_momentum_of_a_band_of_water_with_grains(clone, corrections, closes):
    """It flies through air in a periodic box without weight."""

    def band(low, high):
        upper = np.clip((0.07 - low[:, 0]) / (high[:, 0] - low[:, 0]), 0, 1)
        return upper - np.clip((0.03 - low[:, 0]) / (high[:, 0] - low[:, 0]), 0, 1)

    radius, velocity = 0.003, (0.5, 0.1)
    centres = lattice(3, 6, 0.0105, (0.04, 0.012))
    case = cyclic_box(clone, centres, radius)
    to_two_fluids(case)
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    set_water(case, band, "cyclic")
    write_csv(case, centres, radius, np.tile(velocity, (len(centres), 1)))
    water = case.field("alpha.water", "0")[:, None] > 0.5
    values = "\n".join(f"({x} {y} 0)" for x, y in np.where(water, velocity, 0))
    replace(case, "0/U", "uniform (0 0 0)", f"nonuniform List<vector> {len(water)}\n({values})")
    # What the corrections of the pressure leave is momentum that is not accounted for,
    # unless an equation of momentum that is solved ends them
    controls = f"nCorrectors {corrections}; closeMomentum {closes}"
    replace(case, "system/fvSolution", "nCorrectors     2", controls)
    control(case, deltaT=5e-4, endTime=0.1, writeInterval=20)
    case.run("grainInterFoam")

    cell = SIZE**2 * DEPTH / len(water)
    mass = 2500 * np.pi * radius**2 * DEPTH
    momentum = [
        (case.field("massBefore", t)[:, None] * case.field("U", t)).sum(axis=0)[:2] * cell
        + mass * case.grains(t)["velocity"].sum(axis=0)[:2]
        for t in case.times[1:]
    ]
    change = np.abs(np.array(momentum) - momentum[0]).max()
    assert change <= 1e-8 * np.linalg.norm(momentum[0])


def test_heavy_disc_in_gas(clone):
    """500 times as dense as the fluid around it, which has to go as fast as it is pushed."""
    speed = 0.3
    case = water_box(clone, level(0), [(0.05, 0.035)], 0.03, (20, 20), velocity=[(0, speed)])
    replace(case, GRAINS, "density 2500", "density 500")
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=2e-4, endTime=0.08, writeInterval=40)
    case.run("grainInterFoam")
    # Twice the disc's speed where the gaps are 0.4 of the box, and 0.63 was measured
    assert max(np.abs(case.field("U", t)).max() for t in case.times[1:]) <= 3 * speed
    assert case.grains()["velocity"][0, 1] == pytest.approx(speed, rel=0.02)


@pytest.mark.parametrize("seed", [2, 4])
def test_stop_and_restart(clone, seed):
    whole, parts = (crossing(clone, seed, name) for name in ("whole", "parts"))
    for case in (whole, parts):
        control(case, deltaT=1e-3, endTime=0.04, writeInterval=20)
    run_whole_and_parts(whole, parts, "grainInterFoam", 0.02, 0.04)
    assert_same_grains(whole, parts)
    for name in ("U", "p_rgh", "alpha.water"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)


def test_a_restart_knows_the_length_of_the_last_step(clone):
    """Steps that grow by a fifth each, continued from the fifth one."""
    whole, parts = (
        water_box(clone, column(0.04, 0.08), [(0.06, 0.05)], 0.006, (20, 20), name=name)
        for name in ("whole", "parts")
    )
    for case in (whole, parts):
        adjust = "adjustTimeStep yes; maxCo 0.4; maxDeltaT 0.005;\npurgeWrite"
        replace(case, "system/controlDict", "purgeWrite", adjust)
        control(case, deltaT=1e-4, endTime=2e-3, writeInterval=1, timePrecision=12)
    whole.run("grainInterFoam")
    begin, end = whole.times[5], whole.times[6]
    shutil.copytree(whole.path / begin, parts.path / begin)
    control(parts, endTime=float(end) * (1 - 1e-9))
    parts.run("grainInterFoam")
    # 0.02 m/s where it took the length of the step before
    np.testing.assert_array_equal(whole.field("U", end), parts.field("U", parts.times[-1]))


def test_a_cell_may_lie_alone_among_those_of_another_rank(clone):
    case = crossing(clone, 4)
    rank = np.zeros((20, 20), dtype=int)
    rank[:, 10:] = 1
    rank[3, 3] = 1
    write_label_list(case, "constant/cellDecomposition", rank.ravel())
    manual = 'manual;\nmanualCoeffs { dataFile "cellDecomposition"; }'
    replace(case, "system/decomposeParDict", "simple;", manual)
    control(case, deltaT=1e-3, endTime=5e-3, writeInterval=5)
    case.run("decomposePar")
    case.parallel("grainInterFoam", 2)
    assert np.abs(liquid_ledger(case)["unaccounted"]).max() <= 1e-10


@pytest.mark.parametrize("seed, ranks", [(2, 2), (4, 2), (4, 4)])
def test_ranks_agree(clone, seed, ranks):
    one, parts = (crossing(clone, seed, name) for name in ("one", "parts"))
    steps = 20 if ranks == 2 else 6
    for case in (one, parts):
        control(case, deltaT=1e-3, endTime=steps * 1e-3, writeInterval=steps)
    one.run("grainInterFoam")
    if ranks == 4:
        replace(parts, "system/decomposeParDict", "numberOfSubdomains 2", "numberOfSubdomains 4")
        replace(parts, "system/decomposeParDict", "(2 1 1)", "(2 2 1)")
    parts.run("decomposePar")
    parts.parallel("grainInterFoam", ranks)
    parts.run("reconstructPar")
    # Linear solvers of other sums of residuals 1e-12, over up to 20 steps
    for name, scale in (("U", 1), ("alpha.water", 1), ("p_rgh", 1000)):
        np.testing.assert_allclose(
            one.field(name), parts.field(name), rtol=0, atol=1e-6 * scale, err_msg=name
        )
