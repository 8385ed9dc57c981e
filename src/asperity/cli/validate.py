"""``asperity validate``: evidence that this installation computes correctly."""

from __future__ import annotations

from typing import Any

import click

from asperity.cli.terminal import json_option, prepare_computation


@click.command()
@json_option("Print one JSON document instead of a table.")
@click.option(
    "--out",
    type=click.Path(),
    metavar="FILE",
    help="Also write the evidence to a file: .pdf or .html, to read and print, or .json.",
)
@click.pass_context
def validate(context: click.Context, as_json: bool, out: str | None) -> None:
    """Recompute published and independent results with this installation, and compare.

    The references are tables by quadrature, decks of CONTACT, closed forms, independent solvers and the paper's
    figures. For each check: what was found and expected, how far they differ, the tolerance, and the source. The exit
    code is 1 if any check fails.
    """
    import json
    from pathlib import Path

    from asperity.cli.terminal import progress_bar
    from asperity.errors import InputError
    from asperity.made_files import DOCUMENT, REPORT
    from asperity.writing import check_file, replacing, write_text

    suffix = Path(out).suffix.lower() if out is not None else ""
    if out is not None and suffix not in {".pdf", ".html", ".json"}:
        raise InputError(f"--out {out}: the name must end in .pdf, .html or .json")
    kind = DOCUMENT if suffix == ".json" else REPORT
    check_file(out, kind=kind)
    if suffix == ".pdf":
        from asperity.report.pdf import require_typst

        require_typst()
    prepare_computation()
    from asperity.report.validation_report import validation_report
    from asperity.validation.run import run_checks, validation_document

    with progress_bar("groups of checks") as report:
        document = validation_document(run_checks(report))
    text = json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False)
    if out is not None:
        from asperity.cli.terminal import say_written

        if suffix == ".pdf":
            from asperity.report.pdf import report_pdf

            with replacing(out, kind=kind) as part:
                part.write_bytes(report_pdf(validation_report(document)))
        else:
            from asperity.views.html import report_html

            made = text + "\n" if suffix == ".json" else report_html(validation_report(document))
            write_text(made, out, kind=kind)
        say_written(out)
    if as_json:
        click.echo(text)
    else:
        _show(document)
    if not document["valid"]:
        context.exit(1)


def _show(document: dict[str, Any]) -> None:
    """The checks, below their models, and a count."""
    from itertools import groupby

    from rich.text import Text

    from asperity.cli.terminal import console
    from asperity.report.validation_report import shown

    target = console()
    for model, rows in groupby(document["checks"], key=lambda row: row["model"]):
        target.print(Text(model, "bold"))
        for row in rows:
            verdict = Text("pass", "green") if row["passed"] else Text("FAIL", "bold red")
            count = f" ({row['values']} values, the worst:)" if row["values"] > 1 else ""
            target.print(Text("  ") + verdict + Text(f"  {row['quantity']}{count}"))
            if row["note"]:
                target.print(Text(f"        {row['note']}"))
                continue
            unit = "" if row["unit"] == "-" else f" {row['unit']}"
            kind, of = ("difference", unit) if row["absolute"] else ("relative deviation", "")
            target.print(
                Text(
                    f"        found {shown(row['found'], 8)}, expected {shown(row['expected'], 8)}{unit}\n"
                    f"        {kind} {shown(row['deviation'], 2)}{of}, tolerance {shown(row['tolerance'], 2)}{of}; "
                    f"{row['reference']}"
                )
            )
    total = document["passed"] + document["failed"]
    target.print(
        Text(
            f"{document['passed']} of {total} checks passed: asperity {document['asperity_version']}, source "
            f"{document['source_sha256'][:16]}, Python {document['python']}, {document['platform']}"
        )
    )
