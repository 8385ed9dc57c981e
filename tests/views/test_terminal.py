"""Blocks on a terminal: no number is cut, words wrap, texts neither style nor control it."""

import io
import re

import pytest
from rich.console import Console

from asperity.views.blocks import (
    Bullets,
    Figure,
    Figures,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Table,
    Warned,
    Warnings,
)
from asperity.views.screens import joint_screen, rolling_screen
from asperity.views.terminal import WIDEST, console_on, fitting, plain_text, show


def shown(*blocks, width=WIDEST, encoding="utf-8"):
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding=encoding, errors="strict")
    target = console_on(stream)
    target.width = width
    show(target, blocks)
    stream.flush()
    return raw.getvalue().decode(encoding)


def wide_table(columns):
    head = ("contact", *(f"quantity {k}\nN·m" for k in range(columns)))
    rows = [
        (name, *(f"{1000 * number + k}.5" for k in range(columns)))
        for number, name in enumerate(("sp", "wro"))
    ]
    return Table("Contacts", head, rows)


def test_a_table_that_fits_is_one():
    table = wide_table(3)
    assert list(fitting(table, WIDEST)) == [table]


@pytest.mark.parametrize("width", [100, 60, 40])
@pytest.mark.parametrize("columns", [8, 15])
def test_a_table_too_wide_stands_in_parts_that_begin_with_the_names(width, columns):
    table = wide_table(columns)
    parts = list(fitting(table, width))
    assert [part.title for part in parts] == ["Contacts"] + ["Contacts (continued)"] * (len(parts) - 1)
    assert all([row[0] for row in part.rows] == ["sp", "wro"] for part in parts)
    assert all(part.words == (0,) for part in parts)
    for place in range(2):  # every number once, in order
        assert sum((part.rows[place][1:] for part in parts), ()) == table.rows[place][1:]
    lines = shown(table, width=width).splitlines()
    assert max(map(len, lines)) <= width
    text = "\n".join(lines)
    for row in table.rows:
        for cell in row[1:]:
            assert len(re.findall(rf"(?<![\d.]){re.escape(cell)}(?![\d.])", text)) == 1
    assert "…" not in text


def test_heads_give_way_before_columns_do():
    head = ("contact", *(f"a very long name of the quantity {k}" for k in range(4)))
    table = Table("T", head, [("sp", "1.5", "2.5", "3.5", "4.5")])
    (part,) = fitting(table, 80)
    assert part.rows == table.rows
    assert " ".join(part.head[1].split()) == head[1]
    assert max(len(line) for line in shown(table, width=80).splitlines()) <= 80


def test_long_names_end_their_lines_between_parts_before_columns_move():
    """The change stands beside both values, and what bounds one of them below it."""
    bounded = "30552.2 N·m/rad (upper bound: pins rigid)"
    rows = [("materials.52100.thermal_conductivity", "473 J/kg/K", bounded, "+150 %")]
    table = Table("T", ("number or choice", "wheel_pair.toml", "wedge.toml", "change"), rows)
    (part,) = fitting(table, 80)
    assert part.head == table.head
    assert [cell.replace("\n", "") for cell in part.rows[0][:2]] == list(rows[0][:2])
    assert part.rows[0][0].split("\n")[0][-1] in "._"
    assert part.rows[0][2].replace("\n", " ") == bounded
    assert max(map(len, shown(table, width=80).splitlines())) <= 80


def test_other_columns_of_words_keep_their_place():
    head = ("part", *(f"number {k}" for k in range(12)), "unit")
    table = Table("T", head, [("sun", *("123456.5" for _ in range(12)), "N")], words=(0,))
    parts = list(fitting(table, 60))
    assert len(parts) > 1
    assert parts[-1].head[-1] == "unit"


def test_words_are_wrapped_and_numbers_are_not():
    said = "a sentence of many words that no terminal of sixty letters shows in a single line of its own"
    text = shown(Table("T", ("what", "value"), [(said, "123456.789 N·m")]), width=60)
    assert max(map(len, text.splitlines())) <= 60
    assert "123456.789 N·m" in text
    words = [word for line in text.splitlines() for word in line.replace("123456.789 N·m", "").split()]
    assert " ".join(words).endswith(said)


