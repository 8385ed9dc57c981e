"""What the command of :mod:`asperity.cli.validate` does."""

from __future__ import annotations

import json
from itertools import groupby
from pathlib import Path

import click
from rich.text import Text

from asperity.cli.progress import progress_bar
from asperity.cli.terminal import console, say_written
from asperity.errors import InputError
from asperity.made_files import DOCUMENT, REPORT
from asperity.report.pdf import report_pdf, require_typst
from asperity.report.validation_report import shown, validation_report
from asperity.types import Document
from asperity.validation.run import run_checks, validation_document
from asperity.views.html import report_html
from asperity.views.terminal import print_wrapped
from asperity.writing import check_file, replacing, write_text


def validate(as_json: bool, out: str | None) -> None:
    """What ``asperity validate`` does; its options stand in :mod:`asperity.cli.validate`."""
    suffix = Path(out).suffix.lower() if out is not None else ""
    if out is not None and suffix not in {".pdf", ".html", ".json"}:
        raise InputError(f"--out {out}: the name must end in .pdf, .html or .json")
    kind = DOCUMENT if suffix == ".json" else REPORT
    check_file(out, kind=kind)
    if suffix == ".pdf":
        require_typst()
    with progress_bar("groups of checks") as report:
        document = validation_document(run_checks(report))
    text = json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False)
    if out is not None:
        if suffix == ".pdf":
            with replacing(out, kind=kind) as part:
                part.write_bytes(report_pdf(validation_report(document)))
        else:
            made = text + "\n" if suffix == ".json" else report_html(validation_report(document))
            write_text(made, out, kind=kind)
        say_written(out)
    if as_json:
        click.echo(text)
    else:
        _show(document)
    if not document["valid"]:
        click.get_current_context().exit(1)


def _show(document: Document) -> None:
    """The checks, below their models, and a count."""
    target = console()
    for model, rows in groupby(document["checks"], key=lambda row: row["model"]):
        target.print(Text(model, "bold"))
        for row in rows:
            verdict = Text("pass", "green") if row["passed"] else Text("FAIL", "bold red")
            count = f" ({row['values']} values, the worst:)" if row["values"] > 1 else ""
            target.print(Text("  ") + verdict + Text(f"  {row['quantity']}{count}"), soft_wrap=True)
            if row["note"]:
                print_wrapped(target, f"        {row['note']}", indent=8)
                continue
            unit = "" if row["unit"] == "-" else f" {row['unit']}"
            kind, of = ("difference", unit) if row["absolute"] else ("relative deviation", "")
            sizes = f"found {shown(row['found'], 8)}, expected {shown(row['expected'], 8)}{unit}"
            apart = f"{kind} {shown(row['deviation'], 2)}{of}, tolerance {shown(row['tolerance'], 2)}{of}"
            for line in (sizes, f"{apart}; {row['reference']}"):
                print_wrapped(target, f"        {line}", indent=8)
    total = document["passed"] + document["failed"]
    print_wrapped(
        target,
        f"{document['passed']} of {total} checks passed: asperity {document['asperity_version']}, source "
        f"{document['source_sha256'][:16]}, Python {document['python']}, {document['platform']}",
        indent=2,
    )
