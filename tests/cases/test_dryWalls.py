# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam: walls that move, contact laws, clusters, periodic boxes, force chains."""

import struct

import grainplot
import h5py
import numpy as np
import pytest
from dry_box import GRAINS, G, cubic, dry_box, write_facets
from grain_box import (
    assert_same_grains,
    control,
    lattice,
    ledger,
    make_cyclic,
    replace,
    run_whole_and_parts,
    tracks,
)

RADIUS = 0.005
DT = 1e-3
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


CHAINS = """functions
{
    forceChains
    {
        type            contactNetwork;
        libs            ("libgrainFunctionObjects.so");
        writeControl    writeTime;
    }
"""


def add(case, text):
    """Append to grainProperties."""
    path = case.path / GRAINS
    path.write_text(path.read_text() + text)


def add_wall(case, name, entries):
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    {name} {{ {entries} material steel; }}\n")


def up(dimension):
    return np.eye(dimension)[dimension - 1]


def vector(values):
    """As OpenFOAM writes it; two components are x and y."""
    return "(" + " ".join(str(float(v)) for v in [*values, 0.0][:3]) + ")"


@DIMENSIONS
def test_grain_rides_on_a_piston(clone, dimension):
    """It stays on a floor that is lifted at constant speed and falls when that stops."""
    start = np.full(dimension, 0.05)
    start[-1] = 0.02 + RADIUS
    case = dry_box(clone, [start], RADIUS, dimension=dimension)
    piston = 0.02 * up(dimension)
    add_wall(
        case,
        "piston",
        f"type plane; point {vector(piston)}; normal {vector(up(dimension))};"
        f"motion {{ type translation; velocity {vector(0.5 * up(dimension))}; end 0.03; }}",
    )
    control(case, endTime=0.04)
    case.run("dryGrainFoam")
    n = np.arange(1, 41)
    height = tracks(case)[:, 1 + dimension]
    lifted = n <= 30
    # The tolerance per step
    np.testing.assert_allclose(
        height[lifted], 0.02 + RADIUS + 0.5 * DT * n[lifted], atol=30 * 1e-7
    )
    k = n[~lifted] - 30
    thrown = 0.5 * DT * k - G * DT**2 * k * (k + 1) / 2
    np.testing.assert_allclose(height[~lifted] - height[29], thrown, atol=1e-6)


@DIMENSIONS
def test_moving_walls_continue_after_a_restart(clone, dimension):
    if dimension == 2:
        start = lattice(8, 4, 0.011, (0.01, 0.02))
    else:
        start = cubic(8, 8, 2, 0.011, (0.01, 0.01, 0.02))
    cases = [dry_box(clone, start, RADIUS, dimension=dimension, name=name) for name in "ab"]
    for case in cases:
        add_wall(
            case,
            "shaker",
            f"type plane; point {vector(0.01 * up(dimension))}; normal {vector(up(dimension))};"
            f"motion {{ type oscillation; direction {vector(up(dimension))};"
            " amplitude 2e-3; frequency 20; }",
        )
        control(case, endTime=0.08, writeInterval=40)
    whole, parts = cases
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.04, end=0.08)
    assert_same_grains(whole, parts)
    assert ledger(whole)["active"].max() > 5


def test_free_lid_presses_on_a_column(clone):
    """A lid of finite mass that rests on a disc between walls adds its weight to the floor's."""
    case = dry_box(clone, [(0.05, RADIUS)], RADIUS, dimension=2)
    lid = "vertex 0.02 0.01 {0} vertex 0.08 0.01 {1} vertex 0.08 0.01 {2}"
    facets = [lid.format(-1, -1, 1), lid.format(-1, 1, 1).replace("0.08 0.01 1 v", "0.02 0.01 1 v")]
    text = "".join(f"facet normal 0 1 0 outer loop {f} endloop endfacet\n" for f in facets)
    (case.path / "constant/triSurface").mkdir()
    (case.path / "constant/triSurface/lid.stl").write_text(f"solid lid\n{text}endsolid lid\n")
    add_wall(
        case,
        "lid",
        'type surface; file "lid.stl";'
        "motion { type free; mass 0.05; centre (0.05 0.01 0); force (0 -1 0); }",
    )
    case.run("dryGrainFoam")
    np.testing.assert_allclose(case.grains()["position"], [(0.05, RADIUS)], atol=50e-7)
    # Grain, lid, force: what the floor carries less what the lid gives is the grain's weight
    mass = case.grains()["mass"][0]
    book = ledger(case)
    np.testing.assert_allclose(book["impulse_y"][5:], mass * G * DT, rtol=1e-2)


