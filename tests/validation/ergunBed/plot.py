# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop over velocity of a fixed and a free bed: results.csv, results.png."""

import re
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, RHO_P, MU, D, G = 10.0, 2000.0, 1.5e-3, 1e-3, 9.81
SIDE, COLUMN = 24.733e-3, 57.2e-3
EPS, LENGTH = 0.451335, 15.6e-3  # CFDEM's bed
SOURCE = "Ergun, eps 0.451, as CFDEM's ErgunTest"


def history(case):
    """Time, pressure drop without what speeds the air column up [Pa], superficial velocity."""
    text = Path(case, "postProcessing/inlet/0/surfaceFieldValue.dat").read_text()
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = np.array([re.sub("[()]", " ", line).split() for line in lines], dtype=float)
    time, pressure, speed = rows[:, 0], rows[:, 1], rows[:, 4]
    return time, pressure - RHO * COLUMN * np.gradient(speed, time), speed


def ergun(speed):
    """Pressure drop of CFDEM's bed [Pa]."""
    viscous = 150 * (1 - EPS) ** 2 / EPS**3 * MU * speed / D**2
    return LENGTH * (viscous + 1.75 * (1 - EPS) / EPS**3 * RHO * speed**2 / D)


def main():
    results = Results()
    z = np.genfromtxt("fixed/constant/grains.csv", delimiter=",", names=True, usecols=2)["z"]
    n = len(z)
    weight = n * np.pi / 6 * D**3 * (RHO_P - RHO) * G / SIDE**2
    middle = (z > z.min() + 2 * D) & (z < z.min() + 12 * D)
    results.add("grains", n)
    eps = 1 - np.sum(middle) * np.pi / 6 * D**2 / (10 * SIDE**2)
    results.add("bed: fluid fraction, 2 to 12 d above the screen", eps)

    time, drop, speed = history("fixed")
    first = (time > 0.01) & (time < 0.0195)
    fixed = drop[first].mean()
    results.add("fixed bed: drop at 0.002 m/s", fixed, "Pa", ergun(0.002), "3 %", SOURCE)

    time_free, drop_free, speed_free = history("free")
    up = time_free <= 0.3
    # The fixed bed's branch, a power law, continued to the weight; before, the bed sinks a little
    # as it is let go
    branch = up & (time_free > 0.05) & (drop_free > 0.2 * weight) & (drop_free < 0.7 * weight)
    _, offset = np.polyfit(np.log(drop_free[branch] / weight), np.log(speed_free[branch]), 1)
    minimum = np.exp(offset)
    plateau = drop_free[up & (speed_free > 1.1 * minimum)] / weight
    viscous = D**2 * (RHO_P - RHO) * G * EPS**3 / (150 * MU * (1 - EPS))
    results.add("minimum fluidisation", minimum, "m/s", viscous, "5 %", SOURCE)
    results.add("free bed: plateau over weight", plateau.mean(), "-", 1, "5 %", "weight")
    late = drop_free[time_free > 0.4] / weight
    results.add("0.1 to 0.2 s at 0.02 m/s: drop over weight, mean", late.mean())

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    left.plot(1e3 * speed, drop, label="fixed")
    left.plot(1e3 * speed_free[up], drop_free[up], label="free")
    left.plot(1e3 * speed, ergun(speed), "k:", label="Ergun, eps 0.451")
    left.axhline(weight, color="k", ls="--", label="weight")
    left.axvline(1e3 * viscous, color="0.7")
    left.set(xlabel="superficial velocity [mm/s]", ylabel="pressure drop [Pa]")
    left.legend()
    right.plot(time_free, drop_free / weight)
    right.axvline(0.3, color="0.7", label="end of the ramp")
    right.set(xlabel="t [s]", ylabel="free bed: drop over weight", ylim=(0, 1.2))
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
