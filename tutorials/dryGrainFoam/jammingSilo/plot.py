# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of flow and jam with the forces, snapshots/*.png; what left the silo, discharge.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

DIAMETER = 0.004  # mean [m]
GRAINS = 2500
G = 9.81
SOLID = 0.8  # packing fraction at rest, within the bulk
STRONG = 100 * 2500 * np.pi * DIAMETER**2 / 4 * 0.01 * G  # 100 mean grains' weight [N]
JAMMED = 0.3  # without a grain that leaves, to the end of the run [s]


def discharge(case):
    """Times and number of grains that have left until then."""
    (file,) = Path(case).glob("postProcessing/discharge/*/discharge.dat")
    data = np.loadtxt(file, ndmin=2)
    return data[:, 0], data[:, 4]


def jam(time, number):
    """When the last grain left [s], None if grains were leaving at the end."""
    left = time[np.flatnonzero(np.diff(number, prepend=0))]
    last = left[-1] if len(left) else 0
    return last if number[-1] < 0.9 * GRAINS and time[-1] - last > JAMMED else None


def rate(time, number):
    """Grains per second [1/s] from a tenth to half of what leaves, at most half of the silo."""
    end = min(number[-1], GRAINS / 2)
    if end < 20:
        return np.nan
    some = (number >= 0.1 * end) & (number <= 0.9 * end)
    return np.polyfit(time[some], number[some], 1)[0]


def beverloo(width, rates):
    """C and k of rate = C n sqrt(g) (B - k d)^(3/2), n grains per area; least squares of
    rate^(2/3), which is linear in B."""
    slope, offset = np.polyfit(width * DIAMETER, rates ** (2 / 3), 1)
    per_area = SOLID / (np.pi / 4 * DIAMETER**2)
    return slope**1.5 / (per_area * np.sqrt(G)), -offset / slope / DIAMETER


def draw(axis, case, time, forces, scale=3):
    state = grainplot.read_grains(case, time)
    grainplot.draw_cells(axis, grainplot.read_mesh(case), linewidths=0.1)
    if not forces:
        speed = grainplot.magnitude(state["velocity"])
        return grainplot.draw_grains(axis, state, speed, clim=(0, 0.5), linewidths=0)
    grainplot.draw_grains(axis, state, facecolors="0.88", linewidths=0)
    lines, force = grainplot.read_contacts(case, "forceChains", time)
    grainplot.draw_contacts(axis, lines, np.minimum(force / STRONG, 1), scale=scale)
    return None


def silo(case, name, time):
    """Speeds, forces, forces near the orifice."""
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.6), layout="compressed")
    discs = draw(left, case, time, False)
    draw(middle, case, time, True, scale=2)
    draw(right, case, time, True, scale=6)
    for axis in (left, middle):
        axis.set_ylim(-0.02, 0.21)
    right.set_xlim(-0.03, 0.03)
    right.set_ylim(-0.02, 0.05)
    left.set_title(f"{name}, t = {time} s")
    middle.set_title("forces")
    right.set_title("at the orifice")
    figure.colorbar(discs, ax=left, label="grain speed [m/s]", location="left", shrink=0.6)
    figure.savefig(f"snapshots/{case}.png", dpi=110)
    plt.close(figure)


def curves(rows):
    """Discharge over time, and its rate over the width of the orifice."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for row in rows:
        (line,) = left.plot(row["time"], row["number"], label=f"{row['width']} d")
        if row["jam"]:
            left.plot(row["jam"], row["number"][-1], "x", color=line.get_color())
    left.set(xlabel="time [s]", ylabel="grains that have left", title="x: jams")
    left.legend(title="orifice")

    width = np.array([row["width"] for row in rows])
    rates = np.array([row["rate"] for row in rows])
    right.plot(width, rates, "o")
    free = (width >= 8) & np.isfinite(rates)
    if np.count_nonzero(free) > 1:
        c, k = beverloo(width[free], rates[free])
        x = np.linspace(max(k, 0), width.max())
        unit = SOLID / (np.pi / 4 * DIAMETER**2) * np.sqrt(G) * DIAMETER**1.5
        right.plot(x, c * unit * (x - max(k, 0)) ** 1.5, label=f"C = {c:.2f}, k = {k:.2f}")
        right.legend(title=r"$C\,n\sqrt{g}\,(B-kd)^{3/2}$")
        print(f"Beverloo: C = {c:.2f}, k = {k:.2f}")
    right.set(xlabel="width of the orifice B/d", ylabel="grains per second")
    figure.savefig("snapshots/discharge.png", dpi=110)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    rows = []
    for case in sorted(Path().glob("width_*"), key=lambda path: int(path.name[6:])):
        time, number = discharge(case)
        row = {"width": int(case.name[6:]), "time": time, "number": number}
        rows.append(row | {"jam": jam(time, number), "rate": rate(time, number)})

    jammed = [row["width"] for row in rows if row["jam"]]
    for width in {*jammed, 10}:
        case = f"width_{width}"
        times = [time for time in grainplot.times(case) if time != "0"]
        state, time = ("jammed", -1) if width in jammed else ("flowing", len(times) // 4)
        silo(case, f"B = {width} d, {state}", times[time])
    curves(rows)

    with open("discharge.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["width", "left", "jam", "rate"])
        for row in rows:
            jam_time = row["jam"] or ""
            writer.writerow([row["width"], int(row["number"][-1]), jam_time, f"{row['rate']:.1f}"])


main()
