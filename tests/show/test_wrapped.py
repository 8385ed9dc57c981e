"""Lines of a column: between words, within long words, nothing lost."""

import pytest

from asperity.show.sheet_figure import text_width
from asperity.show.wrapped import wrapped


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
