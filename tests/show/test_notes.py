"""Notes: no line too wide, no letter lost, columns of nearly one length."""

import pytest

from asperity.show.notes import columns_of, wrapped
from asperity.show.sheet_figure import text_width


@pytest.mark.parametrize(
    "text",
    ["sp: sun – planet", "the right hand loading roller of hardened steel: ⌀10, axes on ⌀70", "x" * 90, "ab_" * 40,
     "–  left to left 50.62", ""],
)  # fmt: skip
@pytest.mark.parametrize("width", [40.0, 87.0])
def test_no_line_is_too_wide_and_no_letter_is_lost(text, width):
    lines = wrapped(text, width)
    assert all(text_width(line) <= width for line in lines)
    assert "".join("".join(lines).split()) == "".join(text.split())


def test_lines_break_between_words_and_names():
    assert wrapped("a roller on pins", 20.0) == ["a roller on", "   pins"]
    assert all(line.endswith("_") for line in wrapped("loading_" * 8, 60.0))


NOTES = [
    "ratio 6",
    "",
    "Clearances",
    "A  planet to planet 11.96",
    "",
    "Contacts, length 10",
    "sp: sun – planet",
    "x" * 60,
]


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_columns_have_every_line_once_and_begin_with_words(count):
    columns = columns_of(NOTES, 60.0, count)
    assert len(columns) <= count
    together = "".join("".join("".join(column).split()) for column in columns)
    assert together == "".join("".join(NOTES).split())
    for column in columns:
        assert column[0].strip()
        assert not column[0].startswith("   ")
        assert column[-1].strip() not in ("", "Clearances", "Contacts, length 10")


def test_columns_are_of_nearly_one_length():
    columns = columns_of([f"line {number}" for number in range(31)], 60.0, 3)
    assert [len(column) for column in columns] == [11, 11, 9]
