# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors and orders of convergence of the manufactured solutions: results.csv, results.png."""

import re
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

ERRORS = r"Error of U (\S+), of p (\S+), of T (\S+),"
CELLS = [16, 32, 64]
VARIANTS = {
    "A_0": "form A, steady eps",
    "A_1": "form A, travelling eps",
    "B_1": "form B, travelling eps",
}


def errors(variant):
    """Relative errors of U, p and T, (meshes, 3)."""
    logs = (Path(f"{variant}_{n}/log.manufacturedVANS").read_text() for n in CELLS)
    return np.array(
        [re.search(ERRORS, log).groups() for log in logs], dtype=float
    )


def main():
    results = Results()
    figure, ax = plt.subplots(figsize=(6, 4.5), layout="constrained")
    h = 1 / np.array(CELLS)
    for variant, title in VARIANTS.items():
        error = errors(variant)
        order = np.log2(error[:-1] / error[1:])
        results.add(f"{title}: error of u, {CELLS[-1]} cells", error[-1, 0])
        results.add(f"{title}: order of u", order[:, 0].min(), "-", 1.8, ">=", "second order")
        results.add(f"{title}: error of p, {CELLS[-1]} cells", error[-1, 1])
        results.add(f"{title}: order of p", order[:, 1].min())
        results.add(f"{title}: error of T, {CELLS[-1]} cells", error[-1, 2])
        results.add(f"{title}: order of T", order[-1, 2], "-", 1.9, ">=", "second order")
        ax.loglog(h, error[:, 2], "^-.", label=f"{title}, T")
        ax.loglog(h, error[:, 0], "o-", label=f"{title}, u")
        ax.loglog(h, error[:, 1], "s--", label=f"{title}, p")
    ax.loglog(h, 0.001 * (h / h[-1]) ** 2, "k:", label="second order")
    ax.set(xlabel="h/L", ylabel="relative error", title="manufactured solutions")
    ax.legend(loc="lower right", fontsize="small")
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
