# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""0/U and 0/p_rgh: the Taylor-Green vortices at t = 0.  Usage: initial.py <cells along a side>"""

import sys
from pathlib import Path

import numpy as np

n = int(sys.argv[1])
x, y = np.meshgrid((np.arange(n) + 0.5) / n, (np.arange(n) + 0.5) / n)
k = 2 * np.pi
U = np.stack([np.sin(k * x) * np.cos(k * y), -np.cos(k * x) * np.sin(k * y), 0 * x], axis=-1)
p = 0.25 * (np.cos(2 * k * x) + np.cos(2 * k * y))

FIELD = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       vol{kind}Field;
    object      {name};
}}

dimensions      {dimensions};

internalField   nonuniform List<{type}>
{count}
(
{values}
);

boundaryField
{{
    "left|right|bottom|top"
    {{
        type    cyclic;
    }}
    frontAndBack
    {{
        type    empty;
    }}
}}
"""
Path("0").mkdir()
vectors = "\n".join("({:.15g} {:.15g} {:.15g})".format(*u) for u in U.reshape(-1, 3))
scalars = "\n".join(f"{value:.15g}" for value in p.ravel())
for name, kind, dimensions, values in (
    ("U", "Vector", "[0 1 -1 0 0 0 0]", vectors),
    ("p_rgh", "Scalar", "[1 -1 -2 0 0 0 0]", scalars),
):
    Path("0", name).write_text(
        FIELD.format(
            name=name,
            kind=kind,
            type=kind.lower(),
            dimensions=dimensions,
            count=n * n,
            values=values,
        )
    )
