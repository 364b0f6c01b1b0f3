# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Relaxation against its closed forms: results.csv, results.png."""

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, RHO_P, MU, D, CELL = 1000.0, 2500.0, 1e-3, 0.95e-3, 1e-3
G, SLIP = 1e-9, 1e-9
PHI = np.pi / 6 * (D / CELL) ** 3
EPS = 1 - PHI
GAMMA = 18 * MU / D**2
RATE = GAMMA * (1 / RHO_P + PHI / (EPS * RHO))
V_INF = (RHO_P - RHO) * G * EPS**2 / GAMMA
TAU = EPS**2 * (RHO_P + RHO * PHI / EPS) / GAMMA
STEPS = [25, 50, 100]
MIDDLE = 10  # of 20 cells


def history(case):
    """Times and velocity of the grain in the middle."""
    track = np.genfromtxt(f"{case}/postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    track = track[track["id"] == MIDDLE]
    return track["time"], track["vz"]


def slip(case):
    """u - v at the end, in the middle."""
    time = grainplot.times(case)[-1]
    return grainplot.read_field(case, time, "U")[MIDDLE, 2] - history(case)[1][-1]


def extrapolate(rates):
    """To steps of length 0, from rates with errors of order dt and dt^2."""
    once = 2 * np.array(rates[1:]) - np.array(rates[:-1])
    return (4 * once[1] - once[0]) / 3


def main():
    results = Results()
    rates, inverse_taus = [], []
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for n in STEPS:
        dt = 0.1 / n
        step = np.arange(1, n + 1)

        w = slip(f"periodic_{n}") / SLIP
        exact = (1 + RATE * dt) ** -n
        results.add(f"periodic, {n} steps: slip left", w, "w0", exact, "0.0001 %", "implicit Euler")
        rates.append(-np.log(w) / 0.1)

        time, v = history(f"closed_{n}")
        exact = -V_INF * (1 - (1 + dt / TAU) ** -step)
        error = np.abs(v / exact - 1).max()
        results.add(
            f"closed, {n} steps: largest error of v", error, "-", 1e-6, "<=", "implicit Euler"
        )
        inverse_taus.append(-np.log(1 + v[-1] / V_INF) / 0.1)

        # The fluid's part of what the grains gained: momentum of both is conserved
        time, v = history(f"periodic_{n}")
        w = 1 - v / SLIP * (1 + PHI * RHO_P / (EPS * RHO))
        left.semilogy(time, w, ".", label=f"{n} steps")
        right.plot(*history(f"closed_{n}"), ".", label=f"{n} steps")

    results.add("periodic: rate, dt -> 0", extrapolate(rates), "1/s", RATE, "0.1 %", "closed form")
    results.add("closed: 1/tau, dt -> 0", extrapolate(inverse_taus), "1/s", 1 / TAU, "0.1 %",
                "closed form")
    t = np.linspace(0, 0.1, 200)
    left.semilogy(t, np.exp(-RATE * t), "k", label="exp(-lambda t)")
    right.plot(t, -V_INF * (1 - np.exp(-t / TAU)), "k", label="v_inf (1 - exp(-t/tau))")
    left.set(xlabel="t [s]", ylabel="(u - v)/w0", title="periodic")
    right.set(xlabel="t [s]", ylabel="v [m/s]", title="closed column")
    left.legend()
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
