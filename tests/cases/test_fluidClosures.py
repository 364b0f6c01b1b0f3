# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of the plates of a Hele-Shaw cell, and effective viscosity, against closed forms."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, make_cyclic, replace
from test_motion import gamma

SIDE, RHO = 0.1, 1000.0
FLUID = "constant/transportProperties"
GRAINS = "constant/grainProperties"
WALLS = '"left|right|bottom|top"'


def channel(clone, centres, radius, cells, pressure, sides="noSlip", name=None):
    """From left to right through the box, driven by a pressure [Pa]."""
    case = grain_box(clone, centres, radius, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells[0]} {cells[1]} 1)")
    for patch in ("left", "right"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    ends = f'"left|right" {{ type zeroGradient; }} "bottom|top" {{ type {sides}; }}'
    replace(case, "0/U", f"{WALLS}\n    {{\n        type    noSlip;\n    }}", ends)
    ends = "".join(
        f"{patch} {{ type fixedValue; value uniform {p}; }} "
        for patch, p in (("left", pressure), ("right", 0))
    )
    replace(case, "0/p_rgh", WALLS, ends + '"bottom|top"')
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    return case


def test_channel_between_plates_has_brinkmans_profile(clone):
    mu, gap, pressure = 10.0, 0.1, 1.0
    drag = 12 * mu / gap**2
    k = np.sqrt(drag / mu)
    errors = []
    for n in (10, 20, 40):
        case = channel(clone, [], 0.001, (4, n), pressure, name=f"cells{n}")
        replace(case, FLUID, "1e-4", f"{mu / RHO};\nHeleShaw {{ gap {gap}; }}\n//")
        control(case, deltaT=1e-3, endTime=0.8, writeInterval=800)
        case.run("grainFoam")
        u = case.field("U").reshape(n, 4, 3)
        # The same all along, to what the steady state and the linear solvers leave
        assert np.ptp(u[:, :, 0], axis=1).max() <= 1e-8 * u.max()
        y = (np.arange(n) + 0.5) / n * SIDE
        exact = 1 - np.cosh(k * (y - SIDE / 2)) / np.cosh(k * SIDE / 2)
        exact *= pressure / SIDE / drag
        errors.append(np.abs(u[:, 1, 0] - exact).max() / exact.max())
    # h^2/8 times the second derivative from the cells at the walls, 1/12 from the others
    assert errors[-1] < (1 / 8 + 1 / 12) * (k * SIDE / 40) ** 2
    assert np.all(np.log2(errors[:-1] / np.array(errors[1:])) > 1.8)


@pytest.mark.parametrize("delta_t, coarse", [(1e-4, 1), (1e-2, 1), (1, 1), (1e-2, 2)])
def test_plates_hold_the_fluids_share_of_a_bed(clone, delta_t, coarse):
    """Grains too heavy to move: eps (G - wallDrag u) = phi gamma u, on faces as in cells; with
    a permeability of grains of half the size where discs stand for four."""
    mu, gap, pressure, d, spacing = 0.1, 0.002, 1.0, 0.004, 0.005
    bed = lattice(20, 20, spacing, (0.0025, 0.0025))
    case = channel(clone, bed, d / 2, (10, 10), pressure, sides="slip")
    replace(case, FLUID, "1e-4", f"{mu / RHO};\nHeleShaw {{ gap {gap}; }}\n//")
    replace(case, GRAINS, "density 2500", "density 1e16")
    case.dict_set(GRAINS, "coupling/coarseGraining", coarse)
    control(case, deltaT=delta_t, endTime=500 * delta_t, writeInterval=500)
    case.run("grainFoam")

    # Away from the ends, which grains do not cross
    p = case.field("p_rgh").reshape(10, 10).mean(axis=0)
    gradient = (p[3] - p[6]) / (3 * SIDE / 10)
    eps = 1 - np.pi / 4 * (d / spacing) ** 2
    speed = 0.0
    for _ in range(100):
        law = (1 - eps) * gamma(speed, d / coarse, mu, eps) + eps * 12 * mu / gap**2
        speed = eps * gradient / law
    u = case.field("U").reshape(10, 10, 3)[:, 3:7]
    # Of the time to start, rho/(12 mu/gap^2) = 3 ms, the shortest run has 15
    np.testing.assert_allclose(u[..., 0], speed, rtol=1e-4)
    # What the linear solvers leave
    assert np.abs(u[..., 1]).max() <= 1e-5 * speed


@pytest.mark.parametrize(
    "law, ratio",
    [
        ("type none;", lambda phi: 1 - phi),
        ("type Einstein; intrinsic 2;", lambda phi: 1 + 2 * phi),
        ("type Batchelor;", lambda phi: 1 + 2.5 * phi + 7.6 * phi**2),
        ("type KriegerDougherty; maxFraction 0.6;", lambda phi: (1 - phi / 0.6) ** -2),
    ],
)
def test_layers_share_the_shear_by_their_viscosity(clone, law, ratio):
    """Couette flow, its upper half with grains that go along with the fluid."""
    radius, spacing, speed = 0.0015, 0.005, 1e-4
    case = grain_box(clone, lattice(20, 10, spacing, (0.0025, 0.0525)), radius)
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    lids = (
        '"left|right" { type cyclic; } bottom { type noSlip; }'
        f" top {{ type fixedValue; value uniform ({speed} 0 0); }}"
    )
    replace(case, "0/U", f"{WALLS}\n    {{\n        type    noSlip;\n    }}", lids)
    replace(case, "0/p_rgh", WALLS, '"left|right" { type cyclic; }\n "bottom|top"')
    replace(case, FLUID, "1e-4", "1e-2")
    replace(case, GRAINS, "density 2500", "density 1000")
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    viscosity {{ {law} }}")
    replace(case, "constant/g", "-9.81", "0")
    # With two there would be no predictor where nu dt/h^2 is 4, and no steady flow yet
    case.dict_set("system/fvSolution", "PISO/nCorrectors", 6)
    control(case, deltaT=1e-2, endTime=2, writeInterval=200)
    case.run("grainFoam")

    phi = 4 * np.pi * radius**2 / (SIDE / 10) ** 2
    u = case.field("U")[:, 0].reshape(10, 10).mean(axis=1)
    below, above = u[3] - u[1], u[8] - u[6]
    # Steady to exp(-pi^2 nu t / SIDE^2 / 2), 5e-5, with the grains' inertia
    assert below / above == pytest.approx(ratio(phi), rel=1e-3)


# Per volume [N/m^3], and the velocity to keep [m/s]
FORCE = 10.0
MEAN = 0.01
SOURCES = {
    "force": f"""
        type vectorSemiImplicitSource;
        volumeMode specific;
        injectionRateSuSp {{ U (({FORCE} 0 0) 0); }}
    """,
    "mean": f"""
        type meanVelocityForce;
        fields (U);
        Ubar ({MEAN} 0 0);
    """,
}


def endless_channel(clone, n, source, fluid, name=None):
    """From left to right and back to the left between walls, without grains."""
    case = grain_box(clone, [], 0.001, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"(4 {n} 1)")
    make_cyclic(case, ("left", "right"))
    case.run("blockMesh")
    walls = f"{WALLS}\n    {{\n        type    noSlip;\n    }}"
    replace(case, "0/U", walls, '"left|right" { type cyclic; } "bottom|top" { type noSlip; }')
    replace(case, "0/p_rgh", WALLS, '"left|right" { type cyclic; } "bottom|top"')
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, "constant/g", "-9.81", "0")
    # Two correctors are unstable here, as in pisoFoam, where nu deltaT/h^2 exceeds a few
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    text = (case.path / FLUID).read_text()
    (case.path / FLUID).write_text(text.replace("nu  ", f"{fluid}\n//  "))
    (case.path / "constant/fvOptions").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }\n"
        f"drive {{ {SOURCES[source]} selectionMode all; }}\n"
    )
    return case


