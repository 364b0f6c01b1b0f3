# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed grains that cover cells wholly, but have too few of them to be resolved by default."""

import numpy as np
import pytest
from grain_box import control, grain_box, replace, tracks
from heat_box import GRAINS, fix_grains, stream
from sphere_box import SIDE, field, sphere_box

RHO, SPEED = 1000.0, 0.1
# Of the centre in its cell [cells]
PLACE = np.array([0.37, 0.22, 0.21])


def in_stream(clone, kind, resolution, Re, resolved=None, name=None):
    """In a stream that is everywhere at the start, as if there were no grain."""
    n = 24 if kind == "sphere" else 36
    h = SIDE / n
    d = resolution * h
    centre = (np.array([n // 3, n // 2, n // 2]) + PLACE) * h
    if kind == "sphere":
        case = sphere_box(clone, [centre], d / 2, n=n, name=name)
    else:
        case = grain_box(clone, [centre[:2]], d / 2, name=name)
        replace(case, "system/blockMeshDict", "(10 10 1)", f"({n} {n} 1)")
        case.run("blockMesh")
    stream(case, SPEED)
    replace(case, "constant/transportProperties", "1e-4", repr(SPEED * d / Re))
    fix_grains(case)
    if resolved:
        options = f"motion fixed; resolvedGrains {{ type locked; from {resolved}; }}"
        replace(case, GRAINS, "motion fixed;", options)
    # The fluid passes nine grains and more
    steps = 80
    deltaT = 0.4 * h / SPEED
    control(case, deltaT=deltaT, endTime=steps * deltaT, writeInterval=steps)
    case.run("grainFoam")
    return case


def steady_drag(case):
    """At the end, when the flow is steady and the fluid rests in covered cells."""
    U, eps = field(case, "U"), field(case, "eps")
    assert eps.min() < 1e-12
    assert np.abs(U[eps < 1e-12]).max() <= 1e-6 * SPEED
    assert np.abs(U).max() <= 2 * SPEED
    drag = tracks(case)[:, 11]
    assert drag[-5] == pytest.approx(drag[-1], rel=0.01)
    return drag[-1]


@pytest.mark.parametrize("Re", [1, 100])
@pytest.mark.parametrize("resolution", [2.5, 3, 3.5])
def test_disc_in_a_stream(clone, resolution, Re):
    """As much drag as with the flow resolved around it, in as few cells."""
    law = in_stream(clone, "disc", resolution, Re, name="law")
    resolved = in_stream(clone, "disc", resolution, Re, 2, name="resolved")
    # Off by up to 12 % at Re 100; both know the disc's size to a fraction of a cell
    assert steady_drag(law) == pytest.approx(tracks(resolved)[-1, 11], rel=0.2)


@pytest.mark.parametrize("Re", [1, 100])
def test_sphere_in_a_stream(clone, Re):
    """As much drag as the law gives a lone one: 0.97 and 1.15 of it, eight diameters of room."""
    d = 3 * SIDE / 24
    law = 0.5 * RHO * SPEED**2 * np.pi / 4 * d**2 * (0.63 + 4.8 / np.sqrt(Re)) ** 2
    assert steady_drag(in_stream(clone, "sphere", 3, Re)) == pytest.approx(law, rel=0.2)
