# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""packGrains makes the packing that was asked for, checkGrains says what is wrong with one."""

import re
from pathlib import Path

import numpy as np
import pytest
from dry_box import dry_box
from grain_box import cyclic_box, grain_box, make_cyclic, replace

BOX = "box (0 0 0) (0.1 0.1 0);"
HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }\n"
FILL = f"type randomFill; {BOX} number 150; minRadius 1.6e-3; maxRadius 2.4e-3; material glass;"
UNIFORM = "distribution { type uniform; minRadius 1.6e-3; maxRadius 2.4e-3; }"
DENSE = f"type dense; {BOX} solidFraction 0.82; {UNIFORM} material glass;"
DICT = Path(__file__).parents[2] / "etc/caseDicts/packGrainsDict"
EXAMPLES = dict(re.findall(r"(?ms)^(\w+)\n\{\n(.*?)^\}", DICT.read_text()))


def pack(clone, entries, name=None):
    """Centres and radii that packGrains writes."""
    case = grain_box(clone, name=name)
    return case, *pack_case(case, entries)


def pack_case(case, entries, dimension=2):
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    case.run("packGrains")
    table = np.loadtxt(
        case.path / "constant/grains.csv", delimiter=",", skiprows=1, usecols=(0, 1, 2, 3), ndmin=2
    )
    assert f"Number of grains        {len(table)}\n" in case.log
    return table[:, :dimension], table[:, 3]


def worst_overlap(centres, radii, period=None):
    """Of each other and, unless the box is periodic, of the walls [m]."""
    i, j = np.triu_indices(len(radii), 1)
    apart = centres[i] - centres[j]
    if period:
        apart -= period * np.round(apart / period)
    gaps = np.linalg.norm(apart, axis=1) - radii[i] - radii[j]
    walls = np.minimum(centres, 0.1 - centres).min(axis=1) - radii
    return -gaps.min() if period else -min(gaps.min(), walls.min())


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


def test_dense(clone):
    case, centres, radii = pack(clone, DENSE)
    assert worst_overlap(centres, radii) <= 0
    assert radii.min() >= 1.6e-3
    assert radii.max() <= 2.4e-3
    assert fraction(radii) == pytest.approx(0.82, abs=fraction(radii.max()))
    case.run("checkGrains")
    assert "Grains OK." in case.log
    _, again, _ = pack(clone, DENSE + " seed 1;", "again")
    assert np.array_equal(again, centres)


def test_several_sources_fill_their_boxes(clone):
    coarse = "type lattice; box (0 0 0) (0.05 0.1 0); radius 2e-3; material glass;"
    fine = "type lattice; box (0.05 0 0) (0.1 0.1 0); radius 1e-3; material steel;"
    several = f"type several; sources {{ coarse {{ {coarse} }} fine {{ {fine} }} }}"
    case, centres, radii = pack(clone, several)
    first = radii == 2e-3
    assert np.array_equal(first, np.arange(12 * 25 + 25 * 50) < 12 * 25)
    assert np.array_equal(first, centres[:, 0] < 0.05)
    csv = case.path / "constant/grains.csv"
    table = np.genfromtxt(csv, delimiter=",", names=True, dtype=None, encoding="ascii")
    assert np.array_equal(table["material"], np.where(first, "glass", "steel"))


def test_dense_follows_a_sieve_curve(clone):
    curve = "distribution { type sieve; by mass; passing ((1e-3 0) (2e-3 0.3) (3e-3 1)); }"
    _, centres, radii = pack(clone, DENSE.replace(UNIFORM, curve).replace("0.82", "0.8"))
    assert worst_overlap(centres, radii) <= 0
    # To within a grain of the largest size
    assert fraction(radii[radii < 2e-3]) == pytest.approx(0.3 * 0.8, abs=fraction(np.array(3e-3)))


def test_dense_spheres(clone):
    case = dry_box(clone)
    entries = DENSE.replace("0.1 0)", "0.1 0.1)").replace("0.82", "0.57")
    centres, radii = pack_case(case, entries.replace("1.6e-3", "4e-3").replace("2.4e-3", "6e-3"), 3)
    assert worst_overlap(centres, radii) <= 0
    volume = 4 / 3 * np.pi * radii**3
    assert np.sum(volume) / 0.1**3 == pytest.approx(0.57, abs=volume.max() / 0.1**3)


ROD = "type cluster; centres ((0 0 0) (2 0 0)); radii (1 1);"


