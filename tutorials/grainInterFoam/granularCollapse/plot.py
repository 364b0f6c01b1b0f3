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
SHOWN = (0.2, 0.4, 0.8, 1.2)
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
    """Greatest mean velocity over a tenth of a second: the front is one grain after the other, and
    a diameter more is 0.1 m/s over half of that."""
    n = min(11, len(times))
    return max(
        np.polyfit(times[i : i + n], x[i : i + n], 1)[0] for i in range(len(times) - n + 1)
    )


def levels(case):
    """Places of the gauges, times and levels (time, place), NaN where a line has no water."""
    words = (case / "stations").read_text().replace("(", " ").split()
    x = np.array([float(word) for word in words[1::3]])
    table = np.genfromtxt(
        case / "postProcessing/gauges/0/levels.csv", delimiter=",", skip_header=1, ndmin=2
    )
    return x, table[:, 0], table[:, 1:]


def sheet(case):
    times = grainplot.times(case)
    k = [np.argmin(np.abs(np.array(times, dtype=float) - t)) for t in SHOWN]
    shown = [times[i] for i in sorted(set(k))]
    figure, rows = plt.subplots(
        len(shown), 1, figsize=(9, 2.2 * len(shown)), layout="constrained", squeeze=False
    )
    x, sampled, level = levels(case)
    for ax, time in zip(rows[:, 0], shown, strict=True):
        water = level[np.argmin(np.abs(sampled - float(time)))]
        if case.name.startswith("discs"):
            mesh = grainplot.read_mesh(case)
            alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
            grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1))
        else:
            ax.fill_between(x, 0, water, color="tab:blue", linewidth=0)
        grains = grainplot.read_grains(case, time)
        seen = {"position": grains["position"][:, :2], "radius": grains["radius"]}
        grainplot.draw_grains(ax, seen, facecolors="sienna", linewidths=0)
        ax.set(title=f"t = {time} s", aspect="equal", xlim=(0, x[-1]), ylim=(0, None))
    figure.savefig(f"snapshots/{case.name}.png", dpi=110)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    lines = ["case,Fr_f,Fr_f of the experiment,Fr_f of the thesis,largest crest over depth"]
    for number, (depth, experiment, thesis) in CASES.items():
        for shape, style in (("discs", "-"), ("spheres", "--")):
            case = Path(f"{shape}_{number}")
            if not case.is_dir():
                continue
            label, look = f"{shape} {number}", {"color": f"C{number}", "linestyle": style}
            times, x = front(case, depth)
            Fr = fastest(times, x) / np.sqrt(G * depth)
            left.plot(times, (x - x[0]) / depth, label=label, **look)

            at, sampled, level = levels(case)
            early = sampled <= BEFORE_THE_END
            beyond = at > np.interp(sampled[early], times, x)[:, None]
            crest = np.where(beyond, level[early], 0).max(axis=1) / depth - 1
            right.plot(sampled[early], crest, label=label, **look)
            lines.append(f"{label},{Fr:.2f},{experiment},{thesis},{crest.max():.2f}")
            sheet(case)
    left.set(xlabel="t [s]", ylabel="granular front at the level / depth")
    right.set(xlabel="t [s]", ylabel="crest over the level / depth")
    left.legend()
    figure.savefig("snapshots/fronts.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
