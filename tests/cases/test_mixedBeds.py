# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What beds at rest of two materials conduct, and beds in layers."""

import numpy as np
import pytest
from grain_box import replace
from heat_box import GRAIN_CP, GRAINS, KAPPA
from test_bedConductivity import SIDE, bed, conductivity, disordered, maxwell

BETTER, WORSE = 100, 0.01
LAW = "type Maxwell;"
PHI = 256 * np.pi * 0.0025**2 / SIDE**2


def two_materials(clone, cells, isWorse):
    """Grains that conduct 100 times as well as the fluid, and others a hundredth of it."""
    centres, radius = disordered()
    case = bed(clone, centres, radius, cells, LAW, BETTER * KAPPA)
    material = f"density 2500; heatCapacity {GRAIN_CP}; conductivity {WORSE * KAPPA};"
    replace(case, GRAINS, "    steel   {", f"    cork {{ {material} }}\n    steel   {{")
    text = (case.path / GRAINS).read_text()
    law = "default { type Coulomb; friction 0.3; }"
    (case.path / GRAINS).write_text(text.replace("contactLaws\n{", f"contactLaws\n{{ {law}"))
    file = case.path / "constant/grains.csv"
    header, *lines = file.read_text().splitlines()
    names = np.where(isWorse(centres), "cork", "glass")
    rows = [f"{line},{name}" for line, name in zip(lines, names, strict=True)]
    file.write_text("\n".join([f"{header},material", *rows, ""]))
    return case


@pytest.mark.parametrize("cells", [5, 10])
def test_grains_of_inverse_conductivities_mixed_evenly_conduct_as_their_fluid(clone, cells):
    """Exact in the plane (Keller 1964): what conducts k and 1/k changes places by a quarter turn.

    2.87 with the mean of the conductivities.
    """
    order = np.random.default_rng(1).permutation(np.arange(256) % 2)
    case = two_materials(clone, cells, lambda centres: order > 0)
    # Shares of the two differ in cells of 10 and 2.5 grains, by 0.15 and 0.3
    assert conductivity(case, 30, 300) == pytest.approx(1, abs=0.1)


def test_layers_conduct_in_series(clone):
    """1.19 times it with the mean of both cells on the face between them."""
    case = two_materials(clone, 4, lambda centres: centres[:, 0] > SIDE / 2)
    exact = 2 / (1 / maxwell(PHI, BETTER) + 1 / maxwell(PHI, WORSE))
    assert conductivity(case, 30, 300) == pytest.approx(exact, rel=1e-7)


def test_layers_conduct_side_by_side(clone):
    case = two_materials(clone, 4, lambda centres: centres[:, 1] > SIDE / 2)
    exact = (maxwell(PHI, BETTER) + maxwell(PHI, WORSE)) / 2
    assert conductivity(case, 30, 300) == pytest.approx(exact, rel=1e-7)


def test_a_layer_conducts_in_series_with_its_fluid(clone):
    centres, radius = disordered()
    case = bed(clone, centres[centres[:, 0] < SIDE / 2], radius, 4, LAW, BETTER * KAPPA)
    exact = 2 / (1 / maxwell(PHI, BETTER) + 1)
    assert conductivity(case, 30, 300) == pytest.approx(exact, rel=1e-7)
