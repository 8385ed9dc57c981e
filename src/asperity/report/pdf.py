"""A report as a PDF, set by typst from the fonts that come with matplotlib.

Every text of the typst source is a string literal, so that none can act as markup.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from asperity.errors import printable
from asperity.extras import optional_module
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
from asperity.writing import if_abandoned

_LONGEST_LINE = 128  # letters of a listing
_COLOURS = {"pass": 'rgb("#05603a")', "FAIL": 'rgb("#a4001d")'}
_SHORT = 30  # letters of words that a column does not break
_LONGEST_UNBROKEN = 14  # rows of a table that is kept on one page
_HEAD = """\
#set page(paper: "a4", margin: (x: 20mm, top: 18mm, bottom: 20mm), numbering: "1 / 1")
#set text(font: "DejaVu Sans", size: 9pt, lang: "en", hyphenate: false)
#set par(leading: 0.62em)
#set heading(numbering: "1")
#show heading: it => block(above: 1.6em, below: 0.8em, sticky: true, text(size: 12pt, it))
#show figure: set block(breakable: false)
#show figure.caption: it => text(size: 8.5pt, weight: "bold", it.body)
#set table(stroke: none, inset: (x: 3pt, y: 2.6pt))
"""


def typst_source(report: Report, *, pictures: list[str]) -> str:
    """Write a report as typst."""
    title, names = literal(report.title), iter(pictures)
    parts = [
        f"#set document(title: {title}, keywords: ({literal(MARK)},), date: none)\n{_HEAD}",
        f'#text(size: 16pt, weight: "bold", {title})',
    ]
    parts += _parts(report.blocks, names)
    return "\n\n".join(parts) + "\n"


def _parts(blocks: Sequence[Block], names: Iterator[str]) -> Iterator[str]:
    """Every block; a heading and the sentences below it stay with what follows them.

    Sheets of paper come last, so that no page before one stays half empty; other pictures go where they find room.
    """
    opening: list[Heading | Paragraph] = []
    sheets: list[str] = []
    for block in blocks:
        if isinstance(block, Paragraph) and opening:
            opening.append(block)
            continue
        if isinstance(block, Picture) and block.sheet:
            sheets.append(_sheet(block, opening, next(names)))
        elif isinstance(block, Heading):
            yield from (_block(part) for part in opening)
            opening = [block]
            continue
        else:
            yield from (f"#block(sticky: true)[{_block(part)}]" for part in opening)
            yield (
                _picture(block, next(names), floats=not opening)
                if isinstance(block, Picture)
                else _block(block)
            )
        opening = []
    yield from (_block(part) for part in opening)
    yield from sheets


def literal(text: str) -> str:
    """A text as a string literal of typst."""
    return _quoted(printable(text))


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else f"\\u{{{ord(c):x}}}" for c in escaped) + '"'


def _block(block: Heading | Paragraph | Bullets | Figures | Table | Warnings | Listing) -> str:
    match block:
        case Heading(text):
            return f"#heading({literal(text)})"
        case Paragraph(text, strong, passed):
            weight = 'weight: "bold", ' if strong else ""
            colour = "" if passed is None else f"fill: {_COLOURS['pass' if passed else 'FAIL']}, "
            return f"#par(text({weight}{colour}{literal(text)}))"
        case Bullets(items):
            return f"#list({', '.join(literal(item) for item in items)})" if items else ""
        case Figures(items):
            return _table(figures_table(items))
        case Table():
            return _table(block)
        case Warnings(items):
            return f"#list({', '.join(map(_warned, items))})" if items else ""
        case Listing(text):
            lines = [  # broken where they would leave the page
                line[start : start + _LONGEST_LINE]
                for line in text.split("\n")
                for start in range(0, max(1, len(line)), _LONGEST_LINE)
            ]
            return f"#text(size: 7.5pt, raw({_quoted(chr(10).join(lines))}, block: true))"


def _warned(item: Warned) -> str:
    """A crossed limit: what it is in bold, what it means, and what to do."""
    remedy = f" What to do: {item.remedy}." if item.remedy else ""
    said = literal(f". {sentence('; '.join(item.meanings))}{remedy}")
    return f"""text(weight: "bold", {literal(f"{item.about}: {item.text}")}) + {said}"""


def _picture(picture: Picture, name: str, *, floats: bool) -> str:
    """A picture of the width of the text, at the head or the foot of a page if it floats."""
    return (
        f"#figure(image({_quoted(name)}, width: 100%, alt: {literal(picture.title)}), "
        f"placement: {'auto' if floats else 'none'}, "
        f"caption: {literal(picture.title)}, supplement: none, numbering: none)"
    )


def _sheet(picture: Picture, opening: Sequence[Heading | Paragraph], name: str) -> str:
    """A sheet of paper of its own; the heading above it stands in the margin outside its frame."""
    words = "".join(f"[{_block(part)}]," for part in opening)
    columns = ", ".join(["auto"] * len(opening))
    above = (
        f"#place(top + left, dx: 10mm, dy: 2.5mm, grid(columns: ({columns},), column-gutter: 8mm, "
        f"align: horizon, {words}))"
        if opening
        else ""
    )
    image = f"#image({_quoted(name)}, width: 297mm, alt: {literal(picture.title)})"
    return f'#page(paper: "a4", flipped: true, margin: 0mm, numbering: none)[{image}{above}]'


def _lines(text: str) -> str:
    """A title of a column, which may have several lines."""
    return " + linebreak() + ".join(literal(line) for line in text.split("\n"))


def _table(table: Table) -> str:
    columns = ", ".join(_widths(table))
    align = ", ".join("left" if place in table.words else "right" for place in range(len(table.head)))
    head = ", ".join(f'text(weight: "bold", {_lines(cell)})' for cell in table.head)
    rows = "\n".join(f"  {', '.join(_cells(row, table))}," for row in table.rows)
    made = (
        f"text(size: 8pt, table(columns: ({columns},), align: ({align},),\n"
        f"  table.header({head}), table.hline(stroke: 0.6pt),\n{rows}\n  table.hline(stroke: 0.3pt)))"
    )
    title = f'block(below: 0.5em, sticky: true, text(weight: "bold", {literal(table.title)}))'
    breakable = "false" if len(table.rows) <= _LONGEST_UNBROKEN else "true"
    return f"#block(above: 1.1em, breakable: {breakable}, {title} + {made})"


def _widths(table: Table) -> list[str]:
    """Width of each column: ``auto`` for numbers and short words; long words share the rest by length."""
    widths = ["auto"] * len(table.head)
    if len(table.words) > 1:
        longest = {place: max(len(row[place]) for row in (table.head, *table.rows)) for place in table.words}
        long = {place: count for place, count in longest.items() if count > _SHORT}
        for place, count in (long or dict.fromkeys(table.words[1:], 1)).items():
            widths[place] = f"{count}fr"
    return widths


def _cells(row: tuple[str, ...], table: Table) -> list[str]:
    """Cells of a row, the last one coloured where it is a verdict."""
    cells = [literal(cell) for cell in row]
    if table.verdicts and row[-1] in _COLOURS:
        weight = ', weight: "bold"' if row[-1] == "FAIL" else ""
        cells[-1] = f"text(fill: {_COLOURS[row[-1]]}{weight}, {cells[-1]})"
    return cells


if TYPE_CHECKING:
    import types


def require_typst() -> types.ModuleType:
    """The package typst, imported; MissingExtraError if it is not installed."""
    html = "a report with the ending .html needs no package"
    return optional_module("typst", extra="report", needs="a PDF needs", otherwise=html)


def report_pdf(report: Report) -> bytes:
    """A report as PDF, the same for the same report, without fonts of the system or the network; needs typst."""
    made: bytes = _set(report, format="pdf")
    return made


def report_pages(report: Report, *, points_per_inch: float) -> list[bytes]:
    """The pages of this PDF as PNG pictures, for screens; needs typst."""
    pages: bytes | list[bytes] = _set(report, format="png", ppi=points_per_inch)
    return [pages] if isinstance(pages, bytes) else pages


def _set(report: Report, **options: object) -> Any:
    """What typst makes of a report."""
    import matplotlib

    typst = require_typst()
    pictures = [block.svg for block in report.blocks if isinstance(block, Picture)]
    names = [f"picture-{number}.svg" for number in range(len(pictures))]
    made_here = tempfile.TemporaryDirectory(prefix="asperity-report-")
    with made_here as folder, if_abandoned(made_here.cleanup):
        for name, svg in zip(names, pictures, strict=True):
            Path(folder, name).write_text(svg, encoding="utf-8")
        source = Path(folder, "report.typ")
        source.write_text(typst_source(report, pictures=names), encoding="utf-8")
        return typst.compile(
            str(source),
            root=folder,
            font_paths=[str(Path(matplotlib.get_data_path(), "fonts", "ttf"))],
            ignore_system_fonts=True,
            **options,
        )
