# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat in a case that has none: grains and fluid of one's own temperatures.

    case = with_heat(grain_box(clone, centres, radius), T=300, grains=400)
    case.run("grainThermalFoam")
"""

import numpy as np
from grain_box import replace

GRAINS = "constant/grainProperties"
CP = 1000.0
KAPPA = 0.6
GRAIN_CP = 800.0
SOLVER = "{ solver PBiCGStab; preconditioner DILU; tolerance 1e-16; relTol 0; maxIter 500; }"


def with_heat(
    case,
    T=300,
    grains=400,
    patches='"left|right|bottom|top" { type zeroGradient; }',
    law="type RanzMarshall; shape sphere;",
    fluid=f"Cp {CP}; kappa {KAPPA};",
    heat="conductance none;",
    ofGlass=f"heatCapacity {GRAIN_CP};",
    convection="upwind",
    empty="frontAndBack { type empty; }",
):
    """Add temperatures [K], a number or one per cell, and laws, after the mesh is made."""
    write_T(case, T, f"{patches} {empty}")
    file = case.path / "constant/transportProperties"
    file.write_text(f"{file.read_text()}\n{fluid}\n")
    replace(case, GRAINS, "density 2500;", f"density 2500; {ofGlass}")
    material = "    material    glass;"
    replace(case, GRAINS, f'csv";\n{material}', f'csv";\n{material} temperature {grains};')
    coupling = "\ncoupling\n{"
    replace(
        case, GRAINS, coupling, f"\nheat {{ {heat} }}{coupling}\n    heatTransfer {{ {law} }}"
    )
    scheme = f"    div(phiFluid,T) Gauss {convection};\n"
    replace(case, "system/fvSchemes", "    div(tau)", f"{scheme}    div(tau)")
    replace(case, "system/fvSolution", "    U\n", f"    T {SOLVER}\n    U\n")
    return case


def write_T(case, T, patches):
    write_scalar(case, "T", "0 0 0 1 0 0 0", T, patches)


def write_scalar(case, name, dimensions, values, patches):
    """A number or one per cell."""
    values = np.atleast_1d(np.asarray(values, dtype=float))
    inside = f"uniform {float(values[0])!r}"
    if len(values) > 1:
        inside = f"nonuniform List<scalar> {len(values)}({' '.join(map(repr, values.tolist()))})"
    (case.path / "0" / name).write_text(
        f"FoamFile {{ version 2.0; format ascii; class volScalarField; object {name}; }}\n"
        f"dimensions [{dimensions}];\ninternalField {inside};\n"
        f"boundaryField {{ {patches} }}\n"
    )


def with_psi(case, psi, patches, convection="upwind"):
    """Vapour, a number or one per cell, in a case with heat whose fluid has 'vapour'."""
    write_scalar(case, "psi", "0 0 0 0 0 0 0", psi, patches)
    replace(case, "system/fvSolution", "    T {", f"    psi {SOLVER}\n    T {{")
    scheme = f"    div(phiFluid,psi) Gauss {convection};\n"
    replace(case, "system/fvSchemes", "    div(tau)", f"{scheme}    div(tau)")


def vapour_ledger(case):
    """Columns of the vapour's ledger of a run from the start."""
    return case.table("postProcessing/vapourLedger/0/vapourLedger.csv")


def heat_ledger(case):
    """Columns of the heat's ledger, all starts of the run one after the other."""
    folder = case.path / "postProcessing/heatLedger"
    tables = [
        case.table(start.relative_to(case.path) / "heatLedger.csv")
        for start in sorted(folder.iterdir(), key=lambda path: float(path.name))
    ]
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


def fix_grains(case):
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")


def stream(case, speed):
    """Of a uniform speed along x, from left to right; no gravity, slip on other sides."""
    for patch in ("left", "right"):
        make_patch(case, "constant/polyMesh/boundary", patch)
    U = case.path / "0/U"
    text = U.read_text()
    empty = "" if "frontAndBack" not in text else "frontAndBack { type empty; }"
    U.write_text(
        text[: text.index("internalField")]
        + f"internalField uniform ({speed} 0 0);\nboundaryField {{ {empty}"
        + f" left {{ type fixedValue; value uniform ({speed} 0 0); }}"
        + " right { type zeroGradient; }"
        + ' "bottom|top|back|front" { type slip; } }\n'
    )
    p = case.path / "0/p_rgh"
    text = p.read_text()
    p.write_text(
        text[: text.index("boundaryField")]
        + f"boundaryField {{ {empty} right {{ type fixedValue; value uniform 0; }}"
        + ' "left|bottom|top|back|front" { type zeroGradient; } }\n'
    )
    text = (case.path / "constant/g").read_text()
    (case.path / "constant/g").write_text(text.replace("-9.81", "0"))
    text = (case.path / GRAINS).read_text()
    for old in ('(".*")', "(left right bottom top)"):
        text = text.replace(old, '("bottom|top|back|front")')
    (case.path / GRAINS).write_text(text)


def make_patch(case, file, patch):
    """A wall becomes a patch."""
    case.dict_set(file, f"entry0/{patch}/type", "patch")
    groups = ["-entry", f"entry0/{patch}/inGroups", "-remove"]
    case.run(["foamDictionary", file, *groups], check=False)
