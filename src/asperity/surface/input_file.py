"""Input files: regular files of a bounded size, and lengths with their units."""

from __future__ import annotations

from pathlib import Path

from asperity.errors import InputError
from asperity.reading import check_regular
from asperity.units import Dimension, parse_quantity

#: Bytes of a mebibyte.
MEBIBYTE = 1024**2
#: Larger heights overflow in powers [m].
LARGEST_SPAN = 1e50


def checked_file(*, path: str | Path, largest: int) -> Path:
    """The path, if it is a regular file that is not empty and not larger than a limit [bytes]."""
    size = check_regular(path)
    if size == 0:
        raise InputError(f"{path} is empty")
    if size > largest:
        raise InputError(
            f"{path} has {size / MEBIBYTE:.4g} MiB; the largest file of this kind that is read has "
            f"{largest / MEBIBYTE:.4g} MiB"
        )
    return Path(path)


def file_bytes(*, path: str | Path, largest: int, first: int = -1) -> bytes:
    """Content of a checked file, or only its first bytes.

    Raises
    ------
    InputError
        As :func:`checked_file`, or if the file cannot be opened.
    """
    file = checked_file(path=path, largest=largest)
    try:
        with file.open("rb") as stream:
            return stream.read(first)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None


def metres_per_unit(unit: str) -> float:
    """Metres in one unit of length, or in one count of stated length.

    Raises
    ------
    InputError
        If this is not a unit of length, or the length is not positive.

    Examples
    --------
    >>> metres_per_unit("um"), metres_per_unit("2.5 um")
    (1e-06, 2.5e-06)
    """
    text = unit.strip()
    length = parse_quantity(text if text[:1] in tuple("+-.0123456789") else f"1 {text}", Dimension.LENGTH)
    if not length > 0.0:
        raise InputError(f"one count is '{text}'; it must be a positive length", options=["height-unit"])
    return length
