# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Concentration of the grains against that of the drag law (results.*), and how they flow.

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, RHO, DENSITY, MU = 1e-3, 1000.0, 1500.0, 1e-3
WIDTH, HEIGHT, DEPTH = 0.04, 0.16, 1e-3
MIXTURE = 0.15  # superficial velocity of fluid and grains [m/s]
FLUXES = {0.002: (3, 6), 0.004: (9, 12), 0.008: (15, 18)}  # of grains [m/s]: times to average
LAW = "slip of Dallavalle and Di Felice's law in a uniform suspension"


def slip(eps):
    """Of the fluid past grains that do not accelerate: gamma w = eps (rho_p - rho) g [m/s]."""
    slow, fast = 1e-6, 2.0
    for _ in range(60):
        w = 0.5 * (slow + fast)
        re = eps * RHO * w * D / MU
        exponent = 2.8 - 0.65 * np.exp(-0.5 * (1.5 - np.log10(re)) ** 2)
        root = np.sqrt(2 / np.pi) * (0.63 * np.sqrt(re) + 4.8)
        gamma = eps**-exponent * root**2 * MU / D**2
        if gamma * w < eps * (DENSITY - RHO) * 9.81:
            slow = w
        else:
            fast = w
    return slow


def concentration(flux):
    """Of a uniform suspension that carries a flux of grains: flux = phi v."""
    phi = flux / MIXTURE
    for _ in range(200):
        v = (MIXTURE - flux) / (1 - phi) - slip(1 - phi)
        phi += 0.3 * (flux / v - phi)
    return phi


def ledger():
    file = Path("postProcessing/ledger/0/ledger.csv")
    return np.genfromtxt(file, delimiter=",", names=True)


def snapshots(times):
    figure, axes = plt.subplots(1, len(times), figsize=(2.2 * len(times), 6), layout="constrained")
    mesh = grainplot.read_mesh(".")
    for ax, time in zip(np.atleast_1d(axes), times, strict=True):
        grains = grainplot.read_grains(".", time)
        grainplot.draw_cells(ax, mesh, lines=False, facecolors="0.95")
        speed = grains["velocity"][:, 1]
        drawn = grainplot.draw_grains(ax, grains, speed)
        drawn.set_clim(0, 0.15)
        ax.set(title=f"t = {time} s", xticks=[], yticks=[], ylim=(-0.002, HEIGHT + 0.002))
    figure.colorbar(drawn, ax=axes, label="upward velocity of the grains [m/s]", shrink=0.6)
    Path("snapshots").mkdir(exist_ok=True)
    figure.savefig("snapshots/grains.png", dpi=110)


def main():
    book = ledger()
    t = book["time"]
    phi = book["mappedVolume"] / (WIDTH * HEIGHT * DEPTH)
    results = Results()
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    left.plot(t, phi, label="in the channel")
    for flux, (start, end) in FLUXES.items():
        law = concentration(flux)
        left.plot([start, end], [law, law], "k--", label="law" if flux == 0.002 else None)
        now = (t > start) & (t <= end)
        if not now.any():
            continue
        name = f"flux {1e3 * flux:g} mm/s"
        results.add(f"{name}: solid fraction", phi[now].mean(), "-", law, "10 %", LAW)
        out = book["removedVolume"][now].sum() / book["injectedVolume"][now].sum()
        results.add(f"{name}: out over in", out, "-", 1, "5 %", "what goes in comes out")
    left.set(xlabel="t [s]", ylabel="solid fraction")
    left.legend()
    for kind in ("injected", "removed"):
        right.plot(t, 1e9 * np.cumsum(book[f"{kind}Volume"]), label=kind)
    right.plot(t, 1e9 * book["grainVolume"], label="in the channel")
    right.set(xlabel="t [s]", ylabel="volume of grains [mm$^3$]")
    right.legend()
    figure.savefig("results.png", dpi=110)

    worst = book["grainMomentumError"].max()
    results.add("momentum of the grains unaccounted for", worst, "-", 1e-10, "<=", "round-off")
    times = grainplot.times(".")[1:]
    snapshots([time for time in ("6", "12", "18") if time in times] or times[-2:])
    if "-test" in sys.argv:
        results.write(Path("results.csv"))
    else:
        results.finish()


main()
