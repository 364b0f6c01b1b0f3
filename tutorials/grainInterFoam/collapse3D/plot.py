# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains and surface of the water, and its level at three stations (snapshots/, results.csv)."""

import base64
from pathlib import Path
from xml.etree import ElementTree

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

PLATFORM, DEPTH, END, THICK = 0.08, 0.08, 1.0, 0.1  # [m]
TYPES = {"Float32": "f4", "Int32": "i4", "Int64": "i8"}
SHOWN = ("0.2", "0.4", "0.7", "1.1")
STATIONS = ("0.45 m", "0.6 m", "0.8 m")


def read_surface(path):
    """Triangles (n, 3, 3) of a surface that OpenFOAM has written as .vtp."""
    piece = ElementTree.parse(path).getroot().find("PolyData/Piece")

    def array(element):
        raw = base64.b64decode("".join(element.text.split()))
        return np.frombuffer(raw[8:], dtype=TYPES[element.get("type")])

    points = array(piece.find("Points/DataArray")).reshape(-1, 3)
    polygons = {e.get("Name"): array(e) for e in piece.find("Polys")}
    parts = np.split(polygons["connectivity"], polygons["offsets"][:-1])
    fans = [(p[0], p[i], p[i + 1]) for p in parts for i in range(1, len(p) - 1)]
    return points[np.array(fans)]


def seen(points):
    """Of points (..., 3) what a look from the front, the side and above sees, (..., 2)."""
    x, y, z = np.moveaxis(np.asarray(points, dtype=float), -1, 0)
    return np.stack([x - 0.5 * z, y - 0.35 * z], axis=-1)


def draw(ax, case, time):
    for begin, end, height in ((0, PLATFORM, DEPTH), (PLATFORM, END, 0)):
        sides = ((begin, 0), (end, 0), (end, THICK), (begin, THICK))
        corners = [(x, height, z) for x, z in sides]
        ax.add_collection(PolyCollection([seen(corners)], facecolor="0.85", edgecolor="0.6"))
    grains = grainplot.read_grains(case, time)
    behind_first = np.argsort(grains["position"][:, 2])
    x, radius = grains["position"][behind_first], grains["radius"][behind_first]
    tint = plt.cm.copper(0.4 + 0.6 * x[:, 2] / THICK)
    discs = {"position": seen(x), "radius": radius}
    grainplot.draw_grains(ax, discs, facecolors=tint, linewidths=0)
    path = Path(case) / "postProcessing/surface" / time / "water.vtp"
    water = PolyCollection(seen(read_surface(path)), facecolor="tab:blue", alpha=0.3, linewidths=0)
    ax.add_collection(water)
    ax.set(xlim=(-0.07, END + 0.01), ylim=(-0.05, 0.36), aspect="equal", title=f"t = {time} s")
    ax.set_axis_off()


def sheet(case):
    written = [t for t in grainplot.times(case) if float(t) > 0]
    shown = [t for t in SHOWN if t in written] or written[-1:]
    figure, axes = plt.subplots(
        len(shown), 1, figsize=(9, 3.4 * len(shown)), layout="constrained", squeeze=False
    )
    for ax, time in zip(axes[:, 0], shown, strict=True):
        draw(ax, case, time)
    figure.savefig(f"snapshots/{case}.png", dpi=100)
    plt.close(figure)


def table(case, file):
    """All starts of the run one after the other."""
    paths = sorted(Path(case).glob(f"postProcessing/{file}"), key=lambda p: float(p.parent.name))
    return np.concatenate(
        [np.atleast_1d(np.genfromtxt(p, delimiter=",", names=True)) for p in paths]
    )


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, ax = plt.subplots(figsize=(7, 4), layout="constrained")
    lines = ["case,station,highest level over depth,at [s]"]
    for case, style in (("refined", "-"), ("fine", ":")):
        if not Path(case).is_dir():
            continue
        levels = table(case, "gauges/*/levels.csv")
        for i, station in enumerate(STATIONS):
            level = levels[f"station{i}"] / DEPTH
            label = station if style == "-" else None
            ax.plot(levels["time"], level, style, color=f"C{i}", label=label)
            k = np.nanargmax(level)
            lines.append(f"{case},{station},{level[k]:.3f},{levels['time'][k]:.2f}")
        front = table(case, "front/*/front.csv")
        fastest = np.nanmax(front["Froude"])
        lines.append(f"{case},front Froude number,{fastest:.2f},")
        sheet(case)
    ax.set(xlabel="t [s]", ylabel="level over depth")
    ax.legend()
    figure.savefig("snapshots/levels.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
