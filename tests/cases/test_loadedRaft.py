# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A heavy disc that lies on a light raft tilts it: at rest the contact turns the raft one way and
the water the other, and neither is to be seen in the motion of the raft's cells."""

import numpy as np
from cluster_box import make_clusters
from grain_box import control, replace, tracks
from test_cutCells import FLUID, GRAINS
from water_box import level, water_box

RAFT = "centres ((-3 0 0) (-1 0 0) (1 0 0) (3 0 0)); radii (1 1 1 1);"
RADIUS, LOAD = 0.006, 0.005
BESIDE = 2 * RADIUS  # of the raft's middle: over the gap of its last two discs
TILT = 0.205  # at which buoyancy of the discs in a level surface has no moment about their centre


def test_a_loaded_raft_comes_to_rest_as_archimedes_has_it(clone):
    """Its cells once turned by what the contact does in a step, 0.66 rad/s, and the water with
    them at 14 mm/s for ever; the raft came to lie at 0.08 rad, of which it had 0.16 at 0.8 s."""
    over = np.sqrt((RADIUS + LOAD) ** 2 - RADIUS**2)
    places = [(0.05, 0.049), (0.05 + BESIDE, 0.049 + over)]
    case = water_box(clone, level(0.05), places, [4 * RADIUS, LOAD], cells=(40, 40))
    make_clusters(case, RAFT)
    file = case.path / "constant/grains.csv"
    header, raft, load = file.read_text().splitlines()
    load = load.replace("body", "disc")
    file.write_text(f"{header},material\n{raft},light\n{load},glass\n")
    materials = "glass { density 1500; } light { density 300; }"
    replace(case, GRAINS, "glass   { density 2500; }", materials)
    laws = "".join(
        f"{one}On{other} {{ materials ({one} {other}); type Coulomb; friction 0.5; }}\n"
        for one, other in (("light", "light"), ("light", "glass"), ("light", "steel"))
    )
    replace(case, GRAINS, "contactLaws\n{", f"contactLaws\n{{\n{laws}")
    for nu in ("1e-6", "1.48e-5"):
        replace(case, FLUID, f"nu {nu}", "nu 1e-3")
    dt = 1e-3
    control(case, deltaT=dt, endTime=0.8, writeInterval=800)
    case.run("grainInterFoam")

    raft, load = tracks(case)[::2], tracks(case)[1::2]
    tilt = -np.cumsum(raft[:, 10]) * dt
    # By the staircase of cells, 2.5 mm, 0.012 more
    np.testing.assert_allclose(tilt[-100:], TILT, atol=0.02)
    # The contact carries the load, the fluid none of it (it drew it down by a third)
    weight = 1500 * np.pi * LOAD**2 * 0.01 * 9.81
    assert np.abs(load[-100:, 12]).mean() < 0.06 * weight
    water = case.field("alpha.water") > 0.9
    assert np.abs(case.field("U")[water]).max() < 3e-3
