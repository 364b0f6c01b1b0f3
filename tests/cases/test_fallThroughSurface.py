# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere falls through the surface of a liquid: free fall in the air above, and below soon the
law's terminal speed, in cells of every size."""

import pytest
from falling_sphere import falling_sphere, speeds_over_law
from water_box import liquid_ledger


@pytest.mark.parametrize(
    "cell, width",
    [
        (4, 20),
        (1, 8),
        (0.5, 4),
        *(
            pytest.param(cell, width, marks=pytest.mark.slow)
            for cell, width in ((2, 12), (0.7, 8.4), (0.35, 6.3), (0.25, 8))
        ),
    ],
)
def test_speeds_above_and_below_are_the_laws(clone, cell, width):
    case = falling_sphere(clone, cell, width)
    case.run("grainInterFoam", timeout=7200)
    before, after = speeds_over_law(case, cell, width)
    assert before == pytest.approx(1, abs=0.05)
    assert after == pytest.approx(1, abs=0.05)
    assert abs(liquid_ledger(case)["unaccounted"]).max() <= 1e-10
