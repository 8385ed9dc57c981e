"""What is taken on a sheet: boxes of texts, lines that are crossed, distances between lines."""

import math

import numpy as np
import pytest

from asperity.show.sheet import Circle, Line, Text
from asperity.show.sheet_figure import text_width
from asperity.show.taken import (
    Box,
    Place,
    Side,
    Taken,
    around,
    best_leader,
    crossings,
    distance,
    levels,
    text_box,
)

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


LOW_PAPER = Box(-100.0, 100.0, -50.0, 50.0)
RIGHT = Side(40.0, "left", levels(-50.0, 50.0, 1.0))
LEFT = Side(-40.0, "right", levels(-50.0, 50.0, 1.0))


def test_levels_lie_in_steps_beside_the_axis():
    assert levels(-5.0, 5.0, 1.0) == (3.75, 1.25, -1.25, -3.75)
    assert levels(-5.0, 5.0, 2.0)[:2] == (4.375, 3.125)


def test_places_around_a_circle_avoid_its_axes():
    found = around((3.0, 4.0), 5.0, 0.0, 12)
    assert len(found) == 12
    for place in found:
        assert math.dist(place.tip, (3.0, 4.0)) == pytest.approx(5.0)
        assert min(abs(each) for each in place.outward) > 0.2


def test_lines_cross_circles():
    """Past it, through it, into it, within it, and along its diameter's continuation."""
    starts = np.array([[-5.0, 3.0], [-5.0, 0.0], [-5.0, 0.0], [-1.0, 0.0], [3.0, 0.0]])
    ends = np.array([[5.0, 3.0], [5.0, 0.0], [0.0, 0.0], [1.0, 0.0], [5.0, 0.0]])
    found = crossings(starts, ends, np.array([[0.0, 0.0]]), np.array([2.0]))
    assert found.tolist() == [0, 2, 1, 0, 0]


def test_a_leader_goes_level_from_the_near_side_of_its_circle():
    circle = Circle((0.0, 0.0), 20.0)
    line, text = best_leader(
        "sun ⌀40",
        around((0.0, 0.0), 20.0, 0.0, 24),
        (RIGHT, LEFT._replace(handicap=5.0)),
        [circle],
        Taken(1.0, LOW_PAPER),
    )
    assert isinstance(line, Line)
    assert math.hypot(*line.points[0]) == pytest.approx(20.0)
    assert line.points[0][0] > 19.0
    assert abs(line.points[0][1] - line.points[1][1]) < 1.5
    assert text == Text((41.0, line.points[2][1] - 1.2), "sun ⌀40", "left")


def test_the_other_side_where_one_is_taken_and_nothing_where_both_are():
    taken = Taken(1.0, LOW_PAPER)
    taken.add_box(Box(35.0, 100.0, -50.0, 50.0))
    places = around((0.0, 0.0), 20.0, 0.0, 24)
    found = best_leader("sun ⌀40", places, (RIGHT, LEFT), [Circle((0.0, 0.0), 20.0)], taken)
    assert found[-1].align == "right"
    assert found[0].points[0][0] < 0.0
    taken.add_box(Box(-100.0, -35.0, -50.0, 50.0))
    assert best_leader("sun ⌀40", places, (RIGHT, LEFT), [], taken) is None


def test_leaders_do_not_meet():
    taken, found = Taken(1.0, LOW_PAPER), []
    for radius in (20.0, 15.0, 10.0, 5.0):
        items = best_leader(f"⌀{radius}", around((0.0, 0.0), radius, 0.0, 24), (RIGHT,), [], taken)
        taken.add(items)
        found.append(items)
    assert len({items[-1].at for items in found}) == 4
    for index, items in enumerate(found):
        other = Taken(1.0, LOW_PAPER)
        for each in found[:index] + found[index + 1 :]:
            other.add(each)
        assert other.has_room(items)


def test_a_mark_is_drawn_with_its_leader_and_takes_the_place_of_the_arrow():
    mark = Line(((0.0, -5.0), (0.0, 5.0)), arrows="both")
    found = best_leader("wall 10", [Place((0.0, 0.0), None, (mark,))], (RIGHT,), [], Taken(1.0, LOW_PAPER))
    assert found[0] == mark
    assert (found[1].points[0], found[1].arrows) == ((0.0, 0.0), "")
