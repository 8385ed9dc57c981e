"""A report as typst: every text is a string literal, so that nothing a user writes can act as markup."""

import re

import pytest

from asperity.report.content import Bullets, Heading, Listing, Paragraph, Picture, Report, Table
from asperity.report.typst_source import literal, typst_source

HOSTILE = 'a" + read("/etc/passwd") + " #eval("1") \\u{41} $x$ *b* _c_ \x1b[31m\u202e'


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

    assert outside_literals(made(HOSTILE)) == outside_literals(made("harmless"))


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
