# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coefficient of restitution in a liquid against the Stokes number: results.csv, results.png."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

RATIO, D, DRY, GAP = 8.0, 0.02, 0.97, 0.1
SOURCE = "Legendre et al., Chem. Eng. Sci. 61, 3543, 2006"
METHODS = {
    "law": "not resolved, with Legendre",
    "locked": "locked",
    "cutCells": "cut cells",
    "lockedAndFilm": "locked, with Davis",
    "cutCellsAndFilm": "cut cells, with Davis",
}


def experiments(stokes):
    """Mean of experiments, over the coefficient without a liquid."""
    return np.exp(-35 / stokes)


def rebound(case):
    """Stokes number, and speed a tenth of a diameter from the wall after over that before."""
    nu = float(case.name.split("_")[1])
    track = np.genfromtxt(case / "postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    gap, v = track["z"] / D - 0.5, track["vz"]
    up = int(np.argmax(v > 0)) or len(v)
    before = -np.interp(-GAP, -gap[:up], v[:up])
    after = np.interp(GAP, gap[up:], v[up:]) if len(v) > up and gap[-1] > GAP else 0
    return (RATIO + 0.5) * before * D / (9 * nu), after / before


def main():
    results = Results()
    figure, ax = plt.subplots(figsize=(7, 4.5), layout="constrained")
    for method, label in METHODS.items():
        cases = sorted(Path().glob(f"{method}_*"), key=lambda p: float(p.name.split("_")[1]))
        stokes, ratio = np.transpose([rebound(case) for case in cases])
        for st, e in zip(stokes, ratio, strict=True):
            # As the experiments scatter
            tolerance = "" if method in ("locked", "cutCells") else "+-0.1"
            name = f"{label}, St {st:.3g}"
            results.add(name, e, "-", DRY * experiments(st), tolerance, SOURCE)
        ax.semilogx(stokes, ratio / DRY, "o-" if "Film" in method else "s--", label=label)
    st = np.geomspace(10, 5000, 200)
    ax.semilogx(st, experiments(st), "k", label="experiments, mean")
    ax.set(xlabel="St", ylabel=f"e/{DRY}", ylim=(0, 1.05))
    ax.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
