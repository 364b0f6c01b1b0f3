# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A disc of liquid that is held in a stream of gas, on a mesh that is fitted to it and cut out of
one that is not: force, heat and vapour flow (results.csv).

Usage: compare.py [-bed] [-cutCells] <cells in the diameter> [...] [-Re <number> ...]

With -bed grains that are held fill half of the gas, from a tenth of the radius off the droplet to
4 radii from its centre.  With -cutCells the droplet leaves parts of cells open.
"""

import shutil
import sys
from pathlib import Path

import foamlib
import grainplot
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/cases"))

import conftest  # noqa: E402
from droplet_box import (  # noqa: E402
    BOILING,
    DENSITY,
    GAS_CP,
    GAS_RHO,
    LATENT,
    annulus,
    droplet_table,
    make_gas,
    ring,
    with_droplets,
)
from grain_box import DEPTH, control, replace  # noqa: E402
from heat_box import with_heat  # noqa: E402

RADIUS, OUTER, SPEED, PRANDTL = 1e-3, 8e-3, 1.0, 0.7
# With blowing: Spalding's number; without it vapour is too little to be felt
BLOWING = {1: 0.3, 10: 1.0, 30: 1.0}
WALLS = '"left|right|bottom|top"\n    {\n        type    '


def case_of(name):
    path = Path(name)
    shutil.rmtree(path, ignore_errors=True)
    shutil.copytree(ROOT / "tests/cases/grainBox", path)
    (path / "0.orig").rename(path / "0")
    (path / "constant/grains.csv").write_text("x,y,z,radius\n")
    return conftest.Case(path.resolve())


def add_bed(case, place, d=2.2e-4, room=0.5):
    """Grains that are held, in a hexagonal lattice around the droplet."""
    a = d * np.sqrt(np.pi / (2 * np.sqrt(3) * (1 - room)))
    n = int(5 * RADIUS / a)
    i, j = np.meshgrid(np.arange(-n, n + 1), np.arange(-n, n + 1))
    x = np.stack([a * (i + j % 2 / 2), a * np.sqrt(0.75) * j], axis=-1).reshape(-1, 2)
    r = np.hypot(*x.T)
    x = x[(r > 1.1 * RADIUS + d / 2) & (r < 4 * RADIUS)] + place
    rest = np.broadcast_to((DEPTH / 2, d / 2), x.shape)
    rows = np.column_stack([x, rest])
    lines = [",".join(repr(float(v)) for v in row) for row in rows]
    (case.path / "constant/grains.csv").write_text("\n".join(["x,y,z,radius", *lines, ""]))
    replace(case, "constant/grainProperties", "\ncoupling\n{", "\ncoupling\n{\n    motion fixed;")


def set_up(case, Re, B, cells, patch, bed, place=(0, 0)):
    """Gas and stream; the patch fields of the droplet, none if it is cut out."""
    nu = SPEED * 2 * RADIUS / Re
    kappa = GAS_RHO * GAS_CP * nu / PRANDTL
    hot = BOILING + 0.3 * LATENT / GAS_CP if B == 0 else BOILING + B * LATENT / GAS_CP
    latent = 1e9 * LATENT if B == 0 else LATENT
    sides = f"outer {{ type fixedValue; value uniform {hot}; }} right {{ type zeroGradient; }}"
    stream = (
        f"outer {{ type fixedValue; value uniform ({SPEED} 0 0); }} right {{ type zeroGradient; }}"
    )
    fixed = "right { type fixedValue; value uniform 0; } outer { type zeroGradient; }"
    if patch:
        sides += f" droplet {{ type fixedValue; value uniform {BOILING}; }}"
        stream += (
            f" droplet {{ type dropletBlowing; latentHeat {latent}; vapourDensity {GAS_RHO};"
            " value uniform (0 0 0); }"
        )
        fixed += " droplet { type fixedFluxPressure; }"
        replace(
            case, "system/controlDict", "functions", 'libs ("libgrainDroplets.so");\n\nfunctions'
        )
    with_heat(
        case,
        T=hot,
        grains=hot,
        patches=sides,
        fluid=f"Cp {GAS_CP}; kappa {kappa};",
        convection="linear",
    )
    make_gas(case, nu)
    if bed:
        add_bed(case, place)
    replace(case, "0/U", f"{WALLS}noSlip;\n    }}", stream)
    replace(case, "0/p_rgh", f"{WALLS}zeroGradient;\n    }}", fixed)
    replace(case, "0/U", "uniform (0 0 0);\n\nboundary", f"uniform ({SPEED} 0 0);\n\nboundary")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     4")
    h = 2 * RADIUS / cells
    dt = min(0.3 * h / SPEED, 1.5 * h**2 / nu)
    end = (12 if Re > 1 else 5) * 2 * RADIUS / SPEED
    steps = int(np.ceil(end / dt))
    control(case, endTime=steps * dt, deltaT=dt, writeInterval=steps)
    return latent, kappa, nu, dt


def fitted(Re, B, cells, bed):
    case = case_of(f"fitted_{Re}_{B:g}_{cells}" + "_bed" * bed)
    around = round(np.pi * cells / 4)
    ring(case, RADIUS, OUTER, around, round(1.6 * cells), 5)
    latent, kappa, nu, _ = set_up(case, Re, B, cells, True, bed)
    case.run("grainThermalFoam", timeout=7200)
    return on_patch(case, latent, kappa, GAS_RHO * nu)


def on_patch(case, latent, kappa, mu):
    """Sums over the faces of the patch: the force with what vapour takes along."""
    mesh = case.path / "constant/polyMesh"
    points = np.asarray(grainplot._standalone(mesh / "points"))
    faces = grainplot._standalone(mesh / "faces")
    if isinstance(faces, tuple):
        start, vertices = faces
        faces = np.split(vertices, start[1:-1])
    owner = np.asarray(grainplot._standalone(mesh / "owner"))
    patch = dict(grainplot._standalone(mesh / "boundary"))["droplet"]
    ids = range(patch["startFace"], patch["startFace"] + patch["nFaces"])
    centre = np.array([points[faces[i]].mean(axis=0)[:2] for i in ids])
    ends = [points[faces[i]][:, :2] for i in ids]
    length = np.array([np.ptp(e, axis=0) for e in ends])
    area = np.hypot(*length.T) * DEPTH
    n = centre / np.linalg.norm(centre, axis=1)[:, None]
    polygons = case.mesh().polygons
    cell = np.array([centroid(polygons[owner[i]]) for i in ids])
    delta = 1 / np.sum((cell - centre) * n, axis=1)

    def at(name, columns):
        file = foamlib.FoamFieldFile(case.path / case.times[-1] / name)
        inside = np.asarray(file.internal_field)[owner[list(ids)]]
        value = np.asarray(file.boundary_field["droplet"]["value"])
        return inside, np.broadcast_to(value, (len(area), columns) if columns > 1 else len(area))

    U, Us = (v[:, :2] for v in at("U", 3))
    T, Ts = at("T", 1)
    _, p = at("p_rgh", 1)
    q = kappa * (T - Ts) * delta
    speed = np.sum(Us * n, axis=1)
    stress = -p[:, None] * n + mu * (U - Us) * delta[:, None]
    stress -= (GAS_RHO * speed**2)[:, None] * n
    return (area @ stress)[0], area @ q, GAS_RHO * (area @ speed), speed.mean() / SPEED


def centroid(polygon):
    x, y = polygon.T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    weight = 3 * cross.sum()
    return np.array(
        [(cross * (v + np.roll(v, -1))).sum() / weight for v in (x, y)]
    )


def cut(Re, B, cells, bed, surface="locked", offset=(0.3, 0.1)):
    """Beside the centre of cells."""
    case = case_of(f"cut_{Re}_{B:g}_{cells}" + "_bed" * bed)
    h = 2 * RADIUS / cells
    across = round(1.8 * cells)
    annulus(case, across * h / 2, OUTER, across, round(1.5 * cells), "right", 4)
    place = np.array(offset) * h
    latent, _, _, dt = set_up(case, Re, B, cells, False, bed, place)
    with_droplets(
        case,
        [place],
        RADIUS,
        density=1e6 * DENSITY,
        latent=latent,
        entries="motion fixed;",
        surface=surface,
    )
    case.run("grainDropletFoam", timeout=7200)
    book = droplet_table(case)
    rate = book["vapour"][-1] / dt
    speed = rate / (2 * np.pi * RADIUS * DEPTH * GAS_RHO) / SPEED
    return book["fx"][-1], book["fromFluid"][-1] / dt, rate, speed


def main(arguments):
    numbers = [1, 10, 30]
    bed = "-bed" in arguments
    surface = "cutCells" if "-cutCells" in arguments else "locked"
    arguments = [a for a in arguments if a not in ("-bed", "-cutCells")]
    if "-Re" in arguments:
        at = arguments.index("-Re")
        numbers = [int(a) for a in arguments[at + 1 :]]
        arguments = arguments[:at]
    with open("results.csv", "a") as table:
        for cells in map(int, arguments):
            for Re in numbers:
                for B in (0, BLOWING[Re]):
                    one = fitted(Re, B, cells, bed)
                    other = cut(Re, B, cells, bed, surface)
                    ratios = [b / a for a, b in zip(one, other, strict=True)]
                    row = [cells, Re, B, int(bed), *one, *ratios]
                    line = ",".join(f"{value:.6g}" for value in row)
                    print(line, file=table, flush=True)
                    print(line, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
