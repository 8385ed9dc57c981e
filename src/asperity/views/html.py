"""Blocks as HTML, and a report as one HTML file that needs nothing else: no scripts, no network."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Sequence

from asperity.errors import printable
from asperity.made_files import MARK
from asperity.views.blocks import (
    Block,
    Bullets,
    Figures,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Report,
    Table,
    Warned,
    Warnings,
    figures_table,
)
from asperity.views.numbers import sentence

_STYLE = """
:root { color-scheme: light; --ink: #111; --paper: #fff; --line: #ccc; --pass: #05603a; --fail: #a4001d; }
@media screen and (prefers-color-scheme: dark) { :root { color-scheme: dark; --ink: #e8e8e8; --paper: #161616;
  --line: #444; --pass: #6fd3a0; --fail: #ff8a94; } }
body { font: 16px/1.45 "DejaVu Sans", Verdana, sans-serif; color: var(--ink); background: var(--paper); margin: 0 auto;
  max-width: 62rem; padding: 1rem; overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; border-bottom: 1px solid var(--ink); margin-top: 2rem; }
nav ul { columns: 2; padding-left: 1.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 0.8rem 0; font-size: 0.86rem; }
caption { text-align: left; font-weight: bold; padding: 0.2rem 0; }
th, td { padding: 0.15rem 0.7rem 0.15rem 0; text-align: right; vertical-align: top;
  border-bottom: 1px solid var(--line); overflow-wrap: normal; white-space: nowrap; }
th.w, td.w { text-align: left; white-space: normal; } caption, th { white-space: normal; }
@media (min-width: 40rem) { caption { white-space: nowrap; } }
th { border-bottom: 1px solid var(--ink); }
figure { margin: 1rem 0; } figure svg { width: 100%; height: auto; max-height: 100vh; background: #fff; }
figcaption { font-size: 0.86rem; }
pre { font: 0.8rem/1.35 "DejaVu Sans Mono", monospace; white-space: pre-wrap; padding: 0.6rem;
  border: 1px solid var(--line); }
.strong, .fail { font-weight: bold; } .pass { color: var(--pass); } .fail { color: var(--fail); }
@media (max-width: 40rem) { nav ul { columns: 1; } body { padding: 0.5rem; } }
@page { size: A4; margin: 18mm; }
@media print { body { font-size: 10pt; padding: 0; max-width: none; } nav { display: none; }
  figure, tr { break-inside: avoid; } h2 { break-after: avoid; } }
"""
_VERDICTS = {"pass": "pass", "FAIL": "fail"}
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"


def report_html(report: Report) -> str:
    """A report as one HTML file; the same text for the same report."""
    title = _text(report.title)
    links = "".join(
        f'<li><a href="#s{number}">{_text(text)}</a></li>'
        for number, text in enumerate(report.sections, start=1)
    )
    contents = f'<nav aria-label="Sections"><ul>{links}</ul></nav>' if links else ""
    parts = [
        "<!DOCTYPE html>",
        '<html lang="en"><head><meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta name="generator" content="{MARK}">',
        f"<title>{title}</title><style>{_STYLE}</style></head><body>",
        f"<h1>{title}</h1>{contents}<main>",
    ]
    return "\n".join([*parts, blocks_html(report.blocks), "</main></body></html>\n"])


def blocks_html(blocks: Sequence[Block]) -> str:
    """Write blocks of a report as HTML that another page can hold."""
    section, parts = 0, []
    for number, block in enumerate(blocks):
        section += isinstance(block, Heading)
        parts.append(_block(block, number, section))
    return "\n".join(parts)


_NOTEBOOK_STYLE = (
    ".asperity table { margin: 0 0 0.8em; border-collapse: collapse; } "
    ".asperity :is(th, td) { text-align: right; vertical-align: top; padding: 0.15em 0.7em 0.15em 0; } "
    ".asperity caption { text-align: left; font-weight: bold; white-space: nowrap; } "
    ".asperity .w { text-align: left; } .asperity .strong { font-weight: bold; }"
)


def notebook_html(blocks: Sequence[Block]) -> str:
    """Write blocks as HTML for a cell of a notebook, whose headings have neither numbers nor places to link to."""
    parts = (
        f"<h3>{_text(block.text)}</h3>" if isinstance(block, Heading) else _block(block, number, 0)
        for number, block in enumerate(blocks)
    )
    return f'<style>{_NOTEBOOK_STYLE}</style><div class="asperity">{chr(10).join(parts)}</div>'


def _block(block: Block, number: int, section: int) -> str:
    match block:
        case Heading(text):
            return f'<h2 id="s{section}">{section} {_text(text)}</h2>'
        case Paragraph(text, strong, passed):
            said = "" if passed is None else "pass" if passed else "fail"
            words = " ".join(filter(None, ("strong" if strong else "", said)))
            kind = f' class="{words}"' if words else ""
            return f"<p{kind}>{_lines(text)}</p>"
        case Bullets(items):
            return f"<ul>{''.join(f'<li>{_text(item)}</li>' for item in items)}</ul>"
        case Figures(items):
            return _table(figures_table(items))
        case Table():
            return _table(block)
        case Warnings(items):
            return f"<ul>{''.join(f'<li>{_warned(item)}</li>' for item in items)}</ul>"
        case Picture(title, svg, _):
            caption = _text(title)
            picture = f'<div role="img" aria-label="{caption}">{_inline(svg, number)}</div>'
            return f"<figure>{picture}<figcaption>{caption}</figcaption></figure>"
        case Listing(text):
            return f"<pre>\n{html.escape(text)}</pre>"  # HTML drops the line break that follows <pre>


def _warned(item: Warned) -> str:
    """A crossed limit: what it is in bold, what it means, and what to do."""
    meanings = "; ".join(map(_text, item.meanings))
    remedy = f" What to do: {_text(item.remedy)}." if item.remedy else ""
    return f"<strong>{_text(item.about)}: {_text(item.text)}</strong>. {sentence(meanings)}{remedy}"


def _table(table: Table) -> str:
    def row(cells: tuple[str, ...], kind: str, text: Callable[[str], str]) -> str:
        scope = ' scope="col"' if kind == "th" else ""
        words = [" class=w" if place in table.words else "" for place in range(len(cells))]
        if table.verdicts and cells[-1] in _VERDICTS:
            words[-1] = f" class={_VERDICTS[cells[-1]]}"
        pairs = zip(words, map(text, cells), strict=True)
        return f"<tr>{''.join(f'<{kind}{scope}{word}>{cell}</{kind}>' for word, cell in pairs)}</tr>"

    body = "\n".join(row(cells, "td", _text) for cells in table.rows)
    head = row(table.head, "th", _lines)
    caption = f"<caption>{_text(table.title)}</caption>" if table.title else ""
    return f'<div class="wide"><table>{caption}<thead>{head}</thead><tbody>\n{body}\n</tbody></table></div>'


def _text(text: str) -> str:
    return html.escape(printable(text))


def _lines(text: str) -> str:
    """A text whose lines stand below each other."""
    return "<br>".join(map(_text, text.split("\n")))


def _inline(svg: str, number: int) -> str:
    """A picture inside the page: without the head of a file, its names its own."""
    body = svg[svg.index("<svg") :]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r'\bid="', f'id="p{number}-', body)
    body = re.sub(r"url\(#", f"url(#p{number}-", body)
    return re.sub(r'href="#', f'href="#p{number}-', body)
