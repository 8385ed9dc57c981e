"""The checks as one self-contained HTML page."""

from __future__ import annotations

import html
from itertools import groupby
from typing import Any

_STYLE = """
:root { color-scheme: light dark }
body { font: 15px/1.45 system-ui, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; color: #1a1a1a;
  background: #fff }
table { border-collapse: collapse; width: 100%; margin: .5rem 0 1.5rem }
th, td { text-align: left; padding: .3rem .5rem; border-bottom: 1px solid #ccc; vertical-align: top }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
.pass { color: #05603a } .fail { color: #a4001d; font-weight: 700 }
.scroll { overflow-x: auto } code { overflow-wrap: anywhere }
@media (prefers-color-scheme: dark) {
  body { color: #e8e8e8; background: #161616 } th, td { border-color: #444 }
  .pass { color: #6fd3a0 } .fail { color: #ff8a94 }
}
@media print { body { max-width: none; color: #000; background: #fff } .pass { color: #000 } }
"""


def shown(value: float | None, digits: int = 6) -> str:
    """A number for people; "–" where there is none.

    Parameters
    ----------
    value : float or None
        The number.
    digits : int
        Significant digits.

    Returns
    -------
    str
        Its text.
    """
    return "–" if value is None else f"{value:.{digits}g}"


def validation_page(document: dict[str, Any]) -> str:
    """A page for a file of evidence: no scripts, nothing from the network.

    Parameters
    ----------
    document : dict
        As :func:`asperity.validation.run.validation_document` returns it.

    Returns
    -------
    str
        HTML.
    """
    packages = ", ".join(f"{name} {number}" for name, number in document["packages"].items())
    total = document["passed"] + document["failed"]
    verdict = (
        f'<p class="pass">All {total} checks passed.</p>'
        if document["valid"]
        else f'<p class="fail">{document["failed"]} of {total} checks failed.</p>'
    )
    parts = [
        '<!doctype html><html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>Validation of asperity {html.escape(document['asperity_version'])}</title>",
        f"<style>{_STYLE}</style></head><body>",
        f"<h1>Validation of asperity {html.escape(document['asperity_version'])}</h1>",
        verdict,
        f"<p>Python {html.escape(document['python'])} on {html.escape(document['platform'])}; "
        f"{html.escape(packages)}. SHA-256 of the installed source and data: "
        f"<code>{document['source_sha256']}</code></p>",
        "<p>Of several values the pair that differs most is shown. A deviation is relative unless it has a unit.</p>",
    ]
    return "\n".join([*parts, checks_tables(document), "</body></html>", ""])


def checks_tables(document: dict[str, Any]) -> str:
    """The checks alone, one table for each model.

    Parameters
    ----------
    document : dict
        As :func:`asperity.validation.run.validation_document` returns it.

    Returns
    -------
    str
        HTML without head and body.
    """
    parts: list[str] = []
    for model, rows in groupby(document["checks"], key=lambda row: row["model"]):
        parts += [f"<h2>{html.escape(model)}</h2>", '<div class="scroll"><table><thead><tr>']
        parts += [
            f'<th scope="col"{" class=number" if name in _NUMBERS else ""}>{name}</th>'
            for name in ("Quantity", "Reference", "Unit", *_NUMBERS, "Result")
        ]
        parts += ["</tr></thead><tbody>", *map(_row, rows), "</tbody></table></div>"]
    return "\n".join(parts)


_NUMBERS = ("Values", "Expected", "Found", "Deviation", "Tolerance")


def _row(row: dict[str, Any]) -> str:
    unit = f" {row['unit']}" if row["absolute"] and row["unit"] != "-" else ""
    numbers = (
        str(row["values"]),
        shown(row["expected"], 8),
        shown(row["found"], 8),
        shown(row["deviation"], 2) + unit,
        shown(row["tolerance"], 2) + unit,
    )
    result = '<td class="pass">pass</td>' if row["passed"] else '<td class="fail">FAIL</td>'
    note = f"<br>{html.escape(row['note'])}" if row["note"] else ""
    texts = (html.escape(row["quantity"]) + note, html.escape(row["reference"]), html.escape(row["unit"]))
    return (
        "<tr>"
        + "".join(f"<td>{text}</td>" for text in texts)
        + "".join(f'<td class="number">{html.escape(number)}</td>' for number in numbers)
        + result
        + "</tr>"
    )
