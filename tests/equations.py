# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the numbers of equations fit?  Called by tests/lint.

The tag of an equation of doc/theory is its number.  It occurs once and begins with the number of
its chapter, which is in the first heading of its file.  What chapters refer to, as (2.7) or
(2.7, 2.9), and what code cites, as "doc/theory, eq. 2.7 to 2.9", is there.
"""

import re
from pathlib import Path

THEORY = Path("doc/theory")
CODE = {".C", ".H", ".cpp", ".hpp", ".py", ".md"}
TAG = re.compile(r"\\tag\{(\d+\.\d+)\}")
HEADING = re.compile(r"# (\d+)\. ")
NUMBER = r"(?:10|[1-9])\.\d+"
NUMBERS = rf"{NUMBER}(?:(?:,| to| and|, and) {NUMBER})*"
REFERENCE = re.compile(rf"\(({NUMBERS})\)")
CITATION = re.compile(rf"doc/theory, eq\. ({NUMBERS})")

# A citation may go on in the next line of a comment
COMMENT = re.compile(r"\n\s*(?:///?-?|#|\*|)[ ]*")


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def tags(root, chapters):
    """(number, file, line, message) of all equations; no message if all is well."""
    seen = {}
    for path in chapters:
        text = (root / path).read_text(encoding="utf-8")
        heading = HEADING.match(text)
        for match in TAG.finditer(text):
            number = match[1]
            message = None
            if number in seen:
                message = f"equation {number} is in {seen[number]}, too"
            elif not heading or number.split(".")[0] != heading[1]:
                message = f"equation {number} is not of this chapter"
            seen.setdefault(number, path.name)
            yield number, path, line_of(text, match.start()), message


def cited(text, pattern):
    """(number, line) of all that is cited."""
    # As long as the text, so that positions hold
    flat = COMMENT.sub(lambda match: " " + "\0" * (len(match[0]) - 1), text)
    places = [position for position, letter in enumerate(flat) if letter != "\0"]
    flat = flat.replace("\0", "")
    for match in pattern.finditer(flat):
        for number in re.findall(r"\d+\.\d+", match[1]):
            yield number, line_of(text, places[match.start()])


def check_equations(root, files):
    """(file, line, message) of what is wrong; `files` are relative to `root`."""
    files = [path for path in files if (root / path).is_file()]
    chapters = [path for path in files if path.parent == THEORY and path.suffix == ".md"]
    known = set()
    for number, path, line, message in tags(root, chapters):
        known.add(number)
        if message:
            yield path, line, message
    for path in files:
        if path.suffix in CODE:
            pattern = REFERENCE if path in chapters else CITATION
            text = (root / path).read_text(encoding="utf-8")
            for number, line in cited(text, pattern):
                if number not in known:
                    yield path, line, f"doc/theory has no equation {number}"
