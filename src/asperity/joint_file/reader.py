"""From a TOML file to a checked :class:`asperity.joint_file.model.Case`."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from asperity.errors import InputError
from asperity.joint_file.messages import explain
from asperity.joint_file.model import Case
from asperity.library import with_library_materials

#: A joint file is a page; anything larger is some other file.
LARGEST_FILE = 1_000_000


def read_case(path: str | Path) -> Case:
    """Read a joint file.

    Parameters
    ----------
    path : str or Path
        A TOML file.

    Returns
    -------
    Case
        What it says, checked.

    Raises
    ------
    InputError
        If the file cannot be read, is no TOML, or says something that is not allowed.
    """
    file = Path(path)
    try:
        if file.is_file() and file.stat().st_size > LARGEST_FILE:
            raise InputError(
                f"{path}: a joint file has at most {LARGEST_FILE} bytes, this one {file.stat().st_size}"
            )
        text = file.read_bytes().decode("utf-8-sig")
    except FileNotFoundError:
        raise InputError(f"{path}: there is no such file; 'asperity init' writes an example") from None
    except IsADirectoryError:
        raise InputError(f"{path}: this is a directory, not a joint file") from None
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: this is not a text file in UTF-8 (byte {error.start})") from None
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    return parse_case(text, source=str(path), folder=file.parent)


def parse_case(text: str, *, source: str, folder: Path | None = None) -> Case:
    """Read the text of a joint file.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        What to call it in error messages.
    folder : Path, optional
        Where paths of material libraries in the file start.

    Returns
    -------
    Case
        What it says, checked.

    Raises
    ------
    InputError
        If it is no TOML, or says something that is not allowed.
    """
    try:
        tables = tomllib.loads(text.replace("\r\n", "\n"))
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{source}: not valid TOML: {error}") from None
    except RecursionError:
        raise InputError(f"{source}: not a joint file: nested too deeply") from None
    except ValueError as error:  # numbers of thousands of digits
        raise InputError(f"{source}: not a joint file: {error}") from None
    return case_from_tables(tables, source=source, folder=folder)


def case_from_tables(tables: dict[str, Any], *, source: str, folder: Path | None = None) -> Case:
    """Check the nested tables of a joint file.

    Parameters
    ----------
    tables : dict
        The sections of the file, as :func:`tomllib.loads` returns them.
    source : str
        What to call them in error messages.
    folder : Path, optional
        Where paths of material libraries in them start.

    Returns
    -------
    Case
        What they say, checked.

    Raises
    ------
    InputError
        If they say something that is not allowed.
    """
    try:
        return Case.model_validate(with_library_materials(tables, folder=folder or Path()))
    except InputError as error:
        raise InputError(f"{source}: {error}") from None
    except ValidationError as error:
        raise InputError(f"{source}: {explain(error)}") from None
