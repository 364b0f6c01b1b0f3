# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the ledger says of settling grains: volume and momentum are conserved in every step."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, ledger, replace

RADIUS = 0.004


@pytest.fixture(params=["quads", "triangles"])
def settled(clone, request):
    """20 grains that fall, meet the floor and each other."""
    rng = np.random.default_rng(1)
    centres = lattice(5, 4, 0.012, (0.02, 0.014)) + rng.uniform(-1e-3, 1e-3, (20, 2))
    case = grain_box(clone, centres, RADIUS, request.param)
    replace(case, "system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 2")
    control(case, endTime=0.3, writeInterval=300)
    case.run("grainFoam")
    return case


def test_volume_and_momentum_are_conserved(settled):
    book = ledger(settled)
    assert len(book["time"]) == 300
    assert book["active"].max() >= 10

    # Overlaps add up to the grain, to round-off; the table has 12 digits
    volume = 20 * np.pi * RADIUS**2 * 0.01
    assert book["mappingError"].max() <= 1e-12
    np.testing.assert_allclose(book["grainVolume"], volume, rtol=1e-11)
    # The contact solver lets a grain dip into the floor by 1e-7 m: a segment of its disc is outside
    dipped = 4 / 3 * np.sqrt(2 * RADIUS) * 1e-7**1.5 / (np.pi * RADIUS**2)
    np.testing.assert_allclose(book["mappedVolume"], volume, rtol=dipped)
    before = book["active"] == 0
    np.testing.assert_allclose(book["mappedVolume"][before], volume, rtol=1e-11)

    # One and the same number, summed over cells and over grains
    assert book["momentumError"].max() <= 1e-10
    given = np.array([book["given_x"], book["given_y"]])
    received = np.array([book["received_x"], book["received_y"]])
    assert np.linalg.norm(given - received, axis=0).max() <= 1e-10 * np.linalg.norm(given[:, 0])

    # A residual of 1e-12 over some 100 cells, as a share of the cell's volume
    assert book["divergence"].max() <= 1e-10


def test_fluid_volume_makes_room_for_the_grains(settled):
    eps = settled.field("eps")
    volumes = settled.mesh().areas * 0.01
    solid = 20 * np.pi * RADIUS**2 * 0.01
    assert eps.min() >= 0
    assert volumes @ (1 - eps) + ledger(settled)["overfull"][-1] == pytest.approx(solid, rel=1e-12)
    # No more than the overlaps that the contact solver allows can ask for too much room
    assert ledger(settled)["overfull"].max() <= 1e-6 * solid


def test_grains_stay_within_the_walls(settled):
    position = settled.grains()["position"]
    # Tolerance of the contact solver
    assert position.min() >= RADIUS - 1e-7
    assert position.max() <= 0.1 - RADIUS + 1e-7
    gaps = np.linalg.norm(position[:, None] - position, axis=2)[np.triu_indices(20, 1)]
    assert gaps.min() >= 2 * RADIUS - 1e-6
