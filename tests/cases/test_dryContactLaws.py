# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam: attraction and resistance to rolling of grains that move."""

import numpy as np
import pytest
from dry_box import GRAINS, G, dry_box, write_facets
from grain_box import DEPTH, assert_same_grains, control, ledger, replace, tracks

RADIUS = 0.004
DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3])


def weight(dimension):
    volume = np.pi * RADIUS**2 * DEPTH if dimension == 2 else 4 / 3 * np.pi * RADIUS**3
    return 2500 * volume * G


def set_law(case, law):
    """The same for all contacts."""
    text = (case.path / GRAINS).read_text()
    begin, end = text.index("contactLaws"), text.index("walls\n{")
    laws = f"contactLaws\n{{\n    default {{ {law} }}\n}}\n\n"
    (case.path / GRAINS).write_text(text[:begin] + laws + text[end:])


def set_gravity(case, dimension, up):
    down = "(0 -9.81 0)" if dimension == 2 else "(0 0 -9.81)"
    value = np.zeros(3)
    value[dimension - 1] = up
    replace(case, "constant/g", down, "({} {} {})".format(*value))


def write_spinning(case, rows):
    """constant/grains.csv of x, y, z, vx, vy, vz, wx, wy, wz."""
    lines = ["x,y,z,vx,vy,vz,wx,wy,wz,radius"]
    lines += [",".join(repr(float(value)) for value in [*row, RADIUS]) for row in rows]
    (case.path / "constant/grains.csv").write_text("\n".join([*lines, ""]))


@pytest.mark.parametrize("spin", [10.0, 40.0])
@pytest.mark.parametrize("dt", [1e-3, 2.5e-4])
@DIMENSIONS
def test_pair_that_attracts_turns_as_one(clone, dimension, dt, spin):
    """Whatever the step, up to 0.04 rad: it goes round as often as its spin says.

    The attraction is 23 times the centrifugal force and more.
    """
    case = dry_box(clone, [(0.05,) * dimension], RADIUS, dimension=dimension)
    set_gravity(case, dimension, 0.0)
    set_law(case, "type cohesive; friction 1; cohesion 0.1;")
    half = np.array([RADIUS * (1 + 1e-4), 0, 0])
    centre = np.array([0.05, 0.05, 0.05 if dimension == 3 else DEPTH / 2])
    approach = np.array([0.01, 0, 0])   # a contact attracts once it has carried a load
    turning = np.array([0, spin * RADIUS, 0])
    rows = [(*(centre + s * half), *(s * (turning - approach)), 0, 0, spin) for s in (-1, 1)]
    write_spinning(case, rows)
    control(case, deltaT=dt, endTime=0.2, writeInterval=round(0.2 / dt))
    case.run("dryGrainFoam")
    book = ledger(case)
    assert (book["active"][2:] == 1).all()
    lines = tracks(case)
    apart = (lines[1::2] - lines[::2])[:, 2:4]
    gap = np.hypot(*apart.T) / RADIUS - 2
    # The gap beyond which there is no attraction
    assert gap.max() <= 5e-3
    angle = np.unwrap(np.arctan2(apart[:, 1], apart[:, 0]))
    # The gap takes 0.5 % of the rate at most, the first impact none
    assert angle[-1] - angle[0] == pytest.approx(spin * (0.2 - dt), rel=6e-3)


def write_ceiling(case, angle):
    """Two strips that meet at x = 0.05, z = 0.08, at an angle; > 0 for a ridge."""
    rise = 0.05 * np.tan(angle / 2)
    ends = [(0.0, 0.08 + rise), (0.05, 0.08), (0.1, 0.08 + rise)]
    facets = []
    for (a, b), (c, d) in zip(ends[:-1], ends[1:], strict=True):
        corners = [(a, b, -0.1), (c, d, -0.1), (c, d, 0.1), (a, b, 0.1)]
        facets += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    write_facets(case, "ceiling", facets)


@pytest.mark.parametrize("delay", [0.0, 0.02])
@pytest.mark.parametrize("degrees", [-2.0, 0.1, 5.0])
def test_disc_goes_over_the_kink_of_a_ceiling(clone, degrees, delay):
    """It hangs by five times its weight, pressed on until the contact is old enough."""
    angle = np.radians(degrees)
    normal = np.array([-np.sin(angle / 2), -np.cos(angle / 2)])
    start = np.array([0.03, 0.08 + 0.02 * np.tan(angle / 2)]) + (RADIUS + 1e-8) * normal
    speed = 0.2 * np.array([np.cos(angle / 2), -np.sin(angle / 2)])
    case = dry_box(clone, [start], RADIUS, [speed], dimension=2)
    replace(case, GRAINS, "(left right bottom top)", "(left right bottom)")
    ceiling = 'type surface; file "ceiling.stl"; material steel;'
    replace(case, GRAINS, "walls\n{\n", f"walls\n{{\n    ceiling {{ {ceiling} }}\n")
    write_ceiling(case, angle)
    law = f"type cohesive; friction 0; cohesion {5 * weight(2)}; cohesionDelay {delay};"
    set_law(case, law)
    set_gravity(case, 2, G)
    control(case, endTime=0.04, writeInterval=40)
    case.run("dryGrainFoam")
    replace(case, "constant/g", f"{G}", f"-{G}")
    control(case, endTime=0.25, writeInterval=50)
    case.run("dryGrainFoam")
    position = case.grains()["position"][0]
    assert position[0] > 0.07
    # As far from the ceiling as it attracts, half a per cent of the radius, at most
    height = 0.08 + abs(position[0] - 0.05) * np.tan(angle / 2) - position[1]
    assert height * np.cos(angle / 2) == pytest.approx(RADIUS, abs=5e-3 * RADIUS)


