# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Are the folders of src in layers?  Called by tests/lint.

A library, src/<library>, includes only libraries before it in LIBRARIES, and lists no other in its
Make/options.  The folders of a library include one another in no circle.  No folder has more than
MOST_FILES files of code.
"""

import re
from collections import Counter
from pathlib import Path

LIBRARIES = (
    "overlap",
    "nscd",
    "grainBase",
    "grainMapping",
    "grainClosures",
    "grains",
    "grainExchange",
    "vans",
    "grainThermal",
    "grainDroplets",
    "dropletMotion",
    "grainFreeSurface",
    "grainRun",
    "functionObjects",
)
# Those that do not see each other, whatever their order
APART = {frozenset({"overlap", "nscd"}), frozenset({"grainMapping", "grainClosures"})}
APART |= {frozenset({name, "grainFreeSurface"}) for name in ("grainThermal", "grainDroplets")}
APART |= {frozenset({"grainClosures", name}) for name in ("overlap", "nscd", "grains")}
MOST_FILES = 30
CODE = {".C", ".H", ".cpp", ".hpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
LIBRARY_OF_OPTION = re.compile(r"-I\.\./(\w+)/lnInclude")


def library(path):
    return path.parts[1]


def folder(path):
    """The second level; files beside the folders are of a folder named ''."""
    return path.parts[2] if len(path.parts) > 3 else ""


def may_see(name, other):
    if name == other:
        return True
    lower = LIBRARIES.index(other) < LIBRARIES.index(name)
    return lower and frozenset({name, other}) not in APART


def includes(root, files):
    """(file, line, file included) of all includes of files of src."""
    named = {path.name: path for path in files if path.suffix == ".H"}
    named |= {str(path.relative_to("src")): path for path in files if path.suffix == ".hpp"}
    for path in files:
        for number, line in enumerate((root / path).read_text().split("\n"), 1):
            match = INCLUDE.match(line)
            if match and match[1] in named:
                yield path, number, named[match[1]]


def circular(edges):
    """The edges from whose end a way leads back to their beginning."""
    after = {}
    for start, end in edges:
        after.setdefault(start, set()).add(end)

    def reached(start):
        found, waiting = set(), [start]
        while waiting:
            new = after.get(waiting.pop(), set()) - found
            found |= new
            waiting += new
        return found

    return {(start, end) for start, end in edges if start in reached(end)}


def check_includes(root, files):
    inner = {}
    for path, number, included in includes(root, files):
        name, other = library(path), library(included)
        if not may_see(name, other):
            yield path, number, f"{name} includes {included.name} of {other}"
        elif name == other and folder(path) != folder(included):
            ends = ((name, folder(path)), (name, folder(included)))
            inner.setdefault(ends, []).append((path, number, included))
    for start, end in sorted(circular(inner)):
        for path, number, included in inner[start, end]:
            yield path, number, f"folders in a circle: {start[1]} includes {end[1]}/{included.name}"


def check_options(root, files):
    for path in files:
        if path.parts[2:] != ("Make", "options"):
            continue
        for number, line in enumerate((root / path).read_text().split("\n"), 1):
            for other in LIBRARY_OF_OPTION.findall(line):
                if other not in LIBRARIES or not may_see(library(path), other):
                    yield path, number, f"{library(path)} is not above {other}"


def check_layers(root, files):
    """(file, line, message) of what is wrong; `files` are relative to `root`."""
    files = [path for path in files if path.parts[0] == "src" and (root / path).is_file()]
    code = [path for path in files if path.suffix in CODE]
    unknown = sorted({library(path) for path in code} - set(LIBRARIES))
    if unknown:
        for name in unknown:
            yield Path("src", name), 1, "is not one of the layers of tests/layers.py"
        return
    for parent, count in sorted(Counter(path.parent for path in code).items()):
        if count > MOST_FILES:
            yield parent, 1, f"{count} files, {MOST_FILES} allowed"
    yield from check_includes(root, code)
    yield from check_options(root, files)