def add_rods(case):
    path = case.path / "constant/grainProperties"
    path.write_text(f"{path.read_text()}\nshapes {{ rod {{ {ROD} }} }}\n")


@pytest.mark.parametrize("dimension, wanted", [(2, 0.38), (3, 0.13)])
def test_dense_clusters_fill_the_solid_fraction_themselves(clone, dimension, wanted):
    """Two that touch fill a half of the circle around them, a quarter of the sphere."""
    case = dry_box(clone, dimension=dimension)
    add_rods(case)
    entries = DENSE.replace("0.82", str(wanted)) + " shape rod;"
    if dimension == 3:
        entries = entries.replace("0.1 0)", "0.1 0.1)").replace("1.6e-3", "6e-3")
        entries = entries.replace("2.4e-3", "7e-3")
    _, radii = pack_case(case, entries, dimension)
    volume = np.pi * radii**2 / 2 if dimension == 2 else np.pi / 3 * radii**3
    box = 0.1**dimension
    assert volume.sum() / box == pytest.approx(wanted, abs=volume.max() / box)


def test_dense_clusters_have_their_own_limit(clone):
    case = grain_box(clone)
    add_rods(case)
    entries = DENSE.replace("0.82", "0.6") + " shape rod;"
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False) == 1
    for fragment in ("packGrainsDict", "'solidFraction'", "0.6", "at most about 0.42", "0.5 of"):
        assert fragment in case.log


def test_dense_fills_across_cyclic_patches(clone):
    case = cyclic_box(clone, [(0.05, 0.05)], 0.004)
    centres, radii = pack_case(case, DENSE.replace("0.82", "0.84"))
    assert worst_overlap(centres, radii, period=0.1) <= 0
    assert worst_overlap(centres, radii) > 1e-3
    assert fraction(radii) == pytest.approx(0.84, abs=fraction(radii.max()))


@pytest.mark.parametrize("name", [name for name in EXAMPLES if name != "FoamFile"])
def test_examples_are_packed(clone, name):
    if name in ("inACylinder", "inAHopper", "inAZone"):
        case = dry_box(clone)
        cube_stl(case, 20, 80, "hopper.stl")
        zone(case, "(0 0 0) (0.1 0.1 0.05)", "bed")
    else:
        case = grain_box(clone, [(0.05, 0.05)])
        (case.path / "grains.csv").write_bytes((case.path / "constant/grains.csv").read_bytes())
    (case.path / "system/packGrainsDict").write_text(HEADER + EXAMPLES[name])
    case.run("packGrains")
    assert case.logged("Number of grains        ") > 0


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


def test_grains_that_settle_through_periodic_sides_are_written_in_the_mesh(clone):
    case = grain_box(clone)
    make_cyclic(case, ("left", "right"))
    replace(case, "constant/grainProperties", "(left right bottom top)", "(bottom top)")
    case.run("blockMesh")
    centres, _ = pack_case(case, f"type settled; from {{ {FILL} }} deltaT 1e-3;")
    assert np.all((centres[:, 0] >= 0) & (centres[:, 0] < 0.1))


BAD = [
    (
        "tooDense",
        DENSE.replace("0.82", "0.95"),
        ["'solidFraction'", "reach in the box; no packing of"],
    ),
    ("noDistribution", DENSE.replace(UNIFORM, ""), ["packGrainsDict", "distribution"]),
    (
        "distribution",
        DENSE.replace("uniform", "bell"),
        ["'type'", "bell", "(constant lognormal normal sieve uniform)"],
    ),
    ("order", DENSE.replace("2.4e-3", "1.4e-3"), ["'maxRadius'", "0.0014"]),
    (
        "cut",
        DENSE.replace("uniform;", "normal; mean 5e-3; standardDeviation 0.1e-3;"),
        ["'maxRadius'", "hold part of the distribution"],
    ),
    (
        "logCut",
        DENSE.replace("uniform;", "lognormal; median 5e-3; logDeviation 0.01;"),
        ["'maxRadius'", "hold part of the distribution"],
    ),
    (
        "falling",
        DENSE.replace(UNIFORM, "distribution { type sieve; by mass; passing ((1 1) (2 0)); }"),
        ["'passing'", "rise from 0 to 1"],
    ),
    (
        "by",
        DENSE.replace(UNIFORM, "distribution { type sieve; by size; passing ((1 0) (2 1)); }"),
        ["'by'", "size", "mass number"],
    ),
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
    ("noSource", "type several; sources {}", ["'sources'", "at least one sub-dictionary"]),
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
    (
        "output",
        f'{FILL} output "constant/g/grains.csv";',
        ["'output'", "constant/g/grains.csv", "can be written"],
    ),
    ("fullDisk", f'{FILL} output "/dev/full";', ["/dev/full"]),
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


def test_grains_that_fall_for_ever_do_not_settle(clone):
    """Those of a lattice across the floor that are behind it."""
    case = grain_box(clone)
    floor = "point (0 0.05 0); normal (0 1 0);"
    replace(case, "constant/grainProperties", "type        patches;", f"type plane; {floor}")
    replace(case, "constant/grainProperties", "patches     (left right bottom top);", "")
    lattice = f"type lattice; {BOX} radius 2e-3; spacing 6e-3; material glass;"
    entries = f"type settled; from {{ {lattice} }} deltaT 1e-3;"
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False, timeout=60) == 1
    for fragment in ("'from'", "fallen out of the mesh", "packGrainsDict"):
        assert fragment in case.log, case.log[-800:]


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


