# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""packGrains makes the packing that was asked for, checkGrains says what is wrong with one."""

import numpy as np
import pytest
from grain_box import grain_box, replace

BOX = "box (0 0 0) (0.1 0.1 0);"
HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }\n"
FILL = f"type randomFill; {BOX} number 150; minRadius 1.6e-3; maxRadius 2.4e-3; material glass;"


def pack(clone, entries, name=None):
    """Centres and radii that packGrains writes."""
    case = grain_box(clone, name=name)
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    case.run("packGrains")
    table = np.loadtxt(
        case.path / "constant/grains.csv", delimiter=",", skiprows=1, usecols=(0, 1, 3), ndmin=2
    )
    assert f"Number of grains        {len(table)}\n" in case.log
    return case, table[:, :2], table[:, 2]


def worst_overlap(centres, radii):
    """Of each other and of the walls [m]."""
    i, j = np.triu_indices(len(radii), 1)
    gaps = np.linalg.norm(centres[i] - centres[j], axis=1) - radii[i] - radii[j]
    walls = np.minimum(centres, 0.1 - centres).min(axis=1) - radii
    return -min(gaps.min(), walls.min())


def fraction(radii):
    return np.pi * np.sum(radii**2) / 0.1**2


def test_lattice(clone):
    entries = f"type lattice; {BOX} radius 2e-3; spacing 5e-3; material glass;"
    case, centres, radii = pack(clone, entries)
    # Centres 5 mm apart within 0.1 m less two radii
    assert len(radii) == 20**2
    assert worst_overlap(centres, radii) <= 1e-15
    assert case.logged("of the bounding box, ") == pytest.approx(fraction(radii), rel=1e-9)


def test_hexagonal_is_the_densest(clone):
    _, centres, radii = pack(clone, f"type hexagonal; {BOX} radius 1e-3; material glass;")
    # Rows of 50 and 49, sqrt(3) radii apart: 1 + floor(0.098/0.0017320508) rows
    assert len(radii) == 29 * 50 + 28 * 49
    assert worst_overlap(centres, radii) <= 1e-15
    # pi/sqrt(12) = 0.907, less half a grain's width along each wall
    assert 0.88 < fraction(radii) < np.pi / np.sqrt(12)


def test_random_fill(clone):
    _, centres, radii = pack(clone, FILL)
    assert len(radii) == 150
    assert radii.min() >= 1.6e-3
    assert radii.max() <= 2.4e-3
    # Of 150 uniform radii, the extremes are within a tenth of the range of its ends
    assert np.ptp(radii) > 0.8 * 0.8e-3
    assert worst_overlap(centres, radii) <= 0


def test_the_same_seed_gives_the_same_grains(clone):
    files = []
    for name, seed in (("one", 1), ("same", 1), ("other", 2)):
        case, *_ = pack(clone, f"{FILL} seed {seed};", name)
        files.append((case.path / "constant/grains.csv").read_bytes())
    assert files[0] == files[1]
    assert files[0] != files[2]


def test_settled_grains_rest_on_the_floor_and_run(clone):
    entries = f"type settled; from {{ {FILL} }} deltaT 1e-3;"
    case, centres, radii = pack(clone, entries)
    assert len(radii) == 150
    # Tolerance of a step of the contact solver, and what deep piles add to it
    assert worst_overlap(centres, radii) <= 1e-6
    # A loose pile of 19 % of the box's area at 0.7 to 0.84 of its own
    top = (centres[:, 1] + radii).max()
    assert fraction(radii) / 0.84 < top / 0.1 < fraction(radii) / 0.7 + 0.08
    again, *_ = pack(clone, entries, "again")
    csv = "constant/grains.csv"
    assert (case.path / csv).read_bytes() == (again.path / csv).read_bytes()

    case.run("checkGrains")
    assert "Grains OK." in case.log
    case.run("grainFoam")
    start, end = centres, case.grains()["position"]
    # Nothing but the first step's fall and the wash of the fluid that it set in motion
    assert np.abs(end - start).max() < 0.1 * radii.min()


BAD = [
    ("tooFull", FILL.replace("150", "1500"), ["packGrainsDict", "number"]),
    ("radius", f"type lattice; {BOX} radius 0; material glass;", ["'radius'", "> 0"]),
    ("box", "type lattice; radius 1e-3; material glass;", ["packGrainsDict", "box"]),
    (
        "oneCorner",
        "type lattice; box (0 0.4 0); radius 1e-3; material glass;",
        ["'box'", "two corners"],
    ),
    (
        "noRoom",
        f"type hexagonal; {BOX} radius 1; material glass;",
        ["'radius'", "fits into 'box'"],
    ),
    ("type", f"type heap; {BOX}", ["'type'", "heap", "lattice", "randomFill", "settled"]),
    ("typo", f"{FILL} sede 1;", ["sede", "seed"]),
    ("spacing", f"type lattice; {BOX} radius 1e-3; spacing 1e-3; material glass;", ["'spacing'"]),
    (
        "outside",
        "type lattice; box (0.05 0 0) (0.15 0.1 0); radius 2e-3; material glass;",
        ["outside the mesh"],
    ),
    (
        "maxTime",
        f"type settled; from {{ {FILL} }} deltaT 1e-3; maxTime 0.01;",
        ["'maxTime'", "come to rest"],
    ),
]


@pytest.mark.parametrize("entries, fragments", [b[1:] for b in BAD], ids=[b[0] for b in BAD])
def test_impossible_packings_are_refused(clone, entries, fragments):
    case = grain_box(clone)
    (case.path / "constant/grains.csv").unlink()
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False, timeout=60) == 1
    for fragment in fragments:
        assert fragment in case.log, case.log[case.log.find("-->") :]
    assert "printStack" not in case.log
    assert not (case.path / "constant/grains.csv").exists()


def test_check_grains_reports_a_good_packing(clone):
    case = grain_box(clone, [(0.03, 0.03), (0.06, 0.05)], [0.004, 0.002])
    case.run("checkGrains")
    assert "Grains OK." in case.log
    assert "Number of grains        2" in case.log
    assert "smallest 0.004, mean 0.006, largest 0.008 m" in case.log
    assert case.logged("h/d from ") == pytest.approx(0.01 / 0.008)
    assert case.logged("Recommended deltaT      ") > 0


@pytest.mark.parametrize(
    "centres, said",
    [
        ([(0.03, 0.03), (0.037, 0.03)], "Overlaps                1, worst 0.001 m"),
        ([(0.002, 0.03)], "Overlaps                1, worst 0.002 m"),
        ([(0.03, 0.03), (0.2, 0.3)], "Outside the mesh        1 grains, the first at (0.2 0.3"),
    ],
    ids=["overlap", "wall", "outside"],
)
def test_check_grains_fails_for_a_bad_packing(clone, centres, said):
    case = grain_box(clone, centres)
    assert case.run("checkGrains", check=False) == 1
    assert said in case.log
    assert "Failed: see above." in case.log


def test_check_grains_takes_the_state_of_the_start_time(clone):
    case = grain_box(clone, [(0.03, 0.03)])
    case.run("grainFoam")
    replace(case, "constant/grainProperties", "grains.csv", "none.csv")
    case.run("checkGrains")
    assert "0.05/grains.h5" in case.log
    assert "Number of grains        1" in case.log
