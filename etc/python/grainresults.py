# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of what a case shows and what it should: results.csv.

    from grainresults import Results

    results = Results()
    results.add("terminal velocity", 0.0247, "m/s", 0.02501, "3 %", "Namkoong et al. 2008")
    results.add("mapping error", 3e-15, "-", 1e-12, "<=", "round-off of sums")
    results.add("cells", 115200, "-")
    results.finish()

`finish` writes and prints the table and ends the program, with exit code 1 if a value is not
within its tolerance.
"""

import csv
import math
import sys
from dataclasses import astuple, dataclass, fields
from pathlib import Path


@dataclass
class Result:
    """One line.

    tolerance   "3 %" of the reference, "+-0.1" in its unit, "<=" or ">=" the reference, or
                "" if the value is only reported
    source      of the reference
    """

    quantity: str
    value: float
    unit: str = "-"
    reference: float | None = None
    tolerance: str = ""
    source: str = ""

    @property
    def passes(self):
        if not self.tolerance:
            return True
        if not math.isfinite(self.value):
            return False
        if self.tolerance == "<=":
            return self.value <= self.reference
        if self.tolerance == ">=":
            return self.value >= self.reference
        difference = abs(self.value - self.reference)
        if self.tolerance.startswith("+-"):
            return difference <= float(self.tolerance[2:])
        if self.tolerance.endswith("%"):
            return difference <= float(self.tolerance[:-1]) / 100 * abs(self.reference)
        raise ValueError(f"{self.quantity}: tolerance '{self.tolerance}'")


COLUMNS = [field.name for field in fields(Result)]


class Results(list):
    """The lines of a table."""

    def add(self, *arguments):
        """Append Result(*arguments)."""
        self.append(Result(*arguments))

    def write(self, path):
        with open(path, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            for result in self:
                row = list(astuple(result))
                row[1] = f"{result.value:.6g}"
                row[3] = "" if result.reference is None else f"{result.reference:.6g}"
                writer.writerow(row)

    @classmethod
    def read(cls, path):
        """The table of a file that `write` made."""
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        return cls(
            Result(
                row["quantity"],
                float(row["value"]),
                row["unit"],
                float(row["reference"]) if row["reference"] else None,
                row["tolerance"],
                row["source"],
            )
            for row in rows
        )

    def finish(self, path="results.csv"):
        """Write, print, exit."""
        self.write(path)
        for result in self:
            reference = "" if result.reference is None else f"{result.reference:.6g}"
            verdict = "" if result.passes else "  MISSED"
            print(
                f"{result.quantity:50} {result.value:12.6g} {result.unit:6}"
                f" {reference:>12} {result.tolerance:>7}{verdict}"
            )
        sys.exit(0 if all(result.passes for result in self) else 1)


def table(path):
    """A results file as Markdown."""
    lines = [
        "| quantity | value | unit | reference | tolerance | source | |",
        "|---|---|---|---|---|---|---|",
    ]
    for result in Results.read(Path(path)):
        reference = "" if result.reference is None else f"{result.reference:.4g}"
        verdict = "" if not result.tolerance else "met" if result.passes else "**missed**"
        lines.append(
            f"| {result.quantity} | {result.value:.4g} | {result.unit} | {reference} |"
            f" {result.tolerance} | {result.source} | {verdict} |"
        )
    return "\n".join(lines)
