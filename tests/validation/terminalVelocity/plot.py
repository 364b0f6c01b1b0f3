# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fall against a stream of air and its closed form: results.csv, results.png."""

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, RHO_P, MU, D = 1.2, 2000.0, 1.8e-5, 1e-4
G, AIR, HEIGHT, END = 9.80665, 0.40, 92.5e-3, 0.35
SOURCE = "MFiX DEM06, closed form"


def rate(state):
    """Of height and velocity, by Schiller and Naumann's drag."""
    slip = AIR - state[1]
    reynolds = RHO * abs(slip) * D / MU
    gamma = 18 * MU / D**2 * (1 + 0.15 * reynolds**0.687)
    return np.array([state[1], gamma * slip / RHO_P - G * (1 - RHO / RHO_P)])


def closed_form(steps=3500):
    """Time, height, velocity."""
    h = END / steps
    states = [np.array([HEIGHT, 0.0])]
    for _ in range(steps):
        x = states[-1]
        k1 = rate(x)
        k2 = rate(x + h / 2 * k1)
        k3 = rate(x + h / 2 * k2)
        k4 = rate(x + h * k3)
        states.append(x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    return np.linspace(0, END, steps + 1), *np.array(states).T


def main():
    results = Results()
    t, height, velocity = closed_form()
    # What MFiX's own table has after 0.35 s
    results.add("closed form: velocity", velocity[-1], "m/s", -0.05739, "0.01 %", "MFiX DEM06")
    track = np.genfromtxt("postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    results.add("velocity after 0.35 s", track["vy"][-1], "m/s", velocity[-1], "1 %", SOURCE)
    results.add("height after 0.35 s", track["y"][-1], "m", height[-1], "0.3 %", SOURCE)
    error = np.abs(track["vy"] - np.interp(track["time"], t, velocity)).max()
    results.add("largest error of the velocity over the air's", error / AIR)

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for ax, name, exact in ((left, "y", height), (right, "vy", velocity)):
        ax.plot(t, 1e3 * exact, "k", label="closed form")
        ax.plot(track["time"][::10], 1e3 * track[name][::10], ".", label="grainFoam")
        ax.legend()
    left.set(xlabel="t [s]", ylabel="height [mm]")
    right.set(xlabel="t [s]", ylabel="velocity [mm/s]")
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
