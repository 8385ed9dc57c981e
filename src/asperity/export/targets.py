"""The programs a joint can be exported to: their names, the endings of their files, and who writes them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from asperity.errors import InputError, quoted
from asperity.export.content import ExportContent
from asperity.writing import check_file, replacing

#: Endings of the files of each target.
SUFFIXES = {"table": (".csv", ".mat"), "mujoco": (".xml",), "fmu": (".fmu",), "modelica": (".mo",)}


@dataclass(frozen=True)
class Exported:
    """A file for another program.

    Parameters
    ----------
    data : bytes
        The file.
    notes : tuple of str
        What its user should know, one sentence each.
    """

    data: bytes
    notes: tuple[str, ...] = ()


def check_target(to: str, path: str | Path, *inputs: str | Path) -> None:
    """Raise unless a target is known and its file can be written.

    Parameters
    ----------
    to : str
        Name of the target.
    path : str or Path
        The file to be written.
    *inputs : str or Path
        Files that are read and must not be overwritten.

    Raises
    ------
    InputError
        If there is no such target, the name has another ending than its files, or it cannot be written.
    """
    if to not in SUFFIXES:
        raise InputError(f"there is no export to {quoted(to)}; known are {', '.join(SUFFIXES)}")
    if Path(path).suffix.lower() not in SUFFIXES[to]:
        raise InputError(f"{path}: the name of a file for '{to}' must end in {' or '.join(SUFFIXES[to])}")
    check_file(path, *inputs)


def exported(content: ExportContent, *, to: str, suffix: str) -> Exported:
    """Make the file of a target.

    Parameters
    ----------
    content : ExportContent
        What is exported.
    to : str
        Name of the target.
    suffix : str
        Ending of its file.

    Returns
    -------
    Exported
        The file.

    Raises
    ------
    InputError
        If the target cannot carry something of the joint.
    """
    return _WRITERS[to](content, suffix.lower())


def write_exported(made: Exported, path: str | Path) -> None:
    """Write the file of a target, completely or not at all.

    Parameters
    ----------
    made : Exported
        The file.
    path : str or Path
        Its name.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    with replacing(path) as part:
        part.write_bytes(made.data)


def _table(content: ExportContent, suffix: str) -> Exported:
    from asperity.export.table import csv_file, mat_file

    return Exported(csv_file(content) if suffix == ".csv" else mat_file(content))


def _mujoco(content: ExportContent, suffix: str) -> Exported:
    from asperity.export.elements import fitted_elements
    from asperity.export.mjcf import mjcf_file

    fitted = fitted_elements(content, program="MuJoCo")
    return Exported(mjcf_file(content, fitted), fitted.sentences)


def _fmu(content: ExportContent, suffix: str) -> Exported:
    from asperity.export.fmu import fmu_file, fmu_parts

    parts = fmu_parts(content)
    return Exported(fmu_file(content, parts), parts.sentences)


def _modelica(content: ExportContent, suffix: str) -> Exported:
    from asperity.export.elements import fitted_elements
    from asperity.export.modelica import modelica_file

    fitted = fitted_elements(content, program="the Modelica model")
    return Exported(modelica_file(content, fitted), fitted.sentences)


_WRITERS: dict[str, Callable[[ExportContent, str], Exported]] = {
    "table": _table,
    "mujoco": _mujoco,
    "fmu": _fmu,
    "modelica": _modelica,
}
