"""Paper: formats of ISO 5457, scales of ISO 5455, points on paper in true size."""

import math
from itertools import pairwise

import pytest

from asperity.show.box import Box
from asperity.show.paper import FORMATS, SCALES, Paper, extended_scale
from asperity.show.sheet import Circle, Text, scale_text
from asperity.show.title_block import Title

#: ISO 5455:1979, table.
STATED = {
    *("50:1", "20:1", "10:1", "5:1", "2:1", "1:1", "1:2", "1:5", "1:10", "1:20", "1:50", "1:100", "1:200", "1:500"),
    *("1:1000", "1:2000", "1:5000", "1:10000"),
}  # fmt: skip


def test_scales_are_those_of_the_standard_from_the_largest_on():
    assert {scale_text(scale) for scale in SCALES} == STATED
    assert all(one > other for one, other in pairwise(SCALES))


def test_each_format_is_twice_the_one_before_it_and_of_one_shape():
    """A4 to A0: 1/16 m² to 1 m², sides in the ratio of the root of two, to a millimetre."""
    across = FORMATS[1:]
    for smaller, larger in pairwise(across):
        assert (larger.height, larger.width) == pytest.approx((smaller.width, 2.0 * smaller.height), abs=1.0)
    assert across[-1].width * across[-1].height == pytest.approx(1e6, rel=1e-3)
    assert [form.width / form.height for form in across] == pytest.approx([math.sqrt(2.0)] * 5, rel=5e-3)
    assert (FORMATS[0].width, FORMATS[0].height) == (across[0].height, across[0].width)


def test_points_of_paper_in_true_size_and_back():
    paper = Paper(297.0, 210.0, (100.0, 50.0), 2.0)
    assert paper.at(110.0, 50.0) == (5.0, 0.0)
    assert paper.box(Box(100.0, 110.0, 40.0, 50.0)) == (0.0, 5.0, -5.0, 0.0)
    assert paper.boxed([Circle((1.0, 2.0), 3.0)]) == (96.0, 108.0, 48.0, 60.0)
    assert paper.title_box == (192.0, 287.0, 10.0, 48.0)


@pytest.mark.parametrize(
    ("size", "room", "scale"),
    [(104.0, 150.0, 1.0), (75.0, 150.0, 2.0), (151.0, 150.0, 0.5), (1e8, 821.0, 5e-6), (0.002, 105.0, 5e4)],
)
def test_scales_go_on_by_powers_of_ten(size, room, scale):
    assert extended_scale(size, room=room) == pytest.approx(scale)


def test_the_block_has_the_width_that_the_paper_says():
    narrow, wide = (Paper(420.0, 297.0, (0.0, 0.0), 1.0, width) for width in (95.0, 180.0))
    lefts = [
        min(item.at[0] for item in paper.block("a", "b", Title()) if isinstance(item, Text))
        for paper in (narrow, wide)
    ]
    assert lefts[0] - lefts[1] == pytest.approx(85.0)