def profile(case, n):
    """Velocity from wall to wall, the same all along."""
    u = case.field("U").reshape(n, 4, 3)
    assert np.ptp(u[:, :, 0], axis=1).max() <= 1e-9 * u.max()
    y = (np.arange(n) + 0.5) / n * SIDE - SIDE / 2
    return np.abs(y), u[:, 1, 0]


def test_power_law_has_its_profile(clone):
    """u = (G/k)^(1/n) (H^q - y^q)/q with q = 1 + 1/n, half the width H and the force G over rho."""
    exponent, k, half = 0.5, 5e-4, SIDE / 2
    model = f"powerLaw; powerLawCoeffs {{ nuMax 0.01; nuMin 1e-7; k {k}; n {exponent}; }}"
    errors = []
    for n in (10, 20, 40):
        case = endless_channel(clone, n, "force", f"transportModel {model}", name=f"cells{n}")
        control(case, deltaT=0.02, endTime=30, writeInterval=1500)
        case.run("grainFoam")
        y, u = profile(case, n)
        power = 1 + 1 / exponent
        exact = (FORCE / RHO / k) ** (1 / exponent) * (half**power - y**power) / power
        errors.append(np.abs(u - exact).max() / exact.max())
    assert errors[-1] <= 2e-3
    assert np.all(np.log2(errors[:-1] / np.array(errors[1:])) > 1.9)


@pytest.mark.parametrize("source", SOURCES)
def test_a_source_of_momentum_drives_a_channel(clone, source):
    """u = f/(2 mu) (H^2 - y^2), and h^2/4 of it between the wall and the middle of its cells."""
    mu, n = 0.8, 40
    case = endless_channel(clone, n, source, f"nu {mu / RHO};")
    control(case, deltaT=0.05, endTime=40, writeInterval=800)
    case.run("grainFoam")
    y, u = profile(case, n)
    shape = (SIDE / 2) ** 2 - y**2 + (SIDE / n) ** 2 / 4
    force = FORCE if source == "force" else 2 * mu * MEAN / shape.mean()
    # The start has decayed to exp(-pi^2 nu t/(4 H^2)) = 2e-14
    np.testing.assert_allclose(u, force / (2 * mu) * shape, rtol=1e-8)
    if source == "mean":
        assert u.mean() == pytest.approx(MEAN, rel=1e-10)


@pytest.mark.parametrize("nu", [1e-3, 1e-1])
def test_a_thick_suspension_needs_few_corrections(clone, nu):
    """Discs that fall together, viscosities of 0.25 to 232 times the fluid's, nu dt/h^2 = 2.3 and
    232 in the thickest cells.  After a predictor two corrections made 3.6 times as much of the
    speed in each ten steps, or stopped the run within ten."""

    def speed(correctors):
        discs = lattice(23, 10, 0.0041, (0.004, 0.003))
        case = grain_box(clone, discs, 0.002, name=f"n{correctors}")
        replace(case, FLUID, "1e-4", f"{nu}")
        law = "viscosity { type KriegerDougherty; maxFraction 0.8; }"
        replace(case, GRAINS, "\ncoupling\n{", f"\ncoupling\n{{\n    {law}")
        case.dict_set("system/fvSolution", "PISO/nCorrectors", correctors)
        control(case, deltaT=1e-3, endTime=0.02, writeInterval=20)
        case.run("grainFoam")
        assert correctors > 2 or case.log.count("no predictor with less than") == 1
        return np.abs(case.field("U")).max()

    # What two leave of the start: 7 and 9 %
    assert speed(2) == pytest.approx(speed(10), rel=0.12)
