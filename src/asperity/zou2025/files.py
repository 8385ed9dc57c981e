"""Write the reproduction to a folder: a picture and a table of each panel, the cases of the tables, the verdicts."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import shutil
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from asperity.errors import InputError
from asperity.made_files import IMAGE, Kind
from asperity.types import Document
from asperity.writing import if_abandoned, write_image, write_text
from asperity.zou2025.criteria import CRITERIA, Claim
from asperity.zou2025.curves import Curves
from asperity.zou2025.kinematics import CONTACT_NAMES
from asperity.zou2025.panels import Panel
from asperity.zou2025.preset import ASSUMPTIONS, REMARKS

_PAPER = "Zou et al., Materials 2025, 18(12), 2866, https://doi.org/10.3390/ma18122866"
#: Names of the files of a reproduction.
_NAMES = ("figure_*.png", "figure_*.csv", "table_[12].csv", "claims.json")


@contextlib.contextmanager
def output_folder(path: str | Path) -> Iterator[Path]:
    """A folder for results, created unless it exists; if they are not completed, what was created is removed."""
    folder = Path(path)
    _refuse_files_of_others(folder)
    created = [place for place in (folder, *folder.parents) if not place.exists()]

    def remove() -> None:
        if created:
            shutil.rmtree(folder, ignore_errors=True)
        with contextlib.suppress(OSError):  # somebody else uses it
            for place in created[1:]:
                place.rmdir()

    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"cannot create the folder {folder}: {error.strerror or error}; choose a different folder",
            options=["out"],
        ) from error
    try:
        with if_abandoned(remove):
            yield folder
    except BaseException:
        remove()
        raise


def _refuse_files_of_others(folder: Path) -> None:
    """Refuse a folder in which something bears the name of a result and is none of an earlier run."""
    ours = Kind("", lambda file: json.loads(file.read_bytes())["paper"] == _PAPER).is_made(
        folder / "claims.json"
    )
    for file in (file for pattern in _NAMES for file in sorted(folder.glob(pattern))):
        image = file.with_suffix(".png")
        if file.is_symlink() or not (ours or (file.name.startswith("figure_") and IMAGE.is_made(image))):
            raise InputError(
                f"{folder}: {file.name} is of no earlier run of 'asperity reproduce'; remove it, or choose a different "
                "folder",
                options=["out"],
            )


def _write_rows(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Write a CSV file with a header; floats keep all their digits."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_text(stream.getvalue(), path)


def write_panel(panel: Panel, folder: Path) -> None:
    """Write one panel as ``figure_NAME.png`` and the plotted numbers as ``figure_NAME.csv``."""
    from asperity.zou2025.figures import panel_figure

    write_image(panel_figure(panel), folder / f"figure_{panel.name}.png")
    columns = panel.columns
    points = np.column_stack(list(columns.values())).tolist()
    _write_rows(folder / f"figure_{panel.name}.csv", [dict(zip(columns, p, strict=True)) for p in points])


def table_1_rows(curves: Curves) -> list[Document]:
    """The cases of Table 1: range of the varied quantity, K_t at both ends and its maximum; column → value."""
    rows = []
    for case in "abcdef":
        curve = curves.pairs[case]
        stiffness = curve.tangential_stiffness * 1e-3
        rows.append(
            {
                "case": case,
                "varied": curve.name,
                "from_SI": float(curve.values[0]),
                "to_SI": float(curve.values[-1]),
                "tangential_stiffness_start_N_per_mm": float(stiffness[0]),
                "tangential_stiffness_end_N_per_mm": float(stiffness[-1]),
                "tangential_stiffness_largest_N_per_mm": float(np.max(stiffness)),
            }
        )
    return rows


def table_2_rows(curves: Curves) -> list[Document]:
    """The joint of Table 2 at whole output torques: forces and torsional stiffness; column → value."""
    loads = curves.loads
    columns = {
        "output_torque_Nm": loads.output_torque,
        **{f"normal_force_{c}_N": f[:, 0] for c, f in zip(CONTACT_NAMES, loads.normal_force, strict=True)},
        **{
            f"tangential_force_{c}_N": f[:, 0]
            for c, f in zip(CONTACT_NAMES, loads.tangential_force, strict=True)
        },
        "torsional_stiffness_sun_Nm_per_rad": loads.sun_stiffness[:, 0],
        "torsional_stiffness_output_Nm_per_rad": loads.output_stiffness[:, 0],
    }
    size = loads.output_torque.size
    return [{k: float(v[i]) for k, v in columns.items()} for i in range(0, size, (size - 1) // 5)]


def verdict_document(curves: Curves, claims: tuple[Claim, ...]) -> Document:
    """Verdicts, criteria, assumptions and the cases of the tables as one document."""
    return {
        "paper": _PAPER,
        "met": sum(claim.met for claim in claims),
        "claims": [claim.as_dict() for claim in claims],
        "criteria": [vars(criterion) for criterion in CRITERIA],
        "assumptions": [vars(assumption) for assumption in ASSUMPTIONS],
        "remarks": list(REMARKS),
        "table_1": table_1_rows(curves),
        "table_2": table_2_rows(curves),
    }


def write_verdicts(document: Document, folder: Path) -> None:
    """Write ``table_1.csv``, ``table_2.csv`` and ``claims.json``."""
    for table in ("table_1", "table_2"):
        _write_rows(folder / f"{table}.csv", document[table])
    text = json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False)
    write_text(text + "\n", folder / "claims.json")
