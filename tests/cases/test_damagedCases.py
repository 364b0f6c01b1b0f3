# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a case that are damaged, misspelt or left over are answered by name before a step."""

import shutil

import pytest
from conftest import ROOT, Case
from dry_box import dry_box
from grain_box import control, grain_box
from heat_box import with_heat
from water_box import level, water_box

GRAINS = "constant/grainProperties"
CONTROL = "system/controlDict"
SOLUTION = "system/fvSolution"
MESH = "constant/polyMesh"
CSV = "constant/grains.csv"
CENTRES = [(0.03, 0.03), (0.06, 0.05)]
HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
WALLS = '"left|right|bottom|top"'


def built(folder):
    """Cases of each solver, made once."""

    def clone(template, name):
        shutil.copytree(ROOT / "tests/cases" / template, folder / name)
        shutil.copytree(folder / name / "0.orig", folder / name / "0")
        return Case(folder / name)

    grain_box(clone, CENTRES, name="grainFoam")
    with_heat(grain_box(clone, CENTRES, name="grainThermalFoam"))
    water_box(clone, level(0.05), CENTRES, name="grainInterFoam")
    dry_box(clone, CENTRES, dimension=2, name="dryGrainFoam")
    dry_box(clone, [(0.05, 0.05, 0.02)], name="spheres")
    case = grain_box(clone, CENTRES, name="continued")
    control(case, endTime=0.001, writeInterval=1)
    case.run("grainFoam")
    control(case, endTime=0.002)
    grain_box(clone, CENTRES, name="divided").run("decomposePar")
    return folder


@pytest.fixture(scope="module")
def cases(tmp_path_factory):
    return built(tmp_path_factory.mktemp("cases"))


def swap(file, old, new):
    def spoil(case):
        text = (case.path / file).read_text()
        assert old in text, old
        (case.path / file).write_text(text.replace(old, new, 1))

    return spoil


def write(file, text):
    def spoil(case):
        (case.path / file).parent.mkdir(exist_ok=True)
        (case.path / file).write_text(text)

    return spoil


def both(*spoils):
    return lambda case: [spoil(case) for spoil in spoils]


def remove(file):
    return lambda case: (case.path / file).unlink()


def cut(file, share=0.5):
    def spoil(case):
        data = (case.path / file).read_bytes()
        (case.path / file).write_bytes(data[: int(share * len(data))])

    return spoil


def patch(old, new):
    """A line of the patch 'left' of the mesh."""

    def spoil(case):
        path = case.path / MESH / "boundary"
        before, after = path.read_text().split("    left\n", 1)
        assert old in after
        path.write_text(f"{before}    left\n{after.replace(old, new, 1)}")

    return spoil


def mirror(kind):
    def spoil(case):
        patch("type            wall", f"type            {kind}")(case)
        for file in ("0/U", "0/p_rgh"):
            swap(file, WALLS, f'left {{ type {kind}; }} "right|bottom|top"')(case)
        swap(GRAINS, "(left right bottom top)", "(right bottom top)")(case)

    return spoil


def cyclic(case):
    swap(f"{MESH}/boundary", "type            wall", "type cyclic; neighbourPatch right")(case)
    swap(f"{MESH}/boundary", "type            wall", "type cyclic; neighbourPatch left")(case)


def watch(entries):
    library = 'libs ("libgrainFunctionObjects.so"); writeControl timeStep; writeInterval 1;'
    return swap(CONTROL, "functions\n{", f"functions\n{{ watch {{ {library} {entries} }}\n")


def obj(text):
    wall = "walls\n{\n    other { material steel; type surface; file a.obj; }"
    return both(write("constant/triSurface/a.obj", text), swap(GRAINS, "walls\n{", wall))


def oscillation(entries):
    motion = f"motion {{ type oscillation; {entries} }}"
    plane = f"type plane; material steel; point (0 0 0); normal (0 1 0); {motion}"
    return swap(GRAINS, "walls\n{", f"walls\n{{ p {{ {plane} }}")


NO_BOUNDARY = (
    "FoamFile { version 2.0; format ascii; class polyBoundaryMesh; object boundary; }\n0()\n"
)