@pytest.mark.parametrize("dt", [1e-3, 2.5e-4])
def test_free_plate_that_is_hit_keeps_its_angular_momentum(clone, dt):
    """It tumbles about axes of three different moments of inertia for half a turn.

    Where it kept its spin its angular momentum would point up to 39 degrees elsewhere.
    """
    case = dry_box(clone, [(0.06, 0.07, 0.04)], 0.004, velocity=[(0, 0, 2.0)])
    corners = [(x, y, 0.05) for x, y in [(0.03, 0.03), (0.07, 0.03), (0.07, 0.075), (0.03, 0.075)]]
    write_facets(case, "plate", [corners[:3], [corners[0], *corners[2:]]])
    inertia = np.array([2e-6, 8e-6, 1e-5])
    motion = f"type free; mass 0.02; centre (0.05 0.05 0.05); inertia {vector(inertia)};"
    walls = f'plate {{ type surface; file "plate.stl"; material steel; motion {{ {motion} }} }}'
    text = (case.path / GRAINS).read_text()
    begin, end = text.index("walls\n{"), text.index("initialGrains")
    (case.path / GRAINS).write_text(f"{text[:begin]}walls\n{{\n    {walls}\n}}\n\n{text[end:]}")
    replace(case, GRAINS, "friction    0.2;", "friction 0; restitution 0.176;")
    replace(case, "constant/g", "(0 0 -9.81)", "(0 0 0)")
    control(case, deltaT=dt, endTime=0.24, writeInterval=round(0.03 / dt))
    case.run("dryGrainFoam")
    momenta, energies = [], []
    for time in case.times[1:]:
        with h5py.File(case.path / time / "grains.h5") as state:
            w, *v = state["wallBodies/orientation"][0]
            spin = state["wallBodies/spin"][0]
        x, y, z = v
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        axes = np.eye(3) + 2 * w * cross + 2 * cross @ cross
        momenta.append(axes @ (inertia * (axes.T @ spin)))
        energies.append(momenta[-1] @ spin)
    assert len(momenta) == 8
    # To round-off; the hit is over before the first
    size = np.linalg.norm(momenta[0])
    np.testing.assert_allclose(momenta, np.tile(momenta[0], (8, 1)), rtol=0, atol=1e-12 * size)
    np.testing.assert_allclose(energies, energies[0], rtol=1e-12)
    assert np.linalg.norm(spin) > 10


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_ball_bounces_with_its_restitution(clone, restitution):
    start = (0.05, RADIUS + 0.0303)
    case = dry_box(clone, [start], RADIUS, dimension=2)
    replace(case, GRAINS, "friction    0.2;", f"friction 0.2; restitution {restitution};")
    control(case, endTime=0.13)
    case.run("dryGrainFoam")
    velocity = tracks(case)[:, 6]
    hit = np.argmin(velocity)
    # Without restitution the step that hits closes the gap, the next one stops; gravity of both
    after = velocity[hit + 2]
    assert after == pytest.approx(-restitution * velocity[hit], abs=3 * G * DT)


def test_disc_passes_a_periodic_boundary_and_meets_the_other_side(clone):
    case = dry_box(clone, [(0.02, 0.05), (0.09, 0.05)], RADIUS, [(0, 0), (1, 0)], 2)
    make_cyclic(case, ("left", "right"))
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, "constant/g", "(0 -9.81 0)", "(0 0 0)")
    case.run("blockMesh")
    control(case, endTime=0.04, writeInterval=40)
    case.run("dryGrainFoam")
    grains = case.grains()
    # 20 mm to go to the image of the first, then both at half the speed
    np.testing.assert_allclose(grains["velocity"], [(0.5, 0), (0.5, 0)], atol=1e-4)
    np.testing.assert_allclose(grains["position"][:, 0], [0.03, 0.12], atol=1e-3)
    case.run("foamToVTK -latestTime")
    (file,) = (case.path / "VTK").rglob("lagrangian/**/*.vtp")
    assert b"NumberOfPoints='2'" in file.read_bytes()


def test_force_chains_of_a_column(clone):
    n = 5
    start = lattice(1, n, 2 * RADIUS, (0.05, RADIUS))
    case = dry_box(clone, start, RADIUS, dimension=2)
    replace(case, "system/controlDict", "functions\n{\n", CHAINS)
    control(case, endTime=0.05, writeInterval=50)
    case.run("dryGrainFoam")

    text = (case.path / "postProcessing/forceChains/contacts_0.05.vtk").read_text().split()
    normal = text.index("normal") + 5
    first = text.index("first") + 5
    second = text.index("second") + 5
    weight = case.grains()["mass"][0] * G
    carried = {}
    for k in range(n):
        pair = frozenset((int(text[first + k]), int(text[second + k])))
        carried[pair] = float(text[normal + k]) / weight
    # The k-th contact from below carries n - k grains, to the tolerance over g dt^2
    expected = {frozenset((k, k - 1)): n - k for k in range(n)}
    assert carried.keys() == expected.keys()
    for pair, grains in expected.items():
        assert carried[pair] == pytest.approx(grains, abs=n * 1e-2)


