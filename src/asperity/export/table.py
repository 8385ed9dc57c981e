"""Curves of a joint over its torque: a CSV file with comments, or a MAT file of version 5, as MATLAB reads it."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np

import asperity
from asperity.export.content import ExportContent, heading

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
    "  largest_slip_ratio: the largest T/(mu N) of all contacts, standing under the torque.",
)


def table_columns(content: ExportContent) -> dict[str, np.ndarray]:
    """The curves at the torques of the wind-up, shape (n,)."""
    curve, found = content.windup, content.curves
    columns = {
        "torque_Nm": curve.torque,
        "stiffness_published_Nm_per_rad": found.published,
        "stiffness_series_Nm_per_rad": found.series_with_bulk,
        "stiffness_assembly_Nm_per_rad": found.assembly,
        "loading_rad": curve.angle,
        "unloading_rad": curve.unloading_angle,
        "reloading_rad": curve.reloading_angle,
        "slip_rad": curve.slip_angle,
        "drift_driving_rad_per_turn": found.driving_drift,
        "drift_braking_rad_per_turn": found.braking_drift,
        "largest_slip_ratio": found.slip_ratio,
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
    made = f"MATLAB 5.0 MAT-file, asperity {asperity.__version__}, {Path(content.source).name}"  # without the date
    text = made.encode("ascii", "replace")[:_MAT_TEXT].ljust(_MAT_TEXT)
    return text + target.getvalue()[_MAT_TEXT:]
