# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs do not know how large and heavy they are, nor which of two fluids is called water."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace, write_csv
from heat_box import fix_grains, stream
from test_motion import gamma
from water_box import column, set_water, water_box

FLUIDS = "constant/transportProperties"
GRAINS = "constant/grainProperties"


def collapse(clone, water, centres, radius, name, densities=(1000.0, 1.0)):
    """Water that falls upon grains of which those above four cells are resolved."""
    cells = (16, 16)
    case = water_box(
        clone, water, centres, radius, cells=cells, sigma=0.07, densities=densities, name=name
    )
    control(case, deltaT=1e-3, endTime=0.04, writeInterval=40)
    return case


def exchange(case, angle):
    """Air where water is, with its viscosity, and the angle in the other fluid."""
    text = (case.path / FLUIDS).read_text()
    text = text.replace("1.48e-5", "other").replace("1e-6", "1.48e-5").replace("other", "1e-6")
    (case.path / FLUIDS).write_text(text)
    replace(case, GRAINS, f"contactAngle {angle};", f"contactAngle {180 - angle};")


@pytest.mark.parametrize(
    ("angle", "gravity"), [(60, (0, -9.81)), (120, (0, -9.81)), (60, (3.0, -9.3))]
)
def test_fluids_that_change_their_names_move_as_before(clone, angle, gravity):
    """Of grains with a contact angle, too, beyond whose surface the fraction is bent."""
    rest, columns = (1000.0, 1.0), column(0.06, 0.07)
    fields = []
    for swapped in (False, True):
        water = (lambda low, high: 1 - columns(low, high)) if swapped else columns
        case = collapse(
            clone, water, [(0.053, 0.041)], 0.021, str(swapped), rest[::-1] if swapped else rest
        )
        replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")
        replace(case, GRAINS, "density 2500;", f"density 2500; contactAngle {angle};")
        replace(case, "constant/g", "(0 -9.81 0)", f"({gravity[0]} {gravity[1]} 0)")
        if swapped:
            exchange(case, angle)
        case.run("grainInterFoam")
        fields.append((case.field("alpha.water"), case.field("U")))
    # The tolerance of the linear solvers
    np.testing.assert_allclose(fields[0][0] + fields[1][0], 1, atol=1e-9)
    np.testing.assert_allclose(fields[0][1], fields[1][1], atol=1e-8)


def test_cells_of_some_micrometres_are_as_good_as_larger_ones(clone):
    """All lengths over 1024, with the same dimensionless numbers."""
    centres = np.array([(0.03, 0.02), (0.071, 0.04), (0.05, 0.08)])
    radii = np.array([0.004, 0.021, 0.002])
    fields = []
    for size in (1.0, 2.0**-10):
        water = column(0.06 * size, 0.07 * size)
        case = collapse(clone, water, centres, radii, str(size))
        write_csv(case, size * centres, size * radii)
        replace(case, "system/blockMeshDict", "\nvertices", f"\nscale {size!r};\nvertices")
        case.run("blockMesh")
        set_water(case, water)
        replace(case, "constant/g", "(0 -9.81 0)", f"(0 {-9.81 * size!r} 0)")
        for nu in (1e-6, 1.48e-5):
            text = f"{nu:g}".replace("e-0", "e-")
            replace(case, FLUIDS, f"nu {text};", f"nu {nu * size**2!r};")
        replace(case, FLUIDS, "sigma 0.07", f"sigma {0.07 * size**3!r}")
        case.run("grainInterFoam")
        fields.append((case.field("alpha.water"), case.field("U") / size))
    np.testing.assert_allclose(fields[0][0], fields[1][0], atol=1e-8)
    np.testing.assert_allclose(fields[0][1], fields[1][1], atol=1e-7)


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
def test_falling_grains_in_cells_of_a_micrometre(clone, scheme):
    """All lengths over 16 384.  What OpenFOAM's ddtCorr adds to a flux, 1e-15 m3/s, was as much as
    the flux itself, and the fluid moved otherwise by a third of its largest speed."""
    centres = np.array([(0.03, 0.02), (0.071, 0.043), (0.05, 0.08), (0.022, 0.061)])
    speeds = []
    for size in (1.0, 2.0**-14):
        case = grain_box(clone, size * centres, size * 0.004, name=str(size))
        replace(case, "system/blockMeshDict", "\nvertices", f"\nscale {size!r};\nvertices")
        case.run("blockMesh")
        replace(case, "constant/g", "(0 -9.81 0)", f"(0 {-9.81 * size!r} 0)")
        replace(case, "constant/transportProperties", "1e-4", repr(1e-4 * size**2))
        case.dict_set(GRAINS, "contact/tolerance", repr(1e-7 * size))
        case.dict_set("system/fvSchemes", "ddtSchemes/default", scheme)
        control(case, deltaT=1e-3, endTime=0.05, writeInterval=50)
        case.run("grainFoam")
        speeds.append(case.field("U") / size)
    # The tolerance of the linear solvers
    np.testing.assert_allclose(*speeds, rtol=0, atol=1e-7 * np.abs(speeds[0]).max())


def fixed_discs(clone, density):
    """Discs of three cells, which no flow is resolved around, in a stream."""
    centres = [(0.03, 0.024), (0.05, 0.061), (0.071, 0.04)]
    case = grain_box(clone, centres, 0.0075, name=repr(density))
    replace(case, "system/blockMeshDict", "(10 10 1)", "(20 20 1)")
    case.run("blockMesh")
    stream(case, 1.0)
    fix_grains(case)
    replace(case, FLUIDS, "[1 -3 0 0 0 0 0] 1000", repr(density))
    control(case, deltaT=1e-3, endTime=0.03, writeInterval=30)
    case.run("grainFoam")
    return case


def test_fixed_grains_in_fluids_of_any_density(clone):
    """Fixed grains had one inertia in all, by which their drag was 1.02 to 1.3 of this one."""
    base, *others = (fixed_discs(clone, 1000 * 2.0**power) for power in (0, -20, 20))
    solved = base.logged("Solving for Ux, Initial residual = ")
    for case in others:
        # The tolerance of the linear solvers
        np.testing.assert_allclose(case.field("U"), base.field("U"), rtol=0, atol=1e-9)
    # Covered cells are not all that the equation's norm consists of
    assert solved[1:].min() > 1e-9


@pytest.mark.parametrize("mu", [0.1, 1e12])
def test_fixed_bed_holds_a_fluid_of_any_viscosity(clone, mu):
    """The law's drag: where gamma dt came near the inertia of fixed grains it was too small."""
    n, spacing, d, speed = 20, 0.005, 0.004, 0.1
    bed = lattice(n, n, spacing, (spacing / 2, spacing / 2))
    case = grain_box(clone, bed, d / 2)
    stream(case, speed)
    fix_grains(case)
    replace(case, FLUIDS, "1e-4", repr(mu / 1000))
    control(case, deltaT=1, endTime=5, writeInterval=5)
    case.run("grainFoam")
    p = case.field("p_rgh").reshape(10, 10).mean(axis=0)
    gradient = (p[3] - p[6]) / 0.03
    eps = 1 - np.pi / 4 * (d / spacing) ** 2
    slip = case.field("U").reshape(10, 10, 3)[:, 3:7, 0].mean()
    law = (1 - eps) * gamma(slip, d, mu, eps) * slip / eps
    assert gradient == pytest.approx(law, rel=1e-5)
