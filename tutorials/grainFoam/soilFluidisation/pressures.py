# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressures of the ramp, in Pa, for the file parameters: from the weight of constant/grains.csv."""

import numpy as np

WIDTH, RHO, RHO_P, G, PACKING = 6 * 1.76e-3, 1000.0, 2630.0, 9.81, 0.78

grains = np.genfromtxt("constant/grains.csv", delimiter=",", names=True, usecols=range(8))
weight = float(PACKING * np.pi * np.sum(grains["radius"] ** 2) * (RHO_P - RHO) * G / WIDTH)
print(f"weight {weight!r};\nhold {0.95 * weight!r};\nend {1.05 * weight!r};")
