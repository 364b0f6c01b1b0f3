# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of tests/validation that take less than a minute stay within their tolerances."""

import os
import shutil
import subprocess

import pytest
from conftest import ROOT

FAST = ["fixedBed", "hinderedSettling", "manufacturedVANS", "relaxation", "terminalVelocity"]


@pytest.mark.parametrize("name", FAST)
def test_tolerances_are_kept(tmp_path, name):
    for folder in ("applications", "src", "tutorials"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    case = tmp_path / "tests/validation" / name
    shutil.copytree(ROOT / "tests/validation" / name, case)
    done = subprocess.run(
        ["./Allrun"], cwd=case, env=os.environ | {"GRAINFOAM_PREPARED": "yes"},
        capture_output=True, text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert (case / "results.csv").stat().st_size > 0
    assert (case / "results.png").stat().st_size > 10_000
