"""The evidence of ``asperity validate`` as a report."""

from __future__ import annotations

from itertools import groupby

from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Report, Table

_HEAD = ("quantity: reference", "values", "expected", "found", "deviation", "tolerance", "result")


def validation_report(document: Document) -> Report:
    """A report of the checks, one table for each model."""
    packages = ", ".join(f"{name} {version}" for name, version in document["packages"].items())
    total = document["passed"] + document["failed"]
    passed = f"All {total} checks passed."
    blocks: list[Block] = [
        Paragraph(
            passed if document["valid"] else f"{document['failed']} of {total} checks failed.",
            strong=True,
            passed=bool(document["valid"]),
        ),
        Paragraph(f"Python {document['python']} on {document['platform']}; {packages}."),
        Paragraph(f"SHA-256 of the installed source and data: {document['source_sha256']}"),
        Paragraph(
            "Of several values the pair that differs most is shown. A deviation is relative unless it has a unit."
        ),
    ]
    for model, rows in groupby(document["checks"], key=lambda row: row["model"]):
        blocks.append(Table(model, _HEAD, [_row(row) for row in rows], verdicts=True))
    return Report(f"Validation of asperity {document['asperity_version']}", tuple(blocks))


def _row(row: Document) -> tuple[str, ...]:
    unit = f" {row['unit']}" if row["absolute"] and row["unit"] != "-" else ""
    quantity = row["quantity"] + (f" [{row['unit']}]" if row["unit"] != "-" else "")
    note = f"; {row['note']}" if row["note"] else ""
    return (
        f"{quantity}: {row['reference']}{note}",
        str(row["values"]),
        shown(row["expected"], 8),
        shown(row["found"], 8),
        shown(row["deviation"], 2) + unit,
        shown(row["tolerance"], 2) + unit,
        "pass" if row["passed"] else "FAIL",
    )


def shown(value: float | None, digits: int) -> str:
    """A number for people; a dash where there is none."""
    return "–" if value is None else f"{value:.{digits}g}"
