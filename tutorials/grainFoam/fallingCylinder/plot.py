# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vorticity with the shorter time step (snapshots), velocities against Namkoong et al. (results.*).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, SPEED = 0.005, 0.02501  # diameter [m]; settling speed of the reference, and of the frame [m/s]
SOURCE = "Namkoong et al. 2008"
SETTLED = 60  # time from which on the motion is periodic, in units of D/SPEED


def read_track(case):
    """Time, settling speed and lateral velocity in units of D and SPEED."""
    (file,) = Path(case).glob("postProcessing/tracks/*/grains.csv")
    data = np.genfromtxt(file, delimiter=",", names=True)
    return data["time"] * SPEED / D, 1 - data["vy"] / SPEED, data["vx"] / SPEED


def reference(name):
    """Two columns of a curve of the reference, without units."""
    lines = (Path("reference") / f"namkoong2008_{name}.csv").read_text().splitlines()
    return np.array([x.split(",") for x in lines if x[0] in "0123456789"], dtype=float).T


def oscillation(time, value):
    """Amplitude and frequency, from the extrema and the upward zeros."""
    value = value - 0.5 * (value.max() + value.min())
    k = np.flatnonzero((value[:-1] < 0) & (value[1:] >= 0))
    if len(k) < 2:
        return value.max(), np.nan
    zeros = time[k] - value[k] * (time[k + 1] - time[k]) / (value[k + 1] - value[k])
    return value.max(), (len(zeros) - 1) / (zeros[-1] - zeros[0])


def snapshot(case):
    """Vorticity behind the cylinder at the last time."""
    name = grainplot.times(case)[-1]
    mesh = grainplot.read_mesh(case)
    vorticity = grainplot.read_field(case, name, "vorticity", len(mesh.polygons))[:, 2]
    grains = grainplot.read_grains(case, name)
    figure, ax = plt.subplots(figsize=(4, 8), layout="constrained")
    cells = grainplot.draw_cells(
        ax, mesh, vorticity, lines=False, cmap="RdBu_r", clim=(-10, 10)
    )
    grainplot.draw_grains(ax, grains, facecolors="0.4")
    x, y = grains["position"][0]
    ax.set_xlim(x - 4 * D, x + 4 * D)
    ax.set_ylim(y - 3 * D, y + 16 * D)
    ax.set_title(f"t = {name} s")
    figure.colorbar(cells, label="vorticity [1/s]", shrink=0.7)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig("snapshots/vorticity.png", dpi=110)


def main():
    cases = sorted(Path().glob("step_*"), key=lambda path: -float(path.name.split("_")[1]))
    results = Results()
    figure, axes = plt.subplots(2, 1, figsize=(9, 7), sharex=True, layout="constrained")
    for case in cases:
        step = f"dt = {1e3 * float(case.name.split('_')[1]):g} ms"
        finest = case == cases[-1]
        time, fall, lateral = read_track(case)
        for ax, value in zip(axes, (fall, lateral), strict=True):
            ax.plot(time, value, lw=1 if finest else 0.5, label=f"grainFoam, {step}")

        late = time >= min(SETTLED, time[-2])
        mean = fall[late].mean()
        amplitude, frequency = oscillation(time[late], lateral[late])
        tolerances = ("3 %", "5 %", "20 %", "5 %") if finest else ("",) * 4
        for (quantity, value, unit, expected), tolerance in zip(
            (
                ("settling speed", mean * SPEED, "m/s", SPEED),
                ("Strouhal number", frequency / mean, "-", 0.168),
                ("lateral velocity over settling speed", amplitude / mean, "-", 0.0826),
                ("largest over settling speed", fall.max() / mean, "-", 1.069),
            ),
            tolerances,
            strict=True,
        ):
            results.add(
                f"{quantity}, {step}", value, unit, expected, tolerance, SOURCE
            )

    for ax, name in zip(axes, ("streamwise_up", "lateral_vp"), strict=True):
        ax.plot(*reference(name), "k.", ms=2, label=SOURCE)
    axes[0].set_ylabel("settling speed / U")
    axes[1].set_ylabel("lateral velocity / U")
    axes[1].set_xlabel("t U/d")
    axes[0].legend()
    figure.savefig("results.png", dpi=110)

    snapshot(cases[-1])
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
