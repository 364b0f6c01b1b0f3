# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bubble among the grains, and its height with and without them (snapshots/, results.csv)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

SURFACE, RADIUS = 0.09, 0.009  # level of the water, radius of the bubble [m]
SHOWN = ("0", "0.1", "0.2", "0.3", "0.4", "0.5")


def air_below(case, mesh, time):
    """Volume of the air under the surface over the bubble's, and the height of its centre."""
    alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
    if (Path(case) / time / "eps").exists():
        eps = grainplot.read_field(case, time, "eps", len(mesh.polygons))
    else:
        eps = np.ones(len(alpha))
    height = np.array([polygon[:, 1].mean() for polygon in mesh.polygons])
    # The level has sunk by what has left
    air = np.where(height < SURFACE - RADIUS, eps * (1 - alpha) * mesh.areas, 0)
    return air.sum() / (np.pi * RADIUS**2), np.average(height, weights=air) if air.any() else np.nan


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    lines = ["case,mean speed of the rise [m/s]"]
    for case in ("grains", "alone"):
        if not Path(case).is_dir():
            continue
        mesh = grainplot.read_mesh(case)
        times = grainplot.times(case)
        share, height = np.array([air_below(case, mesh, time) for time in times]).T
        t = np.array([float(time) for time in times])
        left.plot(t, height, label=case)
        right.plot(t, share, label=case)
        whole = share > 0.95
        speed = np.polyfit(t[whole], height[whole], 1)[0]
        lines.append(f"{case},{speed:.3f}")

        shown = [time for time in SHOWN if time in times]
        sheet, axes = plt.subplots(
            1, len(shown), figsize=(2 * len(shown), 4.2), layout="constrained", squeeze=False
        )
        for ax, time in zip(axes[0], shown, strict=True):
            alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
            grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1.3))
            if case == "grains" and float(time) > 0:
                grains = grainplot.read_grains(case, time)
                grainplot.draw_grains(ax, grains, facecolors="sienna", linewidths=0)
            ax.set(title=f"t = {time} s", aspect="equal")
        sheet.savefig(f"snapshots/{case}.png", dpi=110)
        plt.close(sheet)
    left.set(xlabel="t [s]", ylabel="centre of the air below the surface [m]")
    right.set(xlabel="t [s]", ylabel="air below the surface over the bubble's")
    left.legend()
    figure.savefig("snapshots/rise.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
