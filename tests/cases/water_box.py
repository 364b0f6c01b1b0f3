# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case grainBox with water and air, for grainInterFoam and, without grains, for interFoam.

    case = water_box(clone, level(0.05), [(0.05, 0.08)], radius=0.004)
    case.run("grainInterFoam")
"""

import re

import numpy as np
from grain_box import grain_box, replace
from moving_mesh import write

WATER, AIR = 1000.0, 1.0
SIZE = 0.1

TRANSPORT = """
phases (water air);
water { transportModel Newtonian; nu 1e-6; rho %g; }
air { transportModel Newtonian; nu 1.48e-5; rho %g; }
sigma %g;
"""
SCHEMES = """div(rhoPhi,U)   Gauss linearUpwind grad(U);
    div(phi,alpha)  Gauss vanLeer;
    div(phirb,alpha) Gauss linear;"""
ALPHA = """"alpha.water.*"
    {
        MULESCorr yes; nAlphaCorr 1; nAlphaSubCycles 1; nLimiterIter 5; cAlpha 1;
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0;
    }
    UFinal { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0; }
    "pcorr.*" { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; }
    p_rgh
"""


def level(height):
    """Share of a cell, (n, 2) of least and most y, that water up to a height has."""
    return lambda low, high: np.clip(
        (height - low[:, 1]) / (high[:, 1] - low[:, 1]), 0, 1
    )


def column(width, height):
    """The same of a column of water at the left."""

    def share(low, high):
        x = np.clip((width - low[:, 0]) / (high[:, 0] - low[:, 0]), 0, 1)
        return x * level(height)(low, high)

    return share


def corners(case):
    """Least and most coordinates of the cells' polygons, (n, 2) each."""
    polygons = case.mesh().polygons
    return (
        np.array([p.min(axis=0) for p in polygons]),
        np.array([p.max(axis=0) for p in polygons]),
    )


def water_box(
    clone,
    water,
    centres=(),
    radius=0.004,
    cells=(10, 10),
    mesh="quads",
    densities=(WATER, AIR),
    sigma=0.0,
    velocity=None,
    name=None,
):
    """Water where the function says it, see level; grains as in grain_box."""
    case = grain_box(clone, centres, radius, velocity=velocity, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells[0]} {cells[1]} 1)")
    case.run("blockMesh")
    to_two_fluids(case, densities, sigma)
    set_water(case, water)
    return case


def to_two_fluids(case, densities=(WATER, AIR), sigma=0.0):
    path = case.path / "constant/transportProperties"
    header = re.match(r"FoamFile\s*\{[^}]*\}", path.read_text())[0]
    path.write_text(header + TRANSPORT % (*densities, sigma))
    replace(case, "system/fvSchemes", "div(phiEps,U)   Gauss linear;", SCHEMES)
    replace(
        case, "system/fvSchemes", "div(tau)", "div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;\n"
        "    div(tau)"
    )
    path = case.path / "system/fvSolution"
    text = path.read_text().replace("PISO", "PIMPLE", 1)
    path.write_text(text.replace("p_rgh\n", ALPHA, 1))
    path = case.path / "0/p_rgh"
    path.write_text(
        path.read_text().replace("zeroGradient;", "fixedFluxPressure; value uniform 0;")
    )


def set_water(case, water, walls="zeroGradient"):
    """0/alpha.water from the share of each cell, with a type of the walls' patches."""
    values = "\n".join(repr(float(v)) for v in water(*corners(case)))
    n = values.count("\n") + 1
    write(
        case,
        "0/alpha.water",
        "volScalarField",
        f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar> {n}\n(\n{values}\n);\n"
        f'boundaryField {{ "left|right|bottom|top" {{ type {walls}; }}\n'
        "frontAndBack { type empty; } }\n",
    )


def liquid_ledger(case):
    """Columns of the liquid's ledger, all starts of the run one after the other."""
    folder = case.path / "postProcessing/liquidLedger"
    tables = [
        case.table(start.relative_to(case.path) / "liquidLedger.csv")
        for start in sorted(folder.iterdir(), key=lambda path: float(path.name))
    ]
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}
