# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat of grains that come and leave with the fluid, of clusters, and properties that vary."""

import numpy as np
import pytest
from grain_box import control, grain_box, ledger, replace
from heat_box import CP, GRAIN_CP, GRAINS, fix_grains, heat_ledger, with_heat
from test_injections import DENSITY, SIZES, SPEED, channel

RHO = 1000.0
COLD, HOT, FED = 300.0, 400.0, 360.0


@pytest.mark.parametrize("resolved", [False, True], ids=["law", "resolved"])
def test_grains_carry_their_heat_in_and_out(clone, resolved):
    """Hot ones come in through a patch with colder fluid, and leave with what they have kept."""
    sizes, end, rate = SIZES, 2, 40
    if resolved:
        sizes = "distribution { type uniform; minRadius 0.022; maxRadius 0.025; }"
        end, rate = 2.6, 2
    feed = f"type patches; patches (bottom); velocity (0 {SPEED} 0); temperature {FED};"
    case = channel(clone, f"{feed} numberRate {rate}; {sizes}")
    patches = (
        '"left|right|top" { type zeroGradient; }'
        f" bottom {{ type fixedValue; value uniform {COLD}; }}"
    )
    with_heat(case, COLD, FED, patches)
    control(case, endTime=end, deltaT=1e-2, writeInterval=100)
    case.run("grainThermalFoam")
    book, grains = heat_ledger(case), ledger(case)
    assert grains["injected"].sum() >= 2
    assert grains["removed"].sum() >= 1
    assert book["fluidError"].max() <= 1e-8
    assert book["grainError"].max() <= 1e-8

    capacity = DENSITY * GRAIN_CP
    np.testing.assert_allclose(
        book["injected"], capacity * grains["injectedVolume"] * FED, rtol=1e-9
    )
    left = grains["removed"] > 0
    T = book["removed"][left] / (capacity * grains["removedVolume"][left])
    assert (T >= COLD).all()
    assert (T <= FED - 1e-3).all()

    # All of both, from the first step to the last
    total = book["fluidHeat"] + book["grainHeat"]
    through = sum(book[name] for name in book if name.startswith(("convected_", "conducted_")))
    come = book["injected"] - book["removed"] + book["outside"] + book["filled"] - through
    np.testing.assert_allclose(np.diff(total), come[1:], atol=1e-8 * total[0])


def test_clusters_and_fluid_keep_their_heat(clone):
    """Pairs that settle in colder water, in a closed box: of their own volume and capacity."""
    centres = [(0.02 + 0.02 * i, 0.03 + 0.02 * j) for i in range(4) for j in range(3)]
    case = grain_box(clone, centres, 0.004)
    shape = "shapes { pair { type cluster; centres ((0 0 0) (2 1 0)); radii (2 2); } }\n"
    replace(case, GRAINS, "\nwalls\n{", f"\n{shape}\nwalls\n{{")
    file = case.path / "constant/grains.csv"
    header, *lines = file.read_text().splitlines()
    file.write_text("\n".join([f"{header},shape", *(f"{line},pair" for line in lines), ""]))
    with_heat(case, COLD, HOT)
    control(case, deltaT=2e-3, endTime=0.2, writeInterval=100)
    case.run("grainThermalFoam")
    book = heat_ledger(case)
    assert book["fluidError"].max() <= 1e-12
    assert book["grainError"].max() <= 1e-12
    total = book["fluidHeat"] + book["grainHeat"]
    np.testing.assert_allclose(total, total[0], rtol=1e-12 * len(total))
    # Where pairs overlap they count once: the volume that the fluid lacks
    volume = ledger(case)["mappedVolume"][0]
    heat = DENSITY * GRAIN_CP * volume * book["meanGrainT"][0]
    assert book["grainHeat"][0] == pytest.approx(heat, rel=1e-7)
    assert book["meanGrainT"][-1] < HOT - 0.1
    assert book["leastT"].min() >= COLD - 1e-9
    assert book["mostGrainT"].max() <= HOT + 1e-9


