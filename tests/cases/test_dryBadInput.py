# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries of dryGrainFoam that make no sense stop it before the first time step, by name."""

import math
import shutil
import struct

import pytest
from dry_box import GRAINS, dry_box
from grain_box import cyclic_box, replace


def contact(text):
    return lambda case: replace(case, GRAINS, "maxSweeps   200;", f"maxSweeps 200; {text}")


def law(text):
    return lambda case: replace(case, GRAINS, "friction    0.2;", f"friction 0.2; {text}")


def wall(text):
    return lambda case: replace(
        case, GRAINS, "walls\n{\n", f"walls\n{{\n    other {{ material steel; {text} }}\n"
    )


def motion(text):
    return wall(f"type plane; point (0 0 0); normal (0 1 0); motion {{ {text} }}")


def section(name, text):
    def spoil(case):
        path = case.path / GRAINS
        path.write_text(f"{path.read_text()}\n{name}\n{{\n    one {{ {text} }}\n}}\n")

    return spoil


def shape(text):
    return lambda case: replace(case, GRAINS, "shape   disc", f"shape   {text}")


def heat(text, thermal="conductivity 1; heatCapacity 1; youngsModulus 1e9;"):
    def spoil(case):
        path = case.path / GRAINS
        path.write_text(
            path.read_text()
            .replace("density 2500;", f"density 2500; {thermal}")
            .replace("density 7800;", f"density 7800; {thermal}")
            + f"\nheat {{ {text} }}\n"
        )

    return spoil


BOX = "type box; box (0 0 0) (0.1 0.1 0.01);"
SIEVE = "distribution { type sieve; by mass; passing 3; }"


def injection(text):
    usual = "material glass; numberRate 1; distribution { type constant; radius 1e-3; }"
    return section("injections", f"{usual} {text}")


def inlet(text):
    """The same with walls at the sides and the top only."""

    def spoil(case):
        replace(case, GRAINS, "(left right bottom top)", "(right top)")
        injection(text)(case)

    return spoil


def heat_and_injection(case):
    heat("")(case)
    csv = "    material    glass;\n"
    replace(case, GRAINS, f"{csv}}}", f"{csv}    temperature 300;\n}}")
    injection(BOX)(case)


def stl(content):
    """A wall of a file."""

    def spoil(case):
        folder = case.path / "constant/triSurface"
        folder.mkdir()
        (folder / "a.stl").write_bytes(content)
        wall("type surface; file a.stl;")(case)

    return spoil


FACET = b"facet normal 0 1 0 outer loop vertex 0 0 0 vertex 0.1 0 0 vertex 0 0 0.1 endloop endfacet"
NAN_STL = b" " * 80 + struct.pack("<I12fH", 1, 0, 1, 0, 0, 0, -1, 0.1, math.nan, -1, 0, 0, 1, 0)

MOTIONS = ["free", "oscillation", "rotation", "table", "translation"]

