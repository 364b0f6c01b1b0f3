# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Temperatures and heat flows, snapshots/*.png; effective conductivities, conductivity.csv."""

import csv
from dataclasses import dataclass
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

HOT, COLD = 393.0, 293.0
WIDTH, DEPTH = 0.04, 0.01
LEFT = {"Square": 0.0, "Hexagonal": 0.05, "Random": 0.1}
GLASS = (1.4, 6e10, 0.22)  # conductivity [W/m/K], Young's modulus [Pa], Poisson's ratio
COPPER = (400.0, 1.2e11, 0.34)


def conductance(force, radii, second):
    """Of two cylinders of glass, or one and a flat wall of copper (radius inf) [W/K]."""
    modulus = 1 / sum((1 - nu**2) / e for _, e, nu in (GLASS, second))
    effective = 1 / sum(1 / r for r in radii)
    width = np.sqrt(4 * force / DEPTH * effective / (np.pi * modulus))
    spread = [min(radii) if np.isinf(r) else r for r in radii]
    halves = (
        (np.log(2 * r / width) + 1 / 8) / (np.pi * material[0] * DEPTH)
        for r, material in zip(spread, (GLASS, second), strict=True)
    )
    return 1 / sum(halves)


@dataclass
class Network:
    """Contacts of one box: grains of the box by number, -1 the floor, -2 the lid."""

    pairs: list
    conductances: np.ndarray
    heights: np.ndarray
    top: float

    def solved(self):
        """Temperatures and heat flow from the floor [W] in the steady state, by Kirchhoff's law."""
        n = len(self.heights)
        fixed = {-1: HOT, -2: COLD}
        matrix, source = np.zeros((n, n)), np.zeros(n)
        for (i, j), h in zip(self.pairs, self.conductances, strict=True):
            for a, b in ((i, j), (j, i)):
                if a >= 0:
                    matrix[a, a] += h
                    if b >= 0:
                        matrix[a, b] -= h
                    else:
                        source[a] += h * fixed[b]
        # Rattlers touch nothing that conducts
        lone = matrix.diagonal() == 0
        matrix[lone, lone] = 1
        source[lone] = COLD
        temperature = np.linalg.solve(matrix, source)
        flow = sum(
            h * (HOT - temperature[i])
            for (i, j), h in zip(self.pairs, self.conductances, strict=True)
            if j == -1
        )
        return temperature, flow

    def uniform_gradient(self):
        """Heat flow [W] if temperatures were linear in the height: an upper bound."""

        def height(i):
            return {-1: 0.0, -2: self.top}[i] if i < 0 else self.heights[i]

        gradient = (HOT - COLD) / self.top
        squares = [(height(j) - height(i)) ** 2 for i, j in self.pairs]
        return gradient * np.dot(self.conductances, squares) / self.top


def network(name, time, state):
    """The contacts of a box and the conductances that their forces give."""
    inside = np.flatnonzero(np.abs(state["position"][:, 0] - LEFT[name] - WIDTH / 2) < WIDTH / 2)
    number = {state["id"][i]: k for k, i in enumerate(inside)}
    radius, height = state["radius"][inside], state["position"][inside, 1]
    lines, force = grainplot.read_contacts(".", "network", time)
    ends = [grainplot.read_contacts(".", "network", time, v)[1] for v in ("first", "second")]
    pairs, values, tops = [], [], []
    for line, f, i, j in zip(lines, force, *ends, strict=True):
        if i not in number:
            continue
        i = number[i]
        if j >= 0:
            j = number[j]
            values.append(conductance(f, (radius[i], radius[j]), GLASS))
        elif not is_upright(line):
            continue  # the adiabatic sides
        else:
            j = -1 if line[-1][1] < line[0][1] else -2
            values.append(conductance(f, (radius[i], np.inf), COPPER))
            tops += [line[-1][1]] if j == -2 else []
        pairs.append((i, int(j)))
    return Network(pairs, np.array(values), height, np.mean(tops)), inside


