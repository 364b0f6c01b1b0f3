#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare final states: measure.py side NAME CPU_SECONDS FILE [NAME CPU_SECONDS FILE ...]

FILE has x, y, z, r, vx, vy, vz as a CSV, or is a LIGGGHTS dump.
"""

import sys

import numpy as np
from scipy.spatial import cKDTree

DIAMETER = 5e-3


def load(name):
    if name.endswith(".dump"):
        return np.loadtxt(name, skiprows=9)[:, 1:8]
    return np.loadtxt(name, delimiter=",")


def volume_between(low, high, z, r):
    """Volume of the spheres' slices between two heights."""

    def below(h):
        t = np.clip(h - z, -r, r)
        return np.pi * (r**2 * t - t**3 / 3)

    return (below(high) - below(low)).sum()


def row(name, cpu, state, side):
    x, r, v = state[:, :3], state[:, 3], state[:, 4:7]
    pairs = cKDTree(x).query_pairs(2 * r.max(), output_type="ndarray")
    i, j = pairs.T
    overlap = (r[i] + r[j] - np.linalg.norm(x[i] - x[j], axis=1)) / DIAMETER
    overlap = overlap[overlap > 0]
    top = np.sort(x[:, 2] + r)[-len(r) // 100]
    packing = volume_between(0.2 * top, 0.8 * top, x[:, 2], r) / (0.6 * top * side**2)
    height = (r**3 * x[:, 2]).sum() / (r**3).sum()
    speed = np.sqrt((v**2).sum(1).mean())
    return (
        f"| {name} | {cpu:.1f} | {overlap.mean():.1e} | {overlap.max():.1e} "
        f"| {1e3 * height:.2f} | {packing:.4f} | {speed:.1e} |"
    )


def main():
    side = float(sys.argv[1])
    print(
        "| code | CPU s | mean overlap / d | worst overlap / d "
        "| height of the centre [mm] | packing | rms speed [m/s] |"
    )
    print("|---|---|---|---|---|---|---|")
    for name, cpu, file in zip(*[iter(sys.argv[2:])] * 3):
        print(row(name, float(cpu), load(file), side))


main()