# name, how the good case is spoilt, what the message holds besides the file
TABLE = [
    ("shapeOfMesh", shape("sphere"), ["'shape'", "sphere", "disc", "two-dimensional"]),
    ("solver", contact("solver magic;"), ["'solver'", "magic", "sweeps queue nesterov"]),
    ("restitution", law("restitution 2;"), ["'restitution'", "value 2", "from 0 to 1"]),
    ("rolling", law("rolling -1;"), ["'rolling'", "-1", ">= 0"]),
    ("cohesionOfCoulomb", law("cohesion 1;"), ["'cohesion'", "friction"]),
    ("wallType", wall("type cube;"), ["'type'", "cube", "patches surface plane"]),
    ("planeNormal", wall("type plane; point (0 0 0); normal (0 0 1);"), ["'normal'", "(0 0 1)"]),
    ("planeKey", wall("type plane; point (0 0 0); normal (0 1 0); x 1;"), ["other", "'x'"]),
    ("surface", wall('type surface; file "no.stl";'), ["'file'", "no.stl", "exists"]),
    ("nanInSurface", stl(NAN_STL), ["'file'", "a.stl", "finite", "triangle 0", "nan"]),
    ("cutBinarySurface", stl(NAN_STL[:-7]), ["'file'", "a.stl", "127 bytes", "134", "1 triangles"]),
    ("cutTextSurface", stl(b"solid a\n" + FACET + b"\n"), ["'file'", "a.stl", "endsolid"]),
    ("emptySurface", stl(b""), ["'file'", "a.stl", "0 bytes"]),
    ("motionType", motion("type jump;"), ["'type'", "jump", *MOTIONS]),
    ("motionKey", motion("type translation; velocity (0 1 0); x 1;"), ["motion", "'x'"]),
    ("tableOfNothing", motion("type table;"), ["motion", "'displacement'", "none", "angle"]),
    (
        "tableOutOfOrder",
        motion("type table; displacement table ((0 (0 0 0)) (2 (0 0 0)) (1 (0 1 0)));"),
        ["other.motion", "'displacement'", "out-of-order value: 1", "increase"],
    ),
    (
        "twoLawsOfAPair",
        section("contactLaws", "materials (steel glass); type Coulomb; friction 1;"),
        ["one", "'materials'", "(steel glass)", "no other law"],
    ),
    ("friction", law("friction 1e30;"), ["'friction'", "1e+30", "from 0 to 1e+15"]),
    ("outletType", section("outlets", "type hole;"), ["'type'", "hole", "beyond", "patches"]),
    ("outletPatch", section("outlets", "type patches; patches (lid);"), ["'patches'", "lid"]),
    (
        "outletWall",
        section("outlets", "type patches; patches (bottom);"),
        ["'patches'", "bottom", "'walls'"],
    ),
    ("outletBox", section("outlets", "type box; box (0 0 0) (0 1 0);"), ["'box'", "two corners"]),
    ("outletKey", section("outlets", "type patches; patches (top); x 1;"), ["outlets", "'x'"]),
    ("injectionType", injection("type hole;"), ["'type'", "hole", "box patches"]),
    ("injectionKey", injection(f"{BOX} x 1;"), ["injections", "'x'", "numberRate"]),
    ("injectionMaterial", injection(f"{BOX} material wood;"), ["'material'", "wood", "glass"]),
    ("injectionRate", injection(f"{BOX} numberRate -1;"), ["'numberRate'", "-1", "rates >= 0"]),
    (
        "injectionRates",
        injection(f"{BOX} massRate 1;"),
        ["'numberRate'", "beside massRate", "one of massRate, volumeRate and numberRate"],
    ),
    (
        "injectionFunction",
        injection(f"{BOX} numberRate table ((0 1) (2 1) (1 3));"),
        ["'numberRate'", "functions of time"],
    ),
    ("injectionEnd", injection(f"{BOX} start 2; end 1;"), ["'end'", "1", "2"]),
    ("injectionTotal", injection(f"{BOX} total -1;"), ["'total'", "-1", "a value >= 0"]),
    (
        "injectionVelocity",
        injection(f"{BOX} velocity (0 0 1);"),
        ["'velocity'", "(0 0 1)", "plane"],
    ),
    (
        "injectionVelocityShort",
        injection(f"{BOX} velocity (0 0.1);"),
        ["'velocity'", "( 0 0.1 )", "a vector in the plane of the mesh"],
    ),
    (
        "injectionBox",
        injection("type box; box (0 0 0) (0.1 1e-3 0.01);"),
        ["'box'", "0.001 m", "largest grain, of radius 0.001 m"],
    ),
    (
        "injectionOutside",
        injection("type box; box (0.2 0.2 0) (0.3 0.3 0.01);"),
        ["'box'", "outside the mesh", "in the mesh"],
    ),
    (
        "injectionWall",
        injection("type patches; patches (bottom); velocity (0 1 0);"),
        ["'patches'", "bottom", "'walls'"],
    ),
    (
        "injectionDirection",
        inlet("type patches; patches (bottom); velocity (0 -1 0);"),
        ["'velocity'", "(0 -1 0)", "along (0 1 0)"],
    ),
    (
        "injectionWithoutVelocity",
        inlet("type patches; patches (bottom);"),
        ["'velocity'", "none", "into the mesh"],
    ),
    (
        "injectionPlane",
        inlet("type patches; patches (bottom left); velocity (0 1 0);"),
        ["'patches'", "several directions", "one plane"],
    ),
    (
        "injectionWidth",
        inlet("type patches; patches (bottom); velocity (0 1 0); distribution { radius 0.06; }"),
        ["'patches'", "0.0", "wide enough", "radius 0.06 m"],
    ),
    ("injectionOfColdGrains", heat_and_injection, ["'temperature'", "none", "'heat'"]),
    ("heatOfColdGrains", heat(""), ["'temperature'", "grain 0", "value 0", "a value > 0"]),
    ("conductance", heat("conductance spheres;"), ["'conductance'", "spheres", "spot squarePatch"]),
    ("heatKey", heat("x 1;"), ["heat", "'x'", "conductance"]),
    ("conductivity", heat("", "conductivity 0;"), ["glass", "'conductivity'", "value 0", "> 0"]),
    ("modulus", heat("", "conductivity 1;"), ["glass", "youngsModulus"]),
    (
        "heatCapacity",
        heat("", "conductivity 1; youngsModulus 1;"),
        ["glass", "'heatCapacity'", "none", "a value > 0"],
    ),
    (
        "poissonRatio",
        heat("", "conductivity 1; youngsModulus 1; poissonRatio 1;"),
        ["'poissonRatio'", "value 1", "from 0 to 0.5"],
    ),
    (
        "wallTemperature",
        wall("type plane; point (0 0 0); normal (0 1 0); temperature 0;"),
        ["other", "'temperature'", "value 0", "a value > 0"],
    ),
    (
        "wallWithoutHeat",
        wall("type plane; point (0 0 0); normal (0 1 0); temperature 300;"),
        ["other", "'temperature'", "300", "a dictionary 'heat'"],
    ),
    ("shapeType", section("shapes", "type cube;"), ["'type'", "cube", "cluster"]),
    (
        "shapeRadii",
        section("shapes", "type cluster; centres ((0 0 0)); radii (1 2);"),
        ["'centres'", "as many radii"],
    ),
    (
        "shapeNoCentres",
        section("shapes", "type cluster; centres 1; radii (1);"),
        ["'centres'", "value 1", "a list of points"],
    ),
    (
        "shapeNoRadii",
        section("shapes", "type cluster; centres ((0 0 0)); radii wide;"),
        ["'radii'", "value wide", "numbers > 0"],
    ),
    ("wallNoPatches", wall("type patches; patches 3;"), ["'patches'", "value 3", "left right"]),
    (
        "motionForce",
        motion("type free; mass 1; centre (0 0 0); force 3;"),
        ["'force'", "value 3", "a vector"],
    ),
    (
        "lawOfOne",
        section("contactLaws", "materials steel; type Coulomb; friction 1;"),
        ["'materials'", "value steel", "a pair of"],
    ),
    (
        "sieve",
        injection(f"{BOX}\n#remove distribution\n{SIEVE}"),
        ["'passing'", "value 3", "fractions that rise from 0 to 1"],
    ),
    (
        "motionTooFast",
        motion("type translation; velocity (0 1e200 0);"),
        ["'velocity'", "( 0 1e+200 0 )", "components up to 1e15"],
    ),
    (
        "freeWallTooFast",
        motion("type free; mass 1; centre (0 0 0); velocity (0 1e200 0);"),
        ["'velocity'", "( 0 1e+200 0 )", "components up to 1e15"],
    ),
    (
        "planeTooFar",
        wall("type plane; point (0 -1e200 0); normal (0 1 0);"),
        ["'point'", "( 0 -1e+200 0 )", "components up to 1e15"],
    ),
    (
        "outletBoxOfWords",
        section("outlets", "type box; box (0 0 0) (nan 1 1);"),
        ["'box'", "nan", "two corners"],
    ),
    ("wallEmptyPatches", wall("type patches; patches ();"), ["other", "'patches'", "()", "left"]),
    (
        "patchOfTwoWalls",
        wall("type patches; patches (left);"),
        ["'patches'", "value left", "no other entry of 'walls'"],
    ),
    ("injectionTooFast", injection(f"{BOX} velocity (0 1e200 0);"), ["'velocity'", "1e+200"]),
    (
        "injectionSeed",
        injection(f"{BOX} seed 1.5;"),
        ["'seed'", "value 1.5", "a whole number"],
    ),
    ("outletNoBox", section("outlets", "type box;"), ["'box' is missing", "two corners"]),
    ("injectionAll", injection(f"{BOX} total all;"), ["'total'", "all", "a value >= 0"]),
]


