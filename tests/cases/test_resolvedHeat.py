# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat around grains that are many cells large."""

import numpy as np
import pytest
from grain_box import control, grain_box, replace
from heat_box import fix_grains, heat_ledger, with_heat

SIDE, DEPTH = 0.1, 0.01
CENTRE = np.array([0.0487, 0.0513])
K = 0.6
# Of a fluid that is in equilibrium after the one long step of these cases
CP = 1e-3


def around(x, y):
    return np.hypot(x - CENTRE[0], y - CENTRE[1])


def given(T, n):
    """T(x, y) on the sides of the box, as patches of a field."""
    s = (np.arange(n) + 0.5) * SIDE / n
    sides = {
        "left": (0 * s, s),
        "right": (0 * s + SIDE, s),
        "bottom": (s, 0 * s),
        "top": (s, 0 * s + SIDE),
    }
    patches = ""
    for name, (x, y) in sides.items():
        values = " ".join(repr(float(value)) for value in T(x, y))
        patches += f"{name} {{ type fixedValue; value nonuniform List<scalar> {n}({values}); }}\n"
    return patches


def conduction(clone, n, radius, T, grains, material, heat="conductance none;"):
    case = grain_box(clone, [CENTRE], radius, name=f"n{n}")
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({n} {n} 1)")
    case.run("blockMesh")
    fix_grains(case)
    fluid = f"Cp {CP}; kappa {K};"
    with_heat(case, grains, grains, given(T, n), fluid=fluid, heat=heat, ofGlass=material)
    (case.path / "constant/g").write_text(
        (case.path / "constant/g").read_text().replace("-9.81", "0")
    )
    control(case, deltaT=1e3, endTime=1e3, writeInterval=1)
    case.run("grainThermalFoam")
    s = (np.arange(n) + 0.5) * SIDE / n
    x, y = np.tile(s, n), np.repeat(s, n)
    return case, x, y, case.field("T", case.times[-1])


def order(errors, ratio=2):
    return np.log(errors[0] / errors[-1]) / np.log(ratio) / (len(errors) - 1)


def test_conduction_around_a_disc_is_of_second_order(clone):
    """In all the fluid, with a disc of 4.8, 9.6 and 19.2 cells that the mesh does not fit."""
    radius, T_p = 0.012, 400.0
    T = lambda x, y: T_p - 50 * np.log(around(x, y) / radius)
    errors, flux = [], []
    for n in (20, 40, 80):
        case, x, y, found = conduction(clone, n, radius, T, T_p, "heatCapacity 1e10;")
        outside = around(x, y) > radius
        errors.append(np.sqrt(np.mean((found - T(x, y))[outside] ** 2)))
        book = heat_ledger(case)
        flux.append(-book["exchanged"][-1] / 1e3 / (2 * np.pi * 50 * K * DEPTH) - 1)
        # Its heat capacity, which holds the temperature, is 1e10 times that of the fluid
        assert book["fluidError"].max() <= 1e-7
    assert order(errors) >= 1.8
    assert abs(flux[-1]) <= 0.005


# Found 2.5, 0.3 and 0.3 %: less than the fluid it conducts only in first order
@pytest.mark.parametrize(("ratio", "bound"), [(0.1, 0.03), (10, 0.005), (1000, 0.005)])
def test_disc_that_conducts_is_a_dipole(clone, ratio, bound):
    """In a uniform gradient, 16 cells in a diameter; error over that of the radius."""
    n, radius, gradient = 80, 0.01, 1000.0
    strength = (1 - ratio) / (1 + ratio) * radius**2

    def T(x, y):
        return 400 + gradient * (x - CENTRE[0]) * (1 + strength / around(x, y) ** 2)

    material = f"heatCapacity 1e-3; conductivity {ratio * K};"
    case, x, y, found = conduction(
        clone, n, radius, T, 400.0, material, "conductance none; inside conducting;"
    )
    outside = around(x, y) > radius
    error = np.abs(found - T(x, y))[outside]
    assert error.max() <= bound * gradient * radius
