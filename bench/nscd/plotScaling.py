# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure and table of what benchScaling has written: plotScaling.py scaling.csv scaling.png"""

import sys

import matplotlib.pyplot as plt
import numpy as np

GRAINS = {2: "discs", 3: "spheres"}


def main(source, picture):
    rows = np.genfromtxt(source, delimiter=",", names=True)
    figure, (time, memory) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    print("| grains | contacts | us per step and grain | of detection | bytes per grain |")
    print("|---|---|---|---|---|")
    for dimension, name in GRAINS.items():
        part = rows[rows["dimension"] == dimension]
        slope = np.polyfit(np.log(part["grains"]), np.log(part["msPerStep"]), 1)[0]
        label = f"{name}, slope {slope:.2f}"
        time.loglog(part["grains"], part["msPerStep"], "o-", label=label)
        memory.semilogx(part["grains"], part["bytesPerGrain"], "o-", label=name)
        for row in part:
            print(
                f"| {row['grains']:.0f} {name} | {row['contacts']:.0f} "
                f"| {row['usPerStepAndGrain']:.2f} | {row['detectionUs']:.2f} "
                f"| {row['bytesPerGrain']:.0f} |"
            )
    ends = np.array([1e3, 1e6])
    time.loglog(ends, ends * 1e-3, "k:", label="1 us per grain")
    time.set(xlabel="grains", ylabel="ms per step")
    memory.set(xlabel="grains", ylabel="bytes per grain", ylim=(0, None))
    time.legend()
    memory.legend()
    figure.savefig(picture, dpi=110)


main(*sys.argv[1:])
