# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Front and height of the column, and the water (snapshots/)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

G, WIDTH = 9.81, 0.05715
# Martin and Moyce 1952 (Phil. Trans. R. Soc. A 244, 312), column twice as high as wide, 2.25 in:
# front over the width at t sqrt(2 g/width), height over the first at t sqrt(g/width)
FRONT = (
    (0.41, 1.11), (0.84, 1.22), (1.19, 1.44), (1.43, 1.67), (1.63, 1.89), (1.83, 2.11),
    (1.98, 2.33), (2.2, 2.56), (2.32, 2.78), (2.51, 3), (2.65, 3.22), (2.83, 3.44), (2.98, 3.67),
    (3.11, 3.89), (3.33, 4.11),
)
HEIGHT = (
    (0.56, 0.94), (0.77, 0.89), (0.93, 0.83), (1.08, 0.78), (1.28, 0.72), (1.46, 0.67),
    (1.66, 0.61), (1.84, 0.56), (2, 0.5), (2.21, 0.44), (2.45, 0.39), (2.7, 0.33), (3.06, 0.28),
    (3.44, 0.22), (4.2, 0.17), (5.25, 0.11),
)
SHOWN = ("0.06", "0.12", "0.18")


def extents(mesh, centres, time):
    """Front along the floor and height along the wall, where alpha passes one half."""
    alpha = grainplot.read_field(".", time, "alpha.water", len(mesh.polygons))

    def length(row, along):
        order = np.argsort(centres[row, along])
        at, value = centres[row, along][order], alpha[row][order]
        last = np.flatnonzero(value > 0.5)[-1]
        return np.interp(0.5, value[[last + 1, last]], at[[last + 1, last]])

    floor = np.isclose(centres[:, 1], centres[:, 1].min())
    wall = np.isclose(centres[:, 0], centres[:, 0].min())
    return length(floor, 0), length(wall, 1)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    mesh = grainplot.read_mesh(".")
    centres = np.array([polygon.mean(axis=0) for polygon in mesh.polygons])
    times = grainplot.times(".")
    t = np.array([float(time) for time in times])
    front, height = np.array([extents(mesh, centres, time) for time in times]).T

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    left.plot(t * np.sqrt(2 * G / WIDTH), front / WIDTH, label="grainInterFoam")
    left.plot(*np.transpose(FRONT), "ko", label="Martin and Moyce")
    left.set(xlabel="t sqrt(2 g/a)", ylabel="front/a")
    left.legend()
    right.plot(t * np.sqrt(G / WIDTH), height / (2 * WIDTH))
    right.plot(*np.transpose(HEIGHT), "ko")
    right.set(xlabel="t sqrt(g/a)", ylabel="height/(2 a)", xlim=(0, t[-1] * np.sqrt(G / WIDTH)))
    figure.savefig("snapshots/front.png", dpi=110)

    at = np.array(FRONT)
    at = at[at[:, 0] < t[-1] * np.sqrt(2 * G / WIDTH)]
    if len(at):
        ours = np.interp(at[:, 0], t * np.sqrt(2 * G / WIDTH), front / WIDTH)
        print("front less measured, over the width:", (ours - at[:, 1]).round(2))

    shown = [time for time in SHOWN if time in times] or times[-1:]
    figure, rows = plt.subplots(
        len(shown), 1, figsize=(7, 3.2 * len(shown)), layout="constrained", squeeze=False
    )
    for ax, time in zip(rows[:, 0], shown, strict=True):
        alpha = grainplot.read_field(".", time, "alpha.water", len(mesh.polygons))
        grainplot.draw_cells(ax, mesh, alpha, lines=False, cmap="Blues", clim=(0, 1))
        ax.set(title=f"t = {time} s", aspect="equal")
    figure.savefig("snapshots/water.png", dpi=110)


if __name__ == "__main__":
    main()
