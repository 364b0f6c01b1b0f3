# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What grainDropletFoam refuses before the first step, and what it says."""

import pytest
from droplet_box import (
    ANTOINE,
    BOILING,
    DROPLETS,
    FLUID,
    GAS,
    GAS_CP,
    make_gas,
    open_top,
    with_droplets,
)
from grain_box import control, grain_box, ledger, replace
from heat_box import GRAINS, with_heat

CSV = "constant/droplets.csv"
HEAD = "x,y,z,radius\n"


def table(text):
    return lambda case: (case.path / CSV).write_text(text)


def swap(old, new):
    return lambda case: replace(case, DROPLETS, old, new)


def add(text):
    def change(case):
        file = case.path / DROPLETS
        file.write_text(f"{file.read_text()}{text}\n")

    return change


def late(rows):
    """Droplets of a table that come at a time."""

    def change(case):
        (case.path / "constant/late.csv").write_text(HEAD + rows)
        add('releases { r { time 1; droplets { type csv; file "constant/late.csv"; } } }')(case)

    return change


def resolve(entries):
    coupling = "\ncoupling\n{"
    return lambda case: replace(
        case, GRAINS, coupling, f"{coupling} resolvedGrains {{ {entries} }}"
    )


def diffuse(case):
    replace(case, GRAINS, "type    exactOverlap;", "type diffused; length 0.02;")


BAD = {
    "cold": (swap("boilingTemperature 373.15", "boilingTemperature 400"), "'boilingTemperature'"),
    "no latent heat": (swap("latentHeat 2260000.0;", ""), "'latentHeat'"),
    "negative": (swap("mu 2.8e-4", "mu -1"), "'mu'"),
    "a word": (swap("mu 2.8e-4", "mu water"), "'mu'"),
    "not a number": (swap("density 1000.0", "density nan"), "'density'"),
    "dimensions": (swap("density 1000.0", "density [0 0 1 0 0 0 0] 5"), "'density'"),
    "unknown": (swap("liquid {", "vapor on; liquid {"), "'vapor'"),
    "no liquid": (swap("liquid {", "fluid {"), "'liquid'"),
    "no droplets": (swap("initialDroplets", "initialDrops"), "'initialDrops'"),
    "no file": (lambda case: (case.path / DROPLETS).unlink(), "dropletProperties"),
    "empty file": (lambda case: (case.path / DROPLETS).write_text(""), "dropletProperties"),
    "no table": (lambda case: (case.path / CSV).unlink(), "droplets.csv"),
    "empty table": (table(""), "droplets.csv"),
    "small": (table(HEAD + "0.05,0.05,0.005,0.01\n"), "fewer than 4 cells across"),
    "soon gone": (add("tolerance 2e-4;"), "ten times the radius at which droplets are gone"),
    "outside": (table(HEAD + "0.5,0.5,0.005,0.02\n"), "'initialDroplets'"),
    "over a wall": (table(HEAD + "0.01,0.055,0.005,0.02\n"), "only in part in the mesh"),
    "one in another": (
        table(HEAD + "0.05,0.05,0.005,0.021\n0.06,0.05,0.005,0.021\n"),
        "overlaps droplet 1",
    ),
    "radius": (table(HEAD + "0.05,0.05,0.005,nan\n"), "'radius'"),
    "across the mesh": (
        table("x,y,z,radius,vx,vy,vz\n0.05,0.05,0.005,0.02,0,0,1\n"),
        "velocity across the mesh",
    ),
    "few cells": (add("from 1;"), "'from'"),
    "motion": (add("motion x;"), "(free fixed)"),
    "blowing": (add("blowing x;"), "(local uniform)"),
    "tolerance": (add("tolerance 1;"), "'tolerance'"),
    "patches": (add("walls { a { type patches; patches (nope); } }"), "'patches'"),
    "walls": (add("walls yes;"), "'walls'"),
    "saturated without vapour": (
        add(ANTOINE.format(pressure=1e5, temperature=300)),
        "no dictionary 'vapour'",
    ),
    "temperature of their own": (
        swap("initialDroplets {", "initialDroplets { temperature 350;"),
        "'temperature'",
    ),
    "hot": (add(ANTOINE.format(pressure=1e5, temperature=400)), "'temperature'"),
    "curve": (
        add(ANTOINE.format(pressure=1e5, temperature=300).replace("Antoine", "Wagner")),
        "(Antoine ClausiusClapeyron)",
    ),
    "no pressure": (add(ANTOINE.format(pressure=0, temperature=300)), "'pressure'"),
    "kilopascals": (add(ANTOINE.format(pressure=101.325, temperature=300)), "'pressure'"),
    "capacity of the gas": (
        lambda case: replace(case, FLUID, f"Cp {GAS_CP};", "Cp polynomial ((1000 0));"),
        "a number > 0, as grainDropletFoam",
    ),
    "resolved grains": (resolve("type cutCells;"), "none, as the flow is resolved around droplets"),
    "diffused": (diffuse, "exactOverlap, as what grains and droplets exchange"),
    "resolved from two cells": (resolve("from 2;"), "none, as the flow is resolved around"),
    "late outside": (late("0.5,0.5,0.005,0.02\n"), "outside the mesh"),
    "late without time": (add("releases { r { droplets { type csv; } } }"), "'time'"),
    "late unknown": (add("releases { r { time 1; when 2; } }"), "'when'"),
}


