# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs, raft and heave of the cases that have been run (snapshots/, results.csv)."""

from pathlib import Path

import grainplot
import heave
import matplotlib.pyplot as plt
import numpy as np
from setUp import BEAD, DIAMETER, DISCS, LIFT, RADIUS

G = 9.81
COLOURS = ("wheat", "burlywood", "peru")


def tracks(case):
    """Times, and heights of the grains by id, (times, grains)."""
    path = Path(case) / "postProcessing/tracks/0/grains.csv"
    table = np.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1, 3))
    times = np.unique(table[:, 0])
    order = np.lexsort((table[:, 1], table[:, 0]))
    return times, table[order, 2].reshape(len(times), -1)


def level(case):
    table = np.genfromtxt(
        Path(case) / "postProcessing/gauges/0/levels.csv", delimiter=",", names=True
    )
    stations = [name for name in table.dtype.names if name != "time"]
    return table["time"], np.mean([table[name] for name in stations], axis=0)


def draw(case, times, **figure):
    mesh = grainplot.read_mesh(case)
    sheet, axes = plt.subplots(1, len(times), layout="constrained", squeeze=False, **figure)
    for ax, time in zip(axes[0], times, strict=True):
        alpha = grainplot.read_field(case, time, "alpha.water", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1.3))
        grains = grainplot.read_grains(case, time)
        colours = [COLOURS[i % 3] for i in range(len(grains["id"]))] if case == "discs" else "peru"
        grainplot.draw_grains(ax, grains, facecolors=colours, linewidths=0)
        ax.set(title=f"t = {time} s", aspect="equal")
    sheet.savefig(f"snapshots/{case}.png", dpi=110)
    plt.close(sheet)


def of_discs():
    times, y = tracks("discs")
    at, height = level("discs")
    depth = (np.interp(times, at, height)[:, None] - y + DIAMETER / 2) / DIAMETER
    figure, ax = plt.subplots(layout="constrained")
    for i, (material, _, exact) in enumerate(DISCS):
        (line,) = ax.plot(times, depth[:, i], label=material)
        ax.axhline(exact, color=line.get_color(), ls=":")
        at_rest = depth[times > times[-1] / 2, i].mean()
        yield f"immersed depth over diameter, {material}", at_rest, exact
    ax.set(xlabel="t [s]", ylabel="depth of the lowest point/d")
    ax.legend()
    figure.savefig("snapshots/depths.png", dpi=110)
    plt.close(figure)
    draw("discs", ["0.1", "0.3", "4"], figsize=(13, 3))


def of_raft():
    mesh = grainplot.read_mesh("raft")
    times = [t for t in grainplot.times("raft") if float(t) > 0]
    volume = len(grainplot.read_grains("raft", times[-1])["id"]) * np.pi * BEAD**2
    immersed = []
    for time in times:
        eps, alpha = (
            grainplot.read_field("raft", time, name, len(mesh.polygons))
            for name in ("eps", "alpha.water")
        )
        immersed.append(((1 - eps) * alpha * mesh.areas).sum() / volume)
    draw("raft", times[:1] + times[-1:], figsize=(9, 3))
    at_rest = immersed[-len(immersed) // 4 :]
    yield "immersed volume of the raft", np.mean(at_rest), 0.5


def of_heave():
    times, y = tracks("heave")
    unit = np.sqrt(RADIUS / G)
    at, height = level("heave")
    here = (y[:, 0] - height[0]) / LIFT
    exact = heave.displacement(times / unit)
    figure, ax = plt.subplots(layout="constrained")
    ax.plot(times / unit, exact, "k", label="potential flow, deep water")
    ax.plot(times / unit, here, label="grainInterFoam")
    ax.set(xlabel="t sqrt(g/a)", ylabel="height over the first")
    ax.legend()
    figure.savefig("snapshots/heave.png", dpi=110)
    plt.close(figure)
    draw("heave", grainplot.times("heave")[-1:], figsize=(10, 3))
    yield "heave, first trough", here.min(), exact.min()


def main():
    Path("snapshots").mkdir(exist_ok=True)
    lines = ["quantity,here,exact"]
    for case, rows in (("discs", of_discs), ("raft", of_raft), ("heave", of_heave)):
        if Path(case).is_dir():
            lines += [f"{name},{here:.4f},{exact:.4f}" for name, here, exact in rows()]
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
