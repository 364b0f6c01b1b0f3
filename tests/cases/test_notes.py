# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user should know is said, once, before or when it matters."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from droplet_box import BOILING, GAS, droplet_table, make_gas, with_droplets
from dry_box import dry_box, write_grains
from grain_box import control, grain_box, replace, tracks
from heat_box import fix_grains, stream, with_heat
from sphere_box import sphere_box
from test_cutCells import choose, with_cells
from test_dropletsLeave import SPEED
from test_dropletsLeave import channel as droplet_channel
from test_injections import channel
from test_vapour import with_vapour
from water_box import level, water_box

GRAINS = "constant/grainProperties"


def test_patches_that_grains_can_pass_are_listed(clone):
    note = "are neither walls nor outlets of grains"
    case = dry_box(clone, [(0.05, 0.05)], dimension=2)
    control(case, endTime=0.002)
    for program in ("checkGrains", "dryGrainFoam"):
        case.run(program)
        assert note not in case.log

    replace(case, GRAINS, "(left right bottom top)", "(right bottom)")
    for program in ("checkGrains", "dryGrainFoam"):
        case.run(program)
        assert case.log.count(f"Patches (left top) {note}") == 1

    path = case.path / GRAINS
    path.write_text(path.read_text() + "outlets { one { type patches; patches (top); } }\n")
    case.run("checkGrains")
    assert f"Patches (left) {note}" in case.log


def test_patches_that_droplets_can_pass_are_not_said_of_the_grains(clone):
    case = grain_box(clone)
    make_gas(case)
    with_heat(case, T=BOILING, fluid=GAS)
    with_droplets(case, [(0.05, 0.05)], 0.025)
    control(case, endTime=0.001)
    case.run("grainDropletFoam")
    note = "Patches (left right bottom top) are neither walls nor outlets of droplets"
    assert case.log.count(note) == case.log.count("neither walls") == 1


def test_masses_that_the_solver_cannot_cope_with_are_reported(clone):
    """Radii of 6 and 0.05 mm: discs of 1.4e4 times the mass."""
    case = dry_box(clone, [(0.05, 0.05), (0.08, 0.08)], radius=[6e-3, 5e-5], dimension=2)
    case.run("checkGrains")
    assert "Warning: masses" not in case.log
    replace(case, GRAINS, "contact\n{", "contact\n{\n    solver queue;")
    case.run("checkGrains")
    warning = "Warning: masses of grains and free walls differ by a factor of 14400"
    assert case.log.count(warning) == 1


def test_spheres_that_creep_and_cover_cells_are_reported(clone):
    """Of 2.5 cells: Stokes' regime in syrup, not in water; or resolved."""
    warning = "coupling/resolvedGrains { type locked; from 2; } resolves"
    case = sphere_box(clone)
    write_grains(case, [(0.05, 0.05, 0.05)], 0.0125)
    case.run("checkGrains")
    several = "law, over several cells: 1, Reynolds numbers of settling"
    assert several in case.log
    assert warning not in case.log

    replace(case, "constant/transportProperties", "0] 1e-4;", "0] 1e-2;")
    case.run("checkGrains")
    assert case.log.count(warning) == 1

    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    resolvedGrains { type locked; from 2; }")
    case.run("checkGrains")
    assert "resolved: 1, Reynolds numbers of settling" in case.log
    assert warning not in case.log

    # 3.9 cells are not four, and no others than exact overlaps can be resolved
    replace(case, GRAINS, "from 2", "from 4")
    write_grains(case, [(0.05, 0.05, 0.05)], 0.0195)
    case.run("checkGrains")
    assert several in case.log
    write_grains(case, [(0.05, 0.05, 0.05)], 0.021)
    case.run("checkGrains")
    assert several not in case.log
    replace(case, GRAINS, "    resolvedGrains { type locked; from 4; }\n", "")
    replace(case, GRAINS, "exactOverlap", "centroid")
    case.run("checkGrains")
    assert several in case.log


