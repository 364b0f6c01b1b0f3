# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every tutorial runs a few steps and draws its pictures, so that none rots."""

import csv
import os
import shutil
import subprocess

import grainplot
import numpy as np
import pytest
from conftest import ROOT

TUTORIALS = sorted(path.parent for path in ROOT.glob("tutorials/*/*/Allrun"))


@pytest.fixture
def tutorial(tmp_path, request):
    """A copy of the tutorials, one of which has been run with -test."""
    shutil.copytree(
        ROOT / "tutorials",
        tmp_path / "tutorials",
        ignore=shutil.ignore_patterns("exactOverlap", "centroid", "snapshots", "log.*"),
    )
    path = tmp_path / request.param.relative_to(ROOT)
    # The first tutorial of the README looks for itself what there is to build
    prepared = {} if path.name == "sedimentation" else {"GRAINFOAM_PREPARED": "yes"}
    done = subprocess.run(
        ["./Allrun", "-test"], cwd=path, env=os.environ | prepared, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return path


def test_digging_on_a_mesh_that_fits(tmp_path):
    shutil.copytree(
        ROOT / "tutorials",
        tmp_path / "tutorials",
        ignore=shutil.ignore_patterns("snapshots", "log.*", "bed_*"),
    )
    subprocess.run(
        ["./Allrun", "-fitted", "-coarse", "-test"],
        cwd=tmp_path / "tutorials/grainDropletFoam/digging",
        env=os.environ | {"GRAINFOAM_PREPARED": "yes"},
        check=True,
    )
    bed = tmp_path / "tutorials/grainDropletFoam/digging/bed_400_coarse_fitted"
    assert (bed / "snapshots/droplet.png").exists()
    assert "Mesh that follows the droplet" in (bed / "log.grainDropletFoam.0").read_text()


def tell_the_methods_apart(sedimentation):
    with open(sedimentation / "volumeDefects.csv") as file:
        rows = {row["method"]: row for row in csv.DictReader(file)}

    exact, centroid = rows["exactOverlap"], rows["centroid"]
    # Round-off of sums over a grain's cells and over all grains
    assert float(exact["mapping error, max"]) <= 1e-12
    assert float(exact["momentum error, max"]) <= 1e-10
    # The linear solver's tolerance, and nothing is clipped
    assert float(exact["divergence of the mixture, max"]) <= 1e-9
    assert float(exact["volume without room [% of grains]"]) == 0
    # A cell three diameters wide holds 9 to 12 centres of a packing of 0.91
    assert float(centroid["volume without room [% of grains]"]) > 1


def have_the_orifices_of_their_names(silos):
    cases = list(silos.glob("width_*"))
    assert len(cases) == 8
    for case in cases:
        mesh = grainplot.read_mesh(case)
        x = np.abs(np.concatenate(mesh.polygons)[:, 0])
        width = int(case.name.removeprefix("width_"))
        assert 2 * x[x > 1e-6].min() == pytest.approx(0.004 * width)  # vertices at 0 and the edges


def assert_heat_is_kept(file):
    """To 1e-8 of what fluid, grains and walls exchange, but for the digits of what there is."""
    book = np.genfromtxt(file, delimiter=",", names=True)
    conducted = [book[name] for name in book.dtype.names if name.startswith("conducted_")]
    convected = [book[name] for name in book.dtype.names if name.startswith("convected_")]
    exchanged = np.abs([book["exchanged"], book["plates"], book["walls"], *conducted]).sum()
    left = sum(conducted) + sum(convected) - book["plates"] - book["filled"]
    fluid = np.diff(book["fluidHeat"]) + (left + book["exchanged"])[1:]
    came = book["exchanged"] + book["outside"] + book["walls"] + book["injected"] - book["removed"]
    grains = np.diff(book["grainHeat"]) - came[1:]
    for missing, heat in ((fluid, "fluidHeat"), (grains, "grainHeat")):
        digits = np.finfo(float).eps * book[heat].max() * len(missing)
        assert abs(missing.sum()) <= 1e-8 * exchanged + digits, (file, heat)


# What must hold of a tutorial besides
CHECKS = {
    "sedimentation": tell_the_methods_apart,
    "jammingSilo": have_the_orifices_of_their_names,
}


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda path: path.name, indirect=True)
def test_allrunDrawsPictures(tutorial):
    pictures = list(tutorial.glob("snapshots/*.png"))
    assert pictures
    assert all(picture.stat().st_size > 10_000 for picture in pictures)
    if tutorial.parent.name == "grainThermalFoam":
        books = list(tutorial.glob("**/heatLedger.csv"))
        assert books
        for book in books:
            assert_heat_is_kept(book)
    if tutorial.name in CHECKS:
        CHECKS[tutorial.name](tutorial)
