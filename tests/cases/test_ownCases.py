# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases as users make them: a nozzle of topoSet, a mesh of gmsh on ranks, a drum from an STL."""

import grainplot
import numpy as np
import pytest
from dry_box import GRAINS, G, dry_box
from grain_box import (
    assert_same_grains,
    control,
    grain_box,
    lattice,
    ledger,
    replace,
    tracks,
)
from test_dryWalls import add_wall
from test_functionObjects import add_function
from test_openings import append

HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object dict; }\n"
RADIUS = 0.002


def nozzle(case, box):
    """Faces of the bottom in a box become a patch of their own."""
    faces = f"name hole; type faceSet; action new; source boxToFace; box {box};"
    below = "name hole; type faceSet; action subset; source patchToFace; patch bottom;"
    (case.path / "system/topoSetDict").write_text(
        f"{HEADER}actions ( {{ {faces} }} {{ {below} }} );"
    )
    case.run("topoSet")
    patch = "name nozzle; patchInfo { type patch; } constructFrom set; set hole;"
    (case.path / "system/createPatchDict").write_text(
        f"{HEADER}pointSync false; patches ( {{ {patch} }} );"
    )
    case.run("createPatch -overwrite")


def test_grains_spout_above_a_nozzle(clone):
    """A jet in the middle of the bottom carries grains up there, and they come down beside it."""
    side, speed = 0.1, 0.35
    start = lattice(23, 8, 2 * RADIUS + 2e-4, (0.0038, RADIUS + 1e-4))
    case = grain_box(clone, start, RADIUS)
    replace(case, "system/blockMeshDict", "top\n    {\n        type    wall", "top { type patch")
    case.run("blockMesh")
    nozzle(case, "(0.0399 -1e-4 -1) (0.0601 1e-4 1)")
    walls = '"left|right|bottom|top"'
    jet = f"nozzle {{ type fixedValue; value uniform (0 {speed} 0); }}"
    out = "top { type zeroGradient; }"
    replace(case, "0/U", walls, f'{jet} {out} "left|right|bottom"')
    surface = "top { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", walls, f'{surface} "left|right|bottom|nozzle"')
    # A grid keeps the grains off the hole, which lets the fluid through
    add_wall(case, "grid", "type plane; point (0 0 0); normal (0 1 0);")
    replace(case, GRAINS, "(left right bottom top)", "(left right top)")
    control(case, endTime=2, deltaT=2e-3, writeInterval=1000)
    case.run("grainFoam")

    lines = tracks(case)
    assert len(lines) == 1000 * len(start)
    lines = lines[lines[:, 0] > 0.5]
    x, y, vy = lines[:, 2], lines[:, 3], lines[:, 6]
    # None passes a wall, but for the tolerance of contacts
    assert x.min() > RADIUS - 1e-5
    assert x.max() < side - RADIUS + 1e-5
    assert y.min() > RADIUS - 1e-5
    # Up in the spout, down beside it; nothing piles up, so that all in all they rise nowhere
    spout = np.abs(x - side / 2) < 0.01
    beside = (np.abs(x - side / 2) > 0.02) & (y < 0.03)
    assert vy[spout].mean() > 0.1 * speed
    assert vy[beside].mean() < 0
    assert abs(vy.mean()) < 0.05 * vy[spout].mean()

    book = ledger(case)
    assert book["momentumError"].max() <= 1e-9  # round-off of what fluid and grains exchange
    # Fluid and grains together neither gain nor lose volume: the linear solver's tolerance
    assert book["divergence"].max() <= 1e-6


CHANNEL = """
h = 0.005;
Point(1) = {0, 0, 0, h};
Point(2) = {0.06, 0, 0, h};
Point(3) = {0.075, 0, 0, h};
Point(4) = {0.09, 0, 0, h};
Point(5) = {0.16, 0, 0, h};
Point(6) = {0.16, 0.05, 0, h};
Point(7) = {0, 0.05, 0, h};
Line(1) = {1, 2};
Circle(2) = {2, 3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
e[] = Extrude {0, 0, 0.01} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("fluid") = {e[1]};
Physical Surface("bottom") = {e[2], e[3], e[4]};
Physical Surface("right") = {e[5]};
Physical Surface("top") = {e[6]};
Physical Surface("left") = {e[7]};
Physical Surface("frontAndBack") = {1, e[0]};
"""


def channel(clone, name):
    """Grains in a stream over a pit, triangles."""
    speed = 0.2
    case = grain_box(clone, lattice(8, 6, 2.5 * RADIUS, (0.02, 0.015)), RADIUS, name=name)
    (case.path / "box.geo").write_text(CHANNEL)
    case.run("gmsh -3 -format msh2 box.geo")
    case.run("gmshToFoam box.msh")
    kinds = {"frontAndBack": "empty", "bottom": "wall", "top": "wall"}
    for patch, kind in kinds.items():
        case.dict_set("constant/polyMesh/boundary", f"entry0/{patch}/type", kind)
    stream = f"left {{ type fixedValue; value uniform ({speed} 0 0); }}"
    stream += " right { type zeroGradient; }"
    replace(case, "0/U", '"left|right|bottom|top"', f'{stream} "bottom|top"')
    out = "right { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", '"left|right|bottom|top"', f'{out} "left|bottom|top"')
    replace(case, GRAINS, "(left right bottom top)", "(bottom top left)")
    append(case, "outlets { right { type patches; patches (right); } }")
    control(case, endTime=1, deltaT=2e-3, writeInterval=250)
    return case


