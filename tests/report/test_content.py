"""What a report consists of: its sections are its headings, in their order."""

import math

from asperity.report.content import Bullets, Heading, Paragraph, Report, Table, number, percent, quantity


def test_sections_are_the_headings_in_order():
    blocks = (
        Heading("Input"),
        Paragraph("a sentence"),
        Table("sizes", ("part", "mm"), [("sun", "4")]),
        Heading("Results"),
        Bullets(["one"]),
    )
    assert Report("title", blocks).sections == ("Input", "Results")
    assert Report("title", ()).sections == ()


def test_quantities_numbers_and_shares():
    assert quantity(1.4e-5, "um") == "14 µm"
    assert quantity(0.4363323, "deg", 3) == "25 deg"
    assert (number(2.5e-3, 1e3), number(3.0)) == ("2.5", "3")
    assert percent(0.125) == "12.5 %"


def test_what_is_infinite_is_a_word_without_a_unit():
    assert {quantity(math.inf, "h"), number(math.inf), percent(math.inf)} == {"infinite"}


def test_what_is_absent_is_a_dash():
    absent = (
        quantity(None, "N"),
        quantity(math.nan, "N"),
        number(None, 1e6),
        number(math.nan),
        percent(None),
    )
    assert set(absent) == {"–"}
