"""Text in lines that are no wider than a column of a drawing."""

from __future__ import annotations

from asperity.show.sheet_figure import text_width

_INDENT = "   "


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