def test_courant_numbers_above_1_are_reported_once(clone):
    case = grain_box(clone, [(0.05, 0.07)], velocity=[(0, -3)])
    control(case, endTime=0.01, deltaT=1e-3)
    case.run("grainFoam")
    assert "--> FOAM Warning" not in case.log

    # 10 mm cells: 15 m/s in 1 ms
    case = grain_box(clone, [(0.05, 0.08)], velocity=[(0, -15)], name="fast")
    control(case, endTime=0.003, deltaT=1e-3)
    case.run("grainFoam")
    assert case.log.count("(said once)") == 1
    assert "1.5 of the grains after time 0" in case.log


@pytest.mark.parametrize(
    "file, old, new, what",
    [
        ("constant/transportProperties", "rho ", "HeleShow { gap 1; }\nrho ", "'HeleShow'"),
        ("system/fvSolution", "nCorrectors     2", "nCorrectors 0", "'nCorrectors' has the"),
        ("system/fvSolution", "nCorrectors     2", "nCorrector 2", "'nCorrector'"),
        ("system/fvSolution", "PISO", "PIMPLE", "'PISO' is missing"),
        ("constant/MRFProperties", "", "zone {}", "constant/MRFProperties"),
    ],
)
def test_files_of_the_fluid_hold_nothing_that_is_passed_over(clone, file, old, new, what):
    case = grain_box(clone, [(0.05, 0.05)])
    case.run("checkGrains")
    if old:
        replace(case, file, old, new)
    else:
        (case.path / file).write_text(new)
    assert case.run("checkGrains", check=False) == 1
    error = case.log[case.log.index("-->") :]
    assert file in error
    assert what in error


def test_dictionaries_may_have_names_of_their_own(clone):
    case = grain_box(clone, [(0.05, 0.05)])
    (case.path / "constant/parameters").write_text("mySpeed 3;\nmyTolerance 1e-8;\n")
    replace(case, GRAINS, "1e-7", "$myTolerance")
    replace(case, GRAINS, "shape   disc;\n\n", '#include "parameters"\nmu 0.3;\nshape disc;\n\n')
    replace(case, GRAINS, "friction    0.3", "friction $mu")
    control(case, endTime=0.001)
    case.run("decomposePar")
    case.parallel("grainFoam", 2)
    case.run("grainFoam")
    replace(case, GRAINS, "$mu", "0.3")
    assert case.run("grainFoam", check=False) == 1
    assert "Unknown keyword 'mu'" in case.log


def test_users_own_programs_stay_in_front(tmp_path):
    """etc/bashrc puts its programs into PATH, and not all others of the system, too."""
    root = Path(__file__).resolve().parents[2]
    mine = tmp_path / "bin"
    mine.mkdir()
    for name in ("python3", "git", "cmake"):
        (mine / name).write_text("#!/bin/sh\n")
        (mine / name).chmod(0o755)
    clean = {"HOME": os.environ["HOME"], "PATH": f"{mine}:/usr/bin:/bin"}
    for name in ("GRAINFOAM_CACHE", "XDG_CACHE_HOME"):
        if name in os.environ:
            clean[name] = os.environ[name]
    programs = "python3 git cmake grainFoam blockMesh wmake"
    script = f"i=7; . {root}/etc/bashrc && for p in {programs}; do command -v $p; done; echo $i"
    done = subprocess.run(["bash", "-c", script], env=clean, capture_output=True, text=True)
    if "run etc/install first" in done.stderr:
        pytest.skip("another OpenFOAM is used here than that of etc/install")
    found = done.stdout.split()
    assert found[:3] == [str(mine / name) for name in ("python3", "git", "cmake")]
    # A loop's variable of the user's, too
    assert found[6:] == ["7"]
    assert found[3].startswith(f"{root}/platforms/")


def without_heat(transport_properties):
    """Entries that grainFoam refuses are marked as grainThermalFoam's alone."""
    lines, skip = [], False
    for line in transport_properties.splitlines():
        skip = (skip or "Of grainThermalFoam alone" in line) and line.strip() not in ("", "}")
        lines += [] if skip else [line]
    return "\n".join([*lines, ""])


