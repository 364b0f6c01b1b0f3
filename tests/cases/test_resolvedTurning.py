# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resolved grains that turn, and that move through cells of different sizes."""

import re

import numpy as np
import pytest
from cluster_box import ROD, make_clusters
from grain_box import control, grain_box, make_cyclic, replace, tracks
from test_cutCells import choose
from water_box import level, water_box

GRAINS = "constant/grainProperties"
OMEGA = 20.0


def spinning(clone, name, rod="", y=0.05, velocity=(0, 0), density=8000, radius=0.015, dt=5e-4):
    """A disc, or a cluster, that turns in a box of 40 x 40 cells of water without weight."""
    case = grain_box(clone, [(0.05, y)], radius, velocity=[velocity], name=name)
    path = case.path / GRAINS
    text = re.sub(r"friction +0\.\d;", "friction 1; restitution 0.9;", path.read_text())
    path.write_text(text.replace("density 2500", f"density {density}"))
    file = case.path / "constant/grains.csv"
    header, line = file.read_text().splitlines()
    if rod:
        make_clusters(case, rod, 0.7, OMEGA)
    else:
        file.write_text(f"{header},wx,wy,wz\n{line},0,0,{OMEGA}\n")
    replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
    case.run("blockMesh")
    replace(case, "constant/transportProperties", "1e-4", "1e-6")
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=dt, endTime=4e-3, writeInterval=1000)
    return case


# 17.8 and 10.9: with the inertia that fluid adds to a plate.  The pressure within the rod, which
# holds its cells together, once took a fifth of the spin in each step, however short.
@pytest.mark.parametrize("density, low, high", [(8000, 17.2, 18.1), (1200, 10.2, 11.4)])
def test_a_rod_keeps_its_spin_whatever_the_step(clone, density, low, high):
    spins = []
    for dt in (5e-4, 1.25e-4):
        case = spinning(clone, f"rod{dt}", ROD, density=density, dt=dt)
        case.run("grainFoam")
        spins.append(tracks(case)[-1, 10])
    assert low < min(spins) and max(spins) < high
    assert spins[0] == pytest.approx(spins[1], rel=0.01)


def test_ranks_agree_on_a_rod(clone):
    one, two = (spinning(clone, name, ROD) for name in ("one", "two"))
    one.run("grainFoam")
    two.run("decomposePar")
    two.parallel("grainFoam", 2)
    np.testing.assert_allclose(tracks(two)[:, 10], tracks(one)[:, 10], rtol=1e-6)


def write_U(case, velocity, sides, n=20):
    """U(x, y) in n x n cells and on the sides of the box, as (n, 2) arrays about its middle."""
    s = (np.arange(n) + 0.5) * 0.1 / n - 0.05
    x, y = np.meshgrid(s, s)

    def vectors(x, y):
        pairs = np.column_stack([np.ravel(u) for u in velocity(x, y)])
        rows = "".join(f"({u} {v} 0)\n" for u, v in pairs)
        return f"nonuniform List<vector> {np.size(x)}(\n{rows})"

    edges = {
        "left": (0 * s - 0.05, s),
        "right": (0 * s + 0.05, s),
        "bottom": (s, 0 * s - 0.05),
        "top": (s, 0 * s + 0.05),
    }
    patches = "".join(
        f"{name} {{ type fixedValue; value {vectors(*edges[name])}; }}\n"
        if name in sides
        else f"{name} {{ type cyclic; }}\n"
        for name in edges
    )
    (case.path / "0/U").write_text(
        "FoamFile { version 2.0; format ascii; class volVectorField; object U; }\n"
        f"dimensions [0 1 -1 0 0 0 0];\ninternalField {vectors(x, y)};\n"
        f"boundaryField {{ {patches} frontAndBack {{ type empty; }} }}\n"
    )


def shear_fluid(case, shear, n=20):
    """Between the bottom and the top of a box without ends."""
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    write_U(case, lambda x, y: (shear * y, 0 * y), ["bottom", "top"], n)
    patches = '"left|right" { type cyclic; } "bottom|top"'
    replace(case, "0/p_rgh", '"left|right|bottom|top"', patches)
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")


