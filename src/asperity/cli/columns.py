"""Columns of numbers as a CSV file."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from typing import Any

from asperity.writing import replacing


def write_columns(columns: Mapping[str, Any], path: str) -> None:
    """Write columns of one length, completely or not at all.

    Parameters
    ----------
    columns : mapping
        Header with its unit → numbers.
    path : str
        The file.
    """
    import numpy as np

    rows = np.column_stack([np.asarray(column) for column in columns.values()])
    with replacing(path) as part, part.open("w", newline="") as target:
        writer = csv.writer(target)
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in rows)
