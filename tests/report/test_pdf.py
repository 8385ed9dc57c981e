"""A report as PDF: made by typst from a hostile document, the same bytes every time."""

import re
import sys

import pytest

from asperity.errors import MissingExtraError
from asperity.report.pdf import _table, literal, report_pdf, require_typst, typst_source
from asperity.views.blocks import Bullets, Heading, Listing, Paragraph, Picture, Report, Table

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2 1" width="2" height="1"><path d="M0 0L1 1"/></svg>'
HOSTILE = 'a" + read("/etc/passwd") #eval("1") \\ $x$ \x1b[31m\u202e'


def test_hostile_report_is_set_and_does_not_change():
    pytest.importorskip("typst", reason="the extra 'report' is not installed")
    report = Report(
        HOSTILE,
        (
            Heading(HOSTILE),
            Paragraph(HOSTILE),
            Bullets([HOSTILE]),
            Table(HOSTILE, ("x", "y\nmm"), [(HOSTILE, "1")] * 40),
            Picture(HOSTILE, SVG),
            Picture(HOSTILE, SVG, sheet=True),
            Listing(HOSTILE),
        ),
    )
    made = report_pdf(report)
    assert made.startswith(b"%PDF-")
    assert made == report_pdf(report)
    assert b"CreationDate" not in made


def test_without_typst_the_message_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(MissingExtraError, match=r"package 'typst'.*pip install .*\[report\].*\.html"):
        require_typst()


HOSTILE_MARKUP = 'a" + read("/etc/passwd") + " #eval("1") \\u{41} $x$ *b* _c_ \x1b[31m\u202e'


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("plain", '"plain"'),
        ('say "x"', '"say \\"x\\""'),
        ("a\\", '"a\\\\"'),
        ("\x1b", '"\\\\x1b"'),
        ("⌀ µ·m²", '"⌀ µ·m²"'),
    ],
)
def test_literals(text, expected):
    assert literal(text) == expected


def outside_literals(source):
    """The source with every string literal taken out."""
    return re.sub(r'"(?:[^"\\]|\\.)*"', "", source)


def test_no_text_leaves_its_literal():
    def made(text):
        blocks = (
            Heading(text),
            Paragraph(text, strong=True),
            Bullets([text]),
            Table(text, (text, f"{text}\nb"), [(text, text)]),
            Picture(text, ""),
            Picture(text, "", sheet=True),
            Listing(text),
        )
        return typst_source(Report(text, blocks), pictures=["p0.svg", "p1.svg"])

    assert outside_literals(made(HOSTILE_MARKUP)) == outside_literals(made("harmless"))


def test_lines_of_a_listing_stay_on_the_page_and_keep_their_letters():
    source = typst_source(Report("a", (Listing("x" * 300 + "\n\nend\tb"),)), pictures=[])
    (text,) = re.findall(r'raw\("(.*)", block', source)
    lines = text.split("\\u{a}")
    assert max(map(len, lines)) <= 128
    assert "".join(lines).replace("\\u{9}", "\t") == "x" * 300 + "end\tb"


def test_short_tables_stay_on_one_page_and_long_ones_may_break():
    short, long = (
        typst_source(Report("a", (Table("b", ("c",), [("d",)] * rows),)), pictures=[]) for rows in (3, 200)
    )
    assert "breakable: false" in short
    assert "breakable: true" in long


def test_long_words_share_what_numbers_and_short_words_leave():
    """Columns of equal shares left a few letters for the place, under the words beside it."""
    row = (
        "a requirement with a very long name",
        "Stiffness at the output",
        "planet to planet, at its end and beyond",
        "1",
    )
    found = _table(Table("limits", ("requirement", "concerns", "where", "actual"), [row], words=(0, 1, 2)))
    assert f"columns: ({len(row[0])}fr, auto, {len(row[2])}fr, auto,)" in found
    short = _table(Table("limits", ("name", "where", "actual"), [("one", "sp", "1.5")], words=(0, 1)))
    assert "columns: (auto, 1fr, auto,)" in short


def blocks_of(*blocks):
    names = [f"p{number}.svg" for number, _ in enumerate(blocks)]
    return typst_source(Report("a", blocks), pictures=names).split("\n\n")[2:]


def test_a_heading_and_its_sentences_stay_with_what_follows():
    table = Table("t", ("c",), [("d",)])
    heading, sentence, made, after, end = (
        part.strip()
        for part in blocks_of(
            Heading("h"), Paragraph("below the heading"), table, Paragraph("below the table"), Heading("end")
        )
    )
    for part, text in ((heading, "h"), (sentence, "below the heading")):
        assert part.startswith("#block(sticky: true)[")
        assert f'"{text}"' in part
    assert made.startswith("#block(above")
    assert after == '#par(text("below the table"))'
    assert end == '#heading("end")'


def test_a_picture_floats_but_not_away_from_its_heading():
    picture = Picture("p", "")
    parts = blocks_of(Heading("1"), picture, picture, Heading("2"), Paragraph("b"), Bullets(["c"]))
    placed = [part.split("placement: ")[1].split(",")[0] for part in parts if "placement" in part]
    assert placed == ["none", "auto"]


def test_sheets_of_paper_come_last_so_that_no_page_stays_half_empty():
    sheet = Picture("p", "", sheet=True)
    *others, last = blocks_of(Heading("drawing"), sheet, Heading("end"), Bullets(["c"]), Picture("q", ""))
    assert "flipped: true" in last
    assert "p0.svg" in last  # pictures have the names of their place in the report
    assert not any("flipped" in part for part in others)
    assert any("p1.svg" in part for part in others)


def test_the_heading_of_a_sheet_stands_on_it():
    (sheet,) = blocks_of(Heading("drawing"), Paragraph("in mm"), Picture("p", "", sheet=True))
    assert sheet.startswith('#page(paper: "a4", flipped: true')
    image, above = sheet.split("#place(")  # set after the picture, which would cover it
    assert "p0.svg" in image
    assert '#heading("drawing")' in above
    assert '"in mm"' in above


def test_verdicts_have_a_colour():
    table = Table("t", ("x", "y"), [("pass", "pass"), ("b", "FAIL"), ("c", "unknown")], verdicts=True)
    source = typst_source(Report("a", (Paragraph("all", passed=True), table)), pictures=[])
    assert source.count('fill: rgb("#05603a")') == 2  # the sentence and the first row
    assert 'text(fill: rgb("#a4001d"), weight: "bold", "FAIL")' in source
    assert '"c", "unknown",' in source
