# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling speed against the drag law's: results.csv, results.png."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, REFERENCE = 2.663e-3, 0.02990
LAW = "Dallavalle's law"
FLOWS = {"none": "flow of the cell", "filtered": "undisturbed flow"}
LAST = 0.3  # of the time, in which the speed is averaged


def track(case):
    """Time and speed of fall."""
    data = np.genfromtxt(case / "postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    return data["time"], -data["vz"]


def main():
    results = Results()
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    cases = []
    for path in sorted(Path(".").glob("cells_*_width_*")):
        _, h, _, width, flow = path.name.split("_")
        cases.append((float(h), float(width), flow, path))
    speeds = []
    for h, width, flow, path in sorted(cases, reverse=True):
        time, speed = track(path)
        last = speed[time > (1 - LAST) * time[-1]]
        name = f"h/d = {h:g}, box {width:g} d wide, {FLOWS[flow]}"
        speeds.append((h, width, flow, last.mean()))
        tolerance = "10 %" if flow == "filtered" else ""
        results.add(f"{name}: over the law's", last.mean() / REFERENCE, "-", 1, tolerance, LAW)
        results.add(f"{name}: scatter over the mean", last.std() / last.mean())
        left.plot(time, speed, ls="-" if flow == "filtered" else ":", label=name)
    left.axhline(REFERENCE, color="k", ls="--", label=LAW)
    left.set(xlabel="t [s]", ylabel="speed of fall [m/s]")
    left.legend(fontsize=5)
    for flow, label in FLOWS.items():
        points = [(h, v) for h, w, f, v in speeds if f == flow and w in (8, 12, 32)]
        h, value = np.array(points).T
        right.plot(np.log2(h), value / REFERENCE, "o-", label=label)
    right.axhline(1, color="k", ls="--")
    right.fill_between([-2, 2], 0.9, 1.1, color="0.9")
    right.set_xticks([-2, -1, 0, 1, 2], ["1/4", "1/2", "1", "2", "4"])
    right.set(xlabel="h/d", ylabel="speed over the law's")
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
