# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The guide does what it says: its first case runs as printed, its tables are complete."""

import re

import numpy as np
import pytest
from conftest import ROOT, Case
from droplet_box import BOILING, GAS, make_gas, open_top, with_droplets
from dry_box import dry_box
from grain_box import control, grain_box
from heat_box import with_heat
from water_box import level, water_box

GUIDE = ROOT / "doc/guide"
BLOCK = re.compile(r"(?:^File `([^`]+)`:\n\n)?^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def follow(page, path):
    """Write the files of a page and run its commands, in order; what they printed."""
    case = Case(path)
    output = ""
    for file, language, text in BLOCK.findall(page):
        if file:
            (path / file).parent.mkdir(exist_ok=True)
            (path / file).write_text(text)
        else:
            assert language == "bash"
            case.run(["bash", "-euo", "pipefail", "-c", text])
            output += case.log
    return case, output


def test_first_case_runs_as_printed(tmp_path):
    page = (GUIDE / "firstCase.md").read_text()
    case, output = follow(page, tmp_path)
    assert (tmp_path / "grains.png").stat().st_size > 20000
    assert list((tmp_path / "VTK").iterdir())
    assert "Failed" not in output and "FATAL" not in output

    said = re.search(r"It says `carried ([\d.]+) N of ([\d.]+) N`", page)
    got = re.search(r"carried ([\d.]+) N of ([\d.]+) N", output)
    assert got[2] == said[2]
    assert float(got[1]) == pytest.approx(float(said[1]), rel=0.01)
    assert float(got[1]) == pytest.approx(float(got[2]), rel=0.01)
    grains = case.grains()
    assert np.abs(grains["velocity"]).max() < 1e-3
    assert grains["position"][:, 1].max() < 0.04


def books(path):
    """Names of the columns of all ledgers below a case."""
    names = set()
    for file in (path / "postProcessing").glob("*edger/0/*.csv"):
        names |= set(file.read_text().split("\n")[0].split(","))
    for file in (path / "postProcessing").glob("droplets/0/*.csv"):
        names |= set(file.read_text().split("\n")[0].split(","))
    return names


def test_every_column_of_the_ledgers_is_explained(clone):
    centres = [(0.03, 0.03), (0.06, 0.05)]
    gas = with_heat(grain_box(clone, name="droplet"), T=BOILING, grains=BOILING, fluid=GAS)
    make_gas(gas)
    open_top(gas)
    with_droplets(gas, [(0.05, 0.055)], 0.02)
    cases = {
        "grainDropletFoam": gas,
        "grainInterFoam": water_box(clone, level(0.05), centres, name="water"),
        "dryGrainFoam": dry_box(clone, centres, dimension=2, name="dry"),
    }
    names = set()
    for solver, case in cases.items():
        control(case, endTime=1e-4, deltaT=1e-4)
        case.run(solver)
        names |= books(case.path)
    assert len(names) > 80

    explained = set()
    for cell in re.findall(r"^\| (`[^|]*) \|", (GUIDE / "ledgers.md").read_text(), re.MULTILINE):
        explained |= set(re.findall(r"`([^`]+)`", cell))
    plain = {re.sub(r"_(left|right|bottom|top)$", "_<patch>", name) for name in names}
    plain = {re.sub(r"_[xyz]$", "", name) for name in plain}
    assert plain <= explained, sorted(plain - explained)


def test_links_lead_somewhere():
    for page in GUIDE.glob("*.md"):
        for link in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text()):
            if "://" not in link:
                assert (page.parent / link).exists(), f"{page.name}: {link}"