def turn_fluid(case, omega, n=20):
    """As a body, through the sides of the box."""
    path = case.path / "system/blockMeshDict"
    path.write_text(re.sub(r"(\w+\n +\{\n +type +)wall;", r"\1patch;", path.read_text()))
    case.run("blockMesh")
    write_U(case, lambda x, y: (-omega * y, omega * x), ["left", "right", "bottom", "top"], n)
    replace(case, "0/p_rgh", "zeroGradient", "fixedFluxPressure; value uniform 0")


def turning_with_the_fluid(clone, radius, spin, nu, name=None):
    """A disc of the fluid's density in the middle, without weight."""
    case = grain_box(clone, [(0.05, 0.05)], radius, name=name)
    file = case.path / "constant/grains.csv"
    header, line = file.read_text().splitlines()
    file.write_text(f"{header},wz\n{line},{spin}\n")
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    replace(case, GRAINS, "density 2500", "density 1000")
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/transportProperties", "1e-4", repr(nu))
    replace(case, "system/fvSchemes", "U)   Gauss linear", "U)   Gauss linearUpwind grad(U)")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    return case


# Faces of a staircase that do not turn are a rough wall to the fluid that does: the spin was 0.40,
# 0.16 and 0.15 of the shear rate, the less the shorter the steps
@pytest.mark.parametrize(
    "Re, courant, low, high", [(1, 0.2, 0.48, 0.51), (1, 0.04, 0.48, 0.51), (10, 0.2, 0.41, 0.45)]
)
def test_a_disc_turns_with_the_shear(clone, Re, courant, low, high):
    """Half of the shear rate in creeping flow, less with inertia (0.41 in cut cells at Re 10)."""
    shear, radius = 10.0, 0.01
    case = turning_with_the_fluid(clone, radius, -shear / 2, shear * (2 * radius) ** 2 / Re)
    shear_fluid(case, shear)
    dt = courant * 0.005 / (shear * 0.05)
    steps = round((0.1 if Re < 5 else 0.5) / dt)
    control(case, deltaT=dt, endTime=dt * steps, writeInterval=steps)
    case.run("grainFoam")
    assert low < -case.grains()["spin"][0] / shear < high


def test_a_disc_turns_with_fluid_that_turns_as_a_body(clone):
    """In 1/10 of a turn it lost up to 0.9 of its spin, the more the finer the cells."""
    omega = 5.0
    case = turning_with_the_fluid(clone, 0.016, omega, 1e-5)
    turn_fluid(case, omega)
    steps = 200
    dt = 0.1 * 2 * np.pi / omega / steps
    control(case, deltaT=dt, endTime=dt * steps, writeInterval=steps)
    case.run("grainFoam")
    assert case.grains()["spin"][0] / omega == pytest.approx(1, abs=0.02)


@pytest.mark.parametrize("angle", [0.5, -0.5])
def test_a_rod_in_the_surface_turns_level(clone, angle):
    """Half of the water's density; the water's pressure once had no moment on it."""
    case = water_box(clone, level(0.05), [(0.05, 0.05)], 0.025, (40, 40))
    replace(case, GRAINS, "density 2500", "density 500")
    make_clusters(case, ROD, angle)
    control(case, deltaT=5e-4, endTime=0.12, writeInterval=20)
    case.run("grainInterFoam")
    angles = np.array([case.grains(time)["orientation"][0] for time in case.times[1:]])
    # A quarter of its swing, with the inertia of half of the water around a plate: 0.08 s
    level_again = np.argmax(angles * np.sign(angle) < 0)
    assert 0.04 < float(case.times[1:][level_again]) <= 0.1
    assert np.all(np.abs(angles) < 0.5)


