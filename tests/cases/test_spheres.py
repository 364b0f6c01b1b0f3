# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres in a fluid: volume and momentum on meshes of any cells, rest, settling, spin, restart."""

import numpy as np
import pytest
from dry_box import GRAINS, cubic
from grain_box import (
    assert_same_grains,
    control,
    ledger,
    make_cyclic,
    replace,
    run_whole_and_parts,
    tracks,
)
from sphere_box import SIDE, cell_volumes, decompose, field, random_spheres, sphere_box
from test_restart import track_lines

MESHES = ["hexahedra", "warped", "tetrahedra"]


def ball(radius):
    return 4 / 3 * np.pi * radius**3


def spheres_of_all_sizes():
    """Cell size over diameter from 1/8 to 30 in cells of a tenth of the side."""
    rng = np.random.default_rng(3)
    h = SIDE / 10
    radii = [*np.full(20, h / 60), *np.full(20, h / 6), *np.full(10, h / 2), h, 1.5 * h, 4 * h]
    centres, radii = random_spheres(rng, radii)
    # On a face, an edge and a vertex of the hexahedra
    places = np.array([[0.5, 0.53, 0.57], [0.5, 0.6, 0.97], [0.1, 0.1, 0.1]])
    distance = np.linalg.norm(centres[:, None] - places * SIDE, axis=2)
    far = np.all(distance > radii[:, None] + 3e-4, axis=1)
    return np.vstack([centres[far], places * SIDE]), np.append(radii[far], [2e-4, 2e-4, 2e-4])


def one_step(case, write_interval=1):
    control(case, deltaT=1e-5, endTime=1e-5, writeInterval=write_interval)
    replace(case, "constant/g", "-9.81", "0")


@pytest.mark.parametrize("mesh", MESHES)
def test_cells_hold_the_volume_of_the_spheres(clone, mesh):
    centres, radii = spheres_of_all_sizes()
    case = sphere_box(clone, centres, radii, mesh)
    one_step(case)
    case.run("grainFoam")
    book = ledger(case)
    assert book["mappingError"].max() <= 1e-12
    np.testing.assert_allclose(book["grainVolume"], ball(radii).sum(), rtol=1e-11)
    np.testing.assert_allclose(book["mappedVolume"], ball(radii).sum(), rtol=1e-11)
    assert book["overfull"].max() <= 1e-12 * ball(radii).sum()

    eps = field(case, "eps")
    assert 0 <= eps.min() < 1e-12
    assert cell_volumes(case) @ (1 - eps) == pytest.approx(ball(radii).sum(), rel=1e-12)


@pytest.mark.parallel
@pytest.mark.parametrize("mesh", ["hexahedra", "tetrahedra"])
def test_ranks_share_the_spheres(clone, mesh):
    """The largest sphere spans all ranks; some are on the faces between them."""
    centres, radii = spheres_of_all_sizes()
    eps = []
    for ranks in (1, 2, 4):
        case = sphere_box(clone, centres, radii, mesh, name=f"ranks{ranks}")
        one_step(case)
        if ranks == 1:
            case.run("grainFoam")
        else:
            decompose(case, ranks)
            case.parallel("grainFoam", ranks)
            case.run("reconstructPar")
        assert ledger(case)["mappingError"].max() <= 1e-12
        eps.append(field(case, "eps"))
    # 12 digits are written
    np.testing.assert_allclose(eps[1], eps[0], rtol=0, atol=2e-12)
    np.testing.assert_allclose(eps[2], eps[0], rtol=0, atol=2e-12)


def test_sphere_partly_outside_is_reported(clone):
    """A cap of half the radius is beyond an open boundary."""
    radius = 0.012
    case = sphere_box(clone, [(SIDE - radius / 2, 0.05, 0.05)], radius)
    replace(case, GRAINS, '(".*")', "(left)")
    one_step(case)
    case.run("grainFoam")
    cap = np.pi * radius**3 * 5 / 24
    book = ledger(case)
    assert book["grainVolume"][0] - book["mappedVolume"][0] == pytest.approx(cap, rel=1e-11)
    # Only of grains that are wholly within
    assert book["mappingError"][0] == 0


@pytest.mark.parametrize("mesh", MESHES)
def test_neutrally_buoyant_spheres_stay_at_rest(clone, mesh):
    """Spheres that touch each other and the walls, and one that floats."""
    radius = SIDE / 10
    pile = cubic(5, 5, 1, 2 * radius, (radius, radius, radius))
    start = np.vstack([pile, [(0.043, 0.057, 0.061)]])
    case = sphere_box(clone, start, radius, mesh, n=8)
    replace(case, GRAINS, "density 2500", "density 1000")
    control(case, endTime=0.02, writeInterval=20)
    case.run("grainFoam")
    # Round-off of g dt = 1e-2 m/s per step
    assert np.abs(field(case, "U")).max() <= 1e-10
    grains = case.grains()
    assert np.abs(grains["velocity"]).max() <= 1e-10
    np.testing.assert_allclose(grains["position"], start, rtol=0, atol=1e-12)


