# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that was stopped or killed and continued is the uninterrupted run, bit for bit."""

import os
import shutil
import subprocess
import time

import h5py
import numpy as np
import pytest
from dry_box import dry_box
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
    assert "The grains continue from" in parts.log
    if grains == "pile":
        assert whole.logged("Contacts  ").min() >= 30
    assert_same(whole, parts)
    assert track_lines(whole) == track_lines(parts)


STOP = """
    stop
    {
        type        runTimeControl;
        libs        ("libutilityFunctionObjects.so");
        conditions  { passed { type maxDuration; duration 0.0305; } }
    }
"""


@pytest.mark.parametrize("solver", ["grainFoam", "dryGrainFoam"])
def test_a_time_that_a_function_object_has_written_continues(clone, solver):
    """A run that runTimeControl ends between two times of writing."""
    whole, parts = (
        grain_box(clone, CASES["few"], RADIUS, name=name)
        if solver == "grainFoam"
        else dry_box(clone, CASES["few"], RADIUS, dimension=2, name=name)
        for name in ("a", "b")
    )
    for case in (whole, parts):
        control(case, endTime=0.08, writeInterval=40)
    whole.run(solver)
    replace(parts, "system/controlDict", "functions\n{", f"functions\n{{{STOP}")
    parts.run(solver)
    assert 0.03 < float(parts.times[-1]) < 0.04
    replace(parts, "system/controlDict", STOP, "")
    parts.run(solver)
    assert "The grains continue from" in parts.log
    assert_same_grains(whole, parts)
    if solver == "grainFoam":
        assert_same(whole, parts)


