"""A sheet: standard scales and the window that the paper shows."""

import pytest

from asperity.show.sheet import (
    ARROW_LENGTH,
    LINE_WIDTHS,
    TEXT_HEIGHT,
    TITLE_HEIGHT,
    Sheet,
    Text,
    scale_text,
)


@pytest.mark.parametrize(
    ("scale", "words"),
    [(1.0, "1:1"), (2.0, "2:1"), (0.5, "1:2"), (0.2, "1:5"), (0.01, "1:100"), (50.0, "50:1")],
)
def test_scales_are_said_as_drawings_do(scale, words):
    assert scale_text(scale) == words


def test_window_is_the_paper_in_true_size():
    sheet = Sheet(297.0, 210.0, 2.0, (100.0, 50.0), (Text((0.0, 0.0), "a"),))
    assert sheet.window == (-50.0, 98.5, -25.0, 80.0)
    assert sheet.texts == ("a",)


def test_lines_and_letters_are_of_the_standard_series():
    """ISO 128: widths in steps of the root of two, outlines twice the narrow lines; ISO 3098 likewise."""
    series = (0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.5, 3.5, 5.0)
    assert set(LINE_WIDTHS.values()) | {TEXT_HEIGHT, TITLE_HEIGHT, ARROW_LENGTH} <= set(series)
    assert LINE_WIDTHS["outline"] >= 2.0 * max(LINE_WIDTHS[style] for style in ("thin", "axis", "break"))
