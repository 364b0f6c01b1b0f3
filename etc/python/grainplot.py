# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Read and draw two-dimensional cases: cells, fields and grains.

    import grainplot

    figure = grainplot.columns("caseDirectory", ["0", "0.5", "1"], field="U")
    figure.savefig("velocity.png")

A case is two-dimensional if its mesh is one cell thick between patches of type empty.  Lengths
are in m; times are the names of the time directories.
"""

import gzip
import re
from dataclasses import dataclass
from pathlib import Path

import foamlib
import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection  # noqa: E402


@dataclass
class PlanarMesh:
    """Cells as polygons: `polygons[c]` is (n, 2); `axes` are the two in-plane axes, 0 = x."""

    polygons: list
    axes: tuple

    @property
    def bounds(self):
        """Lower left and upper right corner, (2, 2)."""
        vertices = np.concatenate(self.polygons)
        return np.array([vertices.min(axis=0), vertices.max(axis=0)])

    @property
    def areas(self):
        """Areas of the cells [m^2], (n_cells,)."""
        return np.array([abs(_signed_area(polygon)) for polygon in self.polygons])


def _signed_area(polygon):
    x, y = polygon.T
    return 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


def _standalone(path):
    """The list that a file of constant/polyMesh holds, compressed or not."""
    return foamlib.FoamFile(path if path.exists() else path.with_name(path.name + ".gz"))[()]


def times(case):
    """Names of the time directories in ascending order."""
    number = re.compile(r"[0-9.]+(e[-+]?[0-9]+)?")
    folders = (path.name for path in Path(case).iterdir() if path.is_dir())
    return sorted(filter(number.fullmatch, folders), key=float)


def _mesh_file(case, name, time):
    """What <time>/polyMesh holds, or the last time before it or constant."""
    before = [t for t in times(case) if time is not None and float(t) <= float(time)]
    for folder in [*reversed(before), "constant"]:
        path = Path(case) / folder / "polyMesh" / name
        if path.exists() or path.with_name(f"{name}.gz").exists():
            break
    return _standalone(path)


def read_mesh(case, time=None):
    """PlanarMesh of a time, or of constant/polyMesh; ValueError if no patch is of type empty."""
    points = np.asarray(_mesh_file(case, "points", time))
    faces = _mesh_file(case, "faces", time)
    if isinstance(faces, tuple):  # binary: where each face begins, and the vertices of all
        start, vertices = faces
        faces = np.split(vertices, start[1:-1])
    owner = np.asarray(_mesh_file(case, "owner", time))

    empty_faces = []
    for _, patch in _mesh_file(case, "boundary", time):
        if patch["type"] == "empty":
            empty_faces += range(patch["startFace"], patch["startFace"] + patch["nFaces"])
    if not empty_faces:
        raise ValueError(f"{case}: no patch of type empty, the mesh is not two-dimensional")

    across = _thin_axis(points[faces[empty_faces[0]]])
    axes = tuple(axis for axis in range(3) if axis != across)
    # Of the two empty faces of a cell that whose normal points along the axis
    sense = -1 if across == 1 else 1
    polygons = [None] * (owner.max() + 1)
    for face in empty_faces:
        polygon = points[faces[face]][:, axes]
        if sense * _signed_area(polygon) > 0:
            polygons[owner[face]] = polygon
    return PlanarMesh(polygons, axes)


def _thin_axis(vertices):
    """The axis along which the normal of a face is longest."""
    first = vertices[0]
    normal = np.sum(np.cross(vertices[1:-1] - first, vertices[2:] - first), axis=0)
    return int(np.argmax(np.abs(normal)))


def read_field(case, time, name, n_cells=None):
    """Internal values of a volume field, (n_cells,) or (n_cells, 3); n_cells expands a uniform."""
    path = Path(case) / str(time) / name
    if not path.exists():
        path = path.with_name(name + ".gz")
    file = foamlib.FoamFile.loads(_without_conditions(path), include_header=True)
    values = np.asarray(file["internalField"], dtype=float)
    components = 1 if "Vector" in file["FoamFile"]["class"] else 0
    if values.ndim == components and n_cells is not None:
        values = np.broadcast_to(values, (n_cells, *values.shape))
    return values


def _without_conditions(path):
    """What a field's file has before its patches, whose tables foamlib reads in a time that goes
    with the square of their length."""
    content = (gzip.open if path.suffix == ".gz" else open)(path, "rb").read()
    end = content.rfind(b"boundaryField")
    return content if end < 0 else content[:end]


def read_grains(case, time):
    """Data sets of <time>/grains.h5 by name: id, radius (n,), position, velocity (n, 2)."""
    with h5py.File(Path(case) / str(time) / "grains.h5") as file:
        return {name: item[()] for name, item in file.items() if isinstance(item, h5py.Dataset)}


def read_members(case, time):
    """Discs that the grains of <time>/grains.h5 consist of, members of a cluster or the grain:
    position (n, 2), radius (n,), grain: index of the grain (n,)."""
    grains = read_grains(case, time)
    with h5py.File(Path(case) / str(time) / "grains.h5") as file:
        count, centre, radius = (file[f"clusters/{k}"][()] for k in ("members", "centre", "radius"))
    # A single disc, shape -1, is the last one
    first = np.append(np.cumsum(count) - count.ravel(), len(radius))
    count = np.append(count, 1)
    centre, radius = np.append(centre, [[0, 0]], axis=0), np.append(radius, 1.0)

    n = count[grains["shape"]]
    grain = np.repeat(np.arange(len(n)), n)
    within = np.arange(len(grain)) - np.repeat(np.cumsum(n) - n, n)
    member = first[grains["shape"]][grain] + within
    size, angle = grains["radius"][grain], grains["orientation"].ravel()[grain]
    x, y = size * centre[member].T
    turned = np.column_stack(
        [np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y]
    )
    position = grains["position"][grain] + turned
    return {"position": position, "radius": size * radius[member], "grain": grain}


def read_contacts(case, name, time, value="normal"):
    """Lines [(n, 2), ...] and a value of each that a function object contactNetwork wrote:
    normal [N], heatFlow [W], gap [m], first or second (ids)."""
    text = (Path(case) / "postProcessing" / name / f"contacts_{time}.vtk").read_text()
    words = text.split()
    axes = read_mesh(case).axes

    def numbers(keyword, skip, count):
        start = words.index(keyword) + skip
        return np.array(words[start : start + count], dtype=float)

    n_points = int(words[words.index("POINTS") + 1])
    n_lines, n_words = (int(word) for word in numbers("LINES", 1, 2))
    points = numbers("POINTS", 3, 3 * n_points).reshape(-1, 3)[:, axes]
    indices = numbers("LINES", 3, n_words).astype(int)
    lines = []
    while len(indices):
        lines.append(points[indices[1 : 1 + indices[0]]])
        indices = indices[1 + indices[0] :]
    # "SCALARS normal double 1 LOOKUP_TABLE default", then the values
    return lines, numbers(value, 5, n_lines)


def draw_contacts(ax, lines, widths, scale=4.0, **style):
    """Contacts as lines; one of width 1 is drawn `scale` points wide."""
    style = {"colors": "darkred", "capstyle": "round"} | style
    collection = LineCollection(lines, linewidths=scale * np.asarray(widths), **style)
    ax.add_collection(collection)
    return collection


def magnitude(values):
    """Values (n,), lengths of vectors (n, d)."""
    return values if values.ndim == 1 else np.linalg.norm(values, axis=1)


def draw_cells(ax, mesh, values=None, lines=True, **style):
    """Cells in colours of `values`, one per cell, with thin grey lines; returns the collection."""
    style = {"cmap": "Blues", "edgecolors": "0.8" if lines else "face", "linewidths": 0.2} | style
    cells = PolyCollection(mesh.polygons, **style)
    if values is None:
        cells.set_facecolor("none")
    else:
        cells.set_array(np.asarray(values))
    ax.add_collection(cells)
    ax.set_xlim(mesh.bounds[:, 0])
    ax.set_ylim(mesh.bounds[:, 1])
    ax.set_aspect("equal")
    return cells


def draw_grains(ax, grains, values=None, **style):
    """Grains as discs in colours of `values`, one per grain; returns the collection."""
    diameter = 2 * grains["radius"]
    style = {"cmap": "viridis", "edgecolors": "black", "linewidths": 0.2} | style
    discs = EllipseCollection(
        diameter,
        diameter,
        np.zeros_like(diameter),
        units="xy",
        offsets=grains["position"],
        offset_transform=ax.transData,
        **style,
    )
    if values is None:
        discs.set_facecolor(style.get("facecolors", "0.5"))
    else:
        discs.set_array(np.asarray(values))
    ax.add_collection(discs)
    ax.set_aspect("equal")
    return discs


def _limits(lists):
    values = [np.asarray(v) for v in lists if v is not None and len(v)]
    if not values:
        return 0.0, 1.0
    low, high = min(v.min() for v in values), max(v.max() for v in values)
    return (low, high) if high > low else (low, low + 1.0)


def columns(case, at, field=None, grain_value="velocity", lines=True, height=4.0):
    """Figure with a column for each time in `at`: cells coloured by `field`, grains by a value.

    Vectors are shown by their magnitude; None leaves the colours out.  All columns share the colour
    scales; `height` of the axes, in inches, is less if a column would be wider than 6 inches.
    """
    mesh = read_mesh(case)
    n = len(mesh.polygons)
    cells = [magnitude(read_field(case, t, field, n)) if field else None for t in at]
    has_grains = [(Path(case) / str(t) / "grains.h5").exists() for t in at]
    clouds = [read_grains(case, t) if h else None for t, h in zip(at, has_grains, strict=True)]
    speeds = [magnitude(c[grain_value]) if c is not None and grain_value else None for c in clouds]

    width, tall = mesh.bounds[1] - mesh.bounds[0]
    column = min(max(height * width / tall, 1.2), 6.0)
    size = (column * len(at) + 1.6, column * tall / width + 0.8)
    figure, row = plt.subplots(
        1, len(at), squeeze=False, sharey=True, layout="constrained", figsize=size
    )
    discs = None
    for ax, time, values, cloud, speed in zip(row[0], at, cells, clouds, speeds, strict=True):
        shown = draw_cells(ax, mesh, values, lines, clim=_limits(cells))
        if cloud is not None:
            discs = draw_grains(ax, cloud, speed, clim=_limits(speeds))
        ax.set_title(f"t = {time} s")
        ax.set_xlabel(f"{'xyz'[mesh.axes[0]]} [m]")
    row[0][0].set_ylabel(f"{'xyz'[mesh.axes[1]]} [m]")
    if field:
        figure.colorbar(shown, ax=list(row[0]), label=field, shrink=0.8)
    if discs is not None and grain_value:
        figure.colorbar(discs, ax=list(row[0]), label=f"grain {grain_value}", shrink=0.8)
    return figure


def read_droplets(case):
    """Columns of the droplets' books by name, all starts one after the other: see dropletLedger."""
    folder = Path(case) / "postProcessing/droplets"
    starts = sorted((p for p in folder.iterdir()), key=lambda path: float(path.name))
    books = [
        np.atleast_1d(np.genfromtxt(start / "droplets.csv", delimiter=",", names=True))
        for start in starts
    ]
    return {name: np.concatenate([book[name] for book in books]) for name in books[0].dtype.names}


