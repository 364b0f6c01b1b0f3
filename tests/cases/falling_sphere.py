# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere that falls through air into a liquid, in a box with frictionless sides.

    case = falling_sphere(clone, cell=1, width=8)
    case.run("grainInterFoam")
    before, after = speeds_over_law(case, cell=1, width=8)

Lengths are in diameters.  Cells of four and more in a diameter are of one size around the sphere
and stretched beyond.  In the liquid the law's terminal speed has the Reynolds number 10, or
another.  Such spheres have no law; theirs is the standard curve, as Schiller and Naumann's drag is
2.5 % below it at 10 (and 3.6 % below that of a sphere computed on a mesh fitted to it, 4.306).
"""

import math
from dataclasses import dataclass

import numpy as np
from grain_box import control, replace
from settling_box import DRAG, speed_in_box
from sphere_box import sphere_box
from water_box import to_two_fluids

LAW = "SchillerNaumann"
D, G, SPHERE = 1e-3, 9.81, 2000.0  # [m], [m/s^2], [kg/m^3]
RATIO = 5  # of stretched cells, the last over the first
START_IN_CELL = 0.13, 0.31
GRAINS = "constant/grainProperties"
HEADER = "FoamFile { version 2.0; format ascii; class volScalarField; object alpha.water; }\n"


@dataclass
class Fluid:
    """Density [kg/m^3] and viscosity [m^2/s]."""

    rho: float
    nu: float

    def acceleration(self, speed, width, law=LAW):
        """Of the sphere by the law, in the flow that it makes in its box [m/s^2]."""
        Re = max(speed * D / self.nu, 1e-6)
        slip = speed / speed_in_box(Re, width, DRAG[law](Re))
        drag = 18 * self.rho * self.nu * DRAG[law](slip * D / self.nu) * slip / D**2
        return G * (1 - self.rho / SPHERE) - drag / SPHERE

    def terminal(self, width, law=LAW):
        """[m/s]"""
        low, high = 0.0, 400 * self.nu / D
        for _ in range(60):
            mid = (low + high) / 2
            low, high = (mid, high) if self.acceleration(mid, width, law) > 0 else (low, mid)
        return low


AIR = Fluid(1.0, 1.5e-5)


def liquid(Re):
    """In which the law's terminal speed has a Reynolds number."""
    return Fluid(1000.0, math.sqrt(G * D**3 * (SPHERE / 1000 - 1) / (18 * Re * DRAG[LAW](Re))))


START = math.sqrt(2 * G * D)  # that of a fall of one diameter [m/s]


def law_fall(height, width, n=400):
    """Speed of the law after a fall through the air [m/s]."""
    square = START**2
    for _ in range(n):
        half = square + AIR.acceleration(math.sqrt(square), width) * height * D / n
        square += 2 * AIR.acceleration(math.sqrt(half), width) * height * D / n
    return math.sqrt(square)


@dataclass
class Layout:
    """Of the box; heights over its bottom."""

    cell: float
    width: float

    @property
    def above(self):
        """Fall to the surface."""
        return max(2.5 * self.cell, 3)

    @property
    def last(self):
        """The part of the fall in the liquid that counts: whole cells."""
        return self.cell * math.ceil(3 / self.cell)

    @property
    def below(self):
        """Fall in the liquid."""
        settle = 7 if self.cell > 0.25 else 5
        return max(settle + self.last, 3 * self.cell)

    @property
    def floor(self):
        return self.cell * math.ceil(max(self.width / 2, 4) / self.cell)

    @property
    def surface(self):
        # Within a cell
        return self.cell * (math.ceil((self.floor + self.below) / self.cell) + 0.3)

    @property
    def top(self):
        start = self.surface + self.above
        return self.cell * math.ceil((start + max(self.width / 2, 3)) / self.cell)

    @property
    def n(self):
        return round(self.width / self.cell)

    @property
    def wide(self):
        return self.n * self.cell if self.cell > 0.25 else self.width

    @property
    def lateral(self):
        middle = self.wide / 2
        return list(self.sections(0, middle - 1.2, middle + 1.2, self.wide))

    @property
    def vertical(self):
        start = self.surface + self.above
        return list(self.sections(0, self.floor - 1, start + 1, self.top))

    def sections(self, low, first, last, high):
        """Length, number of cells, last over first cell of the parts of an edge."""
        if self.cell > 0.25:
            yield high - low, round((high - low) / self.cell), 1
            return
        mean = self.cell * (RATIO - 1) / math.log(RATIO)
        yield first - low, round((first - low) / mean), 1 / RATIO
        yield last - first, round((last - first) / self.cell), 1
        yield high - last, round((high - last) / mean), RATIO

    def layers(self):
        """Heights of the faces between layers of cells."""
        faces = [0.0]
        for length, n, ratio in self.vertical:
            sizes = ratio ** (np.arange(n) / max(n - 1, 1))
            faces.extend(faces[-1] + np.cumsum(sizes / sizes.sum() * length))
        return np.array(faces)