@pytest.mark.parametrize("spoil, fragments", [row[1:] for row in TABLE], ids=[r[0] for r in TABLE])
def test_bad_input_is_refused(clone, spoil, fragments):
    case = dry_box(clone, [(0.03, 0.03), (0.06, 0.05)], dimension=2)
    spoil(case)
    before = case.times
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in [GRAINS, *fragments]:
        assert fragment in case.log, f"no '{fragment}' in\n{case.log[case.log.find('-->') :]}"
    assert "\nTime = " not in case.log
    assert case.times == before
    assert "printStack" not in case.log


TURNING = {
    "type": ("type rotation; origin (0 0 0); axis (0 0 1); rpm 10;", "rotation"),
    "angle": ("type table; angle table ((0 0) (1 1)); origin (0 0 0); axis (0 0 1);", "( 1 1 )"),
    "inertia": ("type free; mass 1; centre (0 0 0); inertia (1 2 3);", "( 1 2 3 )"),
}


@pytest.mark.parametrize("keyword", TURNING)
def test_planes_of_spheres_do_not_turn(clone, keyword):
    """It is said before the first step; those of discs are segments."""
    entries, value = TURNING[keyword]
    case = dry_box(clone, [(0.05, 0.05, 0.05)])
    motion(entries)(case)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in (f"{GRAINS}.walls.other.motion", f"'{keyword}'", value, "of type plane"):
        assert fragment in case.log, f"no '{fragment}' in\n{case.log[case.log.find('-->') :]}"
    assert "\nTime = " not in case.log
    assert "printStack" not in case.log


