"""The title block: what is stated, dashes for the rest, and texts that stay in their cells."""

from itertools import pairwise

import pytest

from asperity.show.sheet import Circle, Text
from asperity.show.sheet_figure import text_width
from asperity.show.title_block import BLOCK_HEIGHT, MARGIN, Title, fitted, title_block


def block(title, width=297.0, left=192.0):
    return title_block(
        lambda x, y: (x, y), left, width, 1.0, kind="Planetary traction drive", name="a.toml", title=title
    )


def test_what_is_stated_stands_in_its_cell_and_the_rest_is_a_dash():
    texts = [item.text for item in block(Title(project="Wrist", revision="B")) if isinstance(item, Text)]
    said = dict(pairwise(texts))
    assert (said["Project"], said["Revision"], said["Scale"], said["Dimensions"]) == (
        "Wrist",
        "B",
        "1:1",
        "mm",
    )
    assert [said[label] for label in ("Part", "Date", "Material")] == ["–"] * 3


@pytest.mark.parametrize("width", [297.0, 420.0])
def test_long_texts_stay_in_the_block(width):
    long = Title(*("x" * 60 for _ in Title._fields))
    items = block(long, width=width, left=width - 105.0)
    for item in items:
        if isinstance(item, Text):
            assert item.at[0] + text_width(item.text, item.height) < width - MARGIN
            assert MARGIN < item.at[1] < MARGIN + BLOCK_HEIGHT
    assert sum(isinstance(item, Circle) for item in items) == 2  # the symbol of the projection


def test_a_text_that_is_cut_says_so_and_shows_control_characters():
    assert fitted("a" * 200, 20.0).startswith("…a")
    assert text_width(fitted("a" * 200, 20.0)) <= 20.0
    assert "\n" not in fitted("a\nb", 50.0)
    assert "\x1b" not in fitted("a\x1b[31m", 50.0)