@DIMENSIONS
def test_grain_slides_along_a_ceiling_of_patches(clone, dimension):
    """Faces of the mesh, in three dimensions quads cut into triangles."""
    start = np.full(dimension, 0.023)
    start[-1] = 0.1 - RADIUS
    velocity = 0.2 * np.eye(dimension)[0]
    cases = [
        dry_box(clone, [start], RADIUS, [velocity], dimension=dimension, name=n) for n in "ab"
    ]
    for case in cases:
        law = f"type cohesive; friction 0; cohesion {5 * weight(dimension)}; cohesionDelay 0.01;"
        set_law(case, law)
        set_gravity(case, dimension, G)
        control(case, endTime=0.02, writeInterval=20)
        case.run("dryGrainFoam")
        replace(case, "constant/g", f"{G}", f"-{G}")
    whole, parts = cases
    control(whole, endTime=0.3, writeInterval=20)
    whole.run("dryGrainFoam")
    # A restart as it passes from one facet to the next
    for time in (0.14, 0.18, 0.3):
        control(parts, endTime=time)
        parts.run("dryGrainFoam")
    assert_same_grains(whole, parts)
    end = whole.grains()["position"][0]
    assert end[0] == pytest.approx(0.083, abs=1e-6)
    assert end[-1] == pytest.approx(0.1 - RADIUS, abs=5e-3 * RADIUS)


@pytest.mark.parallel
@DIMENSIONS
def test_ranks_agree_on_grains_that_attract_and_roll(clone, dimension):
    """A cloud that flies into a corner of the box and clings to it: the same bit for bit."""
    random = np.random.default_rng(2)
    places = np.stack(np.meshgrid(*dimension * [np.arange(5)], indexing="ij"), axis=-1)
    centres = 0.01 + 0.009 * places.reshape(-1, dimension)
    centres += random.uniform(-4e-4, 4e-4, centres.shape)
    velocity = np.full(centres.shape, -1.0)
    one, many = (dry_box(clone, centres, RADIUS, velocity, dimension, name=n) for n in "ab")
    for case in (one, many):
        pull = 5 * weight(dimension)
        law = f"cohesion {pull}; cohesionDelay 0.01; restitution 0.5; rolling 0.2; friction 0.5;"
        set_law(case, f"type cohesive; {law}")
        control(case, endTime=0.1, writeInterval=100)
    one.run("dryGrainFoam")
    many.run("decomposePar")
    many.parallel("dryGrainFoam", 2)
    assert ledger(one)["active"].max() > 30
    assert_same_grains(one, many)


def test_wall_beside_a_grain_that_lies_on_another_does_not_attract(clone):
    """The floor's contact is old, that with the wall was never one."""
    start = (RADIUS * 1.001, RADIUS)
    case = dry_box(clone, [start], RADIUS, dimension=2)
    set_law(case, f"type cohesive; friction 0; cohesion {5 * weight(2)};")
    case.run("dryGrainFoam")
    np.testing.assert_allclose(case.grains()["position"], [start], atol=50e-7 * 1e-3)


@pytest.mark.parametrize("restitution", [0.0, 1e-3, 0.5, 1.0])
@DIMENSIONS
def test_rolling_is_resisted_in_an_impact(clone, dimension, restitution):
    """A disc or sphere that rolls as it lands loses (1 + e) k_r |u_n|/(1 + k^2) of its speed."""
    case = dry_box(clone, [(0.05,) * dimension], RADIUS, dimension=dimension)
    set_gravity(case, dimension, 0.0)
    rolling, speed, fall = 0.1, 0.3, 1.0
    set_law(
        case, f"type Coulomb; friction 0.5; rolling {rolling}; restitution {restitution};"
    )
    height = RADIUS + 0.0052
    spin = (0, 0, -speed / RADIUS) if dimension == 2 else (0, speed / RADIUS, 0)
    if dimension == 2:
        row = (0.02, height, DEPTH / 2, speed, -fall, 0, *spin)
    else:
        row = (0.02, 0.02, height, speed, 0, -fall, *spin)
    write_spinning(case, [row])
    control(case, endTime=0.02, writeInterval=20)
    case.run("dryGrainFoam")
    grain = case.grains()
    velocity, turning = grain["velocity"][0], np.ravel(grain["spin"][0])
    k2 = 1 / 2 if dimension == 2 else 2 / 5
    left = speed - (1 + restitution) * rolling * fall / (1 + k2)
    # The tolerance over a step is 1e-4 m/s in contacts that last, next to nothing in impacts
    assert velocity[0] == pytest.approx(left, abs=1e-4 if restitution == 0 else 1e-8)
    assert velocity[dimension - 1] == pytest.approx(restitution * fall, abs=1e-4)
    assert np.linalg.norm(turning) * RADIUS == pytest.approx(left, abs=2e-4)


