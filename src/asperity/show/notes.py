"""Notes on a sheet: lines of text broken to the width of a column, and spread over columns."""

from __future__ import annotations

from collections.abc import Sequence

from asperity.show.sheet_figure import text_width

#: Between the base lines of two lines of text [mm on paper].
SPACING = 4.4
_INDENT = "   "


def columns_of(lines: Sequence[str], width: float, count: int) -> list[list[str]]:
    """Lines broken to a width [mm on paper] and spread over columns of nearly one length.

    No column begins with an empty line or within a broken one, and none ends with a heading.
    """
    groups = [wrapped(line, width) for line in lines]
    longest = -(-sum(map(len, groups)) // count)
    while True:
        columns: list[list[str]] = [[]]
        for number, group in enumerate(groups):
            heads = bool(number) and groups[number - 1] == [""] and number + 1 < len(groups)
            needed = len(group) + (len(groups[number + 1]) if heads else 0)
            if len(columns[-1]) + needed > longest and columns[-1] and len(columns) <= count:
                columns.append([])
            if columns[-1] or group != [""]:
                columns[-1] += group
        columns = [_without_last_empty(column) for column in columns]
        if len(columns) <= count and max(map(len, columns)) <= longest:
            return columns
        longest += 1


def _without_last_empty(column: list[str]) -> list[str]:
    return column[:-1] if column and not column[-1] else column


def wrapped(text: str, width: float) -> list[str]:
    """Break a line of normal height between words, and within a word that is too long."""
    if text_width(text) <= width:
        return [text]
    cut = _longest(text, width)
    space = text.rfind(" ", 1, cut + 1)
    if space > 0 and text[:space].strip():
        return [text[:space], *wrapped(f"{_INDENT}{text[space:].strip()}", width)]
    joint = text.rfind("_", cut // 2, cut)  # of a name in several words
    cut = cut if joint < 0 else joint + 1
    return [text[:cut], *wrapped(f"{_INDENT}{text[cut:]}", width)]


def _longest(text: str, width: float) -> int:
    """Number of letters of the longest beginning that fits, more than the indent."""
    low, high = len(_INDENT) + 1, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if text_width(text[:middle]) <= width else (low, middle - 1)
    return low
