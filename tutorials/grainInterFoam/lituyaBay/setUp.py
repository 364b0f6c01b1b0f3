# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bay, watched: numbers of the case: setUp.py scale cell end coarser  [-], [m], [s], [-] of the bay

A scale of 1/675 makes the model of Fritz et al. 2001: lengths are divided by 675, times by its
root, speeds too; gravity, densities and the fluids stay.  Grains are coarser by the last factor.
"""

import sys
from pathlib import Path

scale, cell, end, coarser = (float(word) for word in sys.argv[1:])
time = scale**0.5

bay = {
    "scale": scale,
    "depth": 10,
    # Lengths along the ground: 1530 m, 1098 m, 1304 m; 500 m to the sky
    "slope": round(1530 / cell),
    "floor": round(1098 / cell),
    "shore": round(1304 / cell),
    "high": round(500 / cell),
    "slideLength": 970 * scale,
    "slideThickness": 92 * scale,
    # 27 960 discs of three sizes to one in half of that have a mean diameter of 1.25 m
    "minRadius": 0.313 * coarser * scale,
    "maxRadius": 0.939 * coarser * scale,
    # Fewer grains leave wider gaps at the sides
    "solidFraction": 0.846 if coarser == 1 else 0.8,
    "packingRatio": 0.73,
    "tolerance": 2.5e-4 * scale,
    "end": end * time,
    "write": min(2.5, end) * time,
    "first": 1e-3 * time,
    "longest": 0.05 * time,
}
Path("bay").write_text("".join(f"{name} {value:.9g};\n" for name, value in bay.items()))

# The gauge of the experiment, and the far shore every 5 m
points = [(885, 0)] + [(x, x - 1342) for x in range(1347, 2130, 5)]
stations = "\n".join(f"        ({x * scale:.9g} {y * scale:.9g} 0)" for x, y in points)
Path("watched").write_text(
    f"""gauges
{{
    type            liquidGauges;
    libs            ("libgrainFunctionObjects.so");
    writeControl    adjustableRunTime;
    writeInterval   {0.1 * time:.9g};
    stations
    (
{stations}
    );
}}
front
{{
    type            granularFront;
    libs            ("libgrainFunctionObjects.so");
    writeControl    adjustableRunTime;
    writeInterval   {0.1 * time:.9g};
    direction       (1 0 0);
}}
"""
)
