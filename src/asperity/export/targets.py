"""The programs a joint can be exported to: names and endings of their files, who writes them; files of columns."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import asperity
from asperity.errors import InputError, one_line, quoted
from asperity.export.content import ExportContent, fitted_elements, heading
from asperity.made_files import EXPORTS
from asperity.writing import check_file, replacing

#: Endings of the files of each target.
SUFFIXES = {"table": (".csv", ".mat"), "mujoco": (".xml",), "fmu": (".fmu",), "modelica": (".mo",)}
#: A MAT file begins with this many letters of text.
_MAT_TEXT = 116

_COLUMNS = (
    "Columns:",
    "  stiffness_*: incremental stiffness on first loading at three levels of the model, without play.",
    "  loading, unloading, reloading: angle on first loading from rest in either direction, and both branches of the "
    "loop between minus and plus the largest torque, play included.",
    "  slip: share of the loading angle that is lost to slip; it follows Masing's rule, the rest is reversible.",
    "  drift_driving, drift_braking: angle by which the output gives way to the torque in one turn of its own in "
    "steady rolling, if the drive turns with the torque or against it.",
    "  efficiency: output over input power in steady rolling at the speed of the joint file; nan where it is unknown.",
    "  largest_slip_ratio: the largest T/(mu N) of all contacts, standing under the torque.",
)


@dataclass(frozen=True)
class Exported:
    """A file for another program, and what its user should know, one sentence each."""

    data: bytes
    notes: tuple[str, ...] = ()


def check_target(to: str, path: str | Path, *inputs: str | Path) -> None:
    """Raise an ``InputError`` for an unknown target or ending, or a file that cannot be written or is an input."""
    if to not in SUFFIXES:
        raise InputError(f"there is no export to {quoted(to)}; known are {', '.join(SUFFIXES)}")
    if Path(path).suffix.lower() not in SUFFIXES[to]:
        raise InputError(f"{path}: the name of a file for '{to}' must end in {' or '.join(SUFFIXES[to])}")
    check_file(path, *inputs, kind=EXPORTS[Path(path).suffix.lower()])


def exported(content: ExportContent, *, to: str, suffix: str) -> Exported:
    """The file of a target; an ``InputError`` if the target cannot carry something of the joint."""
    if to == "table":
        return Exported(csv_file(content) if suffix.lower() == ".csv" else mat_file(content))
    if to == "fmu":
        from asperity.export.fmu import fmu_file, fmu_parts

        parts = fmu_parts(content)
        return Exported(fmu_file(content, parts), parts.sentences)
    from asperity.export.mjcf import mjcf_file
    from asperity.export.modelica import modelica_file

    program, file = {"mujoco": ("MuJoCo", mjcf_file), "modelica": ("the Modelica model", modelica_file)}[to]
    fitted = fitted_elements(content, program=program)
    return Exported(file(content, fitted), fitted.sentences)


def write_exported(made: Exported, path: str | Path) -> None:
    """Write the file of a target, completely or not at all; an ``InputError`` if it cannot be written."""
    with replacing(path, kind=EXPORTS[Path(path).suffix.lower()]) as part:
        part.write_bytes(made.data)


def table_columns(content: ExportContent) -> dict[str, np.ndarray]:
    """The curves at the torques of the wind-up, shape (n,)."""
    curve, curves = content.windup, content.curves
    columns = {
        "torque_Nm": curve.torque,
        "stiffness_published_Nm_per_rad": curves.published,
        "stiffness_series_Nm_per_rad": curves.series_with_bulk,
        "stiffness_assembly_Nm_per_rad": curves.assembly,
        "loading_rad": curve.angle,
        "unloading_rad": curve.unloading_angle,
        "reloading_rad": curve.reloading_angle,
        "slip_rad": curve.slip_angle,
        "drift_driving_rad_per_turn": curves.driving_drift,
        "drift_braking_rad_per_turn": curves.braking_drift,
        "efficiency": curves.efficiency,
        "largest_slip_ratio": curves.slip_ratio,
    }
    return {name: np.asarray(values, dtype=float) for name, values in columns.items()}


def table_text(content: ExportContent) -> list[str]:
    """What is said about the columns, one line each."""
    return [*heading(content, what="Table"), *_COLUMNS]


def csv_file(content: ExportContent) -> bytes:
    """The table as CSV: comment lines that begin with #, the names of the columns, numbers in full precision."""
    columns = table_columns(content)
    lines = [f"# {line}" for line in table_text(content)]
    lines.append(",".join(columns))
    lines += [",".join(repr(float(value)) for value in row) for row in zip(*columns.values(), strict=True)]
    return ("\n".join(lines) + "\n").encode("ascii")


def mat_file(content: ExportContent) -> bytes:
    """The table as a MAT file: a column vector for every column, and the text ``about``."""
    from scipy.io import savemat

    target = io.BytesIO()
    vectors = {name: values[:, None] for name, values in table_columns(content).items()}
    savemat(target, {"about": np.array(table_text(content), dtype=object)[:, None], **vectors})
    name = one_line(Path(content.source).name)
    made = f"MATLAB 5.0 MAT-file, asperity {asperity.__version__}, {name}"  # without the date
    text = made.encode("ascii", "replace")[:_MAT_TEXT].ljust(_MAT_TEXT)
    return text + target.getvalue()[_MAT_TEXT:]
