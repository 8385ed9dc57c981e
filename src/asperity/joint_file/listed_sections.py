"""Sections of a joint file that are lists, such as ``[[duty]]``: added, left out and put in another order."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import tomlkit

from asperity.errors import InputError
from asperity.reading import parse_toml

_REMARK = re.compile(r"^\s*(#.*)?$")

#: One section: the lines above it that are about it, and those from its header to its last key.
_Section = tuple[list[str], list[str]]


def rearranged(sections: Sequence[Any], places: Sequence[int], *, name: str) -> list[Any]:
    """The sections of a list in another arrangement."""
    for place in places:
        if not 0 <= place <= len(sections):
            raise InputError(f"{name}: the file has no section {place} in [[{name}]]")
    return [sections[place - 1] if place else {} for place in places]


def rearranged_text(text: str, places: Sequence[int], *, name: str) -> str:
    """The text of a joint file with the sections of a list in another arrangement [{…}]."""
    tables = parse_toml(text, source="the joint file")
    wanted = rearranged(tables.get(name, []), places, name=name)
    if wanted == tables.get(name, []):
        return text
    expected = {key: value for key, value in tables.items() if key != name} | (
        {name: wanted} if wanted else {}
    )
    edited = _edited(text, places, name)
    try:
        found = parse_toml(edited, source="the joint file")
    except InputError:
        found = {}
    return edited if found == expected else tomlkit.dumps(expected)


def _edited(text: str, places: Sequence[int], name: str) -> str:
    """The text with whole lines moved, which is right where every section has a header of its own."""
    lines = [line if line.endswith("\n") else f"{line}\n" for line in text.splitlines(keepends=True)]
    header = re.compile(rf"^\s*\[\[\s*{re.escape(name)}\s*\]\]")
    ends = re.compile(rf"^\s*\[(?!\s*{re.escape(name)}\s*\.)")  # not at a table inside the section
    begins = [index for index, line in enumerate(lines) if header.match(line)]
    sections: list[_Section] = []
    first = last = len(lines)
    for begin in begins:
        end = next((i for i in range(begin + 1, len(lines)) if ends.match(lines[i])), len(lines))
        while _REMARK.match(lines[end - 1]):  # what stands above the next section
            end -= 1
        above = begin
        while above > 0 and lines[above - 1].lstrip().startswith("#"):
            above -= 1
        if sections:  # remarks below a section, with an empty line behind them, are its own
            sections[-1][1].extend("".join(lines[last:above]).rstrip("\n").splitlines(keepends=True))
            if not sections[-1][1][-1].endswith("\n"):
                sections[-1][1][-1] += "\n"
        else:
            first = above
        sections.append((lines[above:begin], lines[begin:end]))
        last = end
    new: _Section = ([], [f"[[{name}]]\n"])
    chosen = [sections[place - 1] if place else new for place in places if place <= len(sections)]
    made = "\n".join("".join([*above, *body]) for above, body in chosen)
    before, after = "".join(lines[:first]), "".join(lines[last:])
    if not made:
        after = after.lstrip("\n")
    elif before and not before.endswith("\n\n"):
        before += "\n"
    return before + made + after