def between_walls(clone, fluid, name=None, steps=40, deltaT=1e6):
    """Fluid at rest between a hot and a cold wall; a grain inside a cell covers nothing of it."""
    case = grain_box(clone, [(0.055, 0.055)], 1e-5, name=name)
    patches = (
        f"left {{ type fixedValue; value uniform {HOT}; }}"
        f" right {{ type fixedValue; value uniform {COLD}; }}"
        ' "bottom|top" { type zeroGradient; }'
    )
    fix_grains(case)
    with_heat(case, 350, 350, patches, fluid=fluid)
    (case.path / "constant/g").write_text(
        (case.path / "constant/g").read_text().replace("-9.81", "0")
    )
    control(case, deltaT=deltaT, endTime=steps * deltaT, writeInterval=steps)
    case.run("grainThermalFoam")
    return case


@pytest.mark.parametrize(
    "kappa", ["polynomial ((0.006 1))", "table ((300 1.8) (350 2.1) (400 2.4))"]
)
def test_conductivity_that_grows_with_temperature(clone, kappa):
    """In proportion to T: the steady T^2 is linear between the walls."""
    case = between_walls(clone, f"Cp {CP}; kappa {kappa};")
    T = case.field("T").reshape(10, 10)
    x = (np.arange(10) + 0.5) / 10
    exact = np.sqrt(HOT**2 + (COLD**2 - HOT**2) * x)
    # What ten cells leave, over the jump between the walls
    np.testing.assert_allclose(T, np.broadcast_to(exact, T.shape), atol=2e-3 * (HOT - COLD))
    flux = heat_ledger(case)["conducted_right"][-1] / 1e6
    assert flux == pytest.approx(0.006 * (HOT**2 - COLD**2) / 2 / 0.1 * 0.1 * 0.01, rel=2e-3)


def test_functions_that_are_constant_are_numbers(clone):
    """Of kappa and mu, in a flow with grains and heat."""
    fields = []
    for name, fluid in (
        ("numbers", f"Cp {CP}; kappa 0.6; mu 0.1;"),
        ("functions", f"Cp {CP}; kappa table ((250 0.6) (500 0.6)); mu polynomial ((0.1 0));"),
    ):
        case = grain_box(clone, [(0.03, 0.05), (0.07, 0.04)], 0.004, name=name)
        path = case.path / "constant/transportProperties"
        lines = path.read_text().splitlines()
        path.write_text("\n".join(line for line in lines if not line.startswith("nu ")) + "\n")
        with_heat(case, COLD, HOT, fluid=fluid)
        control(case, deltaT=2e-3, endTime=0.04, writeInterval=20)
        case.run("grainThermalFoam")
        fields.append([case.field("T"), case.field("U"), case.grains()["position"]])
    for a, b in zip(*fields, strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-12)


def test_warm_fluid_is_less_viscous(clone):
    """A grain settles in it as in a fluid of the viscosity that it has there."""
    speeds = []
    for name, fluid in (
        ("there", f"Cp {CP}; kappa 0.6; mu 0.05;"),
        ("function", f"Cp {CP}; kappa 0.6; mu table ((300 0.15) (400 0.05));"),
        ("cold", f"Cp {CP}; kappa 0.6; mu 0.15;"),
    ):
        case = grain_box(clone, [(0.05, 0.07)], 0.001, name=name)
        path = case.path / "constant/transportProperties"
        lines = path.read_text().splitlines()
        path.write_text("\n".join(line for line in lines if not line.startswith("nu ")) + "\n")
        with_heat(case, HOT, HOT, fluid=fluid)
        control(case, deltaT=2e-3, endTime=0.1, writeInterval=50)
        case.run("grainThermalFoam")
        speeds.append(case.grains()["velocity"][0, 1])
    assert speeds[1] == pytest.approx(speeds[0], rel=1e-9)
    assert abs(speeds[2]) < 0.8 * abs(speeds[0])
