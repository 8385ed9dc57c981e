"""Places of leaders: on the outline, where they are short and free; none where nothing is free."""

import math

import numpy as np
import pytest

from asperity.show.leader_places import Place, Side, around, best_leader, crossings, levels
from asperity.show.sheet import Circle, Line, Text
from asperity.show.taken import Box, Taken

PAPER = Box(-100.0, 100.0, -50.0, 50.0)
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
        Taken(1.0, PAPER),
    )
    assert isinstance(line, Line)
    assert math.hypot(*line.points[0]) == pytest.approx(20.0)
    assert line.points[0][0] > 19.0
    assert abs(line.points[0][1] - line.points[1][1]) < 1.5
    assert text == Text((41.0, line.points[2][1] - 1.2), "sun ⌀40", "left")


def test_the_other_side_where_one_is_taken_and_nothing_where_both_are():
    taken = Taken(1.0, PAPER)
    taken.add_box(Box(35.0, 100.0, -50.0, 50.0))
    places = around((0.0, 0.0), 20.0, 0.0, 24)
    found = best_leader("sun ⌀40", places, (RIGHT, LEFT), [Circle((0.0, 0.0), 20.0)], taken)
    assert found[-1].align == "right"
    assert found[0].points[0][0] < 0.0
    taken.add_box(Box(-100.0, -35.0, -50.0, 50.0))
    assert best_leader("sun ⌀40", places, (RIGHT, LEFT), [], taken) is None


def test_leaders_do_not_meet():
    taken, found = Taken(1.0, PAPER), []
    for radius in (20.0, 15.0, 10.0, 5.0):
        items = best_leader(f"⌀{radius}", around((0.0, 0.0), radius, 0.0, 24), (RIGHT,), [], taken)
        taken.add(items)
        found.append(items)
    assert len({items[-1].at for items in found}) == 4
    for index, items in enumerate(found):
        other = Taken(1.0, PAPER)
        for each in found[:index] + found[index + 1 :]:
            other.add(each)
        assert other.has_room(items)


def test_a_mark_is_drawn_with_its_leader_and_takes_the_place_of_the_arrow():
    mark = Line(((0.0, -5.0), (0.0, 5.0)), arrows="both")
    found = best_leader("wall 10", [Place((0.0, 0.0), None, (mark,))], (RIGHT,), [], Taken(1.0, PAPER))
    assert found[0] == mark
    assert (found[1].points[0], found[1].arrows) == ((0.0, 0.0), "")
