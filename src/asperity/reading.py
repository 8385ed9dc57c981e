"""Files that are read: regular files of a bounded size, in UTF-8, as text, lines, TOML or JSON.

Every reader of the package opens its files here, so that a pipe, a device, a huge file or a deeply nested one is
refused with one sentence instead of a hang or a traceback.
"""

from __future__ import annotations

import json
import re
import stat
import sys
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TextIO

from asperity.errors import InputError, quoted
from asperity.types import Document

#: Largest file that is read as a whole by default [byte]; files of joints and materials have a few thousand.
LARGEST_FILE = 1_000_000
#: Deepest nesting of tables and lists.
MOST_LEVELS = 32
#: Parts of a dotted key; the time that tomllib takes grows with the square of them.
MOST_KEY_PARTS = 16

_KEY_PART = r"""(?:[A-Za-z0-9_-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')"""
_NEXT_PART = rf"[ \t]*+\.[ \t]*+{_KEY_PART}"
#: What a TOML text consists of: comments and texts as a whole, too long keys, other words. Whatever the text says, each
#: character is looked at a few times at most: a text without an end reaches to the end of its line or of the file.
#: Where tomllib has found an error.
_AT_LINE = re.compile(r" ?\(at line (\d+), column \d+\)$")
_TOKEN = re.compile(
    "|".join(
        (
            r"#[^\n]*+",
            r'"{3}(?:[^\\]|\\.)*?(?:"{3,5}|\Z)',
            r"'{3}.*?(?:'{3,5}|\Z)",
            rf"(?P<long_key>{_KEY_PART}(?:{_NEXT_PART}){{{MOST_KEY_PARTS}}})",
            rf"{_KEY_PART}(?:{_NEXT_PART})*+",
            r'"(?:[^"\\\n]|\\.)*+',
            r"'[^'\n]*+",
        )
    ),
    re.DOTALL,
)


def _refusal(path: str | Path, error: OSError, hint: str = "") -> InputError:
    if isinstance(error, FileNotFoundError):
        return InputError(f"{path}: there is no such file{hint and f'; {hint}'}")
    return InputError(f"{path}: cannot be read: {error.strerror or error}")


def check_regular(path: str | Path, *, hint: str = "") -> int:
    """Size of a file [byte], if it is one that can be read to its end; the hint is what to do if there is none."""
    try:
        status = Path(path).stat()
    except OSError as error:
        raise _refusal(path, error, hint) from None
    except ValueError:  # a null character in the name
        raise InputError(f"{path}: this is not a valid file name") from None
    if stat.S_ISDIR(status.st_mode):
        raise InputError(f"{path}: this is a directory; give the name of a file")
    if not stat.S_ISREG(status.st_mode):
        raise InputError(
            f"{path}: this is a pipe or a device, not a regular file; save the data to a file first"
        )
    return status.st_size


def read_bytes(path: str | Path, *, largest: int = LARGEST_FILE, hint: str = "") -> bytes:
    """The content of a regular file of a largest size [byte]; the hint is what to do if there is none."""
    size = check_regular(path, hint=hint)
    try:
        with open(path, "rb") as stream:
            content = stream.read(largest + 1)
    except OSError as error:
        raise _refusal(path, error, hint) from None
    if len(content) > largest:
        raise InputError(
            f"{path}: this file has {max(size, len(content))} bytes; at most {largest} bytes are read here"
        )
    return content


def read_text(path: str | Path, *, largest: int = LARGEST_FILE, hint: str = "") -> str:
    """Text of a regular file of at most ``largest`` bytes in UTF-8, without a byte order mark.

    An ``InputError`` as by :func:`read_bytes`, with the ``hint`` if there is no such file, or if it is not text in
    UTF-8.
    """
    try:
        return read_bytes(path, largest=largest, hint=hint).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: this is not a text file in UTF-8 (byte {error.start})") from None


@contextmanager
def open_text(path: str | Path) -> Iterator[TextIO]:
    """A regular UTF-8 text file of any size, to be read line by line; line ends are left as they are."""
    check_regular(path)
    try:
        stream = open(path, encoding="utf-8-sig", newline="")  # noqa: SIM115 (an error inside the block is not ours)
    except OSError as error:
        raise _refusal(path, error) from None
    with stream:
        try:
            yield stream
        except UnicodeDecodeError:
            raise InputError(f"{path}: this is not a text file in UTF-8") from None


def parse_toml(text: str, *, source: str) -> Document:
    """Nested tables of a TOML text from a file called ``source``.

    An ``InputError`` if it is not valid TOML, a key has more than :data:`MOST_KEY_PARTS` parts, or it is nested deeper
    than :data:`MOST_LEVELS`.
    """
    for token in _TOKEN.finditer(text):
        if token.lastgroup:
            line = text.count("\n", 0, token.start()) + 1
            raise InputError(f"{source}: line {line}: a key has at most {MOST_KEY_PARTS} parts")
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{source}: not valid TOML: {_explained(str(error), text)}") from None
    except RecursionError:
        raise _too_deep(source) from None
    except ValueError:  # Python refuses to read whole numbers of thousands of digits
        raise InputError(f"{source}: not valid TOML: a number has too many digits") from None
    check_depth(tables, source)
    return tables


def _explained(error: str, text: str) -> str:
    """What is wrong with a TOML text, with the line where it is."""
    at = _AT_LINE.search(error)
    if at is None:
        return error
    number = int(at[1])
    written = quoted(text.split("\n")[number - 1].strip())
    if error.startswith("Cannot overwrite a value"):
        return f"line {number} states a key for the second time: {written}; remove one of both"
    if error.startswith("Cannot declare"):
        return f"line {number} begins a section for the second time: {written}; make one of both"
    return f"{error}: {written}"


def read_toml(path: str | Path, *, largest: int = LARGEST_FILE) -> Document:
    """Nested tables of a TOML file; an ``InputError`` as by :func:`read_text` and :func:`parse_toml`."""
    return parse_toml(read_text(path, largest=largest), source=str(path))


def read_json(path: str | Path, *, largest: int = LARGEST_FILE) -> Any:
    """Document of a JSON file of a largest size [byte] and at most :data:`MOST_LEVELS` levels."""
    text = read_text(path, largest=largest)
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise InputError(f"{path}: not valid JSON: {error}") from None
    except RecursionError:
        raise _too_deep(path) from None
    except ValueError:
        raise InputError(f"{path}: not valid JSON: a number has too many digits") from None
    check_depth(document, path)
    return document


def _too_deep(source: str | Path) -> InputError:
    return InputError(f"{source}: nested too deeply; at most {MOST_LEVELS} levels are read")


def check_depth(document: Any, source: str | Path) -> None:
    """Raise if tables and lists are nested too deeply (:data:`MOST_LEVELS`) for code that walks through them.

    A whole number beyond what a float can hold is refused, too.
    """
    level = [document]
    for left in range(MOST_LEVELS, -1, -1):
        if any(isinstance(node, int) and abs(node) > sys.float_info.max for node in level):
            raise InputError(f"{source}: a whole number has too many digits; at most 308 are read")
        tables = [node for node in level if isinstance(node, dict | list)]
        if tables and not left:
            raise _too_deep(source)
        level = [node for table in tables for node in (table.values() if isinstance(table, dict) else table)]
