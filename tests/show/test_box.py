"""Boxes around what is drawn, and the area that several cover together."""

import pytest

from asperity.show.box import Box, around_all, box_of, covered
from asperity.show.sheet import Circle, Line, Text
from asperity.show.sheet_figure import text_width


def test_boxes_around_items():
    assert box_of(Circle((1.0, 2.0), 3.0), 1.0) == (-2.0, 4.0, -1.0, 5.0)
    assert box_of(Line(((0.0, 5.0), (2.0, 1.0), (1.0, 7.0))), 1.0) == (0.0, 2.0, 1.0, 7.0)
    text = box_of(Text((0.0, 0.0), "abc"), 2.0)
    assert text.left < 0.0 < 0.5 * text_width("abc") < text.right
    assert text.low < 0.0 < 1.25 < text.high
    assert around_all([Box(0.0, 1.0, 0.0, 1.0), Box(5.0, 6.0, -2.0, 0.5)]) == (0.0, 6.0, -2.0, 1.0)


@pytest.mark.parametrize(
    ("boxes", "area"),
    [
        ([], 0.0),
        ([Box(0.0, 2.0, 0.0, 3.0)], 6.0),
        ([Box(0.0, 2.0, 0.0, 3.0), Box(0.0, 2.0, 0.0, 3.0)], 6.0),
        ([Box(0.0, 2.0, 0.0, 3.0), Box(5.0, 6.0, 5.0, 9.0)], 10.0),  # apart
        ([Box(0.0, 2.0, 0.0, 2.0), Box(1.0, 3.0, 1.0, 3.0)], 7.0),  # one square in common
        ([Box(0.0, 9.0, 0.0, 9.0), Box(1.0, 3.0, 1.0, 3.0)], 81.0),  # one within the other
    ],
)
def test_what_several_boxes_cover_is_counted_once(boxes, area):
    assert covered(boxes) == pytest.approx(area)