@DIMENSIONS
def test_impacts_with_resistance_to_rolling_give_no_energy(clone, dimension):
    """Grains of many sizes, spins and speeds: no step of 150 raises their energy."""
    random = np.random.default_rng(5)
    places = np.stack(np.meshgrid(*dimension * [np.arange(4)], indexing="ij"), axis=-1)
    centres = 0.02 + 0.015 * places.reshape(-1, dimension)
    centres += random.normal(size=centres.shape) * 1e-3
    case = dry_box(clone, [(0.05,) * dimension], RADIUS, dimension=dimension)
    set_gravity(case, dimension, 0.0)
    set_law(case, "type Coulomb; friction 0.5; rolling 0.3; restitution 0.9;")
    rows = []
    for centre in centres:
        velocity = 10 * (0.0425 - centre) + random.normal(size=dimension) * 0.1
        spin = random.normal(size=3) * 100 * ([0, 0, 1] if dimension == 2 else [1, 1, 1])
        pad = [DEPTH / 2] if dimension == 2 else []
        rows.append((*centre, *pad, *velocity, *np.zeros(3 - dimension), *spin))
    write_spinning(case, rows)
    control(case, endTime=0.15, writeInterval=150)
    case.run("dryGrainFoam")
    book = ledger(case)
    assert (book["contactWork"] <= 1e-14).all()
    assert np.count_nonzero(book["contactWork"] < 0) > 20
    energy = book["kineticEnergy"]
    assert (np.diff(energy) <= 1e-9 * energy[0]).all()
    assert energy[-1] < 0.9 * energy[0]


CHAINS = """functions
{
    forceChains
    {
        type            contactNetwork;
        libs            ("libgrainFunctionObjects.so");
        writeControl    writeTime;
    }
"""


def heap(dimension, columns=5, rows=4):
    """Rows of touching grains in the hollows of those below, on the floor, in a plane."""
    places = []
    for row in range(rows):
        x = 0.03 + RADIUS * (2 * np.arange(columns - row) + row)
        z = np.full(x.shape, RADIUS * (1 + row * np.sqrt(3)))
        places.append(np.column_stack([x, z] if dimension == 2 else [x, np.full(x.shape, 0.05), z]))
    return np.vstack(places)


def forces_of_contacts(case, time):
    """Normal forces over the weight of a grain, by the pair."""
    text = (case.path / f"postProcessing/forceChains/contacts_{time}.vtk").read_text().split()
    names = ("first", "second", "normal")
    begin = [text.index(name) + 5 for name in names]
    number = int(text[text.index("CELL_DATA") + 1])
    first, second, normal = (np.array(text[b : b + number], dtype=float) for b in begin)
    order = np.lexsort([second, first])
    return np.column_stack([first, second])[order], normal[order]


@pytest.mark.parametrize("rolling", [0, 0.2])
@DIMENSIONS
def test_attraction_that_begins_leaves_a_heap_as_it_is(clone, dimension, rolling):
    """20 weights between all grains of a heap that lies still: what carried it carries it still.

    Where contacts are more than equilibrium tells, their forces can hold each other with up to the
    attraction each."""
    case = dry_box(clone, heap(dimension), RADIUS, dimension=dimension)
    attracts = f"cohesion {20 * weight(dimension)}; cohesionDelay 0.0495;"
    set_law(case, f"type cohesive; friction 1; rolling {rolling}; {attracts}")
    replace(case, "system/controlDict", "functions\n{\n", CHAINS)
    replace(case, GRAINS, "tolerance   1e-7", "tolerance   1e-11")
    replace(case, GRAINS, "maxSweeps   200", "maxSweeps   2000")
    control(case, endTime=0.06, writeInterval=1)
    case.run("dryGrainFoam")
    pairs, before = forces_of_contacts(case, "0.049")
    for time in ("0.051", "0.06"):
        others, after = forces_of_contacts(case, time)
        np.testing.assert_array_equal(others, pairs)
        # Of a weight; the tolerance over g dt^2 is 1e-6
        np.testing.assert_allclose(after, before, rtol=0, atol=1e-4 * weight(dimension))
