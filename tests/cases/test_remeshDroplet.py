# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What remeshDroplet keeps of a case, and what it refuses without a change."""

import numpy as np
import pytest
from droplet_box import with_droplets
from grain_box import control, make_cyclic, replace
from moving_mesh import write
from test_fittedMesh import (
    HOT,
    RADIUS,
    SIDE,
    falling,
    let_mesh_follow,
    middles,
    move_droplet,
    remesh,
    small_box,
    with_hot_droplet,
)
from test_parallel import decompose

CENTRE = (4.03e-3, 4.11e-3)
EDGES = 'boundaryField { ".*" { type zeroGradient; } frontAndBack { type empty; } }'


def files(case):
    found = (path for path in case.path.rglob("*") if path.is_file())
    return {path: path.read_bytes() for path in found if not path.name.startswith("log.")}


def refused(case, *reasons):
    """Ends with the reasons, and no file that was there is another one."""
    sizes = "cells 8; largest 5e-4;"
    write(case, "system/remeshDropletDict", "dictionary", sizes)
    before = files(case)
    assert case.run("remeshDroplet", check=False) == 1
    for reason in reasons:
        assert reason in case.log
    assert "printStack" not in case.log
    after = files(case)
    assert all(after[path] == content for path, content in before.items())


def test_no_new_extremes(clone):
    """T of two values: any slope that goes too far is beyond them."""
    random = np.random.default_rng(2)
    case = small_box(clone)
    with_hot_droplet(case, CENTRE, T=random.choice([400.0, HOT], 256))
    for centre in random.uniform(0.3 * SIDE, 0.7 * SIDE, (3, 2)):
        move_droplet(case, centre)
        remesh(case, 8, largest=3e-4)
        T = case.field("T")
        # 3 K were measured where slopes were limited from the cell's centre on
        assert 400 - 1e-9 < T.min() and T.max() < HOT + 1e-9


@pytest.mark.parametrize(
    "inside, edges",
    [
        ("nonuniform List<scalar> 3(1 2 3)", EDGES),
        ("uniform 1", "boundaryField { left { type zeroGradient; } }"),
        ("uniform 1", EDGES.replace("zeroGradient", "noSuchType")),
    ],
    ids=["size", "patches", "type"],
)
def test_a_field_that_cannot_be_read_changes_nothing(clone, inside, edges):
    """It comes after T, p_rgh and psi, whose size would be that of the new mesh."""
    case = with_hot_droplet(small_box(clone), CENTRE)
    text = f"dimensions [0 0 0 0 0 0 0]; internalField {inside}; {edges}"
    write(case, "0/zeta", "volScalarField", text)
    refused(case, "zeta")


@pytest.mark.parametrize("height", [RADIUS, 1.01 * RADIUS])
def test_a_droplet_on_a_wall_is_refused(clone, height):
    case = with_hot_droplet(small_box(clone), (4e-3, height))
    refused(case, "from the boundary of the mesh", "2.5e-05 m at least")


def test_a_droplet_across_a_cyclic_side_is_refused(clone):
    """gmsh ended the program by an exception of its own."""
    refused(cyclic_case(clone, 2e-4), "from the boundary of the mesh")


def cyclic_case(clone, x):
    case = small_box(clone)
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    with_hot_droplet(case, (x, 4e-3))
    for name in ("T", "psi", "U", "p_rgh"):
        path = case.path / "0" / name
        text = path.read_text().replace('"left|right|bottom', '"bottom')
        cyclic = '"left|right" { type cyclic; }'
        head, name, tail = text.partition("boundaryField")
        path.write_text(head + name + tail.replace("{", f"{{ {cyclic}", 1))
    replace(case, "constant/grainProperties", "(left right bottom top)", "(bottom top)")
    return case


def test_faces_of_cyclic_sides_begin_opposite_each_other(clone):
    case = cyclic_case(clone, 4e-3)
    remesh(case, 8)
    case.run("checkMesh")
    assert "Mesh OK" in case.log


def test_many_small_cells(clone):
    """gmsh's front divides by zero there."""
    case = with_hot_droplet(small_box(clone), (4e-3, 4e-3))
    remesh(case, 1000, growth=1)
    assert len(case.mesh().polygons) > 1e4