def rods(clone, dimension, name=None):
    """A lattice of rods of three discs or spheres in random directions, from packGrains."""
    case = dry_box(clone, dimension=dimension, name=name)
    rod = "type cluster; centres ((0 0 0) (2 0 0) (4 0 0)); radii (1 1 1);"
    add(case, f"\nshapes\n{{\n    rod {{ {rod} }}\n}}\n")
    header = "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }\n"
    box = "(0 0 0) (0.1 0.1 0.1)" if dimension == 3 else "(0 0 0) (0.1 0.1 0)"
    (case.path / "system/packGrainsDict").write_text(
        f"{header}type lattice; box {box}; radius 0.012; shape rod; seed 3; material glass;"
    )
    case.run("packGrains")
    return case


def assert_members_do_not_overlap(members, grains):
    """Rods of three touching discs, the middle one at the rod's centre."""
    first, middle, last = members["position"].reshape(-1, 3, 2).transpose(1, 0, 2)
    np.testing.assert_allclose(middle, grains["position"], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(last - first, axis=1), 4 * 0.004, rtol=1e-12)
    i, j = np.triu_indices(len(members["grain"]), 1)
    other = members["grain"][i] != members["grain"][j]
    apart = np.linalg.norm(members["position"][i] - members["position"][j], axis=1)
    # Only if the members are turned as their grain is: what the solver leaves
    assert apart[other].min() > 2 * 0.004 - 1e-4


@DIMENSIONS
def test_rods_fall_settle_and_continue(clone, dimension):
    whole, parts = (rods(clone, dimension, name) for name in "ab")
    for case in (whole, parts):
        control(case, endTime=0.2, writeInterval=100, writeFormat="ascii")
    run_whole_and_parts(whole, parts, "dryGrainFoam", stop=0.1, end=0.2)
    assert_same_grains(whole, parts)
    one = whole.grains("0.2")

    n = len(one["id"])
    assert n == 4**dimension
    # Three discs of a third of the length: area 3 pi (R/3)^2; spheres alike
    volume = 3 * np.pi * 0.004**2 * 0.01 if dimension == 2 else 4 * np.pi * 0.004**3
    np.testing.assert_allclose(one["mass"], 2500 * volume, rtol=1e-5)
    book = ledger(whole)
    # Contacts only take energy
    assert (book["contactWork"] <= 1e-9).all()
    assert book["kineticEnergy"][-1] < book["kineticEnergy"].max()
    assert book["worstOverlap"].max() < 1e-4

    if dimension == 2:
        assert_members_do_not_overlap(grainplot.read_members(whole.path, "0.2"), one)

    # Cloud of the members, three for each rod
    whole.run("foamToVTK -latestTime")
    files = list((whole.path / "VTK").rglob("lagrangian/members/*.vtp"))
    assert len(files) == 1
    assert f"NumberOfPoints='{3 * n}'".encode() in files[0].read_bytes()


@pytest.mark.parallel
def test_ranks_agree_on_rods(clone):
    one, many = (rods(clone, 3, name) for name in "ab")
    for case in (one, many):
        control(case, endTime=0.1, writeInterval=100)
    one.run("dryGrainFoam")
    many.run("decomposePar")
    many.parallel("dryGrainFoam", 2)
    for name in ("position", "velocity", "spin", "orientation"):
        np.testing.assert_array_equal(one.grains("0.1")[name], many.grains("0.1")[name])


PLATE = np.linalg.qr(np.column_stack([(0.2, 0.3, 1.0), (1, 0.1, 0), (0, 1, 0)]))[0]


def on_plate(x, y, height=0.0):
    """A place above an inclined plate through the middle of the cube."""
    up, along, across = PLATE.T * np.sign(PLATE[2, 0])
    return np.array([0.05, 0.05, 0.04]) + x * along + y * across + height * up


