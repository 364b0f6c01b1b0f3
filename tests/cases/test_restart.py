# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that was stopped or killed and continued is the uninterrupted run, bit for bit."""

import os
import subprocess

import numpy as np
import pytest
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    lattice,
    replace,
    run_whole_and_parts,
)

RADIUS = 0.004
CASES = {
    "one": [(0.047, 0.062)],
    "few": [(0.031, 0.042), (0.035, 0.055), (0.062, 0.051), (0.066, 0.012)],
    "pile": lattice(6, 5, 2 * RADIUS, (RADIUS, RADIUS)),
}


def assert_same(one, other):
    """The state of the grains and of the fluid at the last time."""
    assert_same_grains(one, other)
    for name in ("U", "p", "p_rgh", "eps"):
        np.testing.assert_array_equal(one.field(name), other.field(name), err_msg=name)


def track_lines(case):
    """Lines of the trajectories by time and id; a later start overwrites what it repeats."""
    folder = case.path / "postProcessing/tracks"
    lines = {}
    for start in sorted(folder.iterdir(), key=lambda path: float(path.name)):
        for line in (start / "grains.csv").read_text().splitlines()[1:]:
            time, grain, values = line.split(",", 2)
            lines[time, grain] = values
    return lines


@pytest.mark.parametrize("grains", CASES)
def test_stop_and_restart(clone, grains):
    whole, parts = (grain_box(clone, CASES[grains], RADIUS, name=name) for name in ("a", "b"))
    for case in (whole, parts):
        control(case, endTime=0.08, writeInterval=40)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.04, end=0.08)
    assert "Grains continue from" in parts.log
    if grains == "pile":
        assert whole.logged("Contacts  ").min() >= 30
    assert_same(whole, parts)
    assert track_lines(whole) == track_lines(parts)


CLOSURES = """
    form B;
    addedMass 1;
    lift { shear { type SaffmanMei; } spin { type Magnus; } }
    viscosity { type KriegerDougherty; maxFraction 0.9; }
"""


def test_stop_and_restart_with_every_closure(clone):
    whole, parts = (grain_box(clone, CASES["few"], RADIUS, name=name) for name in ("a", "b"))
    for case in (whole, parts):
        grains = "constant/grainProperties"
        replace(case, grains, "\ncoupling\n{", f"\ncoupling\n{{{CLOSURES}")
        replace(case, grains, "type    exactOverlap;", "type diffused; length 0.01;")
        replace(case, "constant/transportProperties", "rho ", "HeleShaw { gap 0.1; }\nrho ")
        control(case, endTime=0.08, writeInterval=40)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.04, end=0.08)
    assert_same(whole, parts)
    assert track_lines(whole) == track_lines(parts)


def test_fields_that_a_restart_lacks_are_reported(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    control(case, endTime=0.02, writeInterval=10)
    case.run("grainFoam")
    assert "made from U" not in case.log
    control(case, endTime=0.03)
    case.run("grainFoam")
    assert " has no " not in case.log

    for name in ("phiU", "phi", "gradP_rgh"):
        (case.path / "0.03" / name).unlink()
    control(case, endTime=0.04)
    case.run("grainFoam")
    assert case.log.count("Time 0.03 has no (phiU phi): made from U") == 1
    assert case.log.count("Time 0.03 has no (gradP_rgh): zero in the first step") == 1


def kill_while_writing(case):
    """Kill the solver in the middle of a time; its name, None if the run got to its end."""
    env = os.environ | {"PWD": str(case.path)}
    solver = subprocess.Popen(["grainFoam"], cwd=case.path, env=env, stdout=subprocess.DEVNULL)
    marker = None
    while marker is None and solver.poll() is None:
        marker = next(case.path.glob("[0-9]*[0-9]/grains.h5.incomplete"), None)
    solver.kill()
    solver.wait()
    if marker is None:
        return None
    # Unless the solver was faster and has just finished the time
    return marker.parent.name if marker.exists() else kill_while_writing(case)


@pytest.mark.parametrize("grains", ["one", "few"])
def test_kill_while_writing_and_restart(clone, grains):
    whole, killed = (grain_box(clone, CASES[grains], RADIUS, name=name) for name in ("a", "b"))
    for case in (whole, killed):
        control(case, endTime=0.3, writeInterval=5)
    whole.run("grainFoam")
    time = kill_while_writing(killed)
    assert time is not None
    assert not (killed.path / time / "grains.h5").exists()

    killed.run("grainFoam")
    assert f"Time {time} is incomplete" in killed.log
    assert (killed.path / f"{time}.incomplete/grains.h5.incomplete").exists()
    before = [name for name in whole.times if float(name) < float(time)][-1]
    if before != "0":
        assert f"/{before}/grains.h5" in killed.log
    assert_same(whole, killed)
    assert track_lines(whole) == track_lines(killed)
