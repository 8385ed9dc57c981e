"""Numbers as all views write them."""

import math

from asperity.views.numbers import (
    number,
    number_in,
    percent,
    quantity,
    sentence,
    unit_words,
    words,
)


def test_numbers_have_four_digits():
    assert [number(30665.4), number(0.0123456), number(3.0)] == ["30665", "0.01235", "3"]
    assert [number(2.5e-3, 1e3), number(1.25, digits=2)] == ["2.5", "1.2"]


def test_quantities_have_their_unit():
    assert quantity(1.4e-5, "um") == "14 µm"
    assert quantity(0.4363323, "deg", 3) == "25 deg"
    assert (quantity(0.004, "mm"), number_in(0.004, "mm")) == ("4 mm", "4")
    assert (percent(0.125), number_in(0.125, "%")) == ("12.5 %", "12.5")


def test_what_is_absent_is_a_dash():
    absent = (
        quantity(None, "N"),
        quantity(math.nan, "N"),
        number(None, 1e6),
        number(math.nan),
        number_in(None, "mm"),
        percent(None),
    )
    assert set(absent) == {"–"}


def test_what_is_infinite_is_a_word_without_a_unit():
    assert {quantity(math.inf, "h"), number(math.inf), percent(math.inf), number_in(math.inf, "h")} == {
        "infinite"
    }
    assert quantity(-math.inf, "N") == "-infinite"


def test_units_as_people_write_them():
    assert [unit_words(unit) for unit in ("1", "um", "N*m/rad", "mm^2", "N/um")] == [
        "", "µm", "N·m/rad", "mm²", "N/µm",
    ]  # fmt: skip


def test_names_and_sentences():
    assert words("driving_ring") == "driving ring"
    assert [sentence("it slips"), sentence("as it is:")] == ["It slips.", "As it is:"]