def of_droplet(books, number):
    """Rows of the books of one droplet."""
    rows = books["droplet"] == number
    return {name: values[rows] for name, values in books.items()}


def draw_droplets(ax, books, time, **style):
    """Droplets of the books at the time nearest to one, as discs; returns the collection."""
    now = np.abs(books["time"] - float(time))
    rows = np.flatnonzero(now < now.min() + 1e-9)
    rows = rows if now.min() < 0.05 * max(float(time), 1e-3) else rows[:0]
    discs = {
        "radius": books["radius"][rows],
        "position": np.column_stack([books["x"][rows], books["y"][rows]]),
    }
    style = {"facecolors": "tab:blue", "alpha": 0.5, "edgecolors": "none"} | style
    return draw_grains(ax, discs, **style)


def droplets(case, at, temperatures, n_columns=None, height=6.4):
    """Figure with a picture for each time in `at`: vapour grey, grains by their temperature [C]
    between two limits, droplets blue; `height` of a picture in inches."""
    mesh = read_mesh(case)
    books = read_droplets(case)
    n_columns = n_columns or len(at)
    width, tall = mesh.bounds[1] - mesh.bounds[0]
    n_rows = -(-len(at) // n_columns)
    figure, axes = plt.subplots(
        n_rows,
        n_columns,
        squeeze=False,
        sharex=True,
        sharey=True,
        layout="constrained",
        figsize=(height * width / tall * n_columns + 1.2, (height + 0.4) * n_rows),
    )
    for ax in axes.ravel()[len(at) :]:
        ax.set_axis_off()
    for ax, time in zip(axes.ravel(), at, strict=False):
        mesh = read_mesh(case, time)
        psi = read_field(case, time, "psi", len(mesh.polygons))
        draw_cells(ax, mesh, psi, lines=False, cmap="Greys", clim=(0, 1.5))
        grains = read_grains(case, time)
        drawn = draw_grains(
            ax,
            grains,
            grains["temperature"].ravel() - 273.15,
            clim=temperatures,
            cmap="inferno",
            linewidths=0,
        )
        draw_droplets(ax, books, time)
        ax.set_title(f"t = {time} s")
    figure.colorbar(drawn, ax=axes, label="temperature of the grains [C]", shrink=0.6)
    return figure
