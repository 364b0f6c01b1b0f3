# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Natural convection of air in a square cavity: mean Nusselt numbers of de Vahl Davis (1983)."""

import sys

import pytest
from heat_box import heat_ledger

CAVITY = "tutorials/grainThermalFoam/differentiallyHeatedCavity"


def nusselt(clone, kind, Ra):
    """Mean Nusselt numbers of the hot and the cold wall at the end, from the ledger's heat."""
    case = clone(CAVITY)
    case.run([sys.executable, "cavity.py", kind, Ra])
    case.run("blockMesh")
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n")
    case.run("grainThermalFoam")

    lines = (case.path / "parameters").read_text().splitlines()
    p = dict(line.rstrip(";").split() for line in lines)
    size, kappa, step = (float(p[name]) for name in ("size", "kappa", "deltaT"))
    unit = kappa * 10 * (0.1 * size) * step  # of 10 K over a depth of 0.1 size
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-9  # of the heat content; the linear solver's tolerance
    assert book["leastT"].min() >= 295 and book["mostT"].max() <= 305
    return -book["conducted_hot"][-1] / unit, book["conducted_cold"][-1] / unit


def test_cavity_at_Ra_1e4(clone):
    hot, cold = nusselt(clone, "air", "1e4")
    assert hot == pytest.approx(2.243, rel=0.01)
    assert cold == pytest.approx(hot, rel=1e-6)


@pytest.mark.validation
@pytest.mark.parametrize("Ra, reference", [("1e3", 1.118), ("1e5", 4.519), ("1e6", 8.800)])
def test_cavity(clone, Ra, reference):
    hot, cold = nusselt(clone, "air", Ra)
    assert hot == pytest.approx(reference, rel=0.01)
    assert cold == pytest.approx(hot, rel=2e-3)  # steady enough
