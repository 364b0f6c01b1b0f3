#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A packed heap of discs in MigFlow's contact solver.

usage: packedMigflow.py packed.csv steps dt tolerance
"""

import sys
import time

import numpy as np
from migflow import scontact, time_integration
from scipy.spatial import cKDTree

WIDTH, HEIGHT, DENSITY, FRICTION, RADIUS = 0.4, 0.8, 1500, 0.3, 1.5e-3


def worst_overlap(x, r):
    i, j = cKDTree(x).query_pairs(2 * r.max(), output_type="ndarray").T
    return (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)).max() / RADIUS


def main():
    discs = np.loadtxt(sys.argv[1], delimiter=",")
    steps, dt, tolerance = int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])
    problem = scontact.ParticleProblem(2)
    problem.add_boundary_segment((0, 0), (WIDTH, 0), "floor")
    problem.add_boundary_segment((WIDTH, 0), (WIDTH, HEIGHT), "right")
    problem.add_boundary_segment((0, HEIGHT), (0, 0), "left")
    mass = DENSITY * np.pi * discs[:, 2] ** 2
    for (x, y, r), m in zip(discs, mass):
        problem.add_particle(np.array([x, y]), r, m)
    problem.set_friction_coefficient(FRICTION)
    weight = np.zeros((len(mass), 2))
    weight[:, 1] = -9.81 * mass
    start, worst = time.process_time(), 0
    measuring = 0
    for _ in range(steps):
        time_integration._advance_particles(problem, weight, dt, 1, tolerance, max_nsub=4096)
        before = time.process_time()
        worst = max(worst, worst_overlap(problem.position(), discs[:, 2]))
        measuring += time.process_time() - before
    seconds = time.process_time() - start - measuring
    print(f"| MigFlow 1.4.0, {tolerance:g} m | {seconds / steps:.4f} | {worst:.2e} |")


main()
