# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""dryGrainFoam: energy of clusters in space that turn and bounce, without weight."""

import numpy as np
import pytest
from cluster_box import make_clusters
from dry_box import GRAINS, dry_box
from grain_box import control, ledger, replace

# Three moments of inertia, with its centre of mass in none of its spheres' middles
BODY = "centres ((-2 0 0) (0 0 0) (2 0.5 0) (0 1.5 0.5)); radii (1 1 1 1.5);"


def clusters(clone, centres, velocity, spins, law, dt, end):
    case = dry_box(clone, centres, 0.012, velocity)
    make_clusters(case, BODY)
    file = case.path / "constant/grains.csv"
    header, *rows = file.read_text().splitlines()
    rows = [
        row.rsplit(",", 3)[0] + ",{},{},{}".format(*spin)
        for row, spin in zip(rows, spins, strict=True)
    ]
    file.write_text("\n".join([header, *rows, ""]))
    replace(case, "constant/g", "-9.81", "0")
    replace(case, GRAINS, "friction    0.3;", law)
    replace(case, GRAINS, "friction    0.2;", law)
    control(case, deltaT=dt, endTime=end, writeInterval=round(end / dt))
    case.run("dryGrainFoam")
    return ledger(case)


@pytest.mark.parametrize("dt", [1e-3, 4e-3])
def test_body_that_turns_freely_keeps_its_energy(clone, dt):
    """About its middle axis, which is unstable, at 30 rad/s: ten turns of space."""
    book = clusters(clone, [(0.05,) * 3], None, [(1, 30, 1)], "friction 0.3;", dt, 2.0)
    # Printed with twelve digits; up to 0.13 rad in a step
    np.testing.assert_allclose(book["kineticEnergy"], book["kineticEnergy"][0], rtol=1e-11)


@pytest.mark.parametrize("law", ["friction 0; restitution 1;", "friction 0.4; restitution 0.7;"])
@pytest.mark.parametrize("dt", [1e-3, 2.5e-4])
def test_energy_of_bodies_that_bounce_is_what_impacts_leave(clone, law, dt):
    """Among each other and off the walls, up to 160 rad/s, whenever in a step they meet."""
    centres = [(0.03, 0.05, 0.05), (0.07, 0.04, 0.06)]
    velocity = [(0.7, 0.4, 0.3), (-0.5, 0.2, -0.4)]
    book = clusters(clone, centres, velocity, [(10, 25, 15), (-20, 5, 30)], law, dt, 0.5)
    energy = book["kineticEnergy"]
    given = np.cumsum(book["contactWork"])
    assert np.count_nonzero(np.abs(np.diff(book["momentum_x"])) > 1e-12) >= 3
    # Printed with twelve digits
    np.testing.assert_allclose(energy, energy[0] - given[0] + given, rtol=0, atol=1e-9 * energy[0])
    if "friction 0;" in law:
        np.testing.assert_allclose(energy, energy[0], rtol=1e-9)
    else:
        assert energy[-1] < 0.7 * energy[0]
