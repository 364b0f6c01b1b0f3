# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Area of the droplet over time beside the closed form (snapshots/), lives (results.csv)."""

import re
from pathlib import Path

import grainplot
import matplotlib.pyplot as plt
import numpy as np

RADIUS, OUTER = 1e-3, 4e-3  # of the droplet at the start, of the gas [m]
KAPPA, CP = 0.026, 1040.0  # of the gas [W/m/K], [J/kg/K]
DENSITY, LATENT, BOILING = 958.0, 2.26e6, 373.15  # of water [kg/m^3], [J/kg], [K]


def closed_form(gas):
    """Times [s] at which R^2 is y R_0^2, y: quasi-steady Stefan flow in an annulus."""
    rate = 2 * KAPPA / (DENSITY * CP) * np.log1p(CP * (gas - BOILING) / LATENT)

    def integral(area):
        return area * (np.log(OUTER) - 0.5 * np.log(area) + 0.5)

    y = np.linspace(1, 1e-6, 400)
    return y, (integral(RADIUS**2) - integral(y * RADIUS**2)) / rate


def main():
    Path("snapshots").mkdir(exist_ok=True)
    figure, (whole, zoom) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    lines = ["case,life,life of the closed form"]
    for number, case in enumerate(sorted(Path().glob("gas_*"))):
        gas = float(re.search(r"[\d.]+", (case / "parameters").read_text())[0])
        y, time = closed_form(gas)
        table = grainplot.read_droplets(case)
        area = (table["radius"] / RADIUS) ** 2
        for ax in (whole, zoom):
            ax.plot(table["time"] / time[-1], area, color=f"C{number}", label=f"{gas - 273.15:g} C")
            ax.plot(time / time[-1], y, "k:", linewidth=1)
        lines.append(f"{case.name},{table['time'][-1]:.5g},{time[-1]:.5g}")
    whole.set(xlabel="time / life of the closed form (dotted)", ylabel="area / first area")
    zoom.set(xlabel="the end of it", xlim=(0.9, 1.05), ylim=(0, 0.1))
    whole.legend()
    figure.savefig("snapshots/evaporation.png", dpi=110)
    Path("results.csv").write_text("\n".join([*lines, ""]))
    print("\n".join(lines))


main()
