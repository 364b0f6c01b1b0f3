# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that goes wrong stops with the reason and leaves what is needed to continue."""

import resource
import signal
import subprocess

import numpy as np
from grain_box import control, grain_box, lattice, replace
from heat_box import fix_grains
from test_adjustableTimeStep import adjusting


def assert_stopped(case, *fragments):
    assert case.run("grainFoam", check=False, timeout=60) == 1
    for fragment in fragments:
        assert fragment in case.log, case.log[-3000:]
    assert "printStack" not in case.log
    assert "sigFpe" not in case.log


def test_grain_lost_through_a_gap_in_the_walls(clone):
    case = grain_box(clone, [(0.05, 0.03), (0.03, 0.07)])
    replace(case, "constant/grainProperties", "(left right bottom top)", "(left right top)")
    control(case, endTime=2, writeInterval=20)
    assert_stopped(case, "Grain 0", "has left the mesh", "gap in the walls")

    # The last complete time can be read and continued
    last = case.times[-1]
    grains = case.grains(last)
    assert np.isfinite(grains["position"]).all()
    assert np.isfinite(case.field("U", last)).all()
    assert grains["position"][0, 1] > -0.004
    control(case, endTime=float(last) + 1e-3)
    case.run("grainFoam")
    assert f"/{last}/grains.h5" in case.log


def test_fluid_that_blows_up(clone):
    """Continued with a lid so fast that its square is beyond all numbers."""
    case = grain_box(clone, [(0.05, 0.03)])
    control(case, endTime=0.01, writeInterval=10, writeFormat="ascii")
    case.run("grainFoam")
    case.dict_set("0.01/U", "boundaryField/top", "{ type fixedValue; value uniform (1e200 0 0); }")
    control(case, endTime=0.1, writeInterval=20)
    assert_stopped(case, "solution is not finite at time", "Courant number", "last complete time")

    # The fields are there for a look, the grains are not: no run continues from here
    last = case.times[-1]
    assert float(last) > 0.01
    assert f"not finite at time {last}" in case.log
    assert (case.path / last / "U").exists()
    assert not (case.path / last / "grains.h5").exists()

    case.dict_set("0.01/U", "boundaryField/top", "{ type noSlip; }")
    control(case, endTime=0.02)
    case.run("grainFoam")
    assert f"Time {last} is incomplete" in case.log
    assert "/0.01/grains.h5" in case.log
    assert case.times[-1] == "0.02"


def test_steps_that_become_too_short(clone):
    """Continued with a lid so fast that a step may last a millionth of the first at most."""
    case = grain_box(clone, [(0.05, 0.03)])
    fix_grains(case)
    adjusting(case, write_interval=0.01, end=0.01)
    control(case, writeFormat="ascii")
    case.run("grainFoam")
    case.dict_set("0.01/U", "boundaryField/top", "{ type fixedValue; value uniform (1e18 0 0); }")
    control(case, endTime=0.1)
    assert_stopped(
        case, "s by maxCo, less than minDeltaT 1e-09 s", "last complete time", "FOAM exiting"
    )

    case.dict_set("0.01/U", "boundaryField/top", "{ type noSlip; }")
    control(case, endTime=0.02)
    case.run("grainFoam")
    assert "/0.01/grains.h5" in case.log
    assert case.times[-1] == "0.02"


def test_a_first_step_that_would_be_too_short_leaves_the_start_as_it_is(clone):
    case = grain_box(clone, [(0.05, 0.05)], velocity=[(30, 0)])
    adjusting(case, write_interval=0.01, end=0.01, minDeltaT=1e-4)
    before = (case.path / "0/U").read_bytes()
    assert_stopped(case, "s by maxGrainDisplacement, less than minDeltaT 0.0001 s")
    assert (case.path / "0/U").read_bytes() == before
    assert not list((case.path / "0").glob("grains.h5.*"))
    replace(case, "system/controlDict", "minDeltaT 0.0001;", "")
    control(case, endTime=1e-4)
    case.run("grainFoam")


def with_full_disc():
    """Files end after 60 kB, as on a disc without room."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))


def test_disc_without_room_for_the_state(clone):
    """The reason is the last thing that is said; a run continues from the time before."""
    case = grain_box(clone, lattice(20, 20, 0.0045, (0.004, 0.004)), 0.002)
    control(case, endTime=0.001, writeInterval=1)
    replace(case, "system/controlDict", "functions", "none")
    case.run("grainFoam")
    assert (case.path / "0.001/grains.h5").stat().st_size > 60000
    control(case, endTime=0.002)
    done = subprocess.run(
        ["grainFoam"], cwd=case.path, capture_output=True, text=True, preexec_fn=with_full_disc
    )
    output = done.stdout + done.stderr
    assert done.returncode == 1, output[-3000:]
    assert "The state of the grains could not be written" in output
    assert "File too large" in output
    assert "printStack" not in output
    assert output.rstrip().endswith("FOAM exiting")

    case.run("grainFoam")
    assert "Time 0.002 is incomplete" in case.log
    assert "/0.001/grains.h5" in case.log
