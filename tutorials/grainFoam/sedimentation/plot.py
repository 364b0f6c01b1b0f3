# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and table of the two runs: snapshots/*.png, volumeDefects.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

METHODS = {"centroid": "particle centroid", "exactOverlap": "exact overlap"}
HEIGHT = 0.6  # of the box [m]


def initial(case):
    """Grains of the CSV file that the run began with."""
    data = np.genfromtxt(
        Path(case) / "constant/grains.csv", delimiter=",", names=True, usecols=range(8)
    )
    position = np.column_stack([data["x"], data["y"]])
    return {"position": position, "radius": data["radius"], "velocity": 0 * position}


def grains(case, time):
    return initial(case) if time == "0" else grainplot.read_grains(case, time)


def void_fraction(case, time, mesh):
    """eps per cell; the initial state is the one of the first time that was written."""
    time = grainplot.times(case)[1] if time == "0" else time
    return grainplot.read_field(case, time, "eps", len(mesh.polygons))


def snapshot(time):
    """Grains with the mesh and void fraction, the two methods side by side (fig. 3.9)."""
    figure, axes = plt.subplots(
        1, 4, figsize=(14, 6.6), sharey=True, layout="constrained"
    )
    for (case, title), (left, right) in zip(METHODS.items(), (axes[:2], axes[2:]), strict=True):
        mesh = grainplot.read_mesh(case)
        state = grains(case, time)
        grainplot.draw_cells(left, mesh)
        speed = grainplot.magnitude(state["velocity"])
        discs = grainplot.draw_grains(left, state, speed, clim=(0, 0.2), linewidths=0)
        grainplot.draw_cells(left, mesh, zorder=3, linewidths=0.15)
        cells = grainplot.draw_cells(
            right, mesh, void_fraction(case, time, mesh), clim=(0, 1), cmap="Blues"
        )
        left.set_title(f"{title}, t = {time} s")
        right.set_title("void fraction")
    axes[0].set_ylabel("y [m]")
    style = {"location": "bottom", "shrink": 0.7, "aspect": 40}
    figure.colorbar(discs, ax=list(axes[:2]), label="grain speed [m/s]", **style)
    figure.colorbar(cells, ax=list(axes[2:]), label="void fraction", **style)
    return figure


def ledger(case):
    """Columns of the run's ledger."""
    rows = []
    for path in sorted(Path(case).glob("postProcessing/ledger/*/ledger.csv")):
        with open(path) as file:
            rows += list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def row(case):
    """A line of the table: what a method does to the volume of the mixture."""
    last = grainplot.times(case)[-1]
    books = ledger(case)
    start, end = initial(case), grainplot.read_grains(case, last)
    top = start["position"][:, 1] > HEIGHT - 2 * start["radius"]
    strip = 10 * start["radius"][0]
    inside = end["position"][:, 1] > HEIGHT - strip
    was_inside = start["position"][:, 1] > HEIGHT - strip
    gap = HEIGHT - np.max(end["position"][:, 1] + end["radius"])
    return {
        "method": case,
        "time [s]": last,
        "void at the top [mm]": f"{1e3 * gap:.3f}",
        "descent of the top row [mm]": "{:.3f}".format(
            1e3 * np.mean(start["position"][top, 1] - end["position"][top, 1])
        ),
        "grains left in the top 5 d": f"{inside.sum()} of {was_inside.sum()}",
        "volume without room [% of grains]": "{:.3g}".format(
            100 * np.max(books["overfull"] / books["grainVolume"])
        ),
        "divergence of the mixture, max": f"{np.max(books['divergence']):.2g}",
        "volume defect of a step, mean [%]": "{:.2g}".format(
            100 * np.mean(books["volumeDefect"])
        ),
        "mapping error, max": f"{np.max(books['mappingError']):.2g}",
        "momentum error, max": f"{np.max(books['momentumError']):.2g}",
        "worst overlap [d]": "{:.2g}".format(
            np.max(books["worstOverlap"]) / (2 * start["radius"][0])
        ),
        "wall clock [s]": f"{books['elapsedTime'][-1]:.1f}",
    }


def main():
    Path("snapshots").mkdir(exist_ok=True)
    for time in grainplot.times("exactOverlap"):
        figure = snapshot(time)
        figure.savefig(f"snapshots/t_{time}.png", dpi=110)
        plt.close(figure)

    table = [row(case) for case in METHODS]
    with open("volumeDefects.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, table[0])
        writer.writeheader()
        writer.writerows(table)
    for name in table[0]:
        print(f"{name:36}" + "".join(f"{entry[name]:>20}" for entry in table))


main()
