"""Write the reproduction to a folder: a picture and a table for each panel, the tables' cases, the verdicts."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import InputError
from asperity.zou2025.criteria import CRITERIA
from asperity.zou2025.curves import Curves
from asperity.zou2025.panels import Panel
from asperity.zou2025.preset import ASSUMPTIONS, REMARKS
from asperity.zou2025.verdict import Claim


def output_folder(path: str | Path) -> Path:
    """Make the folder for the results.

    Parameters
    ----------
    path : path
        A folder, existing or not.

    Returns
    -------
    Path
        The folder, existing.

    Raises
    ------
    InputError
        If it cannot be made.
    """
    folder = Path(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"cannot make the folder {folder}: {error.strerror or error}; choose another one with --out"
        ) from error
    return folder


def write_rows(path: Path, header: Iterable[str], rows: Iterable[Iterable[Any]]) -> Path:
    """Write a CSV file; floats keep all their digits.

    Parameters
    ----------
    path : Path
        The file.
    header : iterable of str
        Column names, units included.
    rows : iterable
        Rows of values.

    Returns
    -------
    Path
        The file.
    """
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([repr(float(v)) if isinstance(v, float) else v for v in row] for row in rows)
    return path


def write_panel(panel: Panel, folder: Path) -> tuple[Path, Path]:
    """Write one panel as ``figure_NAME.png`` and the plotted numbers as ``figure_NAME.csv``.

    Parameters
    ----------
    panel : Panel
        The panel.
    folder : Path
        An existing folder.

    Returns
    -------
    tuple of Path
        Picture and table.
    """
    from asperity.zou2025.figures import panel_figure
    from asperity.zou2025.style import STYLE

    picture = folder / f"figure_{panel.name}.png"
    panel_figure(panel).savefig(picture, dpi=STYLE["savefig.dpi"])
    columns = np.column_stack([panel.abscissa, *(series.values for series in panel.series)])
    table = write_rows(
        folder / f"figure_{panel.name}.csv",
        [panel.x.column, *(series.column for series in panel.series)],
        ([float(v) for v in row] for row in columns),
    )
    return picture, table


def table_1_rows(curves: Curves) -> tuple[list[str], list[list[Any]]]:
    """The cases of Table 1: both ends of what each varies, the tangential stiffness there, its extremes.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    header, rows
        Column names with units, and one row a case.
    """
    header = [
        "case",
        "varied",
        "from_SI",
        "to_SI",
        "tangential_stiffness_start_N_per_mm",
        "tangential_stiffness_end_N_per_mm",
        "tangential_stiffness_largest_N_per_mm",
    ]
    rows = []
    for letter in "abcdef":
        curve = curves.pairs[letter]
        stiffness = curve.tangential_stiffness * 1e-3
        ends = [float(v) for v in (curve.values[0], curve.values[-1], stiffness[0], stiffness[-1])]
        rows.append([letter, curve.name, *ends, float(np.max(stiffness))])
    return header, rows


def table_2_rows(curves: Curves) -> tuple[list[str], list[list[Any]]]:
    """The joint of Table 2 at whole output torques: forces and torsional stiffness.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    header, rows
        Column names with units, and one row a torque.
    """
    loads = curves.loads
    header = [
        "output_torque_Nm",
        *(f"normal_force_{name}_N" for name in CONTACT_NAMES),
        *(f"tangential_force_{name}_N" for name in CONTACT_NAMES),
        "torsional_stiffness_sun_Nm_per_rad",
        "torsional_stiffness_output_Nm_per_rad",
    ]
    rows = []
    for i in range(0, loads.output_torque.size, (loads.output_torque.size - 1) // 5):
        values = [
            loads.output_torque[i],
            *loads.normal_force[:, i, 0],
            *loads.tangential_force[:, i, 0],
            loads.sun_stiffness[i, 0],
            loads.output_stiffness[i, 0],
        ]
        rows.append([float(v) for v in values])
    return header, rows


def write_tables(curves: Curves, folder: Path) -> tuple[Path, Path]:
    """Write ``table_1.csv`` and ``table_2.csv``.

    Parameters
    ----------
    curves : Curves
        Everything computed.
    folder : Path
        An existing folder.

    Returns
    -------
    tuple of Path
        The two files.
    """
    return (
        write_rows(folder / "table_1.csv", *table_1_rows(curves)),
        write_rows(folder / "table_2.csv", *table_2_rows(curves)),
    )


def verdict_document(curves: Curves, claims: tuple[Claim, ...]) -> dict[str, Any]:
    """Verdicts, criteria, assumptions and the tables' cases as one document.

    Parameters
    ----------
    curves : Curves
        Everything computed.
    claims : tuple of Claim
        The verdicts.

    Returns
    -------
    dict
        Plain data for JSON.
    """
    tables = {"table_1": table_1_rows(curves), "table_2": table_2_rows(curves)}
    return {
        "paper": "Zou et al., Materials 2025, 18(12), 2866, https://doi.org/10.3390/ma18122866",
        "met": sum(claim.met for claim in claims),
        "claims": [claim.as_dict() for claim in claims],
        "criteria": [vars(criterion) for criterion in CRITERIA],
        "assumptions": [vars(assumption) for assumption in ASSUMPTIONS],
        "remarks": list(REMARKS),
        **{
            name: [dict(zip(header, row, strict=True)) for row in rows]
            for name, (header, rows) in tables.items()
        },
    }


def write_verdicts(document: dict[str, Any], folder: Path) -> Path:
    """Write ``claims.json``.

    Parameters
    ----------
    document : dict
        :func:`verdict_document`.
    folder : Path
        An existing folder.

    Returns
    -------
    Path
        The file.
    """
    path = folder / "claims.json"
    path.write_text(
        json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8"
    )
    return path
