# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Droplets in a case that has none: a box, or the gas between a droplet and a circle.

    case = with_droplets(with_heat(grain_box(clone)), [(0.05, 0.05)], 0.01)
    case.run("grainDropletFoam")
"""

import numpy as np
import pytest
from grain_box import DEPTH, replace
from heat_box import with_heat, write_T

HEADER = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
DENSITY = 1000.0
LATENT = 2.26e6
BOILING = 373.15
DROPLETS = "constant/dropletProperties"
FLUID = "constant/transportProperties"
GAS_RHO, GAS_CP, GAS_K = 1.2, 1040.0, 0.026
GAS = f"Cp {GAS_CP}; kappa {GAS_K};"
WALLS = '"left|right|bottom|top"'
SURFACES = pytest.mark.parametrize("surface", ["locked", "cutCells"])
# Water from 256 to 373 K
ANTOINE = """saturation
{{
    curve       {{ type Antoine; A 4.6543; B 1435.264; C -64.848; }}
    pressure    {pressure};
    molarMasses 0.622;
    temperature {temperature};
}}
"""


def share_of_water(T, pressure=1e5):
    """Mass fraction of the saturated vapour in air."""
    moles = 1e5 / pressure * 10 ** (4.6543 - 1435.264 / (T - 64.848))
    return 0.622 * moles / (0.622 * moles + 1 - moles)


def with_droplets(
    case,
    centres,
    radius,
    velocity=None,
    liquid="",
    entries="",
    density=DENSITY,
    latent=LATENT,
    surface="locked",
):
    """Add droplets at centres (n, 2) of one radius, or one per droplet."""
    centres = np.asarray(centres, dtype=float).reshape(-1, 2)
    n = len(centres)
    velocity = np.zeros((n, 2)) if velocity is None else np.asarray(velocity).reshape(n, 2)
    rows = np.column_stack([centres, np.full(n, DEPTH / 2), np.broadcast_to(radius, n), velocity])
    lines = [",".join(repr(float(value)) for value in row) for row in rows]
    text = "\n".join(["x,y,z,radius,vx,vy", *lines, ""])
    (case.path / "constant/droplets.csv").write_text(text)
    (case.path / DROPLETS).write_text(
        HEADER.format(kind="dictionary", name="dropletProperties")
        + f"liquid {{ density {density}; latentHeat {latent}; boilingTemperature {BOILING};"
        + f" mu 2.8e-4; kappa 0.68; Cp 4200; {liquid} }}\n"
        + 'initialDroplets { type csv; file "constant/droplets.csv"; }\n'
        + f"surface {surface};\n"
        + entries
    )
    return case


def droplet_table(case):
    """Columns of the droplets' books."""
    return case.table("postProcessing/droplets/0/droplets.csv")


def force_in_fall(table, speed):
    """Mean force of the gas on a droplet that falls from rest, over its weight."""
    return 1 + table[speed][-1] / (9.81 * table["time"][-1])


def annulus(case, core, outer, cells, rings, right="outer", grading=1.0):
    """A mesh of squares around the origin, of half width 'core' and 'cells' across, between
    them and a circle of radius 'outer' 'rings' of cells, the outermost 'grading' times as thick;
    patch 'outer', whose quarter towards +x may have a name of its own."""
    a, b, z = float(core), float(outer / np.sqrt(2)), DEPTH
    square = [(-a, -a), (a, -a), (a, a), (-a, a)]
    circle = [(-b, -b), (b, -b), (b, b), (-b, b)]
    plane = square + circle
    points = [f"({x!r} {y!r} {h!r})" for h in (0, z) for x, y in plane]
    blocks = [f"hex (0 1 2 3 8 9 10 11) ({cells} {cells} 1) simpleGrading (1 1 1)"]
    arcs, faces = [], {"outer": [], right: []}
    for i in range(4):
        j = (i + 1) % 4
        corners = (4 + i, 4 + j, j, i)
        both = " ".join(map(str, [*corners, *(k + 8 for k in corners)]))
        blocks.append(f"hex ({both}) ({cells} {rings} 1) simpleGrading (1 {1 / grading} 1)")
        middle = outer * np.array([(0, -1), (1, 0), (0, 1), (-1, 0)][i])
        for h, plus in ((0, 0), (z, 8)):
            point = f"({float(middle[0])!r} {float(middle[1])!r} {h!r})"
            arcs.append(f"arc {4 + i + plus} {4 + j + plus} {point}")
        name = right if i == 1 else "outer"
        faces[name].append(f"({4 + i} {4 + j} {12 + j} {12 + i})")
    (case.path / "system/blockMeshDict").write_text(
        HEADER.format(kind="dictionary", name="blockMeshDict")
        + f"scale 1; vertices ({' '.join(points)}); blocks ({' '.join(blocks)});\n"
        + f"edges ({' '.join(arcs)}); defaultPatch {{ name frontAndBack; type empty; }}\n"
        + "boundary ("
        + " ".join(f"{k} {{ type patch; faces ({' '.join(v)}); }}" for k, v in faces.items())
        + ");\n"
    )
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/grainProperties", "(left right bottom top)", "(outer)")
    case.run("blockMesh")