@pytest.mark.parametrize("application", ["grainFoam", "grainThermalFoam"])
def test_documented_dictionaries_run(clone, application):
    """Time-step control, function objects, schemes and solvers of etc/caseDicts, in a case."""
    root = Path(__file__).resolve().parents[2]
    case = grain_box(clone, [(0.05, 0.03), (0.03, 0.05)])
    if application == "grainThermalFoam":
        with_heat(case, T=290, grains=290)
        replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure")
    for folder, names in {
        "system": ("controlDict", "fvSchemes", "fvSolution"),
        "constant": ("transportProperties",),
    }.items():
        for name in names:
            text = (root / "etc/caseDicts" / name).read_text()
            if name == "transportProperties" and application == "grainFoam":
                text = without_heat(text)
            (case.path / folder / name).write_text(text)
    (case.path / "0/dye").write_text(
        "FoamFile { version 2.0; format ascii; class volScalarField; object dye; }\n"
        "dimensions [0 0 0 0 0 0 0]; internalField uniform 1;\n"
        'boundaryField { frontAndBack { type empty; } ".*" { type zeroGradient; } }\n'
    )
    case.run("checkGrains")
    case.run(application)
    assert case.times == ["0", "0.005", "0.01"]
    assert abs(case.field("dye", "0.01") - 1).max() <= 1e-12
    written = {path.name for path in (case.path / "postProcessing").iterdir()}
    always = {"ledger", "tracks", "loads", "forceChains", "walls", "front", "problems", "profiles"}
    assert written == always | (
        {"heatLedger"} if application == "grainThermalFoam" else set()
    ) - (
        set() if "problems" in written else {"problems"}
    )
    assert "maxGrainDisplacement" in case.log


def test_documented_dictionaries_of_two_fluids_run(clone):
    root = Path(__file__).resolve().parents[2]
    case = water_box(clone, level(0.05), [(0.05, 0.03), (0.03, 0.08)])
    for file in ("system/fvSchemes", "system/fvSolution", "constant/transportProperties"):
        text = (root / "etc/caseDicts/grainInterFoam" / Path(file).name).read_text()
        (case.path / file).write_text(text)
    (case.path / "system/controlDict").write_text(
        (root / "etc/caseDicts/controlDict").read_text().replace("grainFoam;", "grainInterFoam;")
    )
    watched = root / "etc/caseDicts/grainInterFoam/functions"
    replace(case, "system/controlDict", "functions\n{", f'functions\n{{\n#include "{watched}"\n')
    (case.path / "0/dye").write_text(
        "FoamFile { version 2.0; format ascii; class volScalarField; object dye; }\n"
        "dimensions [0 0 0 0 0 0 0]; internalField uniform 1;\n"
        'boundaryField { frontAndBack { type empty; } ".*" { type zeroGradient; } }\n'
    )
    case.run("checkGrains")
    assert "In water:\n" in case.log and "In air:\n" in case.log
    case.run("grainInterFoam")
    assert case.times == ["0", "0.005", "0.01"]
    assert abs(case.field("dye", "0.01") - 1).max() <= 1e-12
    assert "maxCapillaryCo" in case.log
    levels = case.table("postProcessing/gauges/0/levels.csv")
    assert levels["station0"][0] == pytest.approx(0.05, abs=1e-3)


def test_treatment_of_the_grains_is_told(clone):
    """Of 4.4, 1.4, 1 and 0.2 cells in a diameter."""
    centres = [(0.05, 0.05, 0.03), (0.05, 0.02, 0.08), (0.08, 0.08, 0.08), (0.02, 0.02, 0.08)]
    case = sphere_box(clone, centres, [0.022, 0.0072, 0.005, 0.001])
    locked = "\ncoupling\n{ resolvedGrains { type locked; }"
    replace(case, GRAINS, "\ncoupling\n{", locked)
    control(case, endTime=0.002, deltaT=1e-3)
    case.run("grainFoam")
    said = (
        "Treatment of the grains: 1 resolved, 2 by a law in the flow undisturbed by them,"
        " 1 in that of their cells; 1 cover cells"
    )
    assert case.log.count(said) == 1


def test_contact_law_for_pairs_that_have_none(clone):
    """Discs roll on steel by the friction of the law that is for all pairs."""
    case = dry_box(clone, [(0.02, 0.004), (0.08, 0.004)], dimension=2)
    law = "    glassOnSteel\n    {\n        materials   (glass steel);"
    replace(case, "constant/grainProperties", law, "    default\n    {")
    replace(case, "constant/g", "(0 -9.81 0)", "(1 -9.81 0)")
    case.run("dryGrainFoam")
    # Two thirds of the acceleration along the floor; all of it without friction
    speed = case.grains()["velocity"][:, 0]
    np.testing.assert_allclose(speed, 2 / 3 * 0.05, rtol=0.01)

    replace(case, "constant/grainProperties", "    default\n", "    defaults\n")
    assert case.run("dryGrainFoam", check=False) == 1
    assert "'materials'" in case.log


