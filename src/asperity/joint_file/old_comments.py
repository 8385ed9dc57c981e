"""Comments of a joint file that are no longer true after some of its numbers have been replaced."""

from __future__ import annotations

import re
from collections.abc import Sequence

#: A key and its value behind the sign of a comment: what the file could say, not what it says.
_LEFT_OUT = re.compile(r"\s*#\s*[\w.\"-]+\s*=\s")


def without_old_comments(text: str, before: str) -> str:
    r"""The text of a joint file without the comments that its new numbers have made false.

    Of a line that is not one of the text ``before``, a comment with a number in it; of lines that are comments, the
    sentences that state a quantity of the text before which the new one has replaced, as far as they have lines of
    their own. Keys that are commented out stay.

    Examples
    --------
    >>> print(without_old_comments('# 8 mm thick\na = "9 mm"  # at least 7', '# 8 mm thick\na = "8 mm"  # at least 7'))
    a = "9 mm"
    """
    lines, known = text.splitlines(), before.splitlines()
    gone = _stated([line for line in known if line not in set(lines)])
    false = _stating(gone - _stated([line for line in lines if line not in set(known)]))
    kept: list[str] = []
    sentence: list[str] = []  # the lines of a sentence that has not ended
    for line in [*lines, ""]:
        place = comment_start(line)
        is_comment = place < len(line) and not line[:place].strip() and not _LEFT_OUT.match(line)
        if sentence and not is_comment:
            kept += _unless(false, sentence)
            sentence = []
        if is_comment:
            sentence.append(line)
            if line.rstrip().endswith((".", ":")):
                kept += _unless(false, sentence)
                sentence = []
        elif line not in set(known) and re.search(r"\d", line[place:]):
            kept.append(line[:place].rstrip())
        else:
            kept.append(line)
    return "\n".join(kept[:-1]) + "\n" * text.endswith("\n")


def _unless(false: re.Pattern[str] | None, sentence: list[str]) -> list[str]:
    """The lines of a sentence; none where it states what is not true."""
    return [] if false is not None and any(map(false.search, sentence)) else sentence


def comment_start(line: str) -> int:
    """Where the comment of a line begins, behind all texts in quotes; its end where it has none."""
    quote = ""
    for place, sign in enumerate(line):
        if quote:
            quote = "" if sign == quote else quote
        elif sign in "\"'":
            quote = sign
        elif sign == "#":
            return place
    return len(line)


def _stated(lines: Sequence[str]) -> set[str]:
    """The quantities that lines state, without their tolerances: texts in quotes, and numbers behind a key."""
    values = [line[: comment_start(line)] for line in lines]
    texts = [text for value in values for text in re.findall(r"""["']([^"']+)["']""", value)]
    numbers = [number for value in values for number in re.findall(r"=\s*([-+\d.eE]+)\s*(?:,|\}|$)", value)]
    return {text.split("+-")[0].strip() for text in (*texts, *numbers)}


def _stating(quantities: set[str]) -> re.Pattern[str] | None:
    """What finds these quantities in a comment, however their unit is set off; None without any."""
    found = []
    for text in sorted(quantities):
        number, _, unit = text.partition(" ")
        if re.search(r"\d", number) and (
            unit or "." in number
        ):  # a bare whole number says nothing about which it is
            found.append(rf"{re.escape(number)}\s*{re.escape(unit)}")
    return re.compile(rf"(?<![\w.])(?:{'|'.join(found)})(?![\w.]*\w)") if found else None
