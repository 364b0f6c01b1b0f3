# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs on several ranks are runs on one rank; what post-processing needs is written."""

import numpy as np
import pytest
from droplet_box import GAS, droplet_table, make_gas, with_droplets
from dry_box import dry_box
from grain_box import assert_same_grains, control, grain_box, lattice, ledger, replace, tracks
from heat_box import with_heat

pytestmark = pytest.mark.parallel

TOLERANCE = 1e-7
RADIUS = 0.01 / 6


def settling_pile(clone, cells, name):
    """Loose grains that fall onto each other, over the whole width of the box."""
    rng = np.random.default_rng(2)
    centres = lattice(28, 11, 0.0034, (0.003, 0.0018)) + rng.uniform(-2e-5, 2e-5, (308, 2))
    case = grain_box(clone, centres, RADIUS, name=name)
    # Heavy enough to fall through what they displace within 0.1 s
    replace(case, "constant/grainProperties", "density 2500", "density 7800")
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    control(case, endTime=0.1, writeInterval=50)
    return case


def decompose(case, ranks):
    replace(case, "system/decomposeParDict", "numberOfSubdomains 2", f"numberOfSubdomains {ranks}")
    replace(case, "system/decomposeParDict", "(2 1 1)", f"(2 {ranks // 2} 1)")
    case.run("decomposePar")


# Cell size over diameter 3 and 1/2
@pytest.fixture(params=[10, 60], ids=["coarse", "fine"])
def serial(clone, request):
    case = settling_pile(clone, request.param, "serial")
    case.run("grainFoam")
    case.cells = request.param
    return case


@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks_agree(clone, serial, ranks):
    case = settling_pile(clone, serial.cells, "parallel")
    decompose(case, ranks)
    case.parallel("grainFoam", ranks)

    one, many = serial.grains("0.1"), case.grains("0.1")
    np.testing.assert_array_equal(one["id"], many["id"])
    assert ledger(serial)["active"].max() > 200
    # What contacts leave uncertain in a step
    assert np.abs(one["position"] - many["position"]).max() <= TOLERANCE

    book = ledger(case)
    assert len(book["time"]) == 100
    assert book["mappingError"].max() <= 1e-12
    assert book["momentumError"].max() <= 1e-10
    assert tracks(case).shape == tracks(serial).shape
    np.testing.assert_allclose(tracks(case)[:, 2:4], tracks(serial)[:, 2:4], atol=TOLERANCE)


def vtk_points(case):
    """Number of points of each file of the cloud that foamToVTK wrote."""
    files = sorted((case.path / "VTK").rglob("lagrangian/**/*.vtp"))
    assert files
    return [int(f.read_bytes().split(b"NumberOfPoints=")[1].split(b"'")[1]) for f in files]


def test_two_ranks_continue_on_one(clone):
    whole, parts = (settling_pile(clone, 10, name) for name in ("whole", "parts"))
    whole.run("grainFoam")
    whole.run("foamToVTK -latestTime")
    assert vtk_points(whole) == [308]

    control(parts, endTime=0.05)
    decompose(parts, 2)
    parts.parallel("grainFoam", 2)
    parts.run("reconstructPar")
    parts.run("foamToVTK -latestTime")
    assert vtk_points(parts) == [308]

    control(parts, endTime=0.1)
    parts.run("grainFoam")
    assert "The grains continue from" in parts.log
    difference = whole.grains("0.1")["position"] - parts.grains("0.1")["position"]
    assert np.abs(difference).max() <= TOLERANCE


@pytest.mark.parametrize("handler", ["masterUncollated", "collated"])
def test_file_handlers_agree(clone, handler):
    """Run, restart with purged times, reconstruct: as without a handler, bit for bit."""
    one, other = (settling_pile(clone, 10, name) for name in ("uncollated", handler))
    for case, option in ((one, ""), (other, f" -fileHandler {handler}")):
        control(case, endTime=0.04, writeInterval=10, purgeWrite=2)
        case.run(f"decomposePar{option}")
        case.parallel(f"grainFoam{option}", 2)
        control(case, endTime=0.08)
        case.parallel(f"grainFoam{option}", 2)
        assert "0.04/grains.h5" in case.log
        states = sorted(path.parent.name for path in case.path.glob("*/grains.h5"))
        # OpenFOAM, too, leaves the times of an earlier start
        assert states == ["0.03", "0.04", "0.07", "0.08"]
        case.run(f"reconstructPar -latestTime{option}")
        case.run("foamToVTK -latestTime")
        assert vtk_points(case) == [308]
    assert (other.path / "processors2").exists() == (handler == "collated")
    assert_same_grains(one, other)
    for name in ("U", "p_rgh", "eps"):
        np.testing.assert_array_equal(one.field(name), other.field(name), err_msg=name)


def test_dry_grains_are_divided_again(clone):
    """A later time has no fields, and one of its four ranks no grain."""
    centres = [(0.035, 0.055), (0.062, 0.051), (0.08, 0.03)]
    whole, parts = (dry_box(clone, centres, dimension=2, name=name) for name in ("a", "b"))
    replace(parts, "system/decomposeParDict", "numberOfSubdomains 2", "numberOfSubdomains 4")
    replace(parts, "system/decomposeParDict", "(2 1 1)", "(4 1 1)")
    for case in (whole, parts):
        control(case, endTime=0.02, writeInterval=10)
    whole.run("dryGrainFoam")

    control(parts, endTime=0.01)
    parts.run("dryGrainFoam")
    parts.run("decomposePar -latestTime")
    assert not (parts.path / "processor0/0.01").exists()
    control(parts, endTime=0.02)
    parts.parallel("dryGrainFoam", 4)
    assert "The grains continue from" in parts.log
    assert_same_grains(whole, parts)


def test_droplets_and_a_rank_without_cells(clone):
    """Ranks agree to the tolerances of the solvers, 1e-12."""
    cases = []
    for name in ("one", "many"):
        case = with_heat(grain_box(clone, name=name), T=450, grains=450, fluid=GAS)
        make_gas(case)
        cases.append(with_droplets(case, [(0.048, 0.055)], 0.022))
        control(case, endTime=0.005, writeInterval=5)
    one, many = cases
    one.run("grainDropletFoam")

    file = "system/decomposeParDict"
    replace(many, file, "numberOfSubdomains 2", "numberOfSubdomains 3")
    coefficients = '"ranks"; }\n// '
    replace(many, file, "simple;", f"manual; manualCoeffs {{ dataFile {coefficients}")
    header = "FoamFile { version 2.0; format ascii; class labelList; object ranks; }\n"
    ranks = " ".join(50 * ["0"] + 50 * ["2"])
    (many.path / "constant/ranks").write_text(f"{header}100 ({ranks})\n")
    many.run("decomposePar")
    many.parallel("grainDropletFoam", 3)
    books = [droplet_table(case) for case in cases]
    for column in ("y", "vy", "vapour"):
        np.testing.assert_allclose(books[0][column], books[1][column], rtol=1e-8, err_msg=column)
