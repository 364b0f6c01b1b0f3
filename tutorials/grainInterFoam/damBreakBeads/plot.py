# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fronts of water and beads, and pictures from the side (snapshots/, results.csv)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from setUp import BEAD, CELL, COLUMN, LENGTH, TOP

G = 9.81
# Martin and Moyce 1952 (Phil. Trans. R. Soc. A 244, 312), water alone, column twice as high as
# wide: front over the width at t sqrt(2 g/width)
FRONT = (
    (0.41, 1.11), (0.84, 1.22), (1.19, 1.44), (1.43, 1.67), (1.63, 1.89), (1.83, 2.11),
    (1.98, 2.33), (2.2, 2.56), (2.32, 2.78), (2.51, 3), (2.65, 3.22), (2.83, 3.44), (2.98, 3.67),
    (3.11, 3.89), (3.33, 4.11),
)  # fmt: skip
SHOWN = ("0.1", "0.2", "0.3", "0.5")
NX, NY = round(LENGTH / CELL), round(TOP / CELL)


def water(case, time):
    """Share of water, mean over the depth, (NY, NX)."""
    return grainplot.read_field(case, time, "alpha.water").reshape(-1, NY, NX).mean(axis=0)


def front_of_water(case):
    times, x = [], []
    for time in grainplot.times(case):
        floor = water(case, time)[0]
        last = np.flatnonzero(floor > 0.5)[-1]
        beyond = floor[last + 1] if last + 1 < NX else 0.0
        part = (floor[last] - 0.5) / max(floor[last] - beyond, 1e-9)
        times.append(float(time))
        x.append(min((last + 0.5 + part) * CELL, LENGTH))
    return np.array(times), np.array(x)


def front_of_beads(case):
    """The 99th of a hundred beads along the tank."""
    table = np.loadtxt(
        case / "postProcessing/tracks/0/grains.csv", delimiter=",", skiprows=1, usecols=(0, 2)
    )
    times = np.unique(table[:, 0])
    return times, np.percentile(table[:, 1].reshape(len(times), -1), 99, axis=1) + BEAD / 2


def draw(case):
    times = [time for time in grainplot.times(case) if time in SHOWN] or grainplot.times(case)[-1:]
    sheet, axes = plt.subplots(
        1, len(times), figsize=(4 * len(times), 3.2), layout="constrained", squeeze=False
    )
    for ax, time in zip(axes[0], times, strict=True):
        extent = (0, LENGTH, 0, TOP)
        share = water(case, time)
        ax.imshow(share, origin="lower", extent=extent, cmap="Blues", vmin=0, vmax=1.3)
        grains = grainplot.read_grains(case, time)
        seen = {"position": grains["position"][:, :2], "radius": grains["radius"]}
        grainplot.draw_grains(ax, seen, facecolors="sienna", linewidths=0)
        ax.set(title=f"t = {time} s", aspect="equal", xlim=(0, LENGTH), ylim=(0, TOP))
        ax.set_xticks([0, 0.1, 0.2])
    sheet.savefig(f"snapshots/{case}.png", dpi=110)
    plt.close(sheet)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    unit = np.sqrt(COLUMN / (2 * G))
    figure, ax = plt.subplots(layout="constrained")
    ax.plot(np.array(FRONT)[:, 0] * unit, np.array(FRONT)[:, 1] * COLUMN, "ko",
            label="water alone, Martin and Moyce")  # fmt: skip
    lines = ["case,beads,water at the far wall [s],beads at the far wall [s],unaccounted"]
    for case in (Path(name) for name in ("alone", "slice", "whole")):
        if not case.is_dir():
            continue
        t, x = front_of_water(case)
        ax.plot(t, x, label=f"{case}: water")
        arrival = [np.interp(0.98 * LENGTH, x, t) if x.max() > 0.98 * LENGTH else np.nan]
        n = 0
        if case.name != "alone":
            n = len(grainplot.read_grains(case, grainplot.times(case)[-1])["id"])
            t, x = front_of_beads(case)
            ax.plot(t, x, "--", label=f"{case}: beads, 99 % of them behind")
            draw(case)
            reached = np.flatnonzero(x > 0.98 * LENGTH)
        arrival.append(t[reached[0]] if n and len(reached) else np.nan)
        ledger = np.genfromtxt(
            case / "postProcessing/liquidLedger/0/liquidLedger.csv", delimiter=",", names=True
        )
        lost = np.abs(ledger["unaccounted"]).max()
        lines.append(f"{case},{n},{arrival[0]:.3f},{arrival[1]:.3f},{lost:.1e}")
    ax.set(xlabel="t [s]", ylabel="front [m]")
    ax.legend()
    figure.savefig("snapshots/fronts.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