def write_plate(case, halves):
    """Binary STL of [-0.04, 0] x [-0.03, 0.03] in one strip and [0, 0.04] x ... in several."""
    facets = []
    for (left, right), n in zip([(-0.04, 0.0), (0.0, 0.04)], halves, strict=True):
        ends = np.linspace(-0.03, 0.03, n + 1)
        for low, high in zip(ends[:-1], ends[1:], strict=True):
            a, b, c, d = (
                on_plate(x, y) for x, y in [(left, low), (right, low), (right, high), (left, high)]
            )
            facets += [(a, b, c), (a, c, d)]
    folder = case.path / "constant/triSurface"
    folder.mkdir()
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *np.ravel(f), 0) for f in facets)
    (folder / "plate.stl").write_bytes(b" " * 80 + struct.pack("<I", len(facets)) + data)


@pytest.mark.parametrize("halves", [(1, 1), (1, 7), (5, 3)], ids=["edge", "joints", "more joints"])
def test_spheres_slide_over_the_joints_of_a_binary_stl(clone, halves):
    """Corners of seven digits beside the edges that they lie on are no obstacles."""
    radius, speed = 0.0015, 0.5
    across = np.array([-0.03 + 0.06 * k / 14 for k in range(2, 13)])
    start = [on_plate(-0.012, y, radius + 1e-8) for y in across]
    along = (on_plate(1, 0) - on_plate(0, 0)) * speed
    case = dry_box(clone, start, radius, velocity=np.tile(along, (len(start), 1)))
    write_plate(case, halves)
    add_wall(case, "plate", 'type surface; file "plate.stl";')
    replace(case, GRAINS, "friction    0.2", "friction 0")
    up = on_plate(0, 0, 1) - on_plate(0, 0)
    replace(case, "constant/g", "(0 0 -9.81)", vector(-9.81 * up))
    control(case, endTime=0.05, writeInterval=50)
    case.run("dryGrainFoam")
    lines = tracks(case)
    velocity = lines[:, 5:8]
    # What the contact solver leaves uncertain: 1e-7 m in a step of 1 ms
    assert np.abs(velocity @ up).max() <= 1.2e-4
    np.testing.assert_allclose(velocity @ along / speed, speed, rtol=1e-3)
    height = (lines[:, 2:5] - on_plate(0, 0)) @ up
    assert np.abs(height - radius).max() <= 3e-6
    assert ((lines[-len(start) :, 2:5] - on_plate(0, 0)) @ along / speed > 0.012).all()


def test_surface_in_other_units(clone):
    """A plate drawn in millimetres; checkGrains tells where the walls are."""
    case = dry_box(clone, [(0.05, 0.05, 0.0251)], 0.005)
    folder = case.path / "constant/triSurface"
    folder.mkdir()
    plate = "vertex 20 20 20 vertex 80 20 20 vertex {} 80 20"
    facets = [plate.format(80), plate.replace("80 20 20", "80 80 20", 1).format(20)]
    text = "".join(f"facet normal 0 0 1 outer loop {f} endloop endfacet\n" for f in facets)
    (folder / "plate.stl").write_text(f"solid plate\n{text}endsolid plate\n")
    add_wall(case, "plate", 'type surface; file "plate.stl"; scale 1e-3;')
    case.run("checkGrains")
    assert "Wall plate: 2 faces from (0.02 0.02 0.02) to (0.08 0.08 0.02)" in case.log
    assert "Wall box: 150 faces from (0 0 0) to (0.1 0.1 0.1)" in case.log
    control(case, endTime=0.1)
    case.run("dryGrainFoam")
    np.testing.assert_allclose(case.grains()["position"], [(0.05, 0.05, 0.025)], atol=1e-6)


@DIMENSIONS
def test_walls_may_be_in_another_order_after_a_restart(clone, dimension):
    """A lid that comes down and a floor that rises, which their numbers exchange."""
    start = np.full(dimension, 0.05)
    start[-1] = 0.02 + RADIUS
    floor = (
        f"type plane; point {vector(0.02 * up(dimension))}; normal {vector(up(dimension))};"
        f" motion {{ type translation; velocity {vector(0.2 * up(dimension))}; }}"
    )
    lid = (
        f"type plane; point {vector(0.09 * up(dimension))}; normal {vector(-up(dimension))};"
        f" motion {{ type translation; velocity {vector(-0.3 * up(dimension))}; }}"
    )
    cases = []
    for name in ("whole", "parts"):
        case = dry_box(clone, [start], RADIUS, dimension=dimension, name=name)
        add_wall(case, "floor", floor)
        add_wall(case, "lid", lid)
        control(case, endTime=0.04, writeInterval=20)
        cases.append(case)
    whole, parts = cases
    whole.run("dryGrainFoam")
    control(parts, endTime=0.02)
    parts.run("dryGrainFoam")
    file = parts.path / GRAINS
    text = file.read_text()
    for name in ("floor", "lid"):
        text = text.replace(f"    {name} {{", f"    other{name} {{")
    text = text.replace("    otherfloor {", "    lid {").replace("    otherlid {", "    floor {")
    text = text.replace(floor, "MOVED").replace(lid, floor).replace("MOVED", lid)
    file.write_text(text)
    control(parts, endTime=0.04)
    parts.run("dryGrainFoam")
    for t in ("position", "velocity"):
        np.testing.assert_allclose(parts.grains()[t], whole.grains()[t], atol=1e-12)


