# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The option -postProcess of the solvers: function objects at times on disk."""

import re

import numpy as np
import pytest
from droplet_box import BOILING, GAS, make_gas, open_top, with_droplets
from dry_box import dry_box
from grain_box import control, grain_box, lattice, replace
from heat_box import with_heat
from sphere_box import field
from water_box import level, water_box

LIBRARY = 'libs ("libgrainFunctionObjects.so"); writeControl writeTime;'
WATCHED = f"""functions
{{
    fields {{ type grainFields; {LIBRARY} }}
    loads {{ type wallForces; {LIBRARY} }}
    net {{ type contactNetwork; {LIBRARY} }}
"""


def pile(clone):
    centres = lattice(8, 4, 0.0101, (0.012, 0.00505))
    case = dry_box(clone, centres, 0.005, dimension=2)
    control(case, endTime=0.1, writeInterval=50, writeFormat="ascii")
    replace(case, "system/controlDict", "functions\n{", WATCHED)
    return case


def test_dry_grains_are_as_in_the_run(clone):
    """What is on disk is the same; forces of contacts, which are not, are not made up."""
    case = pile(clone)
    case.run("dryGrainFoam")
    times = case.times[1:]
    names = ("packing", "UGrains", "granularTemperature")
    fields = {(t, name): field(case, name, t) for t in times for name in names}
    for time, name in fields:
        (case.path / time / name).unlink()
    books = sorted((case.path / "postProcessing").rglob("*.*"))
    before = {file: file.read_bytes() for file in [*books, case.path / times[-1] / "grains.h5"]}

    case.run("dryGrainFoam -postProcess -time 0.01:")
    for (time, name), values in fields.items():
        np.testing.assert_allclose(field(case, name, time), values, rtol=1e-9, atol=1e-12)
    tracks = case.table("postProcessing/tracks/postProcess/grains.csv")
    run = case.table("postProcessing/tracks/0/grains.csv")
    at = np.isin(run["time"], [float(time) for time in times])
    for column in ("x", "y", "vx", "vy", "wz"):
        np.testing.assert_allclose(tracks[column], run[column][at], rtol=1e-12, atol=1e-14)
    assert np.isnan(tracks["fx"]).all()

    for name in ("loads", "net"):
        assert f"The function object '{name}' needs the forces of contacts" in case.log
        assert not (case.path / "postProcessing" / name / "postProcess").exists()
    assert {file: file.read_bytes() for file in before} == before


def with_heat_and_droplet(clone):
    case = with_heat(grain_box(clone, name="case"), T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    open_top(case)
    return with_droplets(case, [(0.05, 0.055)], 0.02)


CENTRES = [(0.03, 0.03), (0.06, 0.05)]
CASES = {
    "grainFoam": lambda clone: grain_box(clone, CENTRES),
    "grainThermalFoam": lambda clone: with_heat(grain_box(clone, CENTRES)),
    "grainInterFoam": lambda clone: water_box(clone, level(0.05), CENTRES),
    "grainDropletFoam": with_heat_and_droplet,
}


@pytest.mark.parametrize("solver", CASES)
def test_every_solver_has_it(clone, solver):
    """Its fields are there, too: the magnitude of U is that of U."""
    case = CASES[solver](clone)
    control(case, endTime=2e-4, deltaT=1e-4, writeInterval=1)
    case.run(solver)
    case.run(f"{solver} -postProcess -func mag(U) -latestTime")
    assert "Warning" not in case.log and "End" in case.log
    speed = np.linalg.norm(case.field("U"), axis=1)
    np.testing.assert_allclose(case.field("mag(U)"), speed, rtol=1e-9, atol=1e-15)
    assert not (case.path / "grains.lock").exists()


@pytest.mark.parametrize("solver", CASES)
def test_every_solver_has_the_shear_of_walls(clone, solver):
    """Along a wall the viscosity of one of its fluids times the slope from there to the cells."""
    case = CASES[solver](clone)
    control(case, endTime=2e-3, deltaT=1e-3, writeInterval=1)
    case.run(solver)
    case.run(f"{solver} -postProcess -func wallShearStress -latestTime")
    (file,) = (case.path / "postProcessing/wallShearStress").glob("*/wallShearStress.dat")
    (line,) = [line for line in file.read_text().splitlines() if "left" in line]
    shear = [float(part.split()[1]) for part in line.replace(")", "(").split("(")[1::2]]
    rate = -case.field("U")[::10, 1] / 0.005
    text = (case.path / "constant/transportProperties").read_text()
    nu = [float(value) for value in re.findall(r"\bnu\s+(?:\[.*?\])?\s*([-\d.e]+);", text)]
    assert nu
    # The gradient along the wall, which is that of the cells, takes part
    beside = 0.2 * max(nu) * np.ptp(rate)
    for stress, slope in zip(shear, (rate.min(), rate.max()), strict=True):
        least, most = sorted((min(nu) * slope, max(nu) * slope))
        assert least - beside <= stress <= most + beside
    assert max(map(abs, shear)) > 2 * beside


def test_programs_of_openfoam_read_a_time_with_grains_without_a_word(clone):
    """State of the grains included, in which they look for their header."""
    case = grain_box(clone, CENTRES)
    control(case, endTime=2e-4, deltaT=1e-4, writeInterval=1)
    case.run("grainFoam")
    case.run("foamToVTK -latestTime")
    assert "Warning" not in case.log
    case.run("postProcess -func mag(U) -latestTime -noZero")
    assert "grains.h5" not in case.log


@pytest.mark.parametrize(
    "solver, entries",
    [
        ("grainFoam", "type grainProfiles; direction (0 1 0); number 5; fields (U);"),
        ("grainInterFoam", "type liquidGauges; stations ((0.05 0.05 0.005));"),
        ("grainInterFoam", "type refinementIndicator; alpha alpha.water;"),
    ],
)
def test_fields_that_a_function_object_names_come_later(clone, solver, entries):
    """OpenFOAM reads the function objects before there are fields."""
    case = CASES[solver](clone)
    control(case, endTime=2e-4, deltaT=1e-4, writeInterval=1)
    watched = f"functions\n{{ f {{ {entries} {LIBRARY} }}"
    replace(case, "system/controlDict", "functions\n{", watched)
    case.run(solver)
    case.run(f"{solver} -postProcess -latestTime")
    assert "End" in case.log
    for file in (case.path / "postProcessing/f").glob("postProcess/*.csv"):
        run = case.path / "postProcessing/f/0" / file.name
        assert file.read_text().splitlines()[-1] == run.read_text().splitlines()[-1]