def test_cells_stay_in_their_zones(clone):
    case = small_box(clone)
    half = f"box (0 0 -1) ({SIDE / 2} {SIDE} 1);"
    actions = f"{{ name half; type cellZoneSet; action new; source boxToCell; {half} }}"
    write(case, "system/topoSetDict", "dictionary", f"actions ({actions});")
    case.run("topoSet")
    with_hot_droplet(case, CENTRE)
    remesh(case, 8)
    write(
        case,
        "system/topoSetDict",
        "dictionary",
        "actions ({ name found; type cellSet; action new; source zoneToCell; zone half; });",
    )
    case.run("topoSet")
    assert f"now size {(middles(case)[:, 0] < SIDE / 2).sum()}" in case.log


def test_tensors_are_carried(clone):
    case = with_hot_droplet(small_box(clone), CENTRE)
    values = "(1 2 3 4 5 6)" * 256
    inside = f"internalField nonuniform List<symmTensor> 256({values})"
    text = f"dimensions [0 0 0 0 0 0 0]; {inside}; {EDGES}"
    write(case, "0/R", "volSymmTensorField", text)
    remesh(case, 8)
    assert "R: carried by fluid" in case.log
    assert len(case.field("R", "0")) == len(case.mesh().polygons)


def test_a_decomposed_case_is_to_be_reconstructed_first(clone):
    """Its last time has grains and droplets, and no fields."""
    case = falling(clone, "decomposed")
    control(case, endTime=0.005)
    decompose(case, 2)
    case.parallel("grainDropletFoam", 2)
    refused(case, "no field U", "reconstructPar")
    case.run("reconstructPar")
    remesh(case, 8)
    control(case, endTime=0.006)
    case.run("grainDropletFoam")


def test_steps_of_second_order_begin_anew(clone):
    """Volumes and velocities of the step before are those of the old cells."""
    case = falling(clone, "backward")
    replace(case, "system/fvSchemes", "Euler", "backward")
    control(case, endTime=0.005)
    case.run("grainDropletFoam")
    assert (case.path / "0.005/V0").exists()
    remesh(case, 8, largest=4e-4)
    control(case, endTime=0.0075)
    case.run("grainDropletFoam")


def test_droplets_are_needed_to_follow_them(clone):
    case = with_hot_droplet(small_box(clone), CENTRE)
    let_mesh_follow(case, "reach 1e-3;")
    case.run("grainThermalFoam", check=False)
    assert "'solver'" in case.log and "no droplets" in case.log
    assert "printStack" not in case.log


def test_no_new_mesh_is_asked_for_when_the_droplet_is_gone(clone):
    """remeshDroplet would refuse to make one."""
    case = with_hot_droplet(small_box(clone), CENTRE)
    remesh(case, 8)
    with_droplets(case, [], RADIUS)
    entries = "reach 1e-3; maxNonOrtho 1;"
    let_mesh_follow(case, entries)
    control(case, endTime=1e-3, deltaT=5e-4, writeInterval=2)
    case.run("grainDropletFoam")
    assert "to go on after remeshDroplet" not in case.log


def test_a_droplet_that_comes_to_a_wall_is_kept(clone):
    """The run stops before cells are too thin, and goes on where the mesh stays."""
    case = small_box(clone)
    with_hot_droplet(case, (4e-3, 1.6e-3), velocity=[(0, -0.2)])
    let_mesh_follow(case, "reach 3e-3;")
    control(case, endTime=0.01, deltaT=2e-4, writeInterval=1000)
    remesh(case, 8)
    case.run("grainDropletFoam")
    assert "to go on with shorter steps, or with a mesh that does not follow it" in case.log
    assert len(case.times) == 2
    # 343 K where it was followed to the wall
    assert case.field("T").min() > 373.14
    (case.path / "constant/dynamicMeshDict").unlink()
    end = float(case.times[-1]) + 4e-4
    control(case, endTime=f"{end:.4g}", writeInterval=1)
    case.run("grainDropletFoam")
