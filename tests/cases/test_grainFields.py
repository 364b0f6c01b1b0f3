# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Function object grainFields: packing, mean velocity and granular temperature on the mesh."""

import shutil

import numpy as np
import pytest
from conftest import Case
from dry_box import dry_box
from grain_box import DEPTH, control, cyclic_box, lattice, replace
from sphere_box import cell_volumes, field, random_spheres, sphere_box

V = 1e-4 * DEPTH  # of a cell of grainBox
NAMES = ("packing", "UGrains", "grainFlux", "granularTemperature")


def watch(case, more=""):
    library = 'libs ("libgrainFunctionObjects.so");'
    text = f"fields {{ type grainFields; {library} writeControl writeTime; }} {more}"
    replace(case, "system/controlDict", "functions\n{", f"functions\n{{ {text}\n")
    control(case, endTime=1e-3, deltaT=1e-3, writeInterval=1, writeFormat="ascii")


def weightless(case):
    replace(case, "constant/g", "-9.81", "0")


def discs(clone, name, velocity):
    """Across many cells, at random sizes, and none in the right half."""
    rng = np.random.default_rng(3)
    centres = lattice(4, 9, 0.0105, (0.0083, 0.0081))
    radii = rng.uniform(0.002, 0.005, len(centres))
    case = dry_box(clone, centres, radii, velocity(len(centres)), dimension=2, name=name)
    weightless(case)
    watch(case)
    return case, radii


def test_uniform_motion_is_exact_and_grains_are_all_there(clone):
    v = (0.03, -0.02)
    case, radii = discs(clone, "case", lambda n: np.tile(v, (n, 1)))
    case.run("dryGrainFoam")
    packing = case.field("packing")
    assert packing.sum() * V == pytest.approx(np.pi * (radii**2).sum() * DEPTH, rel=1e-12)
    full = packing > 0
    assert 20 < full.sum() < 80
    U = case.field("UGrains")
    np.testing.assert_allclose(U[full], np.tile([*v, 0], (full.sum(), 1)), rtol=1e-12, atol=1e-15)
    assert not U[~full].any()
    np.testing.assert_allclose(case.field("grainFlux"), packing[:, None] * U, rtol=1e-11)
    assert case.field("granularTemperature").max() < 1e-30


def test_momentum_is_kept_and_two_ranks_agree(clone):
    rng = np.random.default_rng(5)

    def velocity(n):
        return rng.normal(0, 0.1, (n, 2))

    case, radii = discs(clone, "one", velocity)
    two = Case(case.path.parent / "two")
    shutil.copytree(case.path, two.path)
    case.run("dryGrainFoam")
    grains = case.grains()
    areas = np.pi * grains["radius"] ** 2 * DEPTH
    momentum = (areas[:, None] * grains["velocity"]).sum(axis=0)
    np.testing.assert_allclose(
        case.field("grainFlux").sum(axis=0)[:2] * V, momentum[:2], rtol=1e-10
    )
    # Over the mesh: what grains have about the mean of a cell, and the means about zero
    energy = areas @ (grains["velocity"] ** 2).sum(axis=1)
    packing, U = case.field("packing"), case.field("UGrains")
    theta = case.field("granularTemperature")
    parts = packing * (2 * theta + (U**2).sum(axis=1))
    assert parts.sum() * V == pytest.approx(energy, rel=1e-10)
    assert theta.max() > 1e-4

    two.run("decomposePar")
    two.parallel("dryGrainFoam", 2)
    two.run("reconstructPar")
    for name in NAMES:
        np.testing.assert_allclose(two.field(name), case.field(name), rtol=1e-9, atol=1e-15)


def test_temperature_of_two_grains_in_a_cell(clone):
    """Of equal volume and opposite velocities u: u^2/2 in the plane, and no mean."""
    case = dry_box(
        clone, [(0.0525, 0.055), (0.0575, 0.055)], 0.002, [(-0.1, 0), (0.1, 0)], dimension=2
    )
    weightless(case)
    watch(case)
    control(case, endTime=1e-5, deltaT=1e-5)
    case.run("dryGrainFoam")
    cell = np.argmax(case.field("packing"))
    assert case.field("granularTemperature")[cell] == pytest.approx(0.1**2 / 2, rel=1e-12)
    assert abs(case.field("UGrains")[cell]).max() < 1e-15


def test_grains_across_a_period_are_in_the_cells_of_both_sides(clone):
    case = cyclic_box(clone, [(0.0001, 0.055)], 0.004)
    watch(case)
    control(case, endTime=1e-5, deltaT=1e-5)
    case.run("grainFoam")
    packing = case.field("packing").reshape(10, 10)
    assert packing.sum() * V == pytest.approx(np.pi * 0.004**2 * DEPTH, rel=1e-12)
    assert packing[5, 9] == pytest.approx(packing[5, 0], rel=0.1)
    np.testing.assert_allclose(packing.ravel(), 1 - case.field("eps"), atol=1e-12)


def test_spheres_and_means_over_time(clone):
    """fieldAverage after it averages; the volume is that of the spheres."""
    centres, radii = random_spheres(np.random.default_rng(1), np.linspace(0.004, 0.02, 20))
    case = sphere_box(clone, centres, radii, n=5)
    mean = " ".join(f"{name} {{ mean on; prime2Mean off; base time; }}" for name in NAMES)
    library = 'libs ("libfieldFunctionObjects.so"); writeControl writeTime;'
    watch(case, f"means {{ type fieldAverage; {library} fields ({mean}); }}")
    control(case, endTime=2e-3, writeInterval=2)
    case.run("grainFoam")
    volumes = cell_volumes(case)
    for name in ("packing", "packingMean"):
        total = (field(case, name, "0.002") * volumes).sum()
        assert total == pytest.approx(4 / 3 * np.pi * (radii**3).sum(), rel=1e-10)
    # Two steps of weight less buoyancy and drag: the mean lags behind
    last = field(case, "grainFlux", "0.002")[:, 2].min()
    assert last < field(case, "grainFluxMean", "0.002")[:, 2].min() < 0

