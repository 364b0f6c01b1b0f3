# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the powders in the blender, snapshots/*.png; how well they are mixed, mixing.csv."""

import csv
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection, PolyCollection
from matplotlib.colors import to_rgb
from shell import facets

PERIOD = 4.0  # of a turn [s]
SAMPLE = 16  # grains
COLOURS = np.array([to_rgb("tab:orange"), to_rgb("tab:blue")])  # coarse, fine


def initial():
    """Grains of the CSV file that the run began with."""
    columns = ("x", "y", "z", "radius", "material")
    data = np.genfromtxt(
        "constant/grains.csv", delimiter=",", names=True, usecols=columns, dtype=None,
        encoding="ascii",
    )
    position = np.column_stack([data[k] for k in "xyz"])
    material = (data["material"] == "fine").astype(int)
    return {"position": position, "radius": data["radius"], "material": material}


def grains(time):
    state = initial() if time == "0" else grainplot.read_grains(".", time)
    return state | {"material": state["material"].ravel()}


def samples(position, members):
    """Groups of neighbours: halves of equal number across the longest side, again and again."""
    if len(members) < 2 * SAMPLE:
        return [members]
    x = position[members]
    axis = np.argmax(np.ptp(x, axis=0))
    order = members[np.argsort(x[:, axis], kind="stable")]
    half = len(order) // 2
    return samples(position, order[:half]) + samples(position, order[half:])


def lacey(state):
    """Lacey's index: 0 where each sample is of one powder, 1 if grains lie as by chance."""
    groups = samples(state["position"], np.arange(len(state["material"])))
    share = np.array([np.mean(state["material"][group]) for group in groups])
    apart = np.mean(state["material"]) * (1 - np.mean(state["material"]))
    chance = apart * np.mean([1 / len(group) for group in groups])
    return (apart - np.var(share)) / (apart - chance)


def crossed(state):
    """Share of the coarse powder that is in the leg of the fine one."""
    return np.mean(state["position"][state["material"] == 0, 0] > 0)


def spheres(axis, position, radius, colours):
    """Circles with a light spot, in the given order."""
    offset = np.stack([position, position + 0.3 * radius[:, np.newaxis] * [-1, 1]], axis=1)
    width = np.stack([2 * radius, 0.7 * radius], axis=1).ravel()
    shades = np.stack([colours, 0.5 + 0.5 * colours], axis=1).reshape(-1, 3)
    edges = np.stack([0.5 * colours, 0.5 + 0.5 * colours], axis=1).reshape(-1, 3)
    collection = EllipseCollection(
        width, width, np.zeros_like(width), units="xy", offsets=offset.reshape(-1, 2),
        offset_transform=axis.transData, facecolors=shades, edgecolors=edges, linewidths=0.2,
    )
    axis.add_collection(collection)


def view(axis, time, along, cut=False):
    """Seen along y from the front (1) or along x from the right (0): the half of the shell that is
    nearer is cut away, if asked for with the grains in it."""
    angle = 2 * np.pi * float(time) / PERIOD
    cos, sin = np.cos(angle), np.sin(angle)
    turned = np.array([[1, 0, 0], [0, cos, -sin], [0, sin, cos]])
    away, across = (1, 0) if along == 1 else (-1, 1)
    shown = [across, 2]

    shell = facets() @ turned.T
    behind = away * shell.mean(axis=1)[:, along] > -1e-9
    style = {"facecolors": "0.94", "edgecolors": "0.75", "linewidths": 0.3}
    axis.add_collection(PolyCollection(shell[behind][:, :, shown], **style))

    state = grains(time)
    depth = away * state["position"][:, along]
    order = np.argsort(-depth)
    if cut:
        order = order[depth[order] > 0]
    colours = COLOURS[state["material"][order]]
    spheres(axis, state["position"][order][:, shown], state["radius"][order], colours)
    axis.set(xlim=(-0.09, 0.09), ylim=(-0.09, 0.09), aspect="equal", xticks=[], yticks=[])
    axis.set_title(f"t = {time} s")


def blending(times):
    """From the front, the same cut in the middle, and cut between the legs from the right."""
    figure, axes = plt.subplots(3, len(times), figsize=(3 * len(times), 9.6), layout="compressed")
    for time, (front, middle, side) in zip(times, axes.T, strict=True):
        view(front, time, along=1)
        view(middle, time, along=1, cut=True)
        view(side, time, along=0, cut=True)
    for axis, label in zip(axes[:, 0], ("front", "front, cut", "side, cut"), strict=True):
        axis.set_ylabel(label)
    figure.savefig("snapshots/blending.png", dpi=110)


def turn(times):
    """Eighths of the last revolution, cut between the legs, from the right."""
    figure, axes = plt.subplots(2, 4, figsize=(12, 6.4), layout="compressed")
    for axis, time in zip(axes.flat, times[-9:-1], strict=False):
        view(axis, time, along=0, cut=True)
    figure.savefig("snapshots/turn.png", dpi=110)


def index(turns, mixed, share):
    figure, axis = plt.subplots(figsize=(7, 4), layout="constrained")
    axis.plot(turns, mixed, label="Lacey's index")
    axis.plot(turns, share, label="coarse powder in the other leg")
    axis.axhline(0.5, color="0.7", linewidth=0.8)
    axis.set(xlabel="revolutions", ylim=(0, 1))
    axis.legend()
    figure.savefig("snapshots/mixing.png", dpi=110)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    times = ["0", *(time for time in grainplot.times(".") if time != "0")]
    wanted = [0, PERIOD, 3 * PERIOD, 10 * PERIOD]
    seconds = np.array([float(time) for time in times])
    blending([times[np.argmin(abs(seconds - time))] for time in wanted])
    turn(times)

    states = [grains(time) for time in times]
    mixed, share = [lacey(state) for state in states], [crossed(state) for state in states]
    index(seconds / PERIOD, mixed, share)
    with open("mixing.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time", "lacey", "crossed"])
        for row in zip(times, mixed, share, strict=True):
            writer.writerow([row[0], f"{row[1]:.4f}", f"{row[2]:.4f}"])
    print(f"Lacey's index {mixed[0]:.2f} at the start, {mixed[-1]:.2f} at t = {times[-1]} s")


main()
