# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean Nusselt numbers (results.*), isotherms and flow (snapshots).

Usage: plot.py [-test]        -test: too few steps to compare
"""

import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

DELTA_T = 10.0
PHI = np.pi / 4 * 0.7**2  # of the bed

# Mean Nusselt numbers by Rayleigh number
AIR = {1e3: 1.118, 1e4: 2.243, 1e5: 4.519, 1e6: 8.800}
AIR_SOURCE = "de Vahl Davis 1983"
BED = {50: 1.984, 100: 3.110, 200: 4.97}
BED_SOURCE = "Darcy's law, Chebyshev collocation"


def parameters(case):
    """Numbers that cavity.py wrote."""
    lines = (line.rstrip(";").split() for line in (case / "parameters").read_text().splitlines())
    return {name: float(value) for name, value in lines if name != "walls"}


def nusselt(case):
    """Times over that which heat takes to diffuse; at the hot and the cold wall; worst error."""
    p = parameters(case)
    book = np.genfromtxt(
        case / "postProcessing/heatLedger/0/heatLedger.csv", delimiter=",", names=True
    )
    conductivity = p["kappa"] * (1 - PHI if case.name.startswith("bed") else 1)
    depth = 0.1 * p["size"]
    unit = conductivity * DELTA_T * depth * p["deltaT"]
    diffusion = p["size"] ** 2 * p["rho"] * p["Cp"] / conductivity
    return (
        book["time"] / diffusion,
        -book["conducted_hot"] / unit,
        book["conducted_cold"] / unit,
        book["fluidError"].max(),
    )


def draw(axis, case):
    """Temperature in colours, isotherms, arrows of the flow."""
    n = int(parameters(case)["n"])
    time = grainplot.times(case)[-1]
    mesh = grainplot.read_mesh(case)
    T = grainplot.read_field(case, time, "T", n * n)
    U = grainplot.read_field(case, time, "U", n * n)
    colours = grainplot.draw_cells(axis, mesh, T, lines=False, cmap="coolwarm", clim=(295, 305))
    centres = np.array([polygon.mean(axis=0) for polygon in mesh.polygons]).reshape(n, n, 2)
    axis.contour(
        *np.moveaxis(centres, -1, 0),
        T.reshape(n, n), np.arange(296, 305), colors="k", linewidths=0.7,
    )
    if case.name.startswith("bed"):
        grains = grainplot.read_grains(case, time)
        grainplot.draw_grains(axis, grains, facecolors="none", edgecolors="0.5")
    every = np.s_[n // 16 :: n // 8, n // 16 :: n // 8]
    grid = U.reshape(n, n, -1)[every]
    axis.quiver(
        *np.moveaxis(centres[every], -1, 0), grid[..., 0], grid[..., 1],
        color="0.2", width=0.005, scale=10 * np.abs(grid).max(), scale_units="width",
    )
    axis.set(xticks=[], yticks=[])
    return colours


def number(case):
    return float(case.name.split("_")[1])


def main():
    cases = [sorted(Path(".").glob(f"{kind}_*"), key=number) for kind in ("air", "bed")]
    results = Results()
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    kinds = [
        ("air", AIR, AIR_SOURCE, "1 %"),
        ("bed", BED, BED_SOURCE, "2 %"),
    ]
    for runs, axis, (kind, table, source, tolerance) in zip(cases, axes, kinds, strict=True):
        for case, colour in zip(runs, plt.cm.viridis(np.linspace(0, 0.8, 4)), strict=False):
            Ra = number(case)
            time, hot, cold, error = nusselt(case)
            label = f"{kind}, Ra {case.name.split('_')[1]}"
            results.add(f"{label}: Nu", hot[-1], "-", table[Ra], tolerance, source)
            results.add(f"{label}: cold wall over hot wall", cold[-1] / hot[-1], "-", 1, "0.2 %")
            results.add(f"{label}: heat unaccounted for", error, "-", 1e-9, "<=", "linear solver")
            axis.plot(time, hot, color=colour, label=f"Ra {case.name.split('_')[1]}")
            axis.plot(time, cold, color=colour, ls=":")
            axis.axhline(table[Ra], color="k", lw=0.7, ls="--")
        axis.axhline(np.nan, color="k", lw=0.7, ls="--", label=source)
        axis.set(xlabel="t a/L²", ylabel="Nu of the hot wall, dotted: cold", xlim=(0, None))
        axis.set(yscale="log", ylim=(0.9, 20))
        axis.set_title({"air": "air", "bed": "water in a bed of fixed grains"}[kind])
        axis.legend(fontsize=8)
    figure.savefig("results.png", dpi=110)

    Path("snapshots").mkdir(exist_ok=True)
    for kind, runs in zip(("air", "bed"), cases, strict=True):
        if not runs:
            continue
        figure, row = plt.subplots(
            1, len(runs), figsize=(3.4 * len(runs) + 1, 3.6), layout="constrained", squeeze=False
        )
        for case, axis in zip(runs, row.flat, strict=True):
            colours = draw(axis, case)
            axis.set_title(f"Ra {case.name.split('_')[1]}")
        figure.colorbar(colours, ax=row, label="T [K]")
        figure.savefig(f"snapshots/{kind}.png", dpi=110)

    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
