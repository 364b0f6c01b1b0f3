# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The droplets on the bed and their vapour, their histories, and the books of water and heat."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

BED = 0.005  # height of the bed [m]
HOT = 250.0  # of the bed [degrees C]
DENSITY, LATENT = 998.0, 2.4e6  # of water [kg/m^3], [J/kg]


def histories(books):
    figure, axes = plt.subplots(2, 2, figsize=(9, 6), sharex=True, layout="constrained")
    (height, temperature), (liquid, inside) = axes
    for number in np.unique(books["droplet"]):
        of = grainplot.of_droplet(books, number)
        height.plot(of["time"], (of["y"] - of["radius"] - BED) * 1e3)
        temperature.plot(of["time"], of["temperature"] - 273.15)
        liquid.plot(of["time"], of["liquid"] * 1e6)
        inside.plot(of["time"], of["inside"] * 1e9)
    height.axhline(0, color="0.6", linewidth=0.8)
    height.set(ylabel="lowest point above the bed [mm]")
    temperature.set(ylabel="temperature [C]")
    liquid.set(ylabel="liquid [mg]")
    inside.set(ylabel="grains inside [mm3]")
    for ax in axes[1]:
        ax.set(xlabel="time [s]")
    figure.savefig("snapshots/history.png", dpi=110)
    plt.close(figure)


def report(books):
    """Water that came less what is left and what became vapour; and the heat's books."""
    firsts = {n: grainplot.of_droplet(books, n) for n in np.unique(books["droplet"])}
    came = sum(of["liquid"][0] + of["vapour"][0] for of in firsts.values())
    last = books["time"] == books["time"].max()
    left, vapour = books["liquid"][last].sum(), books["vapour"].sum()
    heat = np.genfromtxt(
        "postProcessing/heatLedger/0/heatLedger.csv", delimiter=",", names=True
    )
    print(f"{len(firsts)} droplets came, {last.sum()} are left")
    print(f"water {came:.6g} kg, {vapour / came:.2%} vapour,", end=" ")
    print(f"unaccounted for {abs(came - left - vapour) / came:.1e}")
    for name in ("fluidError", "grainError"):
        print(f"heat, {name}: at most {np.abs(heat[name]).max():.1e}")
    print(f"volume of droplets less liquid and grains: at most {books['volumeError'].max():.1e}")


if __name__ == "__main__":
    Path("snapshots").mkdir(exist_ok=True)
    written = grainplot.times(".")[1:]
    chosen = written[:: max(1, len(written) // 6)][:6]
    sheet = grainplot.droplets(".", chosen, (100, HOT), n_columns=2, height=2.6)
    sheet.savefig("snapshots/spray.png", dpi=110)
    plt.close(sheet)
    table = grainplot.read_droplets(".")
    histories(table)
    report(table)
