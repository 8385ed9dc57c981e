"""What is taken on a sheet: boxes of texts, lines that are crossed, distances between lines."""

import pytest

from asperity.show.sheet import Circle, Line, Text
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Box, Taken, distance, text_box

PAPER = Box(-100.0, 100.0, -100.0, 100.0)


@pytest.mark.parametrize(
    ("line", "apart"),
    [
        (((0.0, 1.0), (10.0, 1.0)), 1.0),  # beside it
        (((13.0, 4.0), (20.0, 4.0)), 5.0),  # beyond its end: 3, 4, 5
        (((5.0, -1.0), (5.0, 1.0)), 0.0),  # across it
    ],
)
def test_distance_from_a_line_of_ten(line, apart):
    assert distance(((0.0, 0.0), (10.0, 0.0)), line) == pytest.approx(apart)


def test_a_line_crosses_a_box_or_passes_it():
    box = Box(0.0, 2.0, 0.0, 1.0)
    assert box.is_crossed_by((-1.0, 0.5), (3.0, 0.5))
    assert box.is_crossed_by((1.0, 0.5), (1.2, 0.5))  # inside
    assert box.is_crossed_by((1.0, -5.0), (1.0, 5.0))
    assert not box.is_crossed_by((-1.0, 2.0), (3.0, 2.0))
    assert not box.is_crossed_by((-1.0, 0.5), (-0.1, 0.5))  # ends before it
    assert not box.is_crossed_by((-1.0, 0.0), (0.0, 1.5))  # past its corner


@pytest.mark.parametrize("scale", [0.2, 1.0, 5.0])
def test_box_of_a_text_has_its_size_on_paper_at_every_scale(scale):
    wide = text_width("planet")
    for align, begin in (("left", 0.0), ("center", -0.5 * wide), ("right", -wide)):
        box = text_box(Text((3.0, 4.0), "planet", align), scale)
        assert box.left <= 3.0 + begin / scale
        assert 3.0 + (begin + wide) / scale <= box.right
        assert (box.right - box.left) * scale < wide + 2.0
        assert box.low < 4.0 < 4.0 + 2.5 / scale < box.high


def test_texts_need_room_and_leaders_keep_apart():
    taken = Taken(1.0, PAPER)
    taken.add([Text((0.0, 0.0), "sun"), Line(((0.0, 20.0), (50.0, 20.0))), Circle((0.0, 0.0), 30.0)])
    taken.add([Line(((0.0, -20.0), (50.0, -20.0)))], crossable=True)
    assert taken.has_room([Text((30.0, 0.0), "planet"), Line(((20.0, 0.0), (20.0, 19.0)))])  # over an outline
    assert not taken.has_room([Text((2.0, 1.0), "planet")])  # on the text
    assert not taken.has_room([Text((99.0, 0.0), "planet")])  # beyond the paper
    assert not taken.has_room([Text((10.0, 19.0), "planet")])  # on the line
    assert not taken.has_room([Text((10.0, -21.0), "planet")])
    assert not taken.has_room([Line(((-5.0, 1.0), (30.0, 1.0)))])  # through the text
    assert not taken.has_room([Line(((0.0, 20.5), (50.0, 20.5)))])  # half a millimetre from a line
    assert taken.has_room([Line(((40.0, -30.0), (40.0, -10.0)))])  # across a line that may be crossed


def test_areas_of_bodies_are_taken_as_a_whole():
    taken = Taken(1.0, PAPER)
    taken.add_areas([Circle((0.0, 0.0), 30.0)])
    taken.add_box(Box(50.0, 60.0, 0.0, 10.0))
    assert not taken.has_room([Text((10.0, 0.0), "a")])
    assert not taken.has_room([Text((55.0, 5.0), "a")])
    assert taken.has_room([Text((40.0, 5.0), "a")])
