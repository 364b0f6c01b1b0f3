# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the file of parameters of a run.

Usage: cavity.py air|bed <Rayleigh number> [<steps>]

Walls are 10 K apart; the size of the cavity makes the Rayleigh number.
"""

import sys

import numpy as np

G, DELTA_T = 9.81, 10.0
SPACING = 0.7  # of a grain's diameter over the cells'

# Cells along a side, their ratio, Courant number, end over L^2/a
AIR = {1e3: (32, 1, 1, 1), 1e4: (32, 2, 1, 1), 1e5: (48, 3, 1, 0.6), 1e6: (64, 4, 1, 0.4)}
BED = {50: (40, 1, 0.5, 0.6), 100: (40, 1, 0.5, 0.4), 200: (40, 1, 0.5, 0.3)}

# Largest velocity in a/L, about: of air (de Vahl Davis 1983), and of the bed
SPEED = {1e3: 3.7, 1e4: 19.6, 1e5: 68.6, 1e6: 220, 50: 20, 100: 40, 200: 80}


def air(number):
    """Pr = 0.71; Ra = g beta Delta T L^3/(nu a)."""
    fluid = {"rho": 1.2, "nu": 1.5e-5, "Cp": 1000.0, "beta": 1 / 300}
    a = fluid["nu"] / 0.71
    fluid["kappa"] = fluid["rho"] * fluid["Cp"] * a
    size = np.cbrt(number * fluid["nu"] * a / (G * fluid["beta"] * DELTA_T))
    return fluid, size, a, AIR[number]


def bed(number):
    """Water; Ra = g beta Delta T K L/(nu a), K by Stokes' drag, a of what is open to conduction."""
    fluid = {"rho": 1000.0, "nu": 1e-6, "Cp": 4180.0, "kappa": 0.6, "beta": 2e-4}
    n = BED[number][0]
    phi = np.pi / 4 * SPACING**2
    eps = 1 - phi
    a = eps * fluid["kappa"] / (fluid["rho"] * fluid["Cp"])
    permeability = eps**2 / (18 * phi) * (SPACING / n) ** 2  # over L^2
    size = np.cbrt(number * fluid["nu"] * a / (G * fluid["beta"] * DELTA_T * permeability))
    return fluid, size, a, BED[number]


def main():
    kind, number = sys.argv[1], float(sys.argv[2])
    fluid, size, a, (n, ratio, Co, end) = {"air": air, "bed": bed}[kind](number)
    steps = int(np.ceil(end * SPEED[number] * n / Co / 20)) * 20
    unit = size**2 / a
    values = fluid | {
        "size": size,
        "n": n,
        "ratio": ratio,
        "inverse": 1 / ratio,
        "spacing": size / n,
        "radius": SPACING * size / n / 2,
        "deltaT": float(f"{end * unit / steps:.5g}"),
    }
    values["endTime"] = values["deltaT"] * (int(sys.argv[3]) if len(sys.argv) > 3 else steps)
    # Darcy's law knows no friction at walls
    walls = {"air": "noSlip", "bed": "slip"}[kind]
    with open("parameters", "w") as file:
        file.write(f"walls {walls};\n")
        for name, value in values.items():
            file.write(f"{name} {value:.10g};\n")


main()
