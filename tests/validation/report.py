# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""README.md of a folder of results: a table and a figure per case.

Usage: report.py <folder with name.csv, name.png>
"""

import sys
from pathlib import Path

import grainresults

HEAD = """# Validation

What grainFoam gives against published data and closed forms, written by `tests/validation/run`.
Each case is a folder of `tutorials/grainFoam`, `tutorials/grainThermalFoam` or `tests/validation`,
with its set-up and what the figures show.
"""


def main(folder):
    parts = [HEAD]
    for path in sorted(folder.glob("*.csv")):
        parts.append(f"## {path.stem}\n\n{grainresults.table(path)}\n")
        if path.with_suffix(".png").exists():
            parts.append(f"![{path.stem}]({path.stem}.png)\n")
    (folder / "README.md").write_text("\n".join(parts))


main(Path(sys.argv[1]))
