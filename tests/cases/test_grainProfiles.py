# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Means over slices along an axis, of grains and of the fluid."""

import numpy as np
import pytest
from dry_box import dry_box
from grain_box import control, grain_box, replace
from heat_box import fix_grains, with_heat
from sphere_box import decompose

DEPTH, H, R = 0.01, 0.01, 0.004
CENTRES = [(0.055, 0.035), (0.025, 0.035), (0.055, 0.075)]


def watch(case, number, fields="fields (T U);", direction="(0 1 0)"):
    entry = (
        'functions { profiles { type grainProfiles; libs ("libgrainFunctionObjects.so");'
        f" writeControl timeStep; writeInterval 1; direction {direction}; number {number};"
        f" {fields} }} }}\n"
    )
    replace(case, "system/controlDict", "purgeWrite", f"{entry}purgeWrite")


def hot_grains(clone, number, name=None, **watched):
    """Fixed, in a fluid whose temperature is 300 K and 1 K per row of cells."""
    case = grain_box(clone, CENTRES, R, name=name)
    T = 300 + np.repeat(np.arange(10.0), 10)
    with_heat(case, T, 400, fluid="Cp 1e9; kappa 1e-9;")
    fix_grains(case)
    watch(case, number, **watched)
    control(case, deltaT=1e-6, endTime=1e-6, writeInterval=1)
    return case


def profiles(case):
    return case.table(next(case.path.glob("postProcessing/profiles/*/profiles.csv")))


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=pytest.mark.parallel)])
def test_slices_of_a_case_with_heat(clone, ranks):
    case = hot_grains(clone, 10)
    if ranks > 1:
        decompose(case, ranks)
        case.parallel("grainThermalFoam", ranks)
    else:
        case.run("grainThermalFoam")
    found = profiles(case)
    np.testing.assert_allclose(found["x"], (np.arange(10) + 0.5) * H, rtol=1e-12)
    np.testing.assert_allclose(found["volume"], 0.1 * H * DEPTH, rtol=1e-12)
    covered = np.zeros(10)
    covered[3], covered[7] = 2, 1
    np.testing.assert_allclose(found["packing"], covered * np.pi * R**2 / (0.1 * H), atol=1e-12)
    np.testing.assert_allclose(found["T"], 300 + np.arange(10), atol=1e-6)
    np.testing.assert_allclose(found["TGrains"][covered > 0], 400, atol=1e-6)
    assert np.isnan(found["TGrains"][covered == 0]).all()
    assert np.isnan(found["UGrains_x"][covered == 0]).all()


def test_one_slice_is_the_mean_of_all(clone):
    """Of the fluid by its volume: rows with grains count less."""
    case = hot_grains(clone, 1)
    case.run("grainThermalFoam")
    found = profiles(case)
    open_part = np.full(10, 0.1 * H)
    open_part[3] -= 2 * np.pi * R**2
    open_part[7] -= np.pi * R**2
    mean = np.sum(open_part * (300 + np.arange(10))) / np.sum(open_part)
    assert found["T"][0] == pytest.approx(mean, abs=1e-6)
    assert found["TGrains"][0] == pytest.approx(400, abs=1e-6)


def test_velocity_of_grains_that_fly(clone):
    """Two rows that fly apart, without a fluid."""
    velocity = [(0.1, 0), (0.1, 0.2), (-0.3, 0)]
    case = dry_box(clone, CENTRES, R, velocity, dimension=2)
    watch(case, 2, fields="")
    control(case, endTime=1e-6, deltaT=1e-6)
    case.run("dryGrainFoam")
    found = profiles(case)
    np.testing.assert_allclose(found["UGrains_x"], [0.1, -0.3], rtol=1e-9)
    np.testing.assert_allclose(found["UGrains_y"], [0.1, 0], atol=1e-4)


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        ({"number": 0}, ["'number'", "value 0"]),
        ({"number": 5, "direction": "(0 0 0)"}, ["'direction'", "0 0 0", "not zero"]),
        ({"number": 5, "fields": "fields (T k);"}, ["'fields'", "value k", "scalar and vector"]),
        ({"number": 5, "fields": "field (T);"}, ["'field'", "fields"]),
    ],
)
def test_bad_input_is_refused(clone, bad, words):
    case = hot_grains(clone, **bad)
    assert case.run("grainThermalFoam", check=False) == 1
    for word in ("controlDict", *words):
        assert word in case.log
    assert "\nTime = " not in case.log