def falling_spheres(clone, mesh="hexahedra", name=None):
    """A cloud that falls upon the floor and itself."""
    rng = np.random.default_rng(6)
    centres = cubic(4, 4, 3, 0.0235, (0.0145, 0.0145, 0.0085)) + rng.uniform(-1e-3, 1e-3, (48, 3))
    case = sphere_box(clone, centres, 0.007, mesh, name=name)
    control(case, endTime=0.06, deltaT=2e-3, writeInterval=15)
    return case


@pytest.mark.parametrize("mesh", MESHES)
def test_momentum_is_exchanged_both_ways(clone, mesh):
    case = falling_spheres(clone, mesh)
    case.run("grainFoam")
    book = ledger(case)
    assert len(book["time"]) == 30
    assert book["active"].max() >= 5
    assert book["momentumError"].max() <= 1e-10
    # The tolerance of the pressure equation is an absolute one of 1e-12
    assert book["divergence"].max() <= 1e-8
    before = book["active"] == 0
    assert book["mappingError"][before].max() <= 1e-12


@pytest.mark.parallel
@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks_agree(clone, ranks):
    one = falling_spheres(clone, name="one")
    one.run("grainFoam")
    many = falling_spheres(clone, name="many")
    decompose(many, ranks)
    many.parallel("grainFoam", ranks)
    # What the contact solver's tolerance leaves uncertain
    difference = one.grains()["position"] - many.grains()["position"]
    assert np.abs(difference).max() <= 1e-7
    assert ledger(many)["momentumError"].max() <= 1e-10
    assert tracks(many).shape == tracks(one).shape


@pytest.mark.parametrize("mesh", ["hexahedra", "tetrahedra"])
def test_stop_and_restart(clone, mesh):
    whole, parts = (falling_spheres(clone, mesh, name=name) for name in ("a", "b"))
    for case in (whole, parts):
        control(case, writeFormat="binary")
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.03, end=0.06)
    assert "The grains continue from" in parts.log
    assert_same_grains(whole, parts)
    for name in ("U", "p", "p_rgh", "eps"):
        np.testing.assert_array_equal(field(whole, name), field(parts, name), err_msg=name)
    assert track_lines(whole) == track_lines(parts)
    # Position of each sphere in the cloud for ParaView
    assert (whole.path / whole.times[-1] / "lagrangian/grains/positions").exists()


def settling_sphere(clone, cells, n, end, deltaT, name=None):
    """A sphere whose terminal speed is 0.02990 m/s by Dallavalle's law, cells per diameter."""
    d, rho, rho_grain, nu = 2.663e-3, 996.78, 1029.0, 8.379e-7
    side = n * d / cells
    start = [(0.52 * side, 0.53 * side, 0.94 * side)]
    case = sphere_box(clone, start, d / 2, side=side, n=n, name=name)
    replace(case, "constant/transportProperties", "0] 1000", f"0] {rho}")
    replace(case, "constant/transportProperties", "1e-4", str(nu))
    replace(case, GRAINS, "density 2500", f"density {rho_grain}")
    control(case, deltaT=deltaT, endTime=end, writeInterval=round(end / deltaT))
    return case


def test_a_sphere_settles_at_the_speed_of_the_drag_law(clone):
    """In cells of four diameters what is put in comes out."""
    case = settling_sphere(clone, 0.25, 10, 2, 1e-2)
    case.run("grainFoam")
    path = tracks(case)
    speed = -path[path[:, 0] > 1, 7]
    # The sphere is 0.8 % of its cell, whose fluid it drags along
    assert speed.mean() == pytest.approx(0.02990, rel=0.02)
    assert np.ptp(speed) <= 0.02 * speed.mean()


def test_a_sphere_as_large_as_a_cell_is_given_the_undisturbed_flow(clone):
    """Of its own cell it would have the fluid fraction of a suspension, and settle too slowly."""
    speed = {}
    for kind in ("none", "filtered"):
        case = settling_sphere(clone, 1, 14, 0.7, 5e-3, name=kind)
        replace(
            case, GRAINS, "coupling\n{", f"coupling\n{{\n    undisturbedFlow {{ type {kind}; }}"
        )
        case.run("grainFoam")
        path = tracks(case)
        speed[kind] = -path[path[:, 0] > 0.4, 7].mean()
    # Some 5 % are left, and the speed varies by 2 % as the sphere passes cells
    assert speed["filtered"] == pytest.approx(0.02990, rel=0.1)
    assert speed["none"] < 0.93 * speed["filtered"]