def ring(case, inner, outer, around, rings, grading=1.0):
    """A mesh fitted to a circle: between patch 'droplet' of radius 'inner' and 'outer', cells
    'around' a quarter and 'rings' of them, the outermost 'grading' times as thick; the quarter
    towards +x of the outer circle is patch 'right'."""
    plane = []
    for radius in (inner, outer):
        b = float(radius / np.sqrt(2))
        plane += [(-b, -b), (b, -b), (b, b), (-b, b)]
    z = DEPTH
    points = [f"({x!r} {y!r} {h!r})" for h in (0, z) for x, y in plane]
    blocks, arcs, sides, drops = [], [], {"outer": [], "right": []}, []
    for i in range(4):
        j = (i + 1) % 4
        corners = (i, 4 + i, 4 + j, j)
        both = " ".join(map(str, [*corners, *(k + 8 for k in corners)]))
        blocks.append(f"hex ({both}) ({rings} {around} 1) simpleGrading ({grading} 1 1)")
        for first, radius in ((0, inner), (4, outer)):
            middle = radius * np.array([(0, -1), (1, 0), (0, 1), (-1, 0)][i])
            for h, plus in ((0, 0), (z, 8)):
                point = f"({float(middle[0])!r} {float(middle[1])!r} {h!r})"
                arcs.append(f"arc {first + i + plus} {first + j + plus} {point}")
        sides["right" if i == 1 else "outer"].append(f"({4 + i} {4 + j} {12 + j} {12 + i})")
        drops.append(f"({i} {8 + i} {8 + j} {j})")
    (case.path / "system/blockMeshDict").write_text(
        HEADER.format(kind="dictionary", name="blockMeshDict")
        + f"scale 1; vertices ({' '.join(points)}); blocks ({' '.join(blocks)});\n"
        + f"edges ({' '.join(arcs)}); defaultPatch {{ name frontAndBack; type empty; }}\n"
        + f"boundary (outer {{ type patch; faces ({' '.join(sides['outer'])}); }}"
        + f" right {{ type patch; faces ({' '.join(sides['right'])}); }}"
        + f" droplet {{ type patch; faces ({' '.join(drops)}); }});\n"
    )
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/grainProperties", "(left right bottom top)", "(droplet)")
    case.run("blockMesh")


def make_gas(case, nu=1.6e-5):
    replace(case, FLUID, "rho     [1 -3 0 0 0 0 0] 1000;", f"rho {GAS_RHO};")
    replace(case, FLUID, "1e-4;", f"{nu};")


def in_annulus(clone, B, cells, offset, outer=4e-3, radius=1e-3, **droplet):
    """A droplet of 'cells' across in a circle of hot gas, with the exact temperature
    T - T_d = L/c ((r/R)^a - 1), a = ln(1 + B)/ln(R_o/R), of a droplet that does not shrink."""
    a = np.log1p(B) / np.log(outer / radius)

    def T(r):
        return BOILING + LATENT / GAS_CP * (np.maximum(r / radius, 1) ** a - 1)

    return in_circle(clone, T, cells, offset, outer, radius, **droplet)


def in_circle(clone, T, cells, offset, outer, radius, fluid=GAS, **droplet):
    """A droplet of 'cells' across in an open circle of gas of temperature T(r)."""
    case = clone("grainBox")
    (case.path / "constant/grains.csv").write_text("x,y,z,radius\n")
    h = 2 * radius / cells
    across = round(1.6 * cells)
    annulus(case, across * h / 2, outer, across, round((outer - 1.8 * radius) / h))
    hot = f"type fixedValue; value uniform {float(T(outer))!r};"
    with_heat(case, grains=300, patches=f"outer {{ {hot} }}", fluid=fluid, convection="linear")
    write_T(case, T(distances(case)), f"outer {{ {hot} }} frontAndBack {{ type empty; }}")
    make_gas(case)
    replace(case, "0/U", f"{WALLS}\n    {{\n        type    noSlip;", "outer { type zeroGradient;")
    fixed = "outer { type fixedValue; value uniform 0;"
    replace(case, "0/p_rgh", f"{WALLS}\n    {{\n        type    zeroGradient;", fixed)
    return with_droplets(case, [np.array(offset) * h], radius, **droplet)


def distances(case):
    """Of the cells from the origin."""
    centres = np.array([polygon.mean(axis=0) for polygon in case.mesh().polygons])
    return np.linalg.norm(centres, axis=1)


def open_top(case):
    """Vapour leaves through the top."""
    top = "top { type pressureInletOutletVelocity; value uniform (0 0 0); }"
    replace(case, "0/U", WALLS, f'{top}\n    "left|right|bottom"')
    top = "top { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", WALLS, f'{top}\n    "left|right|bottom"')