@pytest.mark.parametrize("change, said", BAD.values(), ids=BAD)
def test_bad_input_is_named(clone, change, said):
    case = with_heat(grain_box(clone), T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    open_top(case)
    with_droplets(case, [(0.05, 0.055)], 0.02)
    change(case)
    control(case, endTime=2e-3)
    case.run("grainDropletFoam", check=False)
    assert said in case.log
    assert "FATAL" in case.log
    assert "Time = " not in case.log
    assert "printStack" not in case.log


def test_droplets_that_overlap_are_called_so(clone):
    """With the file that they are in, its lines, and no entry that is not theirs."""
    case = with_heat(grain_box(clone), T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    with_droplets(case, [(0.05, 0.05), (0.06, 0.05)], 0.021)
    assert case.run("grainDropletFoam", check=False) == 1
    error = case.log[case.log.index("-->") :]
    assert "droplet 0 at (0.05 0.05 0.005) with radius 0.021 overlaps droplet 1" in error
    assert "allowed: up to 0.01 of the smaller diameter" in error
    assert f"{case.path}/{DROPLETS}.initialDroplets" in error
    assert "line 0" not in error
    assert "rain" not in error.split("file:")[0].replace("grainDropletFoam", "")


def test_a_missing_state_is_named(clone):
    case = with_heat(grain_box(clone), T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(case)
    open_top(case)
    with_droplets(case, [(0.05, 0.055)], 0.02)
    control(case, endTime=2e-3, writeInterval=1)
    case.run("grainDropletFoam")
    (case.path / "0.002/droplets.h5").unlink()
    control(case, endTime=4e-3)
    case.run("grainDropletFoam", check=False)
    assert "no state of the droplets" in case.log


@pytest.mark.parametrize("isOpen", [True, False], ids=["open", "shut"])
def test_vapour_without_a_way_out_is_said_once(clone, isOpen):
    case = with_heat(grain_box(clone), T=600, grains=BOILING, fluid=GAS)
    make_gas(case)
    if isOpen:
        open_top(case)
    with_droplets(case, [(0.05, 0.055)], 0.02)
    control(case, endTime=2e-2)
    case.run("grainDropletFoam")
    assert case.log.count("no patch lets the fluid") == (0 if isOpen else 1)

    # Without grains there is nothing to differ from
    assert ledger(case)["momentumError"].max() == 0


@pytest.mark.parametrize("cold", [True, False], ids=["cold", "hot"])
def test_heat_that_a_boiling_droplet_gives_away_is_said_once(clone, cold):
    grains = BOILING - 100 if cold else BOILING
    case = with_heat(grain_box(clone, [(0.05, 0.055)], 0.008), T=BOILING, grains=grains, fluid=GAS)
    make_gas(case)
    open_top(case)
    with_droplets(case, [(0.05, 0.055)], 0.02, latent=1e3)
    case.run("grainDropletFoam")
    assert case.log.count("colder than its boilingTemperature") == (1 if cold else 0)
