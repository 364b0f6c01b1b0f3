# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of results of a validation case."""

import math

import pytest
from grainresults import Result, Results, table


@pytest.mark.parametrize(
    ("value", "reference", "tolerance", "passes"),
    [
        (1.029, 1, "3 %", True),
        (1.031, 1, "3 %", False),
        (-0.98, -1, "3 %", True),
        (1.5, 1, "<=", False),
        (1, 1, "<=", True),
        (1.5, 1, ">=", True),
        (0.95, 1, "+-0.1", True),
        (0.85, 1, "+-0.1", False),
        (math.nan, 1, "<=", False),
        (math.nan, None, "", True),
    ],
)
def test_tolerances(value, reference, tolerance, passes):
    assert Result("speed", value, "m/s", reference, tolerance).passes == passes


def test_tableIsReadAsItWasWritten(tmp_path):
    results = Results()
    results.add("speed", 0.5, "m/s", 1.0, "3 %", "closed form, with a comma")
    results.add("cells", 100.0)
    results.write(tmp_path / "results.csv")

    assert Results.read(tmp_path / "results.csv") == results
    assert table(tmp_path / "results.csv").count("**missed**") == 1


def test_missedToleranceFailsTheProgram(tmp_path):
    results = Results()
    results.add("speed", 0.5, "m/s", 1.0, "3 %")
    with pytest.raises(SystemExit) as stopped:
        results.finish(tmp_path / "results.csv")
    assert stopped.value.code == 1