CLOSURES = """
    form B;
    addedMass 1;
    lift { shear { type SaffmanMei; shape sphere; } spin { type Magnus; shape sphere; } }
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
    stop = kill_while_writing(killed)
    assert stop is not None
    assert not (killed.path / stop / "grains.h5").exists()

    killed.run("grainFoam")
    assert f"Time {stop} is incomplete" in killed.log
    assert "FOAM Warning" not in killed.log
    assert (killed.path / f"{stop}.incomplete/grains.h5.incomplete").exists()
    before = [name for name in whole.times if float(name) < float(stop)][-1]
    if before != "0":
        assert f"/{before}/grains.h5" in killed.log
    assert_same(whole, killed)
    assert track_lines(whole) == track_lines(killed)


def test_developed_fields_without_grains_are_refused(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    control(case, endTime=0.02, writeInterval=10)
    case.run("grainFoam")
    (case.path / "0.02/grains.h5").unlink()
    files = [path for path in (case.path / "0.02").iterdir() if path.is_file()]
    before = {path: path.read_bytes() for path in files}
    control(case, endTime=0.03)
    for program in ("grainFoam", "checkGrains"):
        assert case.run(program, check=False) == 1
        for fragment in ("controlDict", "'startFrom'", "0.02/grains.h5", "rename", "processor"):
            assert fragment in case.log, case.log
        assert "\nTime = " not in case.log
    assert case.times[-1] == "0.02"
    assert before == {path: path.read_bytes() for path in before}

    # What the message tells to do
    (case.path / "0.01").rename(case.path / "0.01.old")
    shutil.rmtree(case.path / "0")
    (case.path / "0.02").rename(case.path / "0")
    shutil.rmtree(case.path / "0/uniform")
    case.run("checkGrains")
    case.run("grainFoam")
    assert case.times[-1] == "0.03"


def test_materials_are_found_by_their_names(clone):
    """A material in front of the others takes none of their grains."""
    whole, parts = (grain_box(clone, CASES["pile"], RADIUS, name=name) for name in ("a", "b"))
    control(whole, endTime=0.04, writeInterval=20)
    whole.run("grainFoam")
    control(parts, endTime=0.02, writeInterval=20)
    parts.run("grainFoam")

    grains = "constant/grainProperties"
    replace(parts, grains, "    glass   {", "    gold { density 2500; }\n    glass   {")
    laws = "contactLaws\n{"
    for other in ("gold", "steel"):
        laws += f"\n gold{other} {{ materials (gold {other}); type Coulomb; friction 0; }}"
    replace(parts, grains, "contactLaws\n{", laws)
    control(parts, endTime=0.04)
    parts.run("grainFoam")
    assert (whole.grains()["material"] == 0).all()
    assert (parts.grains()["material"] == 1).all()
    for name in ("position", "velocity", "spin"):
        np.testing.assert_array_equal(whole.grains()[name], parts.grains()[name], err_msg=name)

    replace(parts, grains, "    glass   {", "    silica  {")
    text = (parts.path / grains).read_text()
    (parts.path / grains).write_text(text.replace(" glass", " silica").replace("(glass", "(silica"))
    control(parts, endTime=0.05)
    assert parts.run("grainFoam", check=False) == 1
    assert "material glass, which is none of gold silica steel" in parts.log


def start(case, program="grainFoam", log=subprocess.DEVNULL):
    """A solver that runs until it is told to stop."""
    env = os.environ | {"PWD": str(case.path)}
    return subprocess.Popen(program.split(), cwd=case.path, env=env, stdout=log, stderr=log)


def wait_for(condition, solver, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert solver.poll() is None and time.monotonic() < end
        time.sleep(0.01)


def test_second_run_in_a_live_case_is_refused(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    control(case, endTime=1000, writeInterval=1, purgeWrite=2)
    lock = case.path / "grains.lock"
    solver = start(case)
    try:
        wait_for(lambda: len(case.times) > 1, solver)
        for _ in range(5):
            assert case.run("grainFoam", check=False, timeout=60) == 1
            assert "Another run is in this case: host" in case.log
            assert f"process {solver.pid}" in case.log
            assert str(lock) in case.log
        assert solver.poll() is None
        assert not list(case.path.glob("*.incomplete"))
    finally:
        solver.kill()
        solver.wait()

    # Killed: it could not remove the file
    assert lock.exists()
    control(case, endTime=1e-3 + float(case.times[-1]))
    case.run("grainFoam")
    assert f"process {solver.pid} in this case has ended" in case.log
    assert not lock.exists()

    # Of another host nothing is known
    lock.write_text("host elsewhere process 1\n")
    assert case.run("grainFoam", check=False) == 1
    assert "host elsewhere process 1" in case.log
    assert f'remove "{lock}"' in case.log
    lock.unlink()
    case.run("grainFoam")


def test_run_that_stops_with_an_error_leaves_no_lock(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    replace(case, "constant/grainProperties", "density 2500", "density -1")
    assert case.run("grainFoam", check=False) == 1
    assert not (case.path / "grains.lock").exists()


@pytest.mark.parallel
def test_second_run_in_a_live_case_of_two_ranks_is_refused(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    control(case, endTime=1000, writeInterval=1, purgeWrite=2)
    case.run("decomposePar")
    solver = start(case, "mpirun --oversubscribe -np 2 grainFoam -parallel")
    try:
        wait_for(lambda: len(case.times) > 1, solver)
        assert case.parallel("grainFoam", 2, check=False, timeout=60) == 1
        assert "Another run is in this case: host" in case.log
        assert solver.poll() is None
    finally:
        solver.terminate()
        solver.wait()
    control(case, endTime=1e-3 + max(float(time) for time in case.times))
    case.parallel("grainFoam", 2)
    assert not (case.path / "grains.lock").exists()


def test_state_with_two_grains_of_one_id_is_refused(clone):
    case = grain_box(clone, [(0.03, 0.03), (0.06, 0.05)], RADIUS)
    control(case, endTime=0.002, writeInterval=2)
    case.run("grainFoam")
    with h5py.File(case.path / "0.002/grains.h5", "r+") as state:
        state["id"][1] = state["id"][0]
    control(case, endTime=0.004)
    assert case.run("grainFoam", check=False) == 1
    for fragment in ("0.002/grains.h5", "two grains have the id 0"):
        assert fragment in case.log
    assert "printStack" not in case.log


def test_a_dictionary_that_is_changed_in_a_run_is_said_to_be_read_at_the_start_alone(clone):
    case = grain_box(clone, CASES["one"], RADIUS)
    control(case, endTime=1000, writeInterval=1, purgeWrite=2)
    replace(case, "system/controlDict", "runTimeModifiable false", "runTimeModifiable true")
    log = case.path / "log"
    with log.open("w") as file:
        solver = start(case, log=file)
        try:
            wait_for(lambda: len(case.times) > 1, solver)
            later = time.time() + 3600
            for name in ("grainProperties", "transportProperties"):
                os.utime(case.path / "constant" / name, (later, later))
            wait_for(lambda: log.read_text().count("is read at the start alone") == 2, solver)
            steps = log.read_text().count("\nTime = ")
            wait_for(lambda: log.read_text().count("\nTime = ") > steps + 2, solver)
        finally:
            solver.kill()
            solver.wait()
    text = log.read_text()
    for name in ("grainProperties", "transportProperties"):
        assert text.count(f"constant/{name} has changed. It is read at the start alone") == 1