# Whose principal axes are turned from the frame of its centres
BENT = np.array([[-1.2, 0, 0], [0.5, 0.4, 0], [1.2, 1.3, 0]])


@pytest.mark.parametrize("turned", [True, False])
@DIMENSIONS
def test_a_cluster_of_a_file_lies_as_its_centres_do(clone, dimension, turned):
    """Turned by its quaternion if it has one.  It lay with its principal axes along the mesh, an
    elongated one up to 45 degrees from what its centres say."""
    case = dry_box(clone, [(0.05, 0.04, 0.06)[:dimension]], 0.02, dimension=dimension)
    centres = BENT + (0 if dimension == 2 else [[0, 0, 0.3], [0, 0, -0.2], [0, 0, 1.1]])
    points = " ".join(f"({x} {y} {z})" for x, y, z in centres)
    add(case, f"shapes {{ bent {{ type cluster; centres ({points}); radii (1 0.9 0.6); }} }}")
    axis = np.array([0, 0, 1] if dimension == 2 else [2, -1, 2]) / (1 if dimension == 2 else 3)
    half = 0.35 if turned else 0.0
    file = case.path / "constant/grains.csv"
    header, line = file.read_text().splitlines()
    q = ",".join(repr(float(u)) for u in (np.cos(half), *np.sin(half) * axis))
    if turned:
        file.write_text(f"{header},shape,qw,qx,qy,qz\n{line},bent,{q}\n")
    else:
        file.write_text(f"{header},shape\n{line},bent\n")
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=1e-3, endTime=1e-3, writeInterval=1)
    case.run("dryGrainFoam")
    case.run("foamToVTK -ascii -latestTime")
    (cloud,) = (case.path / "VTK").rglob("lagrangian/members/*.vtp")
    text = cloud.read_text().split("<Points>")[1].split(">", 1)[1].split("<")[0]
    members = np.array(text.split(), dtype=float).reshape(-1, 3)
    # Rodrigues's formula
    given = centres - centres[0]
    cross = np.cross(axis, given)
    given = given + np.sin(2 * half) * cross + (1 - np.cos(2 * half)) * np.cross(axis, cross)
    found = members - members[0]
    size = np.linalg.norm(found[1]) / np.linalg.norm(given[1])
    # The file has six digits
    np.testing.assert_allclose(found, size * given, atol=5e-7)


def test_packGrains_gives_clusters_as_it_takes_them(clone):
    case = dry_box(clone, [(0.05, 0.04)], 0.02, dimension=2)
    points = " ".join(f"({x} {y} {z})" for x, y, z in BENT)
    add(case, f"shapes {{ bent {{ type cluster; centres ({points}); radii (1 0.9 0.6); }} }}")
    file = case.path / "constant/grains.csv"
    header, line = file.read_text().splitlines()
    q = [np.cos(0.35), 0, 0, np.sin(0.35)]
    row = ",".join(map(repr, map(float, q)))
    (case.path / "constant/given.csv").write_text(
        f"{header},shape,qw,qx,qy,qz\n{line},bent,{row}\n"
    )
    (case.path / "system/packGrainsDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object packGrainsDict; }\n"
        'type csv; file "constant/given.csv"; material glass;\n'
    )
    case.run("packGrains")
    header, line = file.read_text().splitlines()
    values = dict(zip(header.split(","), line.split(",")))
    np.testing.assert_allclose([float(values[k]) for k in ("qw", "qx", "qy", "qz")], q, atol=1e-6)


def test_a_quaternion_of_another_length_is_refused(clone):
    """Of a disc, which shows it in no other way, too."""
    case = dry_box(clone, [(0.05, 0.04)], 0.02, dimension=2)
    file = case.path / "constant/grains.csv"
    header, line = file.read_text().splitlines()
    file.write_text(f"{header},qw,qx,qy,qz\n{line},1,1,0,0\n")
    assert case.run("dryGrainFoam", check=False) == 1
    for fragment in ("grains.csv", "line 2", "qw,qx,qy,qz", "a quaternion of length 1"):
        assert fragment in case.log
