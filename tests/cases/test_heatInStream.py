# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat of resolved bodies in a stream, against published Nusselt numbers; minutes each."""

import re

import numpy as np
import pytest
from grain_box import control, grain_box, replace
from heat_box import SOLVER, fix_grains, heat_ledger, stream, with_heat
from sphere_box import sphere_box

D, U, RHO, CP, PR = 0.01, 0.1, 1.0, 1000.0, 0.7
COLD, HOT = 300.0, 310.0
DEPTH = 0.01
TOLERANT = SOLVER.replace("1e-15", "1e-13")


class Axis:
    """Even cells of a size around 0, growing ones towards the ends; lengths in diameters."""

    def __init__(self, ends, core, size, growth):
        def outside(length):
            return int(np.ceil(np.log1p(length * (growth - 1) / size) / np.log(growth)))

        lengths = [core[0] - ends[0], core[1] - core[0], ends[1] - core[1]]
        counts = [outside(lengths[0]), round(lengths[1] / size), outside(lengths[2])]
        total = growth ** (counts[0] - 1), growth ** (counts[2] - 1)
        ratios = [1 / total[0], 1, total[1]]
        self.cells = sum(counts)
        self.ends = [end * D for end in ends]
        parts = zip(lengths, counts, ratios, strict=True)
        self.grading = f"({' '.join(f'({a} {n} {r})' for a, n, r in parts)})"


def mesh(case, x, y, z=None):
    path = case.path / "system/blockMeshDict"
    text = path.read_text()
    lower, upper = z.ends if z else (0, DEPTH)
    corners = [
        (a, b, c)
        for c in (lower, upper)
        for a, b in (
            (x.ends[0], y.ends[0]), (x.ends[1], y.ends[0]),
            (x.ends[1], y.ends[1]), (x.ends[0], y.ends[1]),
        )
    ]
    points = " ".join(f"({a!r} {b!r} {c!r})" for a, b, c in corners)
    text = re.sub(r"vertices\s*\(.*?\n\);", f"vertices\n({points}\n);", text, flags=re.S)
    cells = f"({x.cells} {y.cells} {z.cells if z else 1})"
    grading = f"simpleGrading ({x.grading} {y.grading} {z.grading if z else 1})"
    block = f"blocks\n(hex (0 1 2 3 4 5 6 7) {cells} {grading}\n);"
    text = re.sub(r"blocks\s*\(.*?\n\);", block, text, flags=re.S)
    path.write_text(text)
    case.run("blockMesh")


def hot_body(case, Re, size, end, patches, empty, law):
    """One that stays hot in a cold stream; mean Nusselt number of the last tenth of the run."""
    nu = U * D / Re
    kappa = RHO * CP * nu / PR
    fix_grains(case)
    stream(case, U)
    replace(case, "constant/transportProperties", "1000;", f"{RHO};")
    replace(case, "constant/transportProperties", "1e-4;", f"{nu!r};")
    left = f"left {{ type fixedValue; value uniform {COLD}; }}"
    with_heat(
        case, COLD, HOT, f"{left} {patches}", law, f"Cp {CP}; kappa {kappa!r};",
        ofGlass="heatCapacity 1e4;", convection="limitedLinear 1", empty=empty,
    )
    path = case.path / "system/fvSolution"
    text = re.sub(r"tolerance +1e-12", "tolerance 1e-7", path.read_text())
    text = text.replace("preconditioner  DIC;", "preconditioner { preconditioner GAMG; smoother"
                        " DICGaussSeidel; tolerance 1e-5; relTol 0.1; }")
    path.write_text(text.replace(SOLVER, TOLERANT))
    deltaT = 0.5 * size * D / U
    steps = int(end * D / U / deltaT)
    control(case, deltaT=repr(deltaT), endTime=repr(steps * deltaT), writeInterval=steps)
    case.run("grainThermalFoam", timeout=14400)
    book = heat_ledger(case)
    heat = -book["exchanged"][-steps // 10 :].mean() / deltaT
    return heat / (np.pi * kappa * (book["meanGrainT"][-1] - COLD))


# Lange et al., Int. J. Heat Mass Transfer 41, 3409 (1998); doi:10.1016/S0017-9310(98)00077-5
@pytest.mark.slow
@pytest.mark.parametrize(("Re", "reference", "end"), [(40, 3.28, 30), (100, 5.13, 100)])
def test_cylinder(clone, Re, reference, end):
    size = 1 / 20
    case = grain_box(clone, [(0.0031 * D, 0.0123 * D)], D / 2)
    x = Axis((-20, 20), (-1, 2.5), size, 1.07)
    y = Axis((-40, 40), (-1, 1), size, 1.1)
    mesh(case, x, y)
    patches = '"right|bottom|top" { type zeroGradient; }'
    law = "type ChurchillBernstein;"
    empty = "frontAndBack { type empty; }"
    Nu = hot_body(case, Re, size, end, patches, empty, law) / DEPTH
    print("Nu", Re, Nu)
    assert pytest.approx(reference, rel=0.04) == Nu


# Ranz and Marshall 7.33, Whitaker 6.8
@pytest.mark.slow
@pytest.mark.parametrize(("cells", "least", "most"), [(12, 6.6, 7.4), (8, 6.2, 8.4)])
def test_sphere(clone, cells, least, most):
    size = 1 / cells
    case = sphere_box(clone, [(0.03 * size * D, 0.21 * size * D, 0.13 * size * D)], D / 2)
    x = Axis((-5, 8), (-0.8, 1.2), size, 1.12)
    y = Axis((-5, 5), (-0.8, 0.8), size, 1.15)
    mesh(case, x, y, Axis((-5, 5), (-0.8, 0.8), size, 1.15))
    patches = '".*" { type zeroGradient; }'
    Nu = hot_body(case, 100, size, 12, patches, "", "type RanzMarshall;") / D
    print("Nu", cells, Nu)
    assert least <= Nu <= most
