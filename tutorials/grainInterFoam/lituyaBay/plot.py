# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slide, wave, run-up and gauge of the bays that have been run (snapshots/, results.csv)."""

import re
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

G, DEPTH = 9.81, 122.0
FAR, LEVEL_SHORE = 1342.0, 45.0  # the far edge of the water [m]; slope [degrees]
# Observed trim line; largest amplitude at 885 m in the model of Fritz et al. 2001
RUN_UP, GAUGE = 524.0, 152.0
# What is thinner, upright, is a film, over the depth
FILM = 1 / 8
SHOWN = (2.5, 5, 10, 20, 30, 40, 50, 60)


def scale_of(case):
    return float(re.search(r"(?m)^scale (\S+);", (case / "bay").read_text())[1])


def series(case, file):
    """Columns, in metres and seconds of the bay, from the start of the run."""
    scale = scale_of(case)
    # All starts of the run one after the other
    paths = sorted(
        case.glob(f"postProcessing/gauges/*/{file}.csv"), key=lambda path: float(path.parent.name)
    )
    table = np.concatenate(
        [np.atleast_1d(np.genfromtxt(path, delimiter=",", names=True)) for path in paths]
    )
    return {
        name: np.atleast_1d(table[name]) / (scale**0.5 if name == "time" else scale)
        for name in table.dtype.names
    }


def run_up(case):
    """Highest level on the far shore, of more than a film and of any water, nan where dry."""
    levels, thicknesses = series(case, "levels"), series(case, "thicknesses")
    shore = [name for name in levels if name.startswith("station")][1:]
    # A table that is being written may be a line behind
    n = min(len(levels["time"]), len(thicknesses["time"]))
    level = np.array([levels[name][:n] for name in shore])
    thick = np.array([thicknesses[name][:n] for name in shore]) >= FILM * DEPTH
    any_level = np.where(np.isnan(level), -np.inf, level)

    def highest(values):
        top = values.max(axis=0)
        return np.where(np.isfinite(top), top, np.nan)

    thick_level = np.where(thick, any_level, -np.inf)
    return levels["time"][:n], highest(thick_level), highest(any_level)


def largest(times, values, first, last):
    """Greatest value between two times, and its time; nan without any."""
    among = (times >= first) & (times < last) & ~np.isnan(values)
    if not among.any():
        return np.nan, np.nan
    i = np.flatnonzero(among)[np.argmax(values[among])]
    return values[i], times[i]


def written(case):
    """Times with grains."""
    return [t for t in grainplot.times(case) if (case / t / "grains.h5").exists()]


def impact(case):
    """Mean speed of the grains when the first of them reaches the water, and the time."""
    scale = scale_of(case)
    for time in written(case):
        grains = grainplot.read_grains(case, time)
        if grains["position"][:, 1].min() < 0:
            speed = np.linalg.norm(grains["velocity"], axis=1).mean() / scale**0.5
            return speed, float(time) / scale**0.5
    return np.nan, np.nan


def sheet(name, case):
    mesh, scale = grainplot.read_mesh(case), scale_of(case)
    times = written(case)
    at = np.array([float(time) for time in times]) / scale**0.5
    shown = sorted({int(np.argmin(abs(at - t))) for t in SHOWN if t <= at[-1] + 1})
    shown = shown or [len(at) - 1]
    rows = -(-len(shown) // 2)
    figure, axes = plt.subplots(
        rows, 2, figsize=(14, 2.9 * rows), layout="constrained", squeeze=False
    )
    for ax, i in zip(axes.ravel(), shown, strict=False):
        alpha = grainplot.read_field(case, times[i], "alpha.water", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1.2))
        grains = grainplot.read_grains(case, times[i])
        grainplot.draw_grains(ax, grains, facecolors="sienna", linewidths=0)
        ax.axhline(RUN_UP * scale, xmin=0.7, color="firebrick", lw=0.8)
        ax.set(title=f"t = {at[i]:g} s", aspect="equal", facecolor="0.85")
        ax.set(xlim=(-1000 * scale, 2150 * scale), ylim=(-150 * scale, 1000 * scale))
    for ax in axes.ravel()[len(shown) :]:
        ax.set_axis_off()
    figure.savefig(f"snapshots/{name}.png", dpi=80)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    lines = [
        "case,speed at impact [m/s],run-up [m],at [s],film [m],second run-up [m],gauge [m],at [s]"
    ]
    unit = np.sqrt(G / DEPTH)
    for case in sorted(Path(".").glob("bay_*")):
        name = case.name[len("bay_") :]
        sheet(name, case)
        gauges = series(case, "levels")
        t, up, film = run_up(case)
        speed, start = impact(case)
        highest, when = largest(t, up, 0, np.inf)
        # The water has to come back in between
        second, _ = largest(t, up, when + 25, np.inf)
        crest, crest_at = largest(t, gauges["station0"], 0, 60)
        lines.append(
            f"{name},{speed:.0f},{highest:.0f},{when:.1f},{np.nanmax(film):.0f},{second:.0f},"
            f"{crest:.0f},{crest_at:.1f}"
        )
        left.plot((t - start) * unit, up / DEPTH, label=name)
        right.plot((gauges["time"] - start) * unit, gauges["station0"] / DEPTH, label=name)
    left.axhline(RUN_UP / DEPTH, color="firebrick", label="trim line, 524 m")
    left.set(xlabel="time after impact, t sqrt(g/h0)", ylabel="run-up/h0")
    right.axhline(GAUGE / DEPTH, color="firebrick", label="crest of the model, 152 m")
    right.set(xlabel="time after impact, t sqrt(g/h0)", ylabel="level at 885 m over h0")
    left.legend()
    right.legend()
    figure.savefig("snapshots/waves.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
