# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of walls for the cases of tutorials."""

from pathlib import Path


def write_gate(x, bottom, top):
    """constant/triSurface/gate.stl: a rectangle normal to x between two heights, 2 m wide in z.

    All in m; the folder is made if there is none.
    """
    corners = [(x, bottom, -1), (x, top, -1), (x, top, 1), (x, bottom, 1)]
    lines = ["solid gate"]
    for facet in ((0, 1, 2), (0, 2, 3)):
        lines += ["facet normal 1 0 0", "outer loop"]
        lines += ["vertex {:g} {:g} {:g}".format(*corners[i]) for i in facet]
        lines += ["endloop", "endfacet"]
    folder = Path("constant/triSurface")
    folder.mkdir(exist_ok=True)
    (folder / "gate.stl").write_text("\n".join([*lines, "endsolid gate", ""]))
