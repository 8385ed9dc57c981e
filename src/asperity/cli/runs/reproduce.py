"""What the command of :mod:`asperity.cli.reproduce` does."""

from __future__ import annotations

import contextlib
import json
import textwrap

import click

from asperity.cli.progress import progress_bar
from asperity.types import Document
from asperity.zou2025.claims import judge
from asperity.zou2025.curves import Curves, joint_curves, pair_curves
from asperity.zou2025.files import output_folder, verdict_document, write_panel, write_verdicts
from asperity.zou2025.panels import all_panels

_WIDTH = 110


def _table(rows: list[Document], columns: dict[str, str]) -> list[str]:
    """Rows as an aligned text table; ``columns`` maps keys to headings."""
    cells = [list(columns.values())]
    cells += [
        [f"{row[k]:.5g}" if isinstance(row[k], float) else str(row[k]) for k in columns] for row in rows
    ]
    widths = [max(len(row[i]) for row in cells) for i in range(len(columns))]
    return ["  " + "  ".join(cell.rjust(w) for cell, w in zip(row, widths, strict=True)) for row in cells]


def _verdict(met: bool) -> str:
    return click.style("met    ", fg="green") if met else click.style("not met", fg="red", bold=True)


def _claim_lines(claim: Document) -> list[str]:
    panels = ", ".join(claim["panels"])
    lines = [
        f"{claim['name']:<6} {_verdict(claim['met'])}  {click.style(claim['title'], bold=True)} ({panels})"
    ]
    for part in claim["statements"]:
        lines.append(f"         {_verdict(part['met'])}  {part['says']}")
        lines += textwrap.wrap(
            part["evidence"], _WIDTH - 20, initial_indent=" " * 18, subsequent_indent=" " * 18
        )
    return lines


def _report(document: Document) -> str:
    """The document of :func:`asperity.zou2025.files.verdict_document` as text."""
    contacts = ("sp", "pwr", "pwl", "wro", "wlo")
    lines = [
        click.style(document["paper"], bold=True),
        "Recomputed from its equations (1)-(30), the published model, in which only the asperities are elastic.",
        "",
        click.style("Table 1: one roller pair (lengths in m, forces in N; K_t in N/mm)", bold=True),
        *_table(
            document["table_1"],
            {
                "case": "case",
                "varied": "varied",
                "from_SI": "from",
                "to_SI": "to",
                "tangential_stiffness_start_N_per_mm": "K_t at start",
                "tangential_stiffness_end_N_per_mm": "K_t at end",
                "tangential_stiffness_largest_N_per_mm": "largest K_t",
            },
        ),
        "",
        click.style(
            "Table 2: the joint (torque in N*m, forces in N, K_T at the output in N*m/rad)", bold=True
        ),
        *_table(
            document["table_2"],
            {
                "output_torque_Nm": "torque",
                **{f"normal_force_{c}_N": f"N_{c}" for c in contacts},
                **{f"tangential_force_{c}_N": f"T_{c}" for c in contacts[:3]},
                "torsional_stiffness_output_Nm_per_rad": "K_T",
            },
        ),
        "",
        click.style("Assumptions where the paper gives no value", bold=True),
    ]
    lines += [f"  {a['what']}: {a['value']} ({a['reason']})" for a in document["assumptions"]]
    lines += ["", click.style("Criteria for the qualitative terms of the paper", bold=True)]
    lines += [f"  {c['name']} ({c['limit']:g}): {c['meaning']}" for c in document["criteria"]]
    lines += [
        "",
        click.style(
            f"Claims: {document['met']} of {len(document['claims'])} met in all statements", bold=True
        ),
    ]
    for claim in document["claims"]:
        lines += _claim_lines(claim)
    lines += ["", click.style("Remarks", bold=True), *(f"  {remark}" for remark in document["remarks"])]
    return "\n".join(lines)


def reproduce(out: str | None, as_json: bool) -> None:
    """What ``asperity reproduce`` does; its options stand in :mod:`asperity.cli.reproduce`."""
    with (
        progress_bar("parts") as report,
        output_folder(out) if out is not None else contextlib.nullcontext() as folder,
    ):
        parts = 2 if folder is None else 16
        pairs = pair_curves()
        report(1, parts)
        curves = Curves(pairs=pairs, **joint_curves())
        report(2, parts)
        document = verdict_document(curves, judge(curves))
        if folder is not None:
            for done, panel in enumerate(all_panels(curves), start=3):
                write_panel(panel, folder)
                report(done, parts)
            write_verdicts(document, folder)
    click.echo(
        json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) if as_json else _report(document)
    )
    if folder is not None:
        click.echo(
            f"\n14 panels (PNG, CSV), table_1.csv, table_2.csv and claims.json were written to {folder}",
            err=True,
        )
    elif not as_json:
        click.echo(
            "\nNo files were written. Use --out FOLDER to write the 14 panels of Figs. 4-8 as PNG and CSV.",
            err=True,
        )
