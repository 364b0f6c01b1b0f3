# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure gradient over Beetstra's and Ergun's against the cell size: results.csv, results.png.

Usage: plot.py <pressure drop [Pa]> ...
"""

import re
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, MU, D, WIDTH, LENGTH = 1000.0, 1e-3, 1e-3, 4e-3, 8e-3
CELLS = [1, 2, 4, 8, 16, 32, 48]  # in four diameters
BEETSTRA = "Beetstra et al., AIChE J. 53, 489, 2007"
BETWEEN = "25 % beyond the band of the fine end"


def beetstra(phi, reynolds):
    """Pressure gradient over mu U/d^2."""
    eps = 1 - phi
    force = 10 * phi / eps**2 + eps**2 * (1 + 1.5 * np.sqrt(phi))
    force += (
        (0.413 * reynolds / (24 * eps**2))
        * (1 / eps + 3 * phi * eps + 8.4 * reynolds**-0.343)
        / (1 + 10 ** (3 * phi) * reynolds ** (-(1 + 4 * phi) / 2))
    )
    return 18 * phi / eps * force


def ergun(phi, reynolds):
    """The same."""
    eps = 1 - phi
    return 150 * phi**2 / eps**3 + 1.75 * phi / eps**3 * reynolds


def measure(case, drop):
    """Solid fraction, Reynolds number and pressure gradient over mu U/d^2."""
    volume = re.search(r"Grains: \d+, volume (\S+) m", (case / "log.grainFoam").read_text())[1]
    table = case / "postProcessing/flux/0/surfaceFieldValue.dat"
    speed = abs(np.loadtxt(table)[-1, 1]) / WIDTH**2
    gradient = drop / LENGTH * D**2 / (MU * speed)
    return float(volume) / (WIDTH**2 * LENGTH), RHO * speed * D / MU, gradient


def snapshot(drop):
    """Velocity in a plane through the bed, three meshes."""
    figure, axes = plt.subplots(1, 3, figsize=(9, 6), layout="constrained")
    for ax, n in zip(axes, (4, 16, 48), strict=True):
        case = Path(f"drop_{drop}_{n}")
        time = max((p.name for p in case.glob("0.[0-9]*")), key=float)
        speed = np.abs(grainplot.read_field(case, time, "U", 2 * n**3)[:, 2])
        plane = speed.reshape(2 * n, n, n)[:, n // 2] * 1e3
        image = ax.imshow(plane, origin="lower", extent=(0, 4, 0, 8), vmin=0)
        ax.set(title=f"h/d = {4 / n:.3g}", xlabel="x/d", ylabel="z/d")
        figure.colorbar(image, ax=ax, label="|u_z| [mm/s]", shrink=0.6)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig(f"snapshots/velocity_{drop}.png", dpi=110)


def main():
    results = Results()
    figure, ax = plt.subplots(figsize=(7, 4.5), layout="constrained")
    for drop in sys.argv[1:]:
        ratios = []
        for n in CELLS:
            phi, reynolds, gradient = measure(Path(f"drop_{drop}_{n}"), float(drop))
            ratio = gradient / beetstra(phi, reynolds)
            ratios.append(ratio)
            h = {32: "1/8", 48: "1/12", 16: "1/4", 8: "1/2"}.get(n, 4 // n)
            name = f"{drop} Pa, h/d = {h} (Re {reynolds:.3g}): over Beetstra's"
            if n == CELLS[0]:
                results.add(name, ratio, "-", 1, "5 %", "the law put in: " + BEETSTRA)
            elif n == CELLS[-1]:
                results.add(name, ratio, "-", 1, "15 %", BEETSTRA)
                over = gradient / ergun(phi, reynolds)
                results.add(f"{drop} Pa, h/d = {h}: over Ergun's", over)
            else:
                results.add(name, ratio, "-", 1, "36 %", BETWEEN)
        ax.plot(4 / np.array(CELLS), ratios, "o-", label=f"Re = {reynolds:.2g}")
        snapshot(drop)
    ax.axhspan(0.85, 1.15, color="0.9")
    ax.axhline(1, color="k", ls="--", lw=1, label="Beetstra et al. 2007")
    for bound in (0.85 * 0.75, 1.15 * 1.25):
        ax.axhline(bound, color="0.6", ls=":")
    ax.set_xscale("log", base=2)
    ax.set_xticks(4 / np.array(CELLS), ["4", "2", "1", "1/2", "1/4", "1/8", "1/12"])
    ax.set(xlabel="h/d", ylabel="pressure gradient over the law's", ylim=(0, None))
    ax.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
