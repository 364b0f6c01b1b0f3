#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the runs of this folder show.

    measure.py positions TIME_DIRECTORY             grains of grainFoam as DPMFoam reads them
    measure.py table [SOLVER START SECONDS CPU_SECONDS CASE ...]
                                                    tables of both codes, beds.png
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from peers import rates, vectors, worst_overlap

D, RHO = 2.5e-3, 1.2
WIDTH, DEPTH = 0.15, 0.015
LOWEST = 60  # cells of the lowest layer
WEIGHT = 24750 * np.pi / 6 * D**3 * (2526 - RHO) * 9.81 / (WIDTH * DEPTH)


def peer_grains(case, time):
    """Positions and velocities of DPMFoam, (n, 3) each."""
    cloud = Path(case) / time / "lagrangian/kinematicCloud"
    return vectors(cloud / "positions"), vectors(cloud / "U")


def our_grains(case, time):
    state = grainplot.read_grains(case, time)
    return state["position"], state["velocity"]


GRAINS = {"DPMFoam": peer_grains, "grainFoam": our_grains}


def state(solver, case, time):
    """Mean height of the grains [m], pressure in the lowest cells [Pa], worst overlap over d."""
    field, factor = ("p", RHO) if solver == "DPMFoam" else ("p_rgh", 1)
    pressure = factor * grainplot.read_field(case, time, field)[:LOWEST].mean()
    position, _ = GRAINS[solver](case, time)
    return position[:, 2].mean(), pressure, worst_overlap(position, np.full(len(position), D / 2))


def draw_bed(ax, position, velocity, title):
    """Grains from the front, in colours of their speed."""
    order = np.argsort(position[:, 0])
    state = {"position": position[order, 1:], "radius": np.full(len(position), D / 2)}
    speed = np.linalg.norm(velocity[order], axis=1)
    grains = grainplot.draw_grains(ax, state, speed, clim=(0, 1), linewidths=0)
    ax.set(title=title, xlim=(-WIDTH / 2, WIDTH / 2), ylim=(0, 0.45), aspect="equal")
    return grains


def beds(pictures, path):
    """pictures: title, positions, velocities."""
    figure, axes = plt.subplots(
        1, len(pictures), figsize=(2.6 * len(pictures), 6.5), sharey=True, layout="constrained"
    )
    for ax, (title, position, velocity) in zip(np.atleast_1d(axes), pictures, strict=True):
        grains = draw_bed(ax, position, velocity, title)
    figure.colorbar(grains, ax=axes, label="speed [m/s]", shrink=0.6)
    figure.savefig(path, dpi=110)


def states(runs):
    """What the runs have come to."""
    print("| start | code | t [s] | mean height [mm] | pressure below / weight | overlap / d |")
    print("|---|---|---|---|---|---|")
    for solver, start, _, _, case in runs:
        time = grainplot.times(case)[-1]
        height, pressure, overlap = state(solver, case, time)
        row = f"{1e3 * height:.3f} | {pressure / WEIGHT:.3f} | {overlap:.1e} |"
        print(f"| {start} | {solver} | {time} | {row}")


def main():
    command, *arguments = sys.argv[1:]
    if command == "positions":
        folder = Path(arguments[0])
        for x in our_grains(folder.parent, folder.name)[0]:
            print("({:.9g} {:.9g} {:.9g})".format(*x))
        return
    runs = list(zip(*[iter(arguments)] * 5, strict=True))
    rates([run for run in runs if run[3] != "-"], "DPMFoam")
    print()
    states(runs)
    pictures = []
    for solver, start, _, _, case in runs:
        last = grainplot.times(case)[-1]
        pictures.append((f"{solver}\n{start}, {last} s", *GRAINS[solver](case, last)))
    beds(pictures, "beds.png")


main()
