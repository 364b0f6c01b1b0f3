# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the file of parameters of a run, and the grains.

Usage: bed.py steady|step <law> <Re> [<steps>]

steady: grains so heavy that they stay hot, until the air's temperature is steady
step:   cold air comes into a hot bed, until the grains are cold; of glass with a 100th of its
        heat capacity, so that a step of the run is no longer than a cell's passing
"""

import sys

import numpy as np

EPS, PR = 0.45, 0.71
D = 2e-3
AIR = {"rho": 1.2, "mu": 1.8e-5, "Cp": 1000.0}
COLUMNS, ROWS = 20, 4  # that are hot
COLD = 4  # columns before these, so that the air has the bed's speed when it meets them


def write_grains(spacing):
    x, y = np.meshgrid(np.arange(-COLD, COLUMNS), np.arange(ROWS))
    with open("constant/grains.csv", "w") as file:
        file.write("x,y,z,radius,temperature\n")
        for i, j in zip(x.ravel(), y.ravel(), strict=True):
            place = f"{(i + 0.5) * spacing:.12g},{(j + 0.5) * spacing:.12g},0.005"
            file.write(f"{place},{D / 2:.12g},{300 if i < 0 else 400}\n")


def main():
    kind, law, Re = sys.argv[1], sys.argv[2], float(sys.argv[3])
    spacing = D * np.sqrt(np.pi / 4 / (1 - EPS))
    speed = Re * AIR["mu"] / (AIR["rho"] * D)
    passing = COLUMNS * spacing * EPS / speed
    if kind == "steady":
        steps, end, capacity, scheme = 60, 3 * passing, 1e9, "upwind"
    else:
        steps, end, capacity, scheme = 1000, 0.12, 8.4, "limitedLinear 1"
    step = float(f"{end / steps:.5g}")
    if len(sys.argv) > 4:
        steps = int(sys.argv[4])
    T = ["300"] * (COLD + 2) + ["400"] * (COLUMNS + 2)
    values = AIR | {
        "kappa": AIR["mu"] * AIR["Cp"] / PR,
        "law": law,
        "Re": Re,
        "inflow": speed,
        "d": D,
        "spacing": spacing,
        "columns": COLUMNS,
        "cells": COLD + COLUMNS + 4,
        "start": -(COLD + 2) * spacing,
        "bed": COLUMNS * spacing,
        "end": (COLUMNS + 2) * spacing,
        "height": ROWS * spacing,
        "capacity": capacity,
        "scheme": scheme,
        "deltaT": step,
        "endTime": steps * step,
        "initialT": f"nonuniform List<scalar> {len(T)}({' '.join(T)})",
        "writeInterval": max(1, steps // 4),
    }
    with open("parameters", "w") as file:
        for name, value in values.items():
            text = value if isinstance(value, str) else f"{value:.12g}"
            file.write(f"{name} {text};\n")
    write_grains(spacing)


main()
