# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors and orders of convergence of the flows without grains: results.csv, results.png."""

import os
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

CELLS = [16, 32, 64]
GHIA = Path(os.environ["GRAINFOAM_DIR"]) / "tests/cases/reference/ghiaCavityRe100.csv"
NU, END = 0.1, 0.12  # of the vortices


def velocity(flow, n):
    """(n, n, 3), rows along y."""
    case = f"{flow}_{n}"
    return grainplot.read_field(case, grainplot.times(case)[-1], "U").reshape(n, n, 3)


def interpolate(at, x, values):
    """Cubic through the four nearest points, so that the meshes' errors are not hidden by it."""
    first = np.clip(np.searchsorted(x, at) - 2, 0, len(x) - 4)
    total = np.zeros_like(at)
    for i in range(4):
        weight = np.ones_like(at)
        for j in set(range(4)) - {i}:
            weight *= (at - x[first + j]) / (x[first + i] - x[first + j])
        total += weight * values[first + i]
    return total


def cavity_lines(n):
    """u(y) on the vertical and v(x) on the horizontal centre line, as functions."""
    U = velocity("cavity", n)
    at = np.concatenate([[0], (np.arange(n) + 0.5) / n, [1]])
    u = 0.5 * (U[:, n // 2 - 1, 0] + U[:, n // 2, 0])
    v = 0.5 * (U[n // 2 - 1, :, 1] + U[n // 2, :, 1])
    u, v = np.concatenate([[0], u, [1]]), np.concatenate([[0], v, [0]])
    return lambda y: interpolate(y, at, u), lambda x: interpolate(x, at, v)


def vortex_error(n):
    """Root mean square of the velocity's error over that of the exact velocity."""
    centre = (np.arange(n) + 0.5) / n
    x, y = np.meshgrid(centre, centre)
    k = 2 * np.pi
    decay = np.exp(-2 * NU * k**2 * END)
    exact = decay * np.stack(
        [np.sin(k * x) * np.cos(k * y), -np.cos(k * x) * np.sin(k * y)], axis=-1
    )
    error = velocity("taylorGreen", n)[..., :2] - exact
    return np.sqrt(np.mean(error**2) / np.mean(exact**2))


def orders(errors):
    return np.log2(np.array(errors[:-1]) / np.array(errors[1:]))


def main():
    ghia = np.genfromtxt(GHIA, delimiter=",", names=True, skip_header=3)
    lines = {n: cavity_lines(n) for n in CELLS}
    inner = (np.arange(1, 200)) / 200
    steps = [
        np.sqrt(np.mean([(a(inner) - b(inner)) ** 2 for a, b in zip(lines[m], lines[n])]))
        for m, n in zip(CELLS, CELLS[1:], strict=False)
    ]
    vortex = [vortex_error(n) for n in CELLS]

    results = Results()
    u, v = lines[CELLS[-1]]
    source = "Ghia et al. 1982"
    results.add(
        "cavity Re 100: largest error of u", np.abs(u(ghia["y"]) - ghia["u"]).max(), "-", 0.005,
        "<=", source + "; on finer meshes u falls to -0.214, Ghia has -0.211",
    )
    results.add(
        "cavity Re 100: largest error of v", np.abs(v(ghia["x"]) - ghia["v"]).max(), "-", 0.01,
        "<=", source + "; copies of v differ by 0.01",
    )
    results.add("cavity: order of convergence", orders(steps)[-1], "-")
    for n, error in zip(CELLS, vortex, strict=True):
        results.add(f"Taylor-Green: error of the velocity, {n} cells", error, "-")
    results.add(
        "Taylor-Green: order of convergence", orders(vortex)[-1], "-", 1.9, ">=", "second order"
    )

    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    fine = np.linspace(0, 1, 400)
    for n in CELLS:
        left.plot(lines[n][0](fine), fine, label=f"{n} x {n} cells")
        middle.plot(fine, lines[n][1](fine))
    left.plot(ghia["u"], ghia["y"], "ko", mfc="none", label="Ghia et al.")
    middle.plot(ghia["x"], ghia["v"], "ko", mfc="none")
    left.set(xlabel="u/U at x = L/2", ylabel="y/L", title="lid-driven cavity, Re 100")
    middle.set(xlabel="x/L", ylabel="v/U at y = L/2", title="lid-driven cavity, Re 100")
    left.legend()
    h = 1 / np.array(CELLS)
    right.loglog(h, vortex, "o-", label="Taylor-Green, error")
    right.loglog(h[1:], steps, "s-", label="cavity, change to next coarser mesh")
    right.loglog(h, vortex[-1] * (h / h[-1]) ** 2, "k--", label="second order")
    right.set(xlabel="h/L", ylabel="root mean square", title="convergence")
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
