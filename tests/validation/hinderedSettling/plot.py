# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of settling over the solid fraction: results.csv, results.png."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RHO, RHO_P, MU, G, D, HEIGHT = 1000.0, 2630.0, 1e-3, 9.81, 0.2e-3, 9.6e-3
FRACTIONS = [0.1, 0.2, 0.3, 0.4]


def gamma(reynolds, eps):
    """Drag coefficient of Di Felice's law [kg/m^3/s]."""
    exponent = 2.7 - 0.65 * np.exp(-0.5 * (1.5 - np.log10(reynolds)) ** 2)
    return eps**-exponent * 0.75 * (0.63 * np.sqrt(reynolds) + 4.8) ** 2 * MU / D**2


def law(eps):
    """Speed of settling without a flux of the mixture: gamma v/eps = eps (rho_p - rho) g."""
    low, high = 1e-8, 1.0
    for _ in range(60):
        v = np.sqrt(low * high)
        carries = gamma(RHO * v * D / MU, eps) * v / eps > eps * (RHO_P - RHO) * G
        low, high = (low, v) if carries else (v, high)
    return v


def richardson_zaki(eps):
    """Of the lone sphere's speed (Trans. Inst. Chem. Eng. 32, 35, 1954)."""
    reynolds = RHO * law(1 - 1e-9) * D / MU
    return eps ** (4.35 * reynolds**-0.03 if reynolds < 1 else 4.45 * reynolds**-0.1)


MIDDLE = (0.4, 0.8)  # of the height: between the deposit and the front
EARLY = 0.35  # of the time
METHODS = {"exactOverlap": "--", "diffused": "-"}


def middle(case):
    """Times and mean speed of the grains in the middle, and the fluid fraction there at first."""
    times = grainplot.times(case)[1:]
    speeds = []
    for time in times:
        state = grainplot.read_grains(case, time)
        z = state["position"][:, 2] / HEIGHT
        inside = (z > MIDDLE[0]) & (z < MIDDLE[1])
        speeds.append(-state["velocity"][inside, 2].mean())
    eps = grainplot.read_field(case, times[0], "eps")
    cells = (np.array(MIDDLE) * len(eps)).round().astype(int)
    return np.array(times, dtype=float), np.array(speeds), eps[slice(*cells)].mean()


def add(results, method, phi, time, speed):
    """Rows of one run; speed over the law's, phi as found in the middle."""
    early = speed[(time > 0.1 * time[-1]) & (time < EARLY * time[-1])].mean()
    name = f"{method}, phi {phi:.3f}"
    lone = law(1 - 1e-9)
    of_law = law(1 - phi) / lone
    # At 0.4 the law itself is 8 % below, see README.md
    bound = "5 %" if phi < 0.35 else ""
    results.add(
        f"{name}: speed", early * of_law, "v_t", richardson_zaki(1 - phi), bound,
        "Richardson-Zaki",
    )
    results.add(
        f"{name}: speed", early * of_law, "v_t", of_law, "5 %", "drag law, uniform suspension"
    )
    results.add(f"{name}: law over Richardson-Zaki", of_law / richardson_zaki(1 - phi))
    # Layers form with overlaps that are not spread, see README.md
    one = (1, "5 %", "no layers form") if method == "diffused" else ()
    results.add(f"{name}: speed at the end over the law's", speed[-1], "-", *one)
    return early * of_law


def main():
    results = Results()
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    lone = law(1 - 1e-9)
    for method, line in METHODS.items():
        measured = []
        for i, phi in enumerate(FRACTIONS):
            time, speed, eps = middle(Path(f"{method}_{phi}"))
            speed /= law(eps)
            measured.append((1 - eps, add(results, method, 1 - eps, time, speed)))
            label = f"phi = {phi}" if method == "diffused" else None
            left.plot(time / time[-1], speed, line, color=f"C{i}", label=label)
        marker = "o" if method == "diffused" else "x"
        right.semilogy(*np.transpose(measured), marker, label=f"grainFoam, {method}")
    phi = np.linspace(0.01, 0.5, 100)
    right.semilogy(phi, richardson_zaki(1 - phi), "k--", label="Richardson-Zaki")
    right.semilogy(phi, [law(1 - x) / lone for x in phi], label="drag law, uniform suspension")
    left.set(xlabel="t/t_end", ylabel="speed over the law's", ylim=(0, 1.2))
    left.set_title("broken lines: exactOverlap, full: diffused", fontsize="medium")
    right.set(xlabel="solid fraction", ylabel="speed over that of a lone sphere")
    left.legend()
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
