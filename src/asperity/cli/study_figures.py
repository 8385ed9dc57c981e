"""Files that the commands for designs and calibrations write."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.errors import InputError

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def check_image_name(path: str | None) -> None:
    """Raise unless an image can have this name.

    Parameters
    ----------
    path : str or None
        File name.

    Raises
    ------
    InputError
        If the ending is unknown or the folder is missing.
    """
    if path is not None:
        if Path(path).suffix.lower() not in (".png", ".svg", ".pdf"):
            raise InputError(f"{path}: an image ends in .png, .svg or .pdf")
        check_folder(path)


def check_folder(path: str | None) -> None:
    """Raise unless the folder of a file to be written exists.

    Parameters
    ----------
    path : str or None
        File name.

    Raises
    ------
    InputError
        If it does not.
    """
    if path is not None and not Path(path).parent.is_dir():
        raise InputError(f"{path}: there is no folder {Path(path).parent}")


def write_figure(figure: Figure, path: str) -> None:
    """Write an image and say so on standard error.

    Parameters
    ----------
    figure : Figure
        What to draw.
    path : str
        File name.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    try:
        figure.savefig(path, dpi=150)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None
    click.echo(f"wrote {path}", err=True)


def write_text(text: str, path: str) -> None:
    """Write a text file and say so on standard error.

    Parameters
    ----------
    text : str
        What to write.
    path : str
        File name.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    try:
        Path(path).write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None
    click.echo(f"wrote {path}", err=True)
