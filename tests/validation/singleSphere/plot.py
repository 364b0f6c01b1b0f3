# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling speed against the drag law's: results.csv, results.png."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from grainresults import Results

D, REFERENCE = 2.663e-3, 0.02990
LAST = 0.3  # of the time, in which the speed is averaged


def track(case):
    """Time and speed of fall."""
    data = np.genfromtxt(case / "postProcessing/tracks/0/grains.csv", delimiter=",", names=True)
    return data["time"], -data["vz"]


def main():
    results = Results()
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    cases = sorted(
        (float(path.name.split("_")[1]), float(path.name.split("_")[3]), path)
        for path in Path(".").glob("cells_*_width_*")
    )
    speeds = []
    for h, width, path in reversed(cases):
        time, speed = track(path)
        last = speed[time > (1 - LAST) * time[-1]]
        name = f"h/d = {h:g}, box {width:g} d wide"
        speeds.append((h, width, last.mean()))
        if h == 4:
            results.add(name, last.mean(), "m/s", REFERENCE, "2 %", "Dallavalle's law")
        else:
            results.add(name, last.mean(), "m/s", REFERENCE, "", "Dallavalle's law")
        results.add(f"{name}: over the law's", last.mean() / REFERENCE)
        results.add(f"{name}: scatter over the mean", last.std() / last.mean())
        left.plot(time, speed, label=name)
    left.axhline(REFERENCE, color="k", ls="--", label="Dallavalle's law")
    left.set(xlabel="t [s]", ylabel="speed of fall [m/s]")
    left.legend(fontsize=7)
    for width in sorted({entry[1] for entry in speeds}):
        h, value = np.array([(h, v) for h, w, v in speeds if w == width]).T
        right.plot(np.log2(h), value / REFERENCE, "o-", label=f"box {width:g} d wide")
    right.axhline(1, color="k", ls="--")
    right.set_xticks([-2, -1, 0, 1, 2], ["1/4", "1/2", "1", "2", "4"])
    right.set(xlabel="h/d", ylabel="speed over the law's")
    right.legend()
    figure.savefig("results.png", dpi=110)
    results.finish()


main()
