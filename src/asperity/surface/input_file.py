"""Input files: regular files of a bounded size, and lengths with their units."""

from __future__ import annotations

from pathlib import Path

from asperity.errors import InputError
from asperity.units import Dimension, parse_quantity

#: Bytes of a mebibyte.
MEBIBYTE = 1024**2
#: Larger heights overflow in powers [m].
LARGEST_SPAN = 1e50


def checked_file(*, path: str | Path, largest: int) -> Path:
    """The path, if it is a regular file that is not empty and not larger than a limit [bytes].

    Raises
    ------
    InputError
        If there is no such file, it is a folder, a pipe or a device, it is empty or too large.
    """
    file = Path(path)
    try:
        if file.is_dir():
            raise InputError(f"{path} is a folder; give the name of a file")
        if not file.exists():
            raise InputError(f"there is no file {path}")
        if not file.is_file():
            raise InputError(f"{path} is a pipe or a device; give the name of a regular file")
        size = file.stat().st_size
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{path} cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if size == 0:
        raise InputError(f"{path} is empty")
    if size > largest:
        raise InputError(
            f"{path} has {size / MEBIBYTE:.4g} MiB; the largest file of this kind that is read has "
            f"{largest / MEBIBYTE:.4g} MiB"
        )
    return file


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
        raise InputError(f"{path} cannot be read: {error.strerror or error}") from None


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
