# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nusselt numbers (nusselt.csv), the break-through of cold air; results.*, snapshots.

Usage: plot.py [-test]        -test: too few runs and steps to compare
"""

import csv
import os
import sys
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

EPS, PR = 0.45, 0.71
COLD, HOT = 300.0, 400.0
REFERENCE = Path(os.environ["GRAINFOAM_DIR"]) / "tests/cases/reference/nusseltPackedBed.csv"
OTHERS = ("law", "scheme", "initialT")
SOURCE = "Wakao et al. 1979"


def parameters(case):
    """Numbers that bed.py wrote."""
    lines = (line.rstrip(";").split() for line in (case / "parameters").read_text().splitlines())
    return {name: float(value[0]) for name, *value in lines if name not in OTHERS}


def ledger(case):
    file = case / "postProcessing/heatLedger/0/heatLedger.csv"
    return np.genfromtxt(file, delimiter=",", names=True)


def measured(case):
    """Nu from what the grains received and the temperatures of the cells and the grains."""
    p = parameters(case)
    T = grainplot.read_field(case, grainplot.times(case)[-1], "T")
    columns = int(p["columns"])
    grains = np.repeat([COLD, HOT], [4, columns])
    difference = np.sum(grains - T[2 : 6 + columns])
    volume = (1 - EPS) * p["spacing"] * p["height"] * 0.01  # of the grains in a cell
    per_volume = -ledger(case)["exchanged"][-1] / p["deltaT"] / (volume * difference)
    return per_volume * p["d"] ** 2 / (6 * p["kappa"])


def closed_forms():
    """Columns of the laws at the bed's fluid fraction in air."""
    table = np.genfromtxt(REFERENCE, delimiter=",", names=True, skip_header=3)
    return table[(table["eps"] == EPS) & (table["Pr"] == PR)]


def number(case):
    return float(case.name.split("_")[2])


