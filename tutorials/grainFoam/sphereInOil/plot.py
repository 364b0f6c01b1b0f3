# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow about the sphere (snapshots), its velocity against the experiment of ten Cate et al.
(results.*).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import foamlib
import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RADIUS = 0.0075  # [m]
SOURCE = "ten Cate et al. 2002"
# Reynolds number: largest speed in the experiment [m/s], table II
FASTEST = {"1.5": 0.0363, "11.6": 0.0869}


def read_track(case):
    """Time [s] and velocity [m/s]."""
    (file,) = Path(case).glob("postProcessing/tracks/*/grains.csv")
    data = np.genfromtxt(file, delimiter=",", names=True)
    return data["time"], data["vz"]


def reference(reynolds):
    """Two columns of a curve of the experiment, in s and m/s."""
    file = Path("reference") / f"tencate2002_velocity_Re{reynolds.replace('.', 'p')}.csv"
    lines = [line for line in file.read_text().splitlines() if line[0] in "0123456789"]
    return np.array([line.split(",") for line in lines], dtype=float).T


def snapshot(case, ax):
    """Speed of the oil in the plane through the middle at the last time."""
    time = grainplot.times(case)[-1]
    centre = np.asarray(foamlib.FoamFieldFile(Path(case) / time / "C").internal_field)
    velocity = np.asarray(foamlib.FoamFieldFile(Path(case) / time / "U").internal_field)
    grain = grainplot.read_grains(case, time)["position"][0]
    nearest = np.abs(centre[:, 1]).min()
    plane = np.abs(centre[:, 1] - nearest) < 1e-6
    x, _, z = centre[plane].T
    speed = np.linalg.norm(velocity[plane], axis=1)
    colours = ax.tripcolor(x, z, speed, shading="gouraud", cmap="viridis")
    ax.add_patch(plt.Circle((grain[0], grain[-1]), RADIUS, color="0.8"))
    ax.set_aspect("equal")
    ax.set_title(f"{case}, {time} s")
    ax.figure.colorbar(colours, ax=ax, label="speed [m/s]", shrink=0.7)


def main():
    results = Results()
    figure, ax = plt.subplots(figsize=(8, 5), layout="constrained")
    for (reynolds, fastest), colour in zip(FASTEST.items(), ("tab:blue", "tab:red"), strict=True):
        time, velocity = read_track(f"Re_{reynolds}")
        ax.plot(time, velocity, color=colour, label=f"Re {reynolds}, grainFoam")
        ax.plot(*reference(reynolds), ".", color=colour, label=f"Re {reynolds}, {SOURCE}")
        results.add(
            f"largest speed, Re {reynolds}", -velocity.min(), "m/s", fastest, "5 %", SOURCE
        )
    ax.set_xlabel("time [s]")
    ax.set_ylabel("velocity [m/s]")
    ax.legend()
    figure.savefig("results.png", dpi=110)

    figure, axes = plt.subplots(1, 2, figsize=(9, 6), layout="constrained")
    for reynolds, ax in zip(FASTEST, axes, strict=True):
        snapshot(f"Re_{reynolds}", ax)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig("snapshots/speed.png", dpi=110)

    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
