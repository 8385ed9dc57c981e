"""A report as HTML: nothing from outside, every text as text, headings and tables where they belong."""

import re
from html.parser import HTMLParser

import pytest

from asperity.views.blocks import (
    Bullets,
    Figure,
    Figures,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Report,
    Table,
    Warned,
    Warnings,
)
from asperity.views.html import notebook_html, report_html

HOSTILE = "</pre><script>alert('x')</script><img src=x onerror=y>&amp;\"' #{[*_$\\\x1b[31m\u202e"
SVG = (
    '<?xml version="1.0"?>\n<!DOCTYPE svg>\n<svg viewBox="0 0 1 1"><metadata>m</metadata><defs><path id="a"/></defs>'
    '<use xlink:href="#a"/><g clip-path="url(#a)"/></svg>'
)


def hostile_report():
    return Report(
        HOSTILE,
        (
            Heading(HOSTILE),
            Paragraph(HOSTILE, strong=True),
            Bullets([HOSTILE]),
            Figures([Figure(HOSTILE, HOSTILE, HOSTILE, HOSTILE, 1.0)]),
            Table(HOSTILE, (HOSTILE, "two\nlines"), [(HOSTILE, "1")]),
            Warnings([Warned("damage", HOSTILE, HOSTILE, (HOSTILE,), HOSTILE)]),
            Picture(HOSTILE, SVG),
            Picture("second", SVG),
            Listing("\n# a\n" + HOSTILE),
        ),
    )


class Reader(HTMLParser):
    """Tags in balance, attributes, and the text of each kind of tag."""

    VOID = ("meta", "br")

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.attributes, self.texts = [], [], [], {}
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [(tag, name, value) for name, value in attrs]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [(tag, name, value) for name, value in attrs]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        for tag in set(self.open):
            self.texts[tag] = self.texts.get(tag, "") + data


@pytest.fixture(scope="module")
def page():
    return Reader(report_html(hostile_report()))


def test_hostile_text_stays_text(page):
    assert not {"script", "img"} & set(page.tags)
    assert not [name for _, name, _ in page.attributes if name.startswith("on")]
    shown = HOSTILE.replace("\x1b", "\\x1b").replace("\u202e", "\\u202e")
    for tag in ("h1", "title", "li", "caption", "td", "figcaption", "p"):
        assert shown in page.texts[tag], tag


def test_listing_is_letter_by_letter(page):
    assert page.texts["pre"] == "\n" + "\n# a\n" + HOSTILE  # HTML drops the first line break


def test_nothing_is_loaded_and_names_of_pictures_do_not_clash(page):
    names = [value for _, name, value in page.attributes if name == "id"]
    assert len(names) == len(set(names))
    links = [value for _, name, value in page.attributes if name in ("href", "xlink:href", "src")]
    assert links
    assert {link.removeprefix("#") for link in links} <= set(names)
    policy = next(value for tag, name, value in page.attributes if (tag, name) == ("meta", "content"))
    assert policy.startswith("default-src 'none'")
    text = report_html(hostile_report())
    assert "<metadata>" not in text
    assert not re.search(r"""(src|href)=["']?(https?:|//|data:)""", text)


def test_titles_of_columns_have_lines_and_words_are_left(page):
    text = report_html(Report("a", (Table("t", ("x", "two\nlines"), [("words", "1")]),)))
    assert '<th scope="col">two<br>lines</th>' in text
    assert "<td class=w>words</td><td>1</td>" in text


def test_verdicts_have_a_colour_in_light_and_in_dark():
    rows = [("a", "pass"), ("b", "FAIL"), ("c", "unknown")]
    text = report_html(
        Report(
            "a", (Paragraph("2 of 3", strong=True, passed=False), Table("t", ("x", "y"), rows, verdicts=True))
        )
    )
    assert "<td class=pass>pass</td>" in text
    assert "<td class=fail>FAIL</td>" in text
    assert "<td>unknown</td>" in text
    assert '<p class="strong fail">2 of 3</p>' in text
    assert "prefers-color-scheme: dark" in text
    for verdict in ("pass", "fail"):
        assert text.count(f"--{verdict}: #") == 2  # light and dark
        assert f".{verdict} {{ color: var(--{verdict})" in text


def test_figures_are_a_table_with_their_units():
    known = Figure("Life", "12", "h", "of the drive", 12.0)
    text = report_html(Report("a", (Figures([known]),)))
    assert "<td class=w>Life</td><td class=w>12 h</td><td class=w>of the drive</td>" in text


def test_a_warning_says_what_it_means_and_what_to_do():
    warned = Warned("damage", "Damage", "it is hot", ("it melts", "it burns"), "cool it")
    open_ = Warned("damage", "Not checked", "life 2", ("no film",), "")
    text = report_html(Report("a", (Warnings([warned, open_]),)))
    assert "<li><strong>Damage: it is hot</strong>. It melts; it burns. What to do: cool it.</li>" in text
    assert "<li><strong>Not checked: life 2</strong>. No film.</li>" in text


def test_a_notebook_gets_the_same_blocks_with_their_words_at_the_left():
    blocks = (Paragraph("a < b", strong=True), Table("t", ("x", "y"), [("words", "1")]))
    page = Reader(notebook_html(blocks))
    assert page.texts["p"] == "a < b"
    assert not {"html", "h1", "script"} & set(page.tags)
    text = notebook_html(blocks)
    assert "<td class=w>words</td><td>1</td>" in text
    assert ".asperity .w { text-align: left; }" in text
