"""The view of a drive: rings as drawn, copies in all sectors, names of contacts beside their points."""

import math

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.show.box import Box, text_box
from asperity.show.drive_view import (
    copies_of,
    drive_view,
    radii_of,
    reach_of,
    rings_of,
    write_contact_names,
)
from asperity.show.sheet import Line, Text
from asperity.show.taken import Taken


@pytest.fixture
def joint(planar_case):
    return lambda name: joint_from_case(planar_case(name))


def test_rings_have_the_walls_of_the_file_and_break_where_they_are_thick(joint):
    """10 + 2 · 20 and 10 + 20 + 18 mm inside, walls of 10 mm; 30 mm around 50 mm are broken off at 60 mm."""
    held, driven = rings_of(joint("stepped_planet"))
    assert held[1:] == pytest.approx((50.0, 60.0, 60.0))
    assert driven[1:] == pytest.approx((48.0, 58.0, 58.0))
    assert reach_of(joint("stepped_planet")) == pytest.approx(60.0)
    (broken,) = rings_of(joint("planetary_hollow"))
    assert broken[1:] == pytest.approx((50.0, 80.0, 60.0))


def test_copies_lie_around_the_axis_and_tracks_are_said_once(joint):
    """The first row: s + x_1 = 26 mm from the axis, tracks of 16 and 10 mm."""
    multiroller = joint("multiroller")
    copies = copies_of(multiroller, 1)
    assert [math.hypot(*each) for each in copies] == pytest.approx([26.0] * 4)
    assert copies[1] == pytest.approx((-26.0, 0.0), abs=1e-9)
    assert copies_of(multiroller, 0) == [pytest.approx((0.0, 0.0))]
    assert radii_of(multiroller, 1) == pytest.approx([16.0, 10.0])


@pytest.mark.parametrize("name", ["planetary", "multiroller", "stepped_planet", "planar", "wheel_pair"])
@pytest.mark.parametrize("scale", [0.2, 1.0, 2.0])
def test_names_begin_at_their_contacts_and_cover_neither_each_other_nor_their_points(joint, name, scale):
    drawn, paper = joint(name), Box(-1e4, 1e4, -1e4, 1e4)
    items = write_contact_names(drawn, drive_view(drawn, scale), Taken(scale, paper))
    lines, texts = items[::2], items[1::2]
    assert [text.text for text in texts] == [contact.name for contact in drawn.drive.contacts]
    boxes = [text_box(text, scale) for text in texts]
    for index, box in enumerate(boxes):
        assert not any(box.meets(other) for other in boxes[index + 1 :])
        assert not any(
            box.left < x < box.right and box.low < y < box.high for x, y in (o.points[0] for o in lines)
        )
    assert isinstance(lines[0], Line)
    if name == "planetary":  # between sun and planet, and between planet and ring
        assert lines[0].points[0] == pytest.approx((0.0, 10.0), abs=1e-9)
        assert lines[1].points[0] == pytest.approx((0.0, 50.0), abs=1e-9)


def test_a_long_name_is_shortened_in_the_view(joint, planar_case):
    case = planar_case("planar", replaced={'name = "sp"': 'name = "contact_of_sun_and_planet"'})
    drawn = joint_from_case(case)
    items = write_contact_names(drawn, drive_view(drawn, 1.0), Taken(1.0, Box(-99.0, 99.0, -99.0, 99.0)))
    assert items[1] == Text(items[1].at, "contact_…_planet", items[1].align)
