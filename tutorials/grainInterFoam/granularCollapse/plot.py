# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns, waves and granular fronts of the cases that have been run (snapshots/, results.csv)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

G, DIAMETER = 9.81, 4.6e-3
# Depth of water [m], front Froude number of the experiment (Sarlin et al. 2021, J. Fluid Mech. 919
# R6) and of the thesis (table 5.1)
CASES = {"1": (0.25, 0.19, 0.27), "2": (0.08, 0.65, 0.83), "3": (0.04, 1.39, 1.93)}
SHOWN = ("0.2", "0.4", "0.8", "1.2")
BEFORE_THE_END = 1.0  # [s], of the basin


def front(case, depth):
    """Times and the farthest grain's x within a diameter of the level of the water at rest."""
    table = np.loadtxt(
        case / "postProcessing/tracks/0/grains.csv", delimiter=",", skiprows=1, usecols=(0, 2, 3)
    )
    table = table[np.abs(table[:, 2] - depth) < DIAMETER]
    times = np.unique(table[:, 0])
    return times, np.array([table[table[:, 0] == t, 1].max() for t in times])


def fastest(times, x):
    """Greatest mean velocity over a twentieth of a second."""
    n = min(6, len(times))
    return max(
        np.polyfit(times[i : i + n], x[i : i + n], 1)[0] for i in range(len(times) - n + 1)
    )


def surface(case, mesh, time):
    """x and height of the water, columns of cells."""
    alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
    centres = np.array([polygon.mean(axis=0) for polygon in mesh.polygons])
    x = np.unique(centres[:, 0].round(6))
    width = x[1] - x[0]
    column = np.searchsorted(x, centres[:, 0].round(6))
    return x, np.bincount(column, alpha * mesh.areas) / width


def sheet(name, case, mesh):
    times = grainplot.times(case)
    shown = [t for t in SHOWN if t in times] or times[-1:]
    figure, rows = plt.subplots(
        len(shown), 1, figsize=(9, 2.2 * len(shown)), layout="constrained", squeeze=False
    )
    for ax, time in zip(rows[:, 0], shown, strict=True):
        alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1))
        grains = grainplot.read_grains(case, time)
        grainplot.draw_grains(ax, grains, facecolors="sienna", linewidths=0)
        ax.set(title=f"t = {time} s", aspect="equal")
    figure.savefig(f"snapshots/case_{name}.png", dpi=110)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    rows = []
    for name, (depth, experiment, thesis) in CASES.items():
        case = Path(f"case_{name}")
        if not case.is_dir():
            continue
        mesh = grainplot.read_mesh(case)
        times, x = front(case, depth)
        Fr = fastest(times, x) / np.sqrt(G * depth)
        left.plot(times, (x - x[0]) / depth, label=f"case {name}")

        written = [t for t in grainplot.times(case) if 0 < float(t) <= BEFORE_THE_END]
        crest = []
        for time in written:
            at, height = surface(case, mesh, time)
            beyond = at > np.interp(float(time), times, x)
            crest.append(height[beyond].max() / depth - 1)
        right.plot([float(t) for t in written], crest, label=f"case {name}")
        rows.append((name, Fr, experiment, thesis, max(crest)))
        sheet(name, case, mesh)
    left.set(xlabel="t [s]", ylabel="granular front at the level / depth")
    right.set(xlabel="t [s]", ylabel="crest over the level / depth")
    left.legend()
    figure.savefig("snapshots/fronts.png", dpi=110)
    lines = ["case,Fr_f,Fr_f of the experiment,Fr_f of the thesis,largest crest over depth"]
    lines += [f"{n},{Fr:.2f},{e},{t},{a:.2f}" for n, Fr, e, t, a in rows]
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
