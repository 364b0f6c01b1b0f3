# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets with saturated vapour at their surface, held in a circle of gas and in a box."""

from droplet_box import (
    ANTOINE,
    GAS,
    GAS_CP,
    GAS_K,
    GAS_RHO,
    in_circle,
    make_gas,
    open_top,
    with_droplets,
)
from grain_box import grain_box
from heat_box import with_heat, with_psi

RADIUS, OUTER = 1e-3, 4e-3
DIFFUSIVITY = GAS_K / (GAS_RHO * GAS_CP)


def saturated(clone, gas, start, rim=0.0, **droplet):
    """A droplet of 8 cells across that is held in a circle of gas of Lewis number 1."""
    case = in_circle(
        clone,
        lambda r: gas + 0 * r,
        8,
        (0.3, 0.1),
        OUTER,
        RADIUS,
        fluid=f"{GAS} vapour {{ D {DIFFUSIVITY!r}; }}",
        entries="motion fixed;" + ANTOINE.format(pressure=1e5, temperature=start),
        **droplet,
    )
    outer = f"outer {{ type fixedValue; value uniform {rim}; }} frontAndBack {{ type empty; }}"
    with_psi(case, rim, outer, "linear")
    return case


def in_humid_box(clone, gas, psi, start, velocity=(0, 0), name=None, D=2e-5, nu=1.6e-5, **droplet):
    """A droplet of 4.4 cells across in gas that fills the box and comes in through its top."""

    def as_outside(value):
        top = f"top {{ type inletOutlet; inletValue uniform {value}; value uniform {value}; }}"
        return f'{top} "left|right|bottom" {{ type zeroGradient; }}'

    case = grain_box(clone, name=name)
    fluid = f"{GAS} vapour {{ D {D}; }}"
    with_heat(case, T=gas, grains=300, patches=as_outside(gas), fluid=fluid)
    make_gas(case, nu)
    open_top(case)
    with_psi(case, psi, f"{as_outside(psi)} frontAndBack {{ type empty; }}")
    entries = ANTOINE.format(pressure=1e5, temperature=start)
    with_droplets(case, [(0.048, 0.045)], 0.022, velocity=[velocity], entries=entries, **droplet)
    return case