REGIONS = {
    "cylinder": "region { type cylinder; start (0.05 0.05 0.01); end (0.05 0.05 0.09);"
    " radius 0.03; }",
    "surface": 'region { type surface; file "cube.stl"; scale 0.01; }',
    "cellZone": "region { type cellZone; zone middle; }",
}


def cube_stl(case, low, high, file="cube.stl"):
    """A cube of twelve triangles, outwards."""
    corner = [[(low, high)[i >> d & 1] for d in range(3)] for i in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    text = ""
    for a, b, c, d in quads:
        for triangle in ((a, b, c), (a, c, d)):
            vertices = " ".join("vertex {} {} {}".format(*corner[i]) for i in triangle)
            text += f"facet normal 0 0 0 outer loop {vertices} endloop endfacet\n"
    (case.path / "constant/triSurface").mkdir()
    (case.path / "constant/triSurface" / file).write_text(f"solid c\n{text}endsolid c\n")


def zone(case, box, name="middle"):
    cells = f"name {name}; type cellSet; action new; source boxToCell; box {box};"
    zone = f"name {name}; type cellZoneSet; action new; source setToCellZone; set {name};"
    dictionary = f"{HEADER}actions ( {{ {cells} }} {{ {zone} }} );"
    (case.path / "system/topoSetDict").write_text(dictionary)
    case.run("topoSet")


@pytest.mark.parametrize("region", REGIONS)
@pytest.mark.parametrize("source", ["lattice", "hexagonal", "randomFill"])
def test_spheres_lie_wholly_in_a_region(clone, region, source):
    case = dry_box(clone)
    cube_stl(case, 2, 8)
    zone(case, "(0.021 0.021 0.021) (0.079 0.079 0.079)")
    box = "box (0 0 0) (0.1 0.1 0.1);"
    fill = "number 60; minRadius 4e-3; maxRadius 5e-3;"
    size = fill if source == "randomFill" else "radius 4e-3;"
    entries = f"type {source}; {box} {size} material glass; {REGIONS[region]}"
    centres, radii = pack_case(case, entries, 3)
    assert len(radii) == 60 if source == "randomFill" else len(radii) > 100
    if region == "cylinder":
        assert (np.linalg.norm(centres[:, :2] - 0.05, axis=1) + radii).max() <= 0.03
        assert (np.abs(centres[:, 2] - 0.05) + radii).max() <= 0.04
    else:
        # Cells of 20 mm: the zone is that of the cube
        assert (np.abs(centres - 0.05).max(axis=1) + radii).max() <= 0.03 + 1e-12


def test_discs_lie_wholly_in_a_region(clone):
    """A surface is cut in the middle of the mesh."""
    for region in ("surface", "cellZone"):
        case = grain_box(clone, name=region)
        cube_stl(case, -2, 5)
        zone(case, "(-1 -1 -1) (0.05 0.05 1)")
        centres, radii = pack_case(
            case, f"type hexagonal; {BOX} radius 2e-3; material glass; {REGIONS[region]}"
        )
        assert (centres + radii[:, None]).max() <= 0.05 + 1e-12
        # Rows of 12 and 11 or 12, sqrt(3) radii apart
        assert len(radii) == 7 * 12 + 7 * 12


def test_two_powders_are_mixed_in_one_region(clone):
    coarse = f"type randomFill; {BOX} number 60; minRadius 4e-3; material glass;"
    fine = f"type randomFill; {BOX} number 600; minRadius 1e-3; material steel; seed 2;"
    several = f"type several; sources {{ coarse {{ {coarse} }} fine {{ {fine} }} }}"
    _, centres, radii = pack(clone, several)
    assert worst_overlap(centres, radii) <= 0
    assert (radii == 4e-3).sum() == 60
    assert (radii == 1e-3).sum() == 600
    # Fine grains lie between the coarse ones everywhere
    fine = centres[radii == 1e-3]
    assert np.histogram2d(*fine.T, bins=4, range=[(0, 0.1)] * 2)[0].min() >= 10

    lattice = f"type lattice; {BOX} radius 1e-3; material steel;"
    several = f"type several; sources {{ coarse {{ {coarse} }} fine {{ {lattice} }} }}"
    _, centres, radii = pack(clone, several, "lattice")
    assert worst_overlap(centres, radii) <= 1e-15
    assert 600 < (radii == 1e-3).sum() < 50**2


def test_material_may_stand_in_the_file_alone(clone):
    case = grain_box(clone)
    (case.path / "constant/grains.csv").write_text(
        "x,y,z,radius,material\n0.02,0.02,0,0.004,steel\n0.05,0.02,0,0.004,glass\n"
    )
    replace(case, "constant/grainProperties", "    material    glass;\n}", "}")
    case.run("checkGrains")
    mass = np.pi * 0.004**2 * 0.01 * (7800 + 2500)
    assert case.logged("Mass                    ") == pytest.approx(mass, rel=1e-5)

    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n0.02,0.02,0,0.004\n")
    assert case.run("checkGrains", check=False) == 1
    for fragment in ("initialGrains", "'material' is missing", "(glass steel)", "column"):
        assert fragment in case.log


@pytest.mark.parametrize(
    "entries, what",
    [
        (f"type lattice; {BOX.replace('0.1', '0.3')} radius 2e-3; material glass;", "outside"),
        (f"type lattice; {BOX.replace('(0 0', '(-1e-3 0')} radius 2e-3; material glass;", "wall"),
    ],
)
def test_packing_that_does_not_fit_is_refused_by_its_own_file(clone, entries, what):
    case = grain_box(clone)
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False) == 1
    error = case.log[case.log.index("-->") :]
    assert "system/packGrainsDict" in error
    assert "Keyword 'type'" in error
    assert what in error
    assert "initialGrains" not in error


