# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the benchmarks against OpenFOAM's own solvers share."""

import re
from pathlib import Path

import numpy as np


def vectors(path):
    """Values (n, 3) of an ascii list of vectors."""
    text = Path(path).read_text().split("// * * *")[-1]
    return np.array(re.findall(r"^\((\S+) (\S+) (\S+)\)", text, re.M), dtype=float)


def worst_overlap(position, radius):
    """Of two spheres, over the smaller diameter: (n, 3), (n,); near ones are sought along z."""
    order = np.argsort(position[:, 2])
    position, radius = position[order], radius[order]
    worst = 0.0
    for k in range(1, len(position)):
        apart = position[k:] - position[:-k]
        near = apart[:, 2] < 2 * radius.max()
        if not near.any():
            break
        one, other = radius[k:][near], radius[:-k][near]
        overlap = one + other - np.linalg.norm(apart[near], axis=1)
        worst = max(worst, (overlap / (2 * np.minimum(one, other))).max())
    return worst


def rates(runs, peer):
    """CPU seconds per simulated second, of runs (solver, start, seconds, CPU seconds, case); ratio
    to the peer's from the same start."""
    print("| start | code | simulated s | CPU s | CPU s per simulated s | ratio |")
    print("|---|---|---|---|---|---|")
    of_peer = None
    for solver, start, seconds, cpu, _ in runs:
        rate = float(cpu) / float(seconds)
        of_peer = rate if solver == peer else of_peer
        print(f"| {start} | {solver} | {seconds} | {cpu} | {rate:.0f} | {of_peer / rate:.1f} |")
