"""From a TOML file to a checked :class:`asperity.joint_file.model.Case`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import ValidationError

from asperity.errors import InputError
from asperity.joint_file.messages import explained, listed
from asperity.joint_file.model import Case
from asperity.library import fill_in_materials
from asperity.reading import parse_toml, read_text


def read_case(path: str | Path) -> Case:
    """Read a joint file.

    Parameters
    ----------
    path : str or Path
        A TOML file.

    Returns
    -------
    Case
        Its content, checked.

    Raises
    ------
    InputError
        If the file cannot be read, is not valid TOML, or contains something that is not allowed.
    """
    file = Path(path)
    text = read_text(file, hint="'asperity init' writes an example")
    return parse_case(text, source=str(path), folder=file.parent)


def parse_case(text: str, *, source: str, folder: Path | None = None) -> Case:
    """Read the text of a joint file.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        Name of the file, for messages.
    folder : Path, optional
        Where paths of material libraries in the file start.

    Returns
    -------
    Case
        Its content, checked.

    Raises
    ------
    InputError
        If it is not valid TOML, or contains something that is not allowed.
    """
    return case_from_tables(parse_toml(text, source=source), source=source, folder=folder).with_text(text)


def case_from_tables(tables: dict[str, Any], *, source: str, folder: Path | None = None) -> Case:
    """Check the nested tables of a joint file.

    Parameters
    ----------
    tables : dict
        The sections of the file, as :func:`asperity.reading.parse_toml` returns them.
    source : str
        Name of the file, for messages.
    folder : Path, optional
        Where paths of material libraries in them start.

    Returns
    -------
    Case
        Their content, checked.

    Raises
    ------
    InputError
        If they contain something that is not allowed; all errors are listed.
    """
    filled, refused = fill_in_materials(tables, folder=folder or Path())
    try:
        case = Case.model_validate(filled)
    except ValidationError as error:
        sentences = explained(error, filled, refused)
    else:
        if not refused:
            return case
        sentences = list(refused.values())
    raise InputError(listed(sentences, source))
