#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The settling spheres in MigFlow's contact solver.

usage: settleMigflow.py initial.csv side endTime dt tolerance final.csv
"""

import sys
import time

import numpy as np
from migflow import scontact, time_integration

DENSITY, FRICTION, HEIGHT = 2500, 0.3, 0.4


def add_box(problem, side):
    def rectangle(a, b, c, d, name):
        problem.add_boundary_triangle(a, b, c, name)
        problem.add_boundary_triangle(a, c, d, name)

    low = [(0, 0, 0), (side, 0, 0), (side, side, 0), (0, side, 0)]
    high = [(x, y, HEIGHT) for x, y, _ in low]
    rectangle(*low, "floor")
    for k in range(4):
        n = (k + 1) % 4
        rectangle(low[k], low[n], high[n], high[k], f"side{k}")


def main():
    spheres = np.loadtxt(sys.argv[1], delimiter=",")
    side, end, dt, tolerance = map(float, sys.argv[2:6])
    mass = DENSITY * 4 / 3 * np.pi * spheres[:, 3] ** 3
    problem = scontact.ParticleProblem(3)
    add_box(problem, side)
    for (x, y, z, r), m in zip(spheres, mass):
        problem.add_particle(np.array([x, y, z]), r, m)
    problem.set_friction_coefficient(FRICTION)
    problem.set_use_queue(1)
    problem.set_fixed_contact_geometry(True)
    weight = np.zeros((len(mass), 3))
    weight[:, 2] = -9.81 * mass
    start = time.process_time()
    for _ in range(round(end / dt)):
        time_integration._advance_particles(problem, weight, dt, 1, tolerance, max_nsub=4096)
    print(f"cpu {time.process_time() - start:.1f} s")
    final = np.c_[problem.position(), spheres[:, 3], problem.velocity()]
    np.savetxt(sys.argv[6], final, delimiter=",")


main()