# name: (case, how it is spoilt, what the message holds)
TABLE = {
    # Meshes
    "no owner": ("grainFoam", remove(f"{MESH}/owner"), ["polyMesh/owner", "missing"]),
    "cut points": ("grainFoam", cut(f"{MESH}/points"), ["polyMesh/points"]),
    "no patches": (
        "grainFoam",
        write(f"{MESH}/boundary", NO_BOUNDARY),
        ["polyMesh/boundary", "face 180 of 420"],
    ),
    "start of a patch": (
        "grainFoam",
        patch("startFace       180", "startFace       7"),
        ["left", "startFace 7", "from face 180"],
    ),
    "size of a patch": (
        "dryGrainFoam",
        patch("nFaces          10", "nFaces          11"),
        ["right", "startFace 190", "from face 191"],
    ),
    "type of a patch": (
        "grainFoam",
        patch("type            wall", "type            wal"),
        ["polyMesh/boundary", "left", "does not know", "wall"],
    ),
    "plane of symmetry": ("grainFoam", mirror("symmetryPlane"), [GRAINS, "left", "'walls'"]),
    "symmetry": ("grainFoam", mirror("symmetry"), ["left", "'symmetry'", "motion fixed"]),
    "cyclic walls": ("dryGrainFoam", cyclic, [GRAINS, "'patches'", "left", "'cyclic'"]),
    "cells of a mesh that has changed": (
        "continued",
        both(
            swap("system/blockMeshDict", "(10 10 1)", "(5 5 1)"), lambda case: case.run("blockMesh")
        ),
        ["0.001/p_rgh", "100", "25"],
    ),
    # Files that OpenFOAM passes over
    "fvOptions": ("grainFoam", write("constant/fvOptions", "x"), ["constant/fvOptions", "header"]),
    "fvOptions of system": ("grainFoam", write("system/fvOptions", "x"), ["system/fvOptions"]),
    "turbulenceProperties": (
        "grainThermalFoam",
        write("constant/turbulenceProperties", "x"),
        ["constant/turbulenceProperties", "header"],
    ),
    "dynamicMeshDict": (
        "grainInterFoam",
        write("constant/dynamicMeshDict", ""),
        ["constant/dynamicMeshDict"],
    ),
    "dynamicMeshDict without a fluid": (
        "dryGrainFoam",
        write("constant/dynamicMeshDict", HEADER),
        ["constant/dynamicMeshDict", "not in this solver"],
    ),
    # Solvers of equations that do nothing
    "relTol": (
        "grainFoam",
        swap(SOLUTION, "relTol          0;", "relTol 1;"),
        [SOLUTION, "'relTol'", "value 1", "less than 1"],
    ),
    "maxIter": (
        "grainInterFoam",
        swap(SOLUTION, "relTol          0;", "relTol 0; maxIter 0;"),
        [SOLUTION, "'maxIter'", "value 0", ">= 1"],
    ),
    "capillary limit": (
        "grainInterFoam",
        swap(CONTROL, "deltaT ", "maxCapillaryCo 0;\ndeltaT "),
        [CONTROL, "'maxCapillaryCo'", "value 0", "> 0"],
    ),
    # Fields
    "boundary of the fraction": (
        "grainInterFoam",
        swap("0/alpha.water", "zeroGradient", "fixedValue; value uniform 2"),
        ["0/alpha.water", "left", "from 2 to 2", "0 to 1"],
    ),
    "hot": (
        "grainThermalFoam",
        swap("0/T", "uniform 300.0", "uniform 1e120"),
        ["0/T", "internalField", "1e+120", "at most 1e+15"],
    ),
    "number of values": (
        "grainFoam",
        swap("0/U", "uniform (0 0 0)", "nonuniform List<vector> 2((0 0 0)(0 0 0))"),
        ["0/U", "size 2", "100"],
    ),
    "condition": ("grainFoam", swap("0/U", "noSlip", "nonSlip"), ["0/U", "nonSlip"]),
    # Text
    "brace": (
        "grainFoam",
        swap(GRAINS, "maxSweeps   200;\n}", "maxSweeps 200;\n"),
        [GRAINS, "EOF"],
    ),
    "comment": ("grainFoam", swap(GRAINS, "contact\n{", "/* contact\n{"), [GRAINS, "'contact'"]),
    "name": (
        "grainFoam",
        swap(GRAINS, "density 2500", "density $rhoOfGlass"),
        [GRAINS, "rhoOfGlass"],
    ),
    "expression": (
        "grainFoam",
        swap(GRAINS, "(left right bottom top)", '("side.*")'),
        [GRAINS, "'patches'", "side.*", "left right bottom top"],
    ),
    "semicolons": (
        "grainFoam",
        write(CSV, "x;y;z;radius\n0.03;0.03;0;0.004\n"),
        [CSV, "'x;y;z;radius'", "x y z radius"],
    ),
    "decimal commas": (
        "grainFoam",
        write(CSV, "x,y,z,radius\n0,03,0,03,0,0,004\n"),
        [CSV, "line 2"],
    ),
    "radius that is almost 0": (
        "dryGrainFoam",
        write(CSV, "x,y,z,radius\n0.03,0.03,0,1e-310\n"),
        [CSV, "line 2", "'radius'", "1e-310", "> 0"],
    ),
    "points of a surface": (
        "spheres",
        obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
        [GRAINS, "a.obj", "line 4", "corner 9 of 3"],
    ),
    "swing": (
        "dryGrainFoam",
        oscillation("direction (0 1 0); amplitude 1e-3; frequency -1;"),
        [GRAINS, "'frequency'", "value -1", "> 0"],
    ),
    # Restarts, and what earlier runs have left
    "lock": (
        "grainFoam",
        write("grains.lock", "garbage"),
        ["grains.lock", "'garbage'", "remove it"],
    ),
    "cut state": ("continued", cut("0.001/grains.h5"), ["0.001/grains.h5", "cannot be opened"]),
    "cut field": ("continued", cut("0.001/U"), ["0.001/U"]),
    "material": (
        "continued",
        both(
            swap(GRAINS, "glass   {", "sand   {"),
            swap(GRAINS, "(glass glass)", "(sand sand)"),
            swap(GRAINS, "(glass steel)", "(sand steel)"),
            swap(GRAINS, "material    glass", "material sand"),
        ),
        ["0.001/grains.h5", "material glass", "sand steel"],
    ),
    # Function objects
    "wall": (
        "grainFoam",
        watch("type wallForces; walls (lid);"),
        [CONTROL, "'walls'", "lid", "box"],
    ),
    "keyword": ("grainFoam", watch("type grainFields; mean yes;"), [CONTROL, "'mean'"]),
    "stations": (
        "grainInterFoam",
        watch("type liquidGauges; stations (0.05 0.05 0.005);"),
        [CONTROL, "'stations'", "a list of points"],
    ),
    # Ranks
    "ranks": ("divided", remove("processor1/0/U"), ["processor1/0/U"]),
}


