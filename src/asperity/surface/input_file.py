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
    """Metres in one unit of length.

    Raises
    ------
    InputError
        If this is not a unit of length.

    Examples
    --------
    >>> metres_per_unit("um")
    1e-06
    """
    return parse_quantity(f"1 {unit.strip()}", Dimension.LENGTH)