@pytest.mark.parametrize(
    "n, low, high",
    [(4, 0.48, 0.505), (8, 0.48, 0.505), (10, 0.48, 0.505), (16, 0.485, 0.515)],
)
def test_shear_turns_a_sphere_about_the_axis_of_vorticity(clone, n, low, high):
    """Oblique to the mesh; spin over shear rate.  Cells of a diameter, a half and 0.4 of one give
    it half their vorticity (0.466 and 0.473 where moments of so few cells turned it); with four to
    a diameter the sphere is resolved: half of it at Re -> 0, to 3 %."""
    speed, direction = 0.005, np.array([0.6, 0, 0.8])
    case = sphere_box(clone, [(0.05, 0.05, 0.05)], 0.0125, n=n)
    make_cyclic(case, ("left", "right"), ("back", "front"))
    case.run("blockMesh")
    lids = "".join(
        f"{patch} {{ type fixedValue; value uniform ({u[0]} {u[1]} {u[2]}); }}\n"
        for patch, u in (("top", speed * direction), ("bottom", -speed * direction))
    )
    sides = '"left|right|back|front"'
    no_slip = '".*"\n    {\n        type    noSlip;\n    }'
    replace(case, "0/U", no_slip, f"{sides} {{ type cyclic; }} {lids}")
    replace(case, "0/p_rgh", '".*"', f'{sides} {{ type cyclic; }} "bottom|top"')
    replace(case, "constant/transportProperties", "1e-4", "1e-2")
    replace(case, GRAINS, "density 2500", "density 1000")
    replace(case, GRAINS, '(".*")', "(bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    # Four times the height's diffusion time
    control(case, deltaT=5e-3, endTime=1, writeInterval=200)
    case.run("grainFoam")

    spin = tracks(case)[-1, 8:11] / (2 * speed / SIDE)
    axis = np.cross([0, 1, 0], direction)
    assert low <= spin @ axis <= high
    assert np.linalg.norm(spin - (spin @ axis) * axis) <= 1e-4


# Two correctors of the pressure let it grow by a factor of 1.4 in each step
@pytest.mark.parametrize("ratio", [1, 1000])
def test_a_resolved_sphere_in_a_narrow_box_comes_to_rest(clone, ratio):
    """Gaps of 1.3 cells, steps of nu dt/h^2 = 9; the fluid is as dense or a thousand times."""
    side, n, speed = 0.1, 7, 0.1
    radius, h = 0.32 * side, side / n
    case = sphere_box(clone, [(0.0503, 0.0507, 0.051)], radius, n=n, velocity=[(speed, 0, 0)])
    replace(case, "system/fvSolution", "nCorrectors     2;", "nCorrectors     3;")
    replace(case, "constant/transportProperties", "1000;", f"{2500 * ratio};")
    replace(case, "constant/transportProperties", "1e-4;", f"{10 * speed * 2 * radius};")
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=0.2 * h / speed, endTime=4 * h / speed, writeInterval=20)
    case.run("grainFoam")
    fastest = case.table("postProcessing/ledger/0/ledger.csv")["maxVelocity"]
    assert fastest.max() < 0.1 * speed
    assert fastest[-1] < 1e-3 * fastest[0]


@pytest.mark.parametrize("density", [1000, 2500])
def test_clusters_count_once_where_their_spheres_overlap(clone, density):
    """Two equal spheres, the centre of each on the other's surface, one above the other."""
    case = sphere_box(clone, [(0.05, 0.05, 0.05)], 0.015, "tetrahedra")
    shape = "shapes { pair { type cluster; centres ((0 0 0) (0 0 3)); radii (3 3); } }\n"
    replace(case, GRAINS, "initialGrains\n{", shape + "initialGrains\n{")
    lines = (case.path / "constant/grains.csv").read_text().splitlines()
    (case.path / "constant/grains.csv").write_text(f"{lines[0]},shape\n{lines[1]},pair\n")
    replace(case, GRAINS, "density 2500", f"density {density}")
    control(case, endTime=0.02, writeInterval=20)
    case.run("grainFoam")

    # The radius is that of the sphere around both: 3/2 of theirs
    volume = 27 / 16 * ball(0.01)
    book = ledger(case)
    np.testing.assert_allclose(book["mappedVolume"], volume, rtol=1e-11)
    # Volumes of clusters, and with them their masses, are known to 1e-8
    np.testing.assert_allclose(book["grainVolume"], volume, rtol=1e-7)
    velocity = case.grains()["velocity"][0]
    if density == 1000:
        assert np.abs(velocity).max() <= 1e-7 * 9.81 * 0.02
    else:
        assert book["momentumError"].max() <= 1e-10
        assert -9.81 * 0.02 < velocity[2] < -0.01


@pytest.mark.parametrize(("n", "centre"), [(5, 0.05), (5, 0.06), (25, 0.052)])
def test_fluid_stops_a_small_sphere_that_spins(clone, n, centre):
    """Stokes' torque, in the middle of a cell of five diameters, at the corner of one, and in cells
    of one; 50 steps, implicit: 2 to 3 % more is left."""
    radius, nu, spin, time = 0.002, 2e-5, 20.0, 0.05
    case = sphere_box(clone, [(centre,) * 3], radius, n=n)
    row = f"{centre},{centre},{centre},{radius},0,0,0,0,0,{spin}\n"
    (case.path / "constant/grains.csv").write_text("x,y,z,radius,vx,vy,vz,wx,wy,wz\n" + row)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/transportProperties", "1e-4", str(nu))
    control(case, deltaT=1e-3, endTime=time, writeInterval=50)
    case.run("grainFoam")
    left = spin * np.exp(-15 * nu * 1000 / (2500 * radius**2) * time)
    assert case.grains()["spin"][0, 2] == pytest.approx(left, rel=0.04)
