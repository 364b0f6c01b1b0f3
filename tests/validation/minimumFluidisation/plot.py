# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop over velocity of a bed: results.csv, results.png."""

import re
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, RHO_P, MU, G = 1000.0, 2500.0, 1e-3, 9.81
SIDE, CELL, COLUMN = 10e-3, 2.5e-3, 60e-3


def history():
    """Time, pressure drop without what speeds the water column up [Pa], superficial velocity."""
    text = Path("postProcessing/inlet/0/surfaceFieldValue.dat").read_text()
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = np.array([re.sub("[()]", " ", line).split() for line in lines], dtype=float)
    time, pressure, speed = rows[:, 0], rows[:, 1], rows[:, 4]
    return time, pressure - RHO * COLUMN * np.gradient(speed, time), speed


def gamma(speed, eps, d):
    """Drag coefficient of the default law at a superficial speed [kg/m^3/s]."""
    reynolds = RHO * speed * d / MU
    exponent = 2.8 - 0.65 * np.exp(-0.5 * (1.5 - np.log10(reynolds)) ** 2)
    return eps**-exponent * 0.75 * (0.63 * np.sqrt(reynolds) + 4.8) ** 2 * MU / d**2


def lift(speed, rows, d):
    """Pressure drop that the law gives to a bed of cells of these fluid fractions, (rows, cells of
    a row), and grains of diameters d [Pa].  The cells of a row share its pressure gradient."""
    share = d**3 / np.sum(d**3)
    drop = 0
    for row in rows[rows.max(axis=1) < 0.95]:
        resistance = [(1 - eps) / eps**2 * share @ gamma(speed, eps, d) for eps in row]
        drop += CELL * speed / np.mean(1 / np.array(resistance))
    return drop


def balance(rows, d, weight):
    """Superficial velocity at which drag and pressure carry the bed."""
    low, high = 1e-6, 1.0
    for _ in range(60):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if lift(middle, rows, d) < weight else (low, middle)
    return middle


def bed(time):
    """Fluid fraction of the cells, (rows, cells of a row)."""
    return grainplot.read_field(".", time, "eps").reshape(-1, 16)


def main():
    results = Results()
    time, drop, speed = history()
    grains = np.genfromtxt("constant/grains.csv", delimiter=",", names=True, usecols=range(8))
    d = 2 * grains["radius"]
    weight = np.sum(np.pi / 6 * d**3) * (RHO_P - RHO) * G / SIDE**2

    turn = time[np.argmax(speed)]
    down = time > turn
    # The fixed bed's branch of the way down, a power law, continued to the weight
    fixed = down & (drop > 0.2 * weight) & (drop < 0.7 * weight)
    _, offset = np.polyfit(np.log(drop[fixed] / weight), np.log(speed[fixed]), 1)
    measured = np.exp(offset)
    written = np.array(grainplot.times("."))[1:]
    rows = bed(written[np.argmin(np.abs(written.astype(float) - time[fixed].mean()))])
    expected = balance(rows, d, weight)
    plateau = drop[~down & (speed > 1.05 * expected) & (speed < 1.3 * expected)]
    bubbling = drop[down & (speed > 1.3 * expected)]

    inside = rows[3:5].mean()
    results.add("bed: fluid fraction inside", inside)
    results.add("minimum fluidisation", measured, "m/s", expected, "5 %", "balance of forces")
    results.add("way up: plateau over weight", plateau.mean() / weight, "-", 1, "1 %", "weight")
    results.add("way down: drop over weight", bubbling.mean() / weight)
    figure, ax = plt.subplots(figsize=(6.5, 4.5), layout="constrained")
    ax.plot(speed[~down], drop[~down] / weight, label="way up")
    ax.plot(speed[down], drop[down] / weight, label="way down")
    fine = np.linspace(1e-5, 1.2 * expected, 100)
    law = np.array([lift(u, rows, d) for u in fine])
    ax.plot(fine, law / weight, "k:", label="law at the bed's eps")
    ax.axhline(1, color="k", ls="--")
    ax.axvline(expected, color="k", ls="--", label="balance of forces")
    ax.set(xlabel="superficial velocity [m/s]", ylabel="pressure drop over weight", ylim=(0, 1.3))
    ax.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
