# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The droplets in the hot gas (snapshots/); fall and heat beside laws (results.csv)."""

from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

G, HOT = 9.81, 400.0  # [m/s^2], of the gas [degrees C]
RHO, MU, CP, KAPPA = 1.204, 2e-5, 1040.0, 0.026  # of the gas
LIQUID, LATENT, THICKNESS = 958.0, 2.26e6, 1e-3  # [kg/m^3], [J/kg], of the plane [m]


def drag(speed, d):
    """Of a cylinder [N/m]: White, Viscous fluid flow, 1 < Re < 2e5."""
    Re = RHO * max(speed, 1e-9) * d / MU
    return 0.5 * RHO * speed**2 * d * (1 + 10 * Re ** (-2 / 3))


def heat(speed, d):
    """To a cylinder that evaporates [W/m]: Churchill and Bernstein 1977, ln(1 + B)/B."""
    Re, Pr = RHO * speed * d / MU, MU * CP / KAPPA
    Nu = 0.3 + 0.62 * Re**0.5 * Pr ** (1 / 3) / (1 + (0.4 / Pr) ** (2 / 3)) ** 0.25
    B = CP * (HOT - 100) / LATENT
    return np.pi * KAPPA * Nu * (HOT - 100) * np.log1p(B) / B


def fall(times, d):
    """Speeds [m/s] from rest at these times; added mass is 1e-3 of the droplet's."""
    speeds, mass = [0.0], LIQUID * np.pi * d**2 / 4
    for dt in np.diff(times):
        speeds.append(speeds[-1] + dt * (G - drag(speeds[-1], d) / mass))
    return np.array(speeds)


def sheet(written, table):
    mesh = grainplot.read_mesh(".")
    figure, axes = plt.subplots(
        1, len(written), figsize=(11, 5), layout="constrained", sharey=True, squeeze=False
    )
    for ax, time in zip(axes[0], written, strict=True):
        T = grainplot.read_field(".", time, "T", len(mesh.polygons)) - 273.15
        cells = grainplot.draw_cells(ax, mesh, T, lines=False, cmap="inferno", clim=(100, HOT))
        grainplot.draw_droplets(ax, table, time)
        ax.set(title=f"t = {time} s", aspect="equal")
    figure.colorbar(cells, ax=axes, label="gas [C]", shrink=0.7)
    figure.savefig("snapshots/fall.png", dpi=110)
    plt.close(figure)


def main():
    Path("snapshots").mkdir(exist_ok=True)
    written = grainplot.times(".")[1:]
    table = grainplot.read_droplets(".")
    sheet(written[:6], table)
    lower, upper = (grainplot.of_droplet(table, n) for n in (0, 1))
    # Both become the heavier one
    merged = {name: column[-1] for name, column in table.items()}
    meeting = min(lower["time"][-1], upper["time"][-1])
    upper = {name: column[upper["time"] <= meeting][:-1] for name, column in upper.items()}
    d = 2 * upper["radius"][0]
    law = fall(upper["time"], d)
    warmed = heat(np.maximum(law, 1e-3), d) * THICKNESS
    # Heat is that of a step
    rate = (upper["fromFluid"] + upper["fromGrains"]) / np.gradient(upper["time"])
    fastest = np.argmin(upper["vy"])
    late = upper["time"] > upper["time"][-1] - 0.01
    figure, (speed, flux) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    speed.plot(upper["time"], -upper["vy"])
    speed.plot(upper["time"], law, "k:")
    speed.set(xlabel="time [s]", ylabel="speed of the upper droplet [m/s]")
    flux.plot(upper["time"], 1e3 * rate)
    flux.plot(upper["time"], 1e3 * warmed, "k:")
    flux.set(xlabel="time [s]", ylabel="heat to it [mW]", ylim=(0, None))
    figure.savefig("snapshots/laws.png", dpi=110)

    came = lower["liquid"][0] + lower["vapour"][0] + upper["liquid"][0] + upper["vapour"][0]
    left, vapour = merged["liquid"], table["vapour"].sum()
    lines = [
        "quantity,value,law",
        f"greatest speed [m/s],{-upper['vy'][fastest]:.4f},{law[fastest]:.4f}",
        f"heat, last 10 ms [mW],{1e3 * rate[late].mean():.3g},{1e3 * warmed[late].mean():.3g}",
        f"radius at the end over the first,{2 * merged['radius'] / d:.4f},{2**0.5:.4f}",
        f"water unaccounted for,{abs(came - left - vapour) / came:.1e},0",
    ]
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


main()