def snapshot(time):
    state = grainplot.read_grains(".", time)
    lines, flow = grainplot.read_contacts(".", "network", time, "heatFlow")
    figure, axis = plt.subplots(figsize=(15, 6.2), layout="constrained")
    grainplot.draw_cells(axis, grainplot.read_mesh("."), linewidths=0)
    discs = grainplot.draw_grains(
        axis, state, state["temperature"], clim=(COLD, HOT), cmap="inferno", linewidths=0
    )
    grainplot.draw_contacts(axis, lines, np.abs(flow) / scale(), scale=3, colors="deepskyblue")
    for name, left in LEFT.items():
        axis.plot([left, left + WIDTH], [0, 0], color="red", linewidth=3)
        lid = np.mean([line[-1][1] for line in touching_lid(lines, left)])
        axis.plot([left, left + WIDTH], [lid, lid], color="blue", linewidth=3)
        axis.text(left + WIDTH / 2, 0.055, name.lower(), ha="center")
    axis.set_title(f"t = {time} s")
    axis.set_axis_off()
    figure.colorbar(discs, ax=axis, label="T [K]", shrink=0.7)
    figure.savefig(f"snapshots/t_{time}.png", dpi=110)
    plt.close(figure)


def touching_lid(lines, left):
    """Of the contacts that end at a wall, those at the lid of a box."""
    ends = (line for line in lines if len(line) == 2 and left <= line[0][0] <= left + WIDTH)
    return [line for line in ends if line[-1][1] > 0.04 and is_upright(line)]


def is_upright(line):
    return abs(line[-1][1] - line[0][1]) > abs(line[-1][0] - line[0][0])


def scale():
    """The flow drawn 3 points wide [W]: twice the mean at last."""
    last = grainplot.times(".")[-1]
    return 2 * np.abs(grainplot.read_contacts(".", "network", last, "heatFlow")[1]).mean()


def shown(times):
    """At most five times, the later the farther apart."""
    return [times[i - 1] for i in np.unique(np.geomspace(1, len(times), 5).round().astype(int))]


def ledger():
    file = next(Path("postProcessing/ledger").glob("*/ledger.csv"))
    return np.genfromtxt(file, delimiter=",", names=True)


def main():
    times = [time for time in grainplot.times(".") if time != "0"]
    Path("snapshots").mkdir(exist_ok=True)
    for time in shown(times):
        snapshot(time)

    last, book = times[-1], ledger()
    step = book["time"][-1] - book["time"][-2]
    state = grainplot.read_grains(".", last)
    figure, axes = plt.subplots(1, 3, figsize=(13, 5), sharey=True, layout="constrained")
    rows = []
    for axis, name in zip(axes, LEFT, strict=True):
        contacts, inside = network(name, last, state)
        exact, flow = contacts.solved()
        heights = contacts.heights
        order = np.argsort(heights)
        for time in shown(times):
            temperature = grainplot.read_grains(".", time)["temperature"][inside]
            axis.plot(temperature, 1e3 * heights, ".", markersize=3, label=f"t = {time} s")
        axis.plot(exact[order], 1e3 * heights[order], "k", linewidth=0.8, label="Kirchhoff")
        axis.set_title(name.lower())
        axis.set_xlabel("T [K]")
        conductivity = contacts.top / (WIDTH * DEPTH * (HOT - COLD))
        rows.append(
            {
                "network": name,
                "grains": len(inside),
                "contacts per grain": 2 * len(contacts.pairs) / len(inside),
                "from the floor [W/m/K]": conductivity * book[f"heatFrom_hot{name}"][-1] / step,
                "to the lid [W/m/K]": -conductivity * book[f"heatFrom_lid{name}"][-1] / step,
                "Kirchhoff [W/m/K]": conductivity * flow,
                "uniform gradient [W/m/K]": conductivity * contacts.uniform_gradient(),
            }
        )
    axes[0].set_ylabel("y [mm]")
    axes[0].legend()
    figure.savefig("snapshots/profiles.png", dpi=110)

    with open("conductivity.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        for row in rows:
            short = {k: f"{v:.5g}" if isinstance(v, float) else v for k, v in row.items()}
            writer.writerow(short)
            print(short)


main()
