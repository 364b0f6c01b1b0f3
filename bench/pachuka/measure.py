#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of both codes and tanks.png.

Usage: measure.py [SOLVER START SECONDS CPU_SECONDS CASE ...]
"""

import re
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from peers import rates, vectors, worst_overlap

PEER = "MPPICInterFoam"
RADIUS = 0.11  # of the tank [m]


def peer_grains(case, time):
    """Positions (n, 3) and radii (n,) of MPPICInterFoam."""
    cloud = Path(case) / time / "lagrangian/kinematicCloud"
    text = (cloud / "d").read_text().split("// * * *")[-1]
    diameters = np.array(re.findall(r"^([-0-9.e]+)$", text, re.M)[1:], dtype=float)
    return vectors(cloud / "positions"), diameters / 2


def our_grains(case, time):
    state = grainplot.read_grains(case, time)
    return state["position"], state["radius"].ravel()


GRAINS = {PEER: peer_grains, "grainInterFoam": our_grains}


def states(runs):
    """What the runs have come to."""
    print("| code | steps | grains | their mean height [mm] | highest [mm] | overlap / d |")
    print("|---|---|---|---|---|---|")
    for solver, _, _, _, case in runs:
        steps = (Path(case) / f"log.{solver}").read_text().count("\nTime = ")
        x, radius = GRAINS[solver](case, grainplot.times(case)[-1])
        z = 1e3 * x[:, 2]
        row = f"{len(x)} | {z.mean():.1f} | {z.max():.1f} | {worst_overlap(x, radius):.1e} |"
        print(f"| {solver} | {steps} | {row}")


def tanks(runs):
    """Grains of both, from the side."""
    figure, axes = plt.subplots(
        1, len(runs), figsize=(6 * len(runs), 3), sharey=True, layout="constrained"
    )
    for ax, (solver, _, _, _, case) in zip(axes, runs, strict=True):
        time = grainplot.times(case)[-1]
        x, _ = GRAINS[solver](case, time)
        ax.plot(x[:, 0], x[:, 2], "k,")
        ax.set(title=f"{solver}, {time} s", aspect="equal", xlim=(-RADIUS, RADIUS))
    figure.savefig("tanks.png", dpi=110)


def main():
    runs = list(zip(*[iter(sys.argv[1:])] * 5, strict=True))
    rates(runs, PEER)
    print()
    states(runs)
    tanks(runs)


main()
