# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A heavy disc that starts through fluid at rest in a periodic box of 4 by 4 diameters, seen from
frames of several speeds."""

import numpy as np
from grain_box import DEPTH, control, cyclic_box, replace, tracks

SPEED, D, RHO = 0.1, 0.025, 1000.0


def force(clone, Re, cells, courant, angle, frame, end, scheme="backward"):
    """Way [diameters] and force on the disc along it and across, over rho U^2 d/2, (n, 2).

    cells     in the diameter
    courant   cells that the disc passes of the fluid in a step
    angle     of the way to the mesh [degrees]
    frame     speed of the disc over that with which it passes the fluid
    end       of the way
    """
    way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    case = cyclic_box(clone, [(0.0471, 0.0411)], D / 2)
    case.path = case.path.rename(case.path.with_name(f"{Re}_{cells}_{courant}_{angle}_{frame}"))
    disc = case.path / "constant/grains.csv"
    vx, vy = frame * SPEED * way
    disc.write_text(disc.read_text().replace(",0.0,0.0\n", f",{vx},{vy}\n"))
    ux, uy = (frame - 1) * SPEED * way
    replace(case, "0/U", "uniform (0 0 0)", f"uniform ({ux} {uy} 0)")
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({4 * cells} {4 * cells} 1)")
    replace(case, "constant/transportProperties", "1e-4", repr(SPEED * D / Re))
    replace(case, "constant/grainProperties", "density 2500", "density 1e6")
    resolved = "\ncoupling\n{\n    resolvedGrains { type cutCells; from 4; }"
    replace(case, "constant/grainProperties", "\ncoupling\n{", resolved)
    replace(case, "system/fvSchemes", "Euler", scheme)
    replace(case, "system/fvSchemes", "U)   Gauss linear;", "U)   Gauss linearUpwind grad(U);")
    replace(case, "system/fvSolution", "nCorrectors     2", "nCorrectors     3")
    step = courant * D / cells / SPEED
    n = round(end * D / SPEED / step)
    control(case, deltaT=step, endTime=n * step, writeInterval=n)
    case.run("blockMesh")
    case.run("grainFoam", timeout=36000)
    motion = tracks(case)
    along_and_across = np.column_stack([way, [-way[1], way[0]]])
    unit = RHO * SPEED**2 * D * DEPTH / 2
    return motion[:, 0] * SPEED / D, motion[:, 11:13] @ along_and_across / unit


def drag_and_jump(way, forces, begin):
    """Mean drag, and the largest jump of the force from step to step over it."""
    later = forces[way > begin]
    drag = abs(later[:, 0].mean())
    return drag, np.linalg.norm(np.diff(later, axis=0), axis=1).max() / drag