@pytest.mark.parallel
def test_channel_of_gmsh_on_two_ranks_with_a_restart(clone):
    """As without a break, bit for bit; the picture is drawn from the reconstructed case."""
    whole, parts = channel(clone, "whole"), channel(clone, "parts")
    for case, stops in ((whole, [1]), (parts, [0.5, 1])):
        case.run("decomposePar")
        for stop in stops:
            control(case, endTime=stop)
            case.parallel("grainFoam", 2)
        case.run("reconstructPar")
    assert "The grains continue from" in (parts.path / "log.grainFoam").read_text()
    assert_same_grains(whole, parts)
    for name in ("U", "p_rgh", "eps"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)

    # Some lie in the pit, others have left
    grains = whole.grains()
    assert 10 < np.sum(grains["position"][:, 1] < 0)
    assert ledger(whole)["removed"].sum() == 48 - len(grains["id"]) > 0
    figure = grainplot.columns(parts.path, ["0", "0.5", "1"], field="U")
    figure.savefig(parts.path / "channel.png")
    assert (parts.path / "channel.png").stat().st_size > 10_000


def write_drum(case, radius, facets=90):
    """A cylinder about the middle of the box, along z, as triangles."""
    turn = 2 * np.pi * np.arange(facets + 1) / facets
    x, y = 0.05 + radius * np.cos(turn), 0.05 + radius * np.sin(turn)
    text = ""
    for i in range(facets):
        a, b, c, d = (
            f"vertex {x[j]:.9g} {y[j]:.9g} {z}"
            for j, z in ((i, -0.01), (i + 1, -0.01), (i + 1, 0.02), (i, 0.02))
        )
        for corners in ((a, b, c), (a, c, d)):
            text += f"facet normal 0 0 0 outer loop {' '.join(corners)} endloop endfacet\n"
    (case.path / "constant/triSurface").mkdir()
    (case.path / "constant/triSurface/drum.stl").write_text(f"solid drum\n{text}endsolid drum\n")


def segment_arm(area, radius):
    """Distance of the centre of a segment of a circle from the circle's."""
    half = np.linspace(0, np.pi, 100_001)
    half = np.interp(area, radius**2 * (half - np.sin(half) * np.cos(half)), half)
    return 2 / 3 * (radius * np.sin(half)) ** 3 / area


def test_torque_of_a_drum_is_that_of_its_tilted_bed(clone):
    """Weight times the arm of a segment of a circle that is tilted by the angle of repose."""
    drum, radius, rpm = 0.045, 0.002, 15
    place = lattice(16, 9, 2.1 * radius, (0.0185, 0.022))
    place = place[np.hypot(*(place - 0.05).T) < drum - 1.1 * radius]
    case = dry_box(clone, place, radius, dimension=2)
    write_drum(case, drum)
    motion = f"motion {{ type rotation; origin (0.05 0.05 0); axis (0 0 1); rpm {rpm}; }}"
    add_wall(case, "drum", f'type surface; file "drum.stl"; {motion}')
    replace(case, GRAINS, "friction    0.2", "friction    0.8")
    replace(case, GRAINS, "friction    0.3", "friction    0.5")
    add_function(case, "wallForces", every=1)
    kind = "type wallForces;"
    replace(case, "system/controlDict", kind, f"{kind} walls (drum); origin (0.05 0.05 0);")
    turns = 2
    control(case, endTime=60 / rpm * turns, deltaT=2e-3, writeInterval=4000)
    case.run("dryGrainFoam")

    table = case.table("postProcessing/out/0/drum.csv")
    last = table["time"] > 60 / rpm
    lines = tracks(case).reshape(-1, len(place), 14)
    centre = lines[:, :, 2:4].mean(axis=1) - 0.05
    weight = case.grains()["mass"].sum() * G

    # What does not turn faster and faster has the weight for a counterpart, but for the mean over
    # avalanches
    torque = -table["mz"][last].mean()
    x, y = centre[last].mean(axis=0)
    assert torque == pytest.approx(weight * x, rel=0.02)
    # The bed is a segment of the circle, a random packing of 0.82; that its surface is not quite
    # straight and rises and falls by a disc or two in the bed's depth of eight brings it nearer
    arm = segment_arm(len(place) * np.pi * radius**2 / 0.82, drum)
    angle = np.arctan2(x, -y)
    assert torque == pytest.approx(weight * arm * np.sin(angle), rel=0.06)
    assert np.radians(15) < angle < np.arctan(0.5)  # rough discs; the friction of one plane
