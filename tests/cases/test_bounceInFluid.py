# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs that bounce in a fluid: what contacts do once the fluid does not expect again."""

import re

import numpy as np
from grain_box import control, grain_box, replace

GRAINS = "constant/grainProperties"


def rebound(
    clone, radius, height, speed, delta_t, end, cells=10, density=2500, name=None, resolved=""
):
    """Speeds up of a disc in each step after its bounce on the floor, without weight."""
    start = [(0.05, height)]
    case = grain_box(clone, start, radius, velocity=[(0, -speed)], name=name)
    path = case.path / GRAINS
    text = re.sub(r"(friction +0\.\d);", r"\1; restitution 0.9;", path.read_text())
    text = text.replace("\ncoupling\n{", f"\ncoupling\n{{\n    {resolved}")
    path.write_text(text.replace("density 2500", f"density {density}"))
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    replace(case, "constant/transportProperties", "1e-4", "1e-5")
    replace(case, "constant/g", "-9.81", "0")
    control(case, deltaT=delta_t, endTime=end, writeInterval=1)
    case.run("grainFoam")
    up = np.array([case.grains(time)["velocity"][0, 1] for time in case.times[1:]])
    return up[np.argmax(up > 0) :]


def test_rebound_does_not_depend_on_the_step(clone):
    """The step after it had the bounce once more: 7 % less of the speed with the longest."""
    last = [
        rebound(clone, 0.002, 0.012, 0.5, delta_t, 0.06, name=str(delta_t))[-1]
        for delta_t in (2e-3, 5e-4, 1.25e-4)
    ]
    np.testing.assert_allclose(last, last[-1], rtol=0.01)


def test_resolved_disc_goes_on_as_it_bounced(clone):
    """It had 0.158, 0.019 and 0.066 m/s in the steps after the bounce."""
    up = rebound(clone, 0.01, 0.016, 0.3, 1e-3, 0.04, cells=50, density=8000)
    assert len(up) > 5
    # The fluid that it set in motion slows it down
    assert np.all(np.diff(up[:8]) < 0)
    assert up[1] > 0.6 * up[0]


def test_rebound_of_cut_cells_does_not_depend_on_the_step(clone):
    """Of 8 cells; locked ones have a tenth of it with the shorter steps."""
    cut = "resolvedGrains { type cutCells; }"
    tops = [
        rebound(
            clone, 0.01, 0.015, 0.3, delta_t, 0.05, 40, 8000, name=str(delta_t), resolved=cut
        ).max()
        for delta_t in (2e-3, 1e-3, 5e-4)
    ]
    np.testing.assert_allclose(tops, tops[-1], rtol=0.02)
    assert tops[-1] > 0.6 * 0.3
