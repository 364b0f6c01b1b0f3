# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the fall, level and volume that is immersed (snapshots/, results.csv)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from setUp import BEAD, COLUMNS, ROWS, WIDTH

G = 9.81


def immersed(y, level):
    """Area of discs below a level [m^2]."""
    x = np.clip((level - y) / BEAD, -1, 1)
    return BEAD**2 * (np.pi / 2 + np.arcsin(x) + x * np.sqrt(1 - x**2))


def mean_level():
    table = np.genfromtxt("postProcessing/gauges/0/levels.csv", delimiter=",", names=True)
    stations = [name for name in table.dtype.names if name != "time"]
    return table["time"], np.mean([table[name] for name in stations], axis=0)


def tracks():
    """Times, heights and speeds of fall of all beads."""
    table = np.loadtxt(
        "postProcessing/tracks/0/grains.csv", delimiter=",", skiprows=1, usecols=(0, 3, 6)
    )
    times = np.unique(table[:, 0])
    return times, *np.moveaxis(table[:, 1:].reshape(len(times), -1, 2), 2, 0)


def draw(times):
    mesh = grainplot.read_mesh(".")
    sheet, axes = plt.subplots(1, len(times), layout="constrained", figsize=(15, 3), squeeze=False)
    for ax, time in zip(axes[0], times, strict=True):
        alpha = grainplot.read_field(".", time, "alpha.water", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1.3))
        grainplot.draw_grains(ax, grainplot.read_grains(".", time), facecolors="peru", linewidths=0)
        ax.set(title=f"t = {time} s", aspect="equal")
    sheet.savefig("snapshots/fall.png", dpi=110)
    plt.close(sheet)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    at, level = mean_level()
    times, y, speed = tracks()
    expected = np.array(
        [immersed(row, np.interp(t, at, level)).sum() for t, row in zip(times, y, strict=True)]
    )
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    left.plot(at, 1e3 * level, label="level, mean of the stations")
    left.plot(times, 1e3 * expected / WIDTH, "k--", label="volume below it over the tank's area")
    left.set(xlabel="t [s]", ylabel="over the level at rest [mm]")
    left.legend()
    right.plot(times, -speed.mean(axis=1), label="mean of the beads")
    right.plot(times, G * times, "k--", label="free fall")
    right.set(xlabel="t [s]", ylabel="speed of fall [m/s]")
    right.set_ylim(-0.05, -1.1 * speed.mean(axis=1).min())
    right.legend()
    figure.savefig("snapshots/level.png", dpi=110)
    plt.close(figure)

    names = grainplot.times(".")[1:]
    wanted = [0.02, 0.06, 0.1, 0.2, float(names[-1])]
    draw(sorted({min(names, key=lambda name: abs(float(name) - t)) for t in wanted}, key=float))

    volume = ROWS * COLUMNS * np.pi * BEAD**2 / WIDTH
    liquid = np.genfromtxt(
        "postProcessing/liquidLedger/0/liquidLedger.csv", delimiter=",", names=True
    )
    lines = [
        "quantity,here,reference",
        f"level's rise, mean of the second half [mm],"
        f"{1e3 * level[at > at[-1] / 2].mean():.2f},{1e3 * volume:.2f}",
        f"speed of the beads at 0.04 s [m/s],{-np.interp(0.04, times, speed.mean(axis=1)):.3f},"
        f"{0.04 * G:.3f}",
        f"liquid unaccounted for,{np.abs(liquid['unaccounted']).max():.1e},0",
    ]
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
