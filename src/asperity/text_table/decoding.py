"""Bytes of a text file as text: UTF-8, UTF-16, or Latin-1."""

from __future__ import annotations

import codecs

from asperity.errors import InputError

_UTF_16 = {codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be"}
#: Largest share of control characters among the first bytes of a text.
_MOST_CONTROL = 0.01
#: Characters from which text in UTF-16 is told without its mark.
_FEWEST = 16


def decoded(data: bytes, *, source: str) -> str:
    """The text of a file called ``source``: UTF-16 by its mark, otherwise UTF-8, or Latin-1, which holds any byte.

    An ``InputError`` if the mark of UTF-16 begins what is not UTF-16.
    """
    encoding = _UTF_16.get(data[:2])
    if encoding is not None:
        try:
            return data[2:].decode(encoding)
        except UnicodeDecodeError as error:
            raise InputError(
                f"{source}: begins as text in UTF-16 and is not (byte {2 + error.start}); save it as text in UTF-8"
            ) from None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def looks_like_text(beginning: bytes) -> bool:
    """Whether the first bytes of a file are text: the mark of UTF-16, or no NUL and hardly any control characters."""
    if beginning[:2] in _UTF_16:
        whole = beginning[2 : 2 + (len(beginning) - 2) // 2 * 2]
        return _is_plain(whole.decode(_UTF_16[beginning[:2]], errors="replace"))
    return bool(beginning) and _is_plain(beginning.decode("latin-1"))


def _is_plain(text: str) -> bool:
    """Whether a text has no NUL and hardly any control characters."""
    control = sum(character < "\t" or "\r" < character < " " for character in text)
    return "\0" not in text and control < _MOST_CONTROL * max(1, len(text))


def refuse_unmarked_utf_16(beginning: bytes, *, source: str) -> None:
    """Raise if the first bytes of a file are text in UTF-16 without its mark."""
    even = beginning[: len(beginning) // 2 * 2]
    for encoding in ("utf-16-le", "utf-16-be"):
        text = even.decode(encoding, errors="replace")
        printable = sum(" " <= character <= "~" or character in "\t\r\n" for character in text)
        if len(text) > _FEWEST and printable > (1.0 - _MOST_CONTROL) * len(text):
            raise InputError(
                f"{source}: seems to be text in UTF-16 without its mark; save it as text in UTF-8"
            )
