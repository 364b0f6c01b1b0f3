# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heave of the layer on each mesh: snapshots/*.png, results.csv, results.png."""

import re
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

MESHES = ["8", "4", "2", "1", "0.5"]
D_MAX, D_MEAN = 0.24e-3, 0.22e-3
SOURCE = "balance of forces"


def start():
    """Grains before the first step, in the order of their ids."""
    data = np.genfromtxt("constant/grains.csv", delimiter=",", names=True, usecols=range(8))
    return np.column_stack([data["x"], data["y"]]), data["radius"]


def parameter(case, name):
    return float(re.search(rf"{name} (\S+);", (case / "parameters").read_text())[1])


def pressure(case):
    """Times, and pressure at the bottom over the layer's weight in water."""
    text = (case / "postProcessing/inlet/0/surfaceFieldValue.dat").read_text()
    rows = [re.sub("[()]", " ", line).split() for line in text.splitlines() if line[0] != "#"]
    rows = np.array(rows, dtype=float)
    return rows[:, 0], rows[:, 1] / parameter(case, "weight")


def displacement(case, time):
    """Of each grain from its place at the start [m], (n, 2)."""
    state = grainplot.read_grains(case, time)
    return state["position"][np.argsort(state["id"].ravel())] - start()[0]


def motion(case):
    """Times, share of the mass displaced by more than d_max, mean rise [m]."""
    mass = start()[1] ** 2
    times = grainplot.times(case)[1:]
    moves = [displacement(case, time) for time in times]
    share = [mass @ (grainplot.magnitude(move) > D_MAX) / mass.sum() for move in moves]
    rise = [mass @ move[:, 1] / mass.sum() for move in moves]
    return np.array(times, dtype=float), np.array(share), np.array(rise)


def crossing(x, y, level):
    """x where y, which rises, passes a level; nan if it does not."""
    above = np.flatnonzero(y >= level)
    if len(above) == 0 or above[0] == 0:
        return np.nan
    i = above[0]
    return x[i - 1] + (level - y[i - 1]) / (y[i] - y[i - 1]) * (x[i] - x[i - 1])


def snapshots(case, times):
    """Grains coloured by where they were at the start, as in fig. 3.16."""
    mesh = grainplot.read_mesh(case)
    order = start()[0][:, 1] * 1e3
    figure, row = plt.subplots(
        1, len(times), figsize=(3 * len(times), 5.5), sharey=True, layout="constrained"
    )
    for ax, time in zip(row, times, strict=True):
        state = grainplot.read_grains(case, time)
        grainplot.draw_cells(ax, mesh)
        colour = order[state["id"].ravel()]
        discs = grainplot.draw_grains(ax, state, colour, cmap="turbo", linewidths=0)
        ax.set_title(f"t = {time} s")
    row[0].set_ylabel("y [m]")
    figure.colorbar(discs, ax=list(row), label="height at the start [mm]", shrink=0.8)
    return figure


def main():
    results = Results()
    Path("snapshots").mkdir(exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    heaves = []
    cases = {h: Path(f"mesh_{h}") for h in MESHES if Path(f"mesh_{h}").exists()}
    for h, case in cases.items():
        at, gradient = pressure(case)
        times, share, rise = motion(case)
        first, heave = crossing(times, share, 0.05), crossing(times, share, 0.95)
        lift = crossing(times, rise, 0.02 * D_MAX)
        ratio = {name: np.interp(t, at, gradient) for name, t in
                 (("lifts", lift), ("first movement", first), ("heave", heave))}
        heaves.append(ratio["heave"])
        results.add(f"h/d {h}: i/i_c as the layer lifts", ratio["lifts"], "-", 1, "3 %", SOURCE)
        results.add(f"h/d {h}: i/i_c at first movement", ratio["first movement"])
        results.add(f"h/d {h}: i/i_c at heave", ratio["heave"], "-", 1, "3 %", SOURCE)
        left.plot(times, share, ".-", label=f"h/d = {h}")
        right.plot(np.interp(times, at, gradient), rise / D_MEAN, ".-", label=f"h/d = {h}")
        if h in (MESHES[0], MESHES[-1]):
            written = grainplot.times(case)[1:]
            late = [time for time in written if float(time) > 0.3] or written
            picture = snapshots(case, late[:: max(len(late) // 4, 1)][:5])
            picture.savefig(f"snapshots/mesh_{h}.png", dpi=110)
            plt.close(picture)
    if len(cases) < len(MESHES):
        results.write("results.csv")
        return
    spread = (max(heaves) - min(heaves)) / np.mean(heaves)
    results.add("heave: spread over the meshes", spread, "-", 0.03, "<=", "fig. 3.17")
    left.set(xlabel="t [s]", ylabel="share of the mass displaced by more than d_max")
    right.set(xlabel="i/i_c", ylabel="mean rise over d", ylim=(-0.2, 5))
    right.axvline(1, color="k", ls="--")
    left.legend()
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