@pytest.mark.parametrize("kind", ["locked", "cutCells"])
@pytest.mark.parametrize("density", [500, 1200, 8000])
def test_a_wall_that_holds_leaves_the_spin_of_what_turns(clone, kind, density):
    """Twice its volume of fluid moves with the disc, none turns with it: where the surface stops,
    v + impulse/(s m) + spin r + 2 impulse/m = 0, v being what the fluid has given it along the
    wall.  A third would be left without a fluid; it had -4 times the spin at half of the fluid's
    density, as what the wall did to a fluid that turns with it came back as spin, and then a third,
    as if of a mass of its inertia."""
    case = spinning(clone, "disc", y=0.015, velocity=(0, -0.6), density=density, radius=0.01)
    resolved = f"\ncoupling\n{{\n    resolvedGrains {{ type {kind}; }}"
    replace(case, GRAINS, "\ncoupling\n{", resolved)
    control(case, endTime=0.04)
    case.run("grainFoam")
    table = tracks(case)
    spin, along, up = table[:, 10], table[:, 5], table[:, 6]
    bounce = int(np.argmax(up > 0))
    assert bounce > 3
    # The last step before it, and a few after: viscosity takes a little, too
    ratio = spin[bounce : bounce + 6] / spin[bounce - 1]
    heaviness = 1 + 2000 / density
    drift = along[bounce - 1] / (0.01 * spin[bounce - 1])
    assert np.all(np.abs(ratio - (1 - 2 * heaviness * drift) / (2 * heaviness + 1)) < 0.03)


@pytest.mark.parametrize("density, rho, nu", [(1000, 1.2, 1.6e-5), (8000, 1000, 1e-6)])
def test_cells_that_grow_do_not_push_a_grain(clone, density, rho, nu):
    """Cells of one edge of the box are 4 times those of the other, by 3 % from each to the next.
    In gas it gained a third of its speed, the more the shorter the steps."""

    def speed(grading, dt):
        name = f"g{grading}_{dt}"
        case = grain_box(clone, [(0.02, 0.05)], 0.0045, velocity=[(1.2, 0)], name=name)
        replace(case, "system/blockMeshDict", "(10 10 1)", "(44 44 1)")
        graded = f"simpleGrading ({grading} 1 1)"
        replace(case, "system/blockMeshDict", "simpleGrading (1 1 1)", graded)
        case.run("blockMesh")
        replace(case, GRAINS, "density 2500", f"density {density}")
        replace(case, "constant/g", "-9.81", "0")
        fluid = "constant/transportProperties"
        replace(case, fluid, "rho     [1 -3 0 0 0 0 0] 1000;", f"rho {rho};")
        replace(case, fluid, "1e-4;", f"{nu};")
        control(case, deltaT=dt, endTime=0.02, writeInterval=1000)
        case.run("grainFoam")
        return tracks(case)[-1, 5]

    even, graded, shorter = speed(1, 2.5e-4), speed(4, 2.5e-4), speed(4, 6.25e-5)
    # Cells of 0.55 to 2 times the size have other drag in water
    assert graded == pytest.approx(even, rel=0.005 if rho < 2 else 0.12)
    # 0.7 % less on cells of one size, 1.9 % more here
    assert shorter == pytest.approx(graded, rel=0.005 if rho < 2 else 0.03)


def test_a_disc_rolls_as_far_with_longer_steps(clone):
    """Under a viscous fluid, without slip.  Friction gives back the spin the fluid takes: while
    the torque knew of the free spin alone it went 1.15 times as far with 4 ms as with 1 ms."""
    ways = []
    for dt in (4e-3, 1e-3):
        case = choose(grain_box(clone, [(0.03, 0.01)], 0.01, name=f"{dt}"), "locked")
        replace(case, "system/blockMeshDict", "(10 10 1)", "(40 40 1)")
        case.run("blockMesh")
        replace(case, GRAINS, "friction    0.2;", "friction    1;")
        replace(case, "constant/g", "(0 -9.81 0)", "(2 -9 0)")
        replace(case, "constant/transportProperties", "1e-4", "1e-3")
        replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
        control(case, deltaT=dt, endTime=0.48, writeInterval=1000)
        case.run("grainFoam")
        last = tracks(case)[-1]
        assert -last[10] * 0.01 == pytest.approx(last[5], rel=1e-6)
        ways.append(last[2] - 0.03)
    assert ways[0] == pytest.approx(ways[1], rel=0.1)
