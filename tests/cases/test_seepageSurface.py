# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of water in fixed beds: a dry bed that is flooded from below, a dam that water seeps
through, against Darcy's law with the drag law's own permeability."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, replace
from water_box import WATER, level, liquid_ledger, set_water, to_two_fluids

GRAINS = "constant/grainProperties"
FLUIDS = "constant/transportProperties"
D, PITCH, NU = 1.6e-3, 2e-3, 3e-5
EPS = 1 - np.pi / 4 * (D / PITCH) ** 2
# Of the velocity between the grains in the gradient that drives it [1/m2]: Stokes, eq. 4.8
RESISTANCE = 18 * (1 - EPS) / (EPS * D**2)
CONDUCTIVITY = EPS * 9.81 / (RESISTANCE * NU)


def bed(clone, centres, cells):
    """Fixed grains with the drag of Stokes in a box whose walls slip."""
    case = grain_box(clone, centres, D / 2)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells[0]} {cells[1]} 1)")
    to_two_fluids(case)
    replace(case, FLUIDS, "nu 1e-6", f"nu {NU}")
    law = "type    DallavalleDiFelice;\n        shape   disc;"
    replace(case, GRAINS, law, "type Stokes; shape sphere;")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    replace(case, "0/U", "noSlip", "slip")
    return case


def test_water_rises_in_a_dry_bed_as_darcy_has_it(clone):
    """The front z from a given head at the bottom, with the inertia of what is wet."""
    cells, start, head, dt, steps = 40, 0.01, 0.12, 3e-3, 200
    case = bed(clone, lattice(50, 50, PITCH, (PITCH / 2, PITCH / 2)), (4, cells))
    for patch in ("bottom", "top"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    set_water(case, level(start))
    walls = '"left|right|bottom|top"'
    ends = '"bottom|top" { type pressureInletOutletVelocity; value uniform (0 0 0); }'
    replace(case, "0/U", walls, ends + ' "left|right"')
    pressures = zip(("bottom", "top"), (WATER * 9.81 * head, 9.81 * 0.1), strict=True)
    ends = " ".join(f"{end} {{ type fixedValue; value uniform {p}; }}" for end, p in pressures)
    replace(case, "0/p_rgh", walls, ends + ' "left|right"')
    ends = " ".join(
        f"{end} {{ type inletOutlet; inletValue uniform {a}; value uniform {a}; }}"
        for end, a in (("bottom", 1), ("top", 0))
    )
    replace(case, "0/alpha.water", walls, ends + ' "left|right"')
    replace(case, GRAINS, "(left right bottom top)", "(left right)")
    control(case, deltaT=dt, endTime=dt * steps, writeInterval=steps)
    case.run("grainInterFoam")

    z, v, front = start, 0.0, []
    for i in range(10 * steps):
        v = (v * z + 0.1 * dt * 9.81 * (head - z)) / (z + 0.1 * dt * RESISTANCE * NU * z)
        z += 0.1 * dt * v
        if i % 10 == 9:
            front.append(z)
    liquid = liquid_ledger(case)
    wet = liquid["liquid"] / (EPS * 0.1 * 0.01)
    part = slice(steps // 8, None)
    # The cell of the surface has the drag of a mixture: less than a cell of 2.5 mm
    assert wet[part] == pytest.approx(np.array(front)[part], abs=0.02 * (0.1 - start))
    assert np.abs(liquid["unaccounted"]).max() <= 1e-10


def test_seepage_through_a_dam(clone):
    """Mean over the dam of the flux: K (h1^2 - h2^2)/(2 L) at each time, whatever the surface in it
    and the face where water leaves above the lower level (Charny)."""
    n, high, low = 20, 0.08, 0.02
    dam = lattice(20, 50, PITCH, (0.03 + PITCH / 2, PITCH / 2))
    case = bed(clone, dam, (n, n))
    case.run("blockMesh")
    begin, end = 6, 14  # cells of the dam

    def heights(least, most):
        x = np.clip((0.5 * (least + most)[:, 0] - 0.03) / 0.04, 0, 1)
        surface = np.sqrt(high**2 - (high**2 - low**2) * x)
        return np.clip((surface - least[:, 1]) / (most - least)[:, 1], 0, 1)

    set_water(case, heights)
    control(case, deltaT=2e-3, endTime=0.4, writeInterval=40)
    case.run("grainInterFoam")
    for time in case.times[2:]:
        water = case.field("alpha.water", time).reshape(n, n)
        flux = case.field("eps", time).reshape(n, n) * water
        flux = flux * case.field("U", time).reshape(n, n, 3)[:, :, 0] * 0.1 / n
        upper, lower = water.sum(axis=0)[[begin - 1, end]] * 0.1 / n
        darcy = CONDUCTIVITY * (upper**2 - lower**2) / (2 * 0.04)
        # Levels in cells of 5 mm: 0.01
        assert flux.sum(axis=0)[begin:end].mean() == pytest.approx(darcy, rel=0.03)