@pytest.mark.parametrize(
    "speed, fragments",
    [
        # Its kinetic energy is more than a number holds
        (1e200, ["grains.csv", "line 2", "'vx'", "1e+200", "at most 1e15"]),
        (1e14, ["too far for sub-steps"]),
    ],
)
def test_grains_that_are_too_fast_are_reported(clone, speed, fragments):
    case = dry_box(clone, [(0.05, 0.05)], velocity=[(speed, 0)], dimension=2)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in fragments:
        assert fragment in case.log
    assert "printStack" not in case.log


def test_limits_of_the_step_are_checked(clone):
    case = dry_box(clone, [(0.05, 0.05)], dimension=2)
    limit = "adjustTimeStep yes; maxGrainDisplacement 0;"
    replace(case, "system/controlDict", "deltaT ", f"{limit}\ndeltaT ")
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in ("system/controlDict", "'maxGrainDisplacement'", "value 0", "> 0"):
        assert fragment in case.log


def test_walls_that_swing_faster_than_steps_are_refused(clone):
    """With steps of one period it would stand still."""
    case = dry_box(clone, [(0.05, 0.05)], dimension=2)
    swing = "type oscillation; direction (0 1 0); amplitude 1e-3; frequency"
    motion(f"{swing} 1000;")(case)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in (GRAINS, "'frequency'", "value 1000", "at most 250 Hz", "steps of 0.001 s"):
        assert fragment in case.log
    replace(case, GRAINS, f"{swing} 1000;", f"{swing} 250;")
    case.run("dryGrainFoam")


def test_initial_grains_overlap_across_a_period(clone):
    """Grains and walls are met by all images, as in the run."""
    case = cyclic_box(clone, [(0.001, 0.05), (0.0985, 0.05)], 0.002)
    shutil.rmtree(case.path / "0")
    (case.path / "constant/transportProperties").unlink()
    text = (case.path / GRAINS).read_text()
    text = text[: text.index("\ncoupling\n")]
    (case.path / GRAINS).write_text(text)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in ("'initialGrains'", "overlaps grain", "by 0.0015 m"):
        assert fragment in case.log

    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n0.0985,0.05,0,0.002\n")
    plate = "type surface; file plate.stl; material steel;"
    (case.path / GRAINS).write_text(text.replace("walls\n{}", f"walls\n{{ plate {{ {plate} }} }}"))
    (case.path / "constant/triSurface").mkdir()
    corners = "vertex 0 0.02 -1\n vertex 0 0.08 -1\n vertex 0 0.05 2\n"
    stl = f"solid p\nfacet normal 1 0 0\nouter loop\n{corners}endloop\nendfacet\nendsolid p\n"
    (case.path / "constant/triSurface/plate.stl").write_text(stl)
    assert case.run("dryGrainFoam", check=False, timeout=60) == 1
    for fragment in ("'initialGrains'", "overlaps a wall", "by 0.0005 m"):
        assert fragment in case.log