@pytest.mark.parametrize(
    "entries, keyword",
    [
        (f"type lattice; {BOX} radius 1e-6; material glass;", "radius"),
        (f"type hexagonal; {BOX} radius 1e-6; material glass;", "radius"),
        (FILL.replace("150", "1000000000"), "number"),
        (DENSE.replace("e-3", "e-6"), "distribution"),
    ],
)
def test_numbers_beyond_all_memory_are_refused(clone, entries, keyword):
    case = grain_box(clone)
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False, timeout=60) == 1
    assert re.search(r"Source packGrainsDict: about [0-9.e+]+ grains", case.log)
    for fragment in (f"Keyword '{keyword}'", "at most 1e8 grains"):
        assert fragment in case.log


def test_settling_tells_how_far_it_is(clone):
    fill = FILL.replace("150", "500").replace("1.6e-3", "1e-3").replace("2.4e-3", "1.5e-3")
    entries = f"type settled; from {{ {fill} }} deltaT 2e-5; maxTime 10;"
    case = grain_box(clone)
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    case.run("packGrains")
    assert "about 500 grains" in case.log
    assert case.log.count("Settling 500 grains, at most 10 s") == 2
    assert re.search(r"[0-9.e-]+ s: the fastest moves at [0-9.e-]+ m/s", case.log)


@pytest.mark.parametrize("output", ["/proc/none/grains.csv", "constant"])
def test_output_that_cannot_be_written_is_refused(clone, output):
    case = grain_box(clone)
    entries = f'type lattice; {BOX} radius 2e-3; material glass; output "{output}";'
    (case.path / "system/packGrainsDict").write_text(HEADER + entries)
    assert case.run("packGrains", check=False, timeout=30) == 1
    for fragment in ("system/packGrainsDict", "'output'", output, "can be written"):
        assert fragment in case.log
