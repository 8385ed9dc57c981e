"""What lines around a table state: a key and its value, ``key = value unit``, ``key: value``, ``key,value,unit``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from asperity.text_table.layout import COMMENTS, Line

_NUMBER = r"[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?"
_PAIR = re.compile(r"(?P<key>[^=:：,;\t]*[^\W\d][^=:：,;\t]*?)\s*(?:=|:|：)\s*(?P<value>.*)")
_LIST, _COMMAS = re.compile(r"\s*[;\t]\s*"), re.compile(r"\s*,\s*")
_WORDS = re.compile(rf"(?P<key>[^\W\d]\S*)\s+(?P<value>{_NUMBER})")
_VALUE = re.compile(rf"(?P<number>{_NUMBER})\s*(?P<unit>.*)")
_KEY_UNIT = re.compile(r"[\[(](?:->\s*)?(?P<unit>[^\])]+)[\])]")


@dataclass(frozen=True)
class Entry:
    """A value that a line states: its ``key`` in lower case without signs, the ``text`` of the value, and the line.

    ``number`` and ``unit``: what the text begins with if it is a number, and what follows, or the unit in brackets
    after the key; None and empty otherwise.
    """

    key: str
    text: str
    number: float | None
    unit: str
    line: Line

    def __str__(self) -> str:
        return str(self.line)


def entries(lines: Iterable[Line]) -> tuple[Entry, ...]:
    """The entries of lines, in their order."""
    return tuple(entry for line in lines for entry in _entries_of(line))


def plain_key(text: str) -> str:
    """A key as entries have it: in lower case, with letters and digits only."""
    return re.sub(r"[\W_]", "", text.lower())


def _entries_of(line: Line) -> Iterator[Entry]:
    plain = line.text.strip()
    for sign in COMMENTS:
        plain = plain.removeprefix(sign)
    plain = plain.replace('"', "").strip().strip("'")
    listed = (_LIST if re.search(r"[;\t]", plain) else _COMMAS).split(plain)
    pair = _PAIR.fullmatch(plain)
    if pair is not None and len(pair["key"]) <= 60:
        yield _entry(pair["key"], " ".join(re.split(r"[;\t]", pair["value"])).strip(), line)
    elif len(listed) >= 2 and re.search(r"[^\W\d]", listed[0]) and len(listed[0]) <= 60:
        yield _entry(listed[0], " ".join(filter(None, listed[1:])), line)
    else:
        words = _WORDS.fullmatch(plain)
        if words is not None:
            yield _entry(words["key"], words["value"], line)


def _entry(key: str, text: str, line: Line) -> Entry:
    found = _VALUE.fullmatch(text)
    bracket = _KEY_UNIT.search(key)
    name = plain_key(_KEY_UNIT.sub("", key))
    if found is None:
        return Entry(name, text, None, "", line)
    unit = found["unit"].strip(" []()")
    return Entry(
        name,
        text,
        float(found["number"].replace(",", ".")),
        unit or (bracket["unit"].strip() if bracket else ""),
        line,
    )