def test_Biot_number_without_conductivity_is_unknown(clone):
    case = with_heat(grain_box(clone, [(0.05, 0.05)]))
    case.run("checkGrains")
    assert "Biot number             unknown: 'glass' has no conductivity" in case.log


def test_cohesion_that_asks_for_vapour_where_there_is_none_is_said(clone):
    """As of psi = 0; grainThermalFoam without the entry vapour, too, and not with it."""
    note = "'psi0' of a contact law asks for the vapour around grains, and there is none: psi is 0"
    law = "type cohesive; cohesion 1; psi0 0.9; friction 0.2;"
    case = grain_box(clone, [(0.05, 0.05)])
    replace(case, GRAINS, "type        Coulomb;\n        friction    0.2;", law)
    control(case, deltaT=1e-3, endTime=0.003)
    case.run("grainFoam")
    assert case.log.count(note) == 1

    with_heat(case)
    case.run("grainThermalFoam")
    assert case.log.count(note) == 1


def test_nothing_is_said_of_vapour_that_is_there(clone):
    case = grain_box(clone, [(0.05, 0.05)])
    with_vapour(case, 0.5, "type cohesive; cohesion 1; psi0 0.9; friction 0.2;")
    control(case, deltaT=1e-3, endTime=0.003)
    case.run("grainThermalFoam")
    assert "asks for the vapour" not in case.log


FILLED = "fill cells at patch %s, which gives the velocity"


@pytest.mark.parametrize("kind", ["locked", "cutCells"])
def test_fixed_grain_at_an_inlet_is_said(clone, kind):
    """A disc of 8 cells, a fifth of a cell into the inlet: 93 or 8100 N; 1.6 cells off 0.01 N."""
    forces = []
    for x in (0.0095, 0.014, 0.0905):
        case = grain_box(clone, [(x, 0.05)], 0.01, name=f"{kind}{x}")
        with_cells(case, 40)
        stream(case, SPEED)
        fix_grains(case)
        choose(case, kind)
        replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
        control(case, deltaT=4e-3, endTime=0.4)
        case.run("grainFoam")
        forces.append(tracks(case)[-1, 11])
        assert case.log.count(FILLED % "left") == (x == 0.0095)
        assert case.log.count("the force on them is not that of a flow") == (x == 0.0095)
        assert FILLED % "right" not in case.log
    assert forces[0] > 1000 * max(forces[1:])


def test_grains_that_come_in_with_a_velocity_of_their_own_are_said_to_lose_it(clone):
    """Of 5 cells, 7.8 times as dense as the fluid, a fifth of its speed: they take its speed."""
    feed = "type patches; patches (bottom); velocity (0 %g 0); numberRate 4; total 1;"
    size = "distribution { type constant; radius 0.006; }"
    case = channel(clone, f"{feed % (0.2 * SPEED)} {size}")
    with_cells(case, 40)
    replace(case, GRAINS, "density 2500", "density 7800")
    control(case, deltaT=2e-3, endTime=0.4)
    case.run("grainFoam")
    assert case.log.count(FILLED % "bottom") == 1
    assert case.log.count("their own velocity, such as that of the entry 'velocity', is lost") == 1
    assert FILLED % "top" not in case.log
    np.testing.assert_allclose(tracks(case)[-1, 6], SPEED, rtol=1e-3)


def test_droplet_at_an_inlet_is_said_to_move_with_its_gas(clone):
    case = droplet_channel(clone, [(0.048, 0.021)], 0.02, speed=0, fluid=GAS)
    make_gas(case)
    control(case, deltaT=2e-3, endTime=0.02)
    case.run("grainDropletFoam")
    assert case.log.count(f"Droplets or grains {FILLED % 'bottom'}") == 1
    # At rest before, and 1000 times as dense: 0.89 of the gas's speed after ten steps
    assert droplet_table(case)["vy"][-1] > 0.8 * SPEED
