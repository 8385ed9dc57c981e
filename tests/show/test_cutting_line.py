"""The cutting line of a drive: through centres, from outside to outside, its arrows towards the section."""

import math
from itertools import pairwise

import numpy as np
import pytest

from asperity.joint_file.build import joint_from_case
from asperity.show.cutting_line import cutting_marks, cutting_path, is_bent
from asperity.show.section_view import drive_section
from asperity.show.sheet import Line, Text

NAMES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "zou2025", "planar", "wheel_pair")


@pytest.fixture
def joint(planar_case):
    return lambda name: joint_from_case(planar_case(name))


def test_the_path_of_a_planetary_goes_through_a_planet_the_sun_and_another_planet(joint):
    """58 mm to the outside of the ring; planets on 30 mm, at 90 and at 210 degrees."""
    down = (math.cos(math.radians(210.0)), math.sin(math.radians(210.0)))
    wanted = [(0.0, 58.0), (0.0, 30.0), (0.0, 0.0), *((far * down[0], far * down[1]) for far in (30.0, 58.0))]
    np.testing.assert_allclose(cutting_path(joint("planetary")), wanted, atol=1e-9)


def test_the_path_of_wheels_ends_beyond_both(joint):
    np.testing.assert_allclose(
        cutting_path(joint("wheel_pair")), [(0.0, 100.0), (0.0, 60.0), (0.0, 0.0), (0.0, -20.0)], atol=1e-9
    )
    assert not is_bent(cutting_path(joint("wheel_pair")))


@pytest.mark.parametrize("name", NAMES)
def test_the_section_is_as_high_as_the_path_is_long(joint, name):
    """Developed into one plane, from the axis of the outermost rollers to that of the drive."""
    path = cutting_path(joint(name))
    half = path[1 : len(path) // 2 + 1]
    last = max(drive_section(joint(name), 1.0).axes)
    assert sum(math.dist(*ends) for ends in pairwise(half)) == pytest.approx(last)
    if joint(name).drive.sectors > 1:
        assert len(path) % 2 == 1
        assert math.dist(path[0], (0.0, 0.0)) == pytest.approx(math.dist(path[-1], (0.0, 0.0)))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("scale", [0.5, 2.0])
def test_the_ends_lie_outside_the_view_with_an_arrow_and_a_letter_each(joint, name, scale):
    made = joint(name)
    marks, path = cutting_marks(made, scale), cutting_path(made)
    lines = [mark for mark in marks if isinstance(mark, Line) and len(mark.points) == 2]
    ends = [line for line in lines if line.style == "outline"]
    arrows = [line for line in lines if line.arrows == "end"]
    assert [mark.text for mark in marks if isinstance(mark, Text)] == ["A", "A"]
    for end, arrow, at, inner in zip(ends, arrows, (path[0], path[-1]), (path[1], path[-2]), strict=True):
        outward = np.subtract(at, inner)
        assert np.dot(np.subtract(end.points[0], at), outward) > 0.0
        assert arrow.points[1] == pytest.approx(end.points[1])  # its tip
        along = np.subtract(arrow.points[1], arrow.points[0])
        assert np.dot(along, outward) == pytest.approx(0.0, abs=1e-9)
    assert arrows[0].points[1][0] < arrows[0].points[0][0]  # to the left, where the section stands