@pytest.mark.parametrize("name", TABLE)
def test_damage_is_named(cases, tmp_path, name):
    template, spoil, fragments = TABLE[name]
    shutil.copytree(cases / template, tmp_path / "case")
    case = Case(tmp_path / "case")
    spoil(case)
    solvers = {"spheres": "dryGrainFoam", "continued": "grainFoam", "divided": "grainFoam"}
    solver = solvers.get(template, template)
    if template == "divided":
        case.parallel(solver, 2, check=False, timeout=60)
    else:
        assert case.run(solver, check=False, timeout=60) == 1
    for fragment in fragments:
        assert fragment in case.log, f"no '{fragment}' in\n{case.log[case.log.find('-->') :]}"
    assert "FATAL" in case.log
    assert "\nTime = " not in case.log
    assert "printStack" not in case.log


def test_fixed_grains_may_meet_a_plane_of_symmetry(cases, tmp_path):
    """One that is cut by it is half a grain."""
    shutil.copytree(cases / "grainFoam", tmp_path / "case")
    case = Case(tmp_path / "case")
    mirror("symmetryPlane")(case)
    swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")(case)
    write(CSV, "x,y,z,radius\n0.001,0.05,0.005,0.004\n")(case)
    control(case, endTime=0.002)
    case.run("grainFoam")
    assert case.logged("of it in the mesh ")[0] < 0.9 * case.logged("volume ")[0]


def test_a_plane_of_symmetry_of_the_fluid_may_be_a_wall_of_grains(cases, tmp_path):
    """A grain that flies at it comes back."""
    shutil.copytree(cases / "grainFoam", tmp_path / "case")
    case = Case(tmp_path / "case")
    mirror("symmetry")(case)
    swap(GRAINS, "(right bottom top)", "(left right bottom top)")(case)
    swap("constant/g", "(0 -9.81 0)", "(-9.81 0 0)")(case)
    write(CSV, "x,y,z,radius\n0.0045,0.05,0.005,0.004\n")(case)
    control(case, endTime=0.1)
    case.run("grainFoam")
    assert case.grains()["position"][0, 0] == pytest.approx(0.004, abs=1e-6)


def test_expression_for_walls_leaves_cyclic_patches_out(cases, tmp_path):
    """A grain that falls through a period of a box whose walls are all that can be."""
    shutil.copytree(cases / "dryGrainFoam", tmp_path / "case")
    case = Case(tmp_path / "case")
    cyclic(case)
    swap(GRAINS, "(left right bottom top)", '("[lrbt].*")')(case)
    swap("constant/g", "(0 -9.81 0)", "(9.81 0 0)")(case)
    control(case, endTime=0.2)
    case.run("dryGrainFoam")
    assert case.grains()["velocity"][:, 0] == pytest.approx(0.2 * 9.81, rel=1e-6)