def falling_sphere(clone, cell, width, start=START_IN_CELL, Re=10, name=None):
    """The sphere `start` cells beside a corner of cells in the middle of the box."""
    at = Layout(cell, width)
    below = liquid(Re)
    case = sphere_box(clone, name=name or f"cell{cell}")
    mesh(case, at)
    place_sphere(case, at, start)
    replace(case, "0/U", "noSlip", "slip")
    to_two_fluids(case, (below.rho, AIR.rho))
    for old, fluid in (("1e-6", below), ("1.48e-5", AIR)):
        replace(case, "constant/transportProperties", f"nu {old}", f"nu {fluid.nu!r}")
    fill(case, at)

    fastest = law_fall(at.above, width)
    end = D * (2 * at.above / fastest + 1.3 * at.below / below.terminal(width))
    control(case, deltaT=0.01 * cell * D / fastest, endTime=end, writeInterval=100000)
    # Euler's scheme in time adds a viscosity that is at most the liquid's
    longest = 2 / Re * D / below.terminal(width)
    replace(
        case,
        "system/controlDict",
        "runTimeModifiable false;",
        "runTimeModifiable false; adjustTimeStep yes; maxCo 0.5; maxAlphaCo 0.4;\n"
        f"maxGrainCo 0.1; maxGrainDisplacement 0.1; maxDeltaT {longest!r};",
    )
    tracks = case.path / "system/controlDict"
    text = tracks.read_text()
    last = text.rindex("writeInterval")
    tracks.write_text(text[:last] + text[last:].replace("100000", "1", 1))
    solution = case.path / "system/fvSolution"
    solution.write_text(solution.read_text().replace("1e-12", "1e-8"))
    return case


def mesh(case, at):
    words = [
        "(" + " ".join(f"({length!r} {n} {ratio!r})" for length, n, ratio in parts) + ")"
        for parts in (at.lateral, at.lateral, at.vertical)
    ]
    counts = [sum(n for _, n, _ in parts) for parts in (at.lateral, at.lateral, at.vertical)]
    corners = "".join(
        f"({x * at.wide * D!r} {y * at.wide * D!r} {z * float(at.layers()[-1]) * D!r})"
        for z in (0, 1)
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))
    )
    path = case.path / "system/blockMeshDict"
    text = path.read_text().replace("(10 10 10)", "({} {} {})".format(*counts))
    text = text.replace("simpleGrading (1 1 1)", f"simpleGrading ({' '.join(words)})")
    head, rest = text.split("scale", 1)
    path.write_text(f"{head}vertices ({corners});{rest.split(');', 1)[1]}")
    case.run("blockMesh")


def place_sphere(case, at, start):
    middle = at.wide / 2 + (at.cell / 2 if at.cell > 0.25 and at.n % 2 else 0)
    x, y = (middle + s * at.cell for s in start)
    row = [*(D * v for v in (x, y, at.surface + at.above)), D / 2, -START]
    (case.path / "constant/grains.csv").write_text(
        "x,y,z,radius,vz\n" + ",".join(repr(float(v)) for v in row) + "\n"
    )
    replace(case, GRAINS, "density 2500", f"density {SPHERE}")
    law = "type    DallavalleDiFelice;\n        shape   sphere;"
    replace(case, GRAINS, law, f"type    {LAW};")


def fill(case, at):
    """0/alpha.water by layers."""
    z = at.layers()
    n = sum(count for _, count, _ in at.lateral) ** 2
    share = np.clip((at.surface - z[:-1]) / np.diff(z), 0, 1)
    values = "\n".join(repr(float(v)) for v in np.repeat(share, n))
    (case.path / "0/alpha.water").write_text(
        f"{HEADER}dimensions [0 0 0 0 0 0 0];\n"
        f"internalField nonuniform List<scalar> {n * len(share)}\n({values}\n);\n"
        'boundaryField { ".*" { type zeroGradient; } }\n'
    )


def speeds_over_law(case, cell, width, Re=10):
    """Before the sphere comes to the cell of the surface, and at the end of its fall."""
    at = Layout(cell, width)
    track = case.table("postProcessing/tracks/0/grains.csv")
    z, t, v = track["z"] / D, track["time"], -track["vz"]
    height = 0.7 * cell + 0.5
    before = np.interp(-(at.surface + height), -z, v)
    end = -(at.surface - at.below)
    after = at.last * D / (np.interp(end, -z, t) - np.interp(end - at.last, -z, t))
    law = LAW if cell > 0.25 else "standard"
    return before / law_fall(at.above - height, width), after / liquid(Re).terminal(width, law)