def draw_nusselt(axis, results):
    """Laws and measured numbers; a table of them beside Wakao's."""
    table = closed_forms()
    Re = table["Re_s"]
    rows = {}
    laws = ["Henry", "WakaoKaguei", "Gunn", "RanzMarshall"]
    for law, colour in zip(laws, ["k", "tab:blue", "tab:green", "tab:orange"], strict=True):
        axis.loglog(Re, table[law], color=colour, lw=2.5 if law == "Henry" else 1.2, label=law)
        for case in sorted(Path(".").glob(f"steady_{law}_*"), key=number):
            at = number(case)
            rows.setdefault(at, {})[law] = Nu = measured(case)
            axis.plot(at, Nu, "o", mfc="none", color=colour)
            form = table[law][Re == at][0]
            results.add(f"{law}, Re {at:g}: Nu", Nu, "-", form, "0.2 %", "closed form")
    axis.plot([], [], "o", mfc="none", color="k", label="runs")
    axis.axvspan(15, 8500, color="0.93", label="range of Wakao's law")
    axis.set(xlabel="superficial Re", ylabel="Nu", title=f"packed bed, eps {EPS}, Pr {PR}")
    axis.legend(fontsize=8)

    with open("nusselt.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["Re", *laws, "Henry over Wakao"])
        for at in sorted(rows):
            ratio = rows[at]["Henry"] / table["WakaoKaguei"][Re == at][0]
            values = [rows[at].get(law, np.nan) for law in laws]
            writer.writerow([f"{value:.4g}" for value in (at, *values, ratio)])
            tolerance = "10 %" if 15 <= at <= 8500 else ""
            results.add(f"Henry over Wakao, Re {at:g}", ratio, "-", 1, tolerance, SOURCE)


def front(x, y):
    """How far fluid and solid are on their way to the new temperature (Schumann 1929)."""
    t = np.linspace(0, np.sqrt(x), 801) ** 2
    f = np.exp(-y - t) * np.i0(2 * np.sqrt(y * t))
    fluid = 1 - np.sum(0.5 * (f[1:] + f[:-1]) * np.diff(t))
    return fluid, fluid - f[-1]


def draw_front(outlet, profiles, case, results):
    """Air at the outlet over time, grains over the length, beside the closed form."""
    p = parameters(case)
    Nu = closed_forms()["Henry"][closed_forms()["Re_s"] == p["Re"]][0]
    h = 6 * Nu * p["kappa"] / p["d"] ** 2
    units = h * (1 - EPS) / (p["rho"] * p["Cp"] * p["inflow"])  # of transfer, per length
    rate = h / (2500 * p["capacity"])

    def arrived(x, time):
        # The air before the hot grains is cold from the beginning
        return front(units * x, rate * max(time - EPS * x / p["inflow"], 0))

    book = ledger(case)
    carried = p["rho"] * p["Cp"] * p["inflow"] * p["height"] * 0.01 * p["deltaT"]
    air = book["convected_outlet"] / carried
    way = (p["end"] - p["bed"]) / p["inflow"]  # from the bed to the outlet
    exact = [HOT - (HOT - COLD) * arrived(p["bed"], time - way)[0] for time in book["time"]]
    outlet.plot(book["time"], air, lw=2.5, label="run")
    outlet.plot(book["time"], exact, "k--", label="Schumann 1929")
    outlet.set(xlabel="t [s]", ylabel="T of the air at the outlet [K]")
    outlet.set_title(f"Re {p['Re']:g}, {units * p['bed']:.1f} transfer units")
    outlet.legend(fontsize=8)

    worst = 0
    times = [time for time in grainplot.times(case) if time != "0"]
    for time in times:
        grains = grainplot.read_grains(case, time)
        hot = grains["position"][:, 0] > 0
        x, T = grains["position"][hot, 0], grains["temperature"][hot]
        order = np.argsort(x)
        exact_T = np.array([HOT - (HOT - COLD) * arrived(xi, float(time))[1] for xi in x])
        worst = max(worst, np.abs(T - exact_T).max())
        (line,) = profiles.plot(1e3 * x[order], T[order], "o", ms=3, label=f"t = {time} s")
        profiles.plot(1e3 * x[order], exact_T[order], "--", color=line.get_color())
    profiles.set(xlabel="x [mm]", ylabel="T of the grains [K]", title="dashed: Schumann 1929")
    profiles.legend(fontsize=8)

    step = HOT - COLD
    difference = np.abs(air - exact)[book["time"] > way].max() / step
    source = "Schumann 1929"
    results.add("step: air at the outlet, worst of the step", difference, "-", 0.02, "<=", source)
    results.add("step: grains, worst of the step", worst / step, "-", 0.02, "<=", source)
    for error in ("fluidError", "grainError"):
        results.add(f"step: {error}", book[error].max(), "-", 1e-9, "<=", "linear solver")


def draw_bed(case):
    """Grains in colours of their temperature, at four times."""
    p = parameters(case)
    times = [time for time in grainplot.times(case) if time != "0"]
    figure, rows = plt.subplots(
        len(times), 1, figsize=(8, 5.5), layout="constrained", squeeze=False
    )
    mesh = grainplot.read_mesh(case)
    for time, axis in zip(times, rows.flat, strict=True):
        T = grainplot.read_field(case, time, "T", len(mesh.polygons))
        style = {"clim": (COLD, HOT), "cmap": "coolwarm"}
        grainplot.draw_cells(axis, mesh, T, lines=False, **style)
        grains = grainplot.read_grains(case, time)
        discs = grainplot.draw_grains(axis, grains, grains["temperature"], **style)
        axis.set(title=f"t = {time} s", xticks=[], yticks=[], ylim=(0, p["height"]))
    figure.colorbar(discs, ax=rows, label="T of grains and air [K]")
    figure.savefig("snapshots/bed.png", dpi=110)


def main():
    results = Results()
    Path("snapshots").mkdir(exist_ok=True)
    figure, axes = plt.subplots(1, 3, figsize=(15, 4.4), layout="constrained")
    draw_nusselt(axes[0], results)
    (case,) = Path(".").glob("step_*")
    draw_front(axes[1], axes[2], case, results)
    figure.savefig("results.png", dpi=110)
    draw_bed(case)
    if "-test" in sys.argv:
        results.write("results.csv")
    else:
        results.finish()


main()