def test_a_real_joint_fits_narrow_terminals(paper_view, planetary_view):
    """Every number of the tables of contacts, whole, in 60 letters."""
    for view in (paper_view, planetary_view):
        for screen in (joint_screen, rolling_screen):
            blocks = list(screen(view, "a.toml"))
            text = shown(*blocks, width=60)
            assert "…" not in text
            assert max(map(len, text.splitlines())) <= 60
            words = set(text.split())
            for block in blocks:
                if isinstance(block, Table) and block.head[0] == "contact":
                    assert {cell for row in block.rows for cell in row if " " not in cell} <= words


def test_plain_text_has_no_colours_and_no_spaces_at_the_ends(paper_view):
    text = plain_text(joint_screen(paper_view, "a.toml"))
    assert "\x1b" not in text
    assert all(line == line.rstrip() for line in text.split("\n"))
    assert not text.endswith("\n")
    assert max(map(len, text.split("\n"))) <= WIDEST


def test_markup_in_texts_is_no_style():
    mark = "[bold]loud[/bold] [red]x"
    figure = Figure(mark, "1", "N", mark, 1.0)
    warned = Warned("damage", mark, mark, (mark,), mark)
    text = shown(
        Heading(mark),
        Paragraph(mark),
        Bullets([mark]),
        Figures([figure]),
        Table(mark, (mark, "radius [mm]"), [(mark, "2")]),
        Warnings([warned]),
        Listing(mark),
        width=200,
    )
    assert text.count(mark) == 1 + 1 + 1 + 2 + 3 + 4 + 1
    assert "radius [mm]" in text


def test_control_characters_are_written_out():
    evil = "a\x1b[31mred\x07"
    text = shown(
        Heading(evil),
        Paragraph(evil),
        Bullets([evil]),
        Table(evil, (evil, "b"), [(evil, "2")]),
        Listing(evil),
    )
    assert "\x1b" not in text
    assert "\x07" not in text
    assert text.count(r"a\x1b[31mred\x07") == 7


def test_without_unicode_there_are_no_rules():
    table = Table("T", ("contact", "force"), [("sp", "1.5")])
    lines = shown(table, Paragraph("next"), encoding="ascii").splitlines()
    assert [line.split() for line in lines] == [["T"], ["contact", "force"], ["sp", "1.5"], [], ["next"], []]
    assert "─" in shown(table)


def test_verdicts_have_colours_on_a_terminal_only():
    table = Table(
        "T", ("limit", "result"), [("slip", "pass"), ("yield", "FAIL"), ("life", "unknown")], verdicts=True
    )
    stream = io.StringIO()
    show(Console(file=stream, force_terminal=True, width=80, color_system="standard"), [table])
    colours = dict(re.findall(r"\x1b\[([\d;]+)m(pass|FAIL|unknown)", stream.getvalue()))
    assert set(colours.values()) == {"pass", "FAIL"}
    assert len(colours) == 2
    assert "\x1b" not in shown(table)


def test_a_warning_says_what_it_means_and_what_to_do():
    warned = Warned("damage", "Damage", "it is hot", ("it melts", "it burns"), "cool it")
    open_ = Warned("damage", "Not checked", "life 2", ("no film",), "")
    assert [line.rstrip() for line in shown(Warnings([warned, open_])).splitlines()] == [
        "Warnings, most serious first",
        "  Damage: it is hot",
        "    it melts",
        "    it burns",
        "    What to do: cool it",
        "  Not checked: life 2",
        "    no film",
        "",
    ]


def test_pictures_are_for_other_screens_and_listings_letter_by_letter():
    listing = "a = 1   # " + 30 * "long "
    text = shown(Picture("a drawing", "<svg/>"), Listing(listing), width=60)
    assert "drawing" not in text
    assert text.splitlines()[0].rstrip() == listing.rstrip()
