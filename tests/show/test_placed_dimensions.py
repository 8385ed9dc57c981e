"""Dimensions of a view: each shown once, or reported as without room."""

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.show.box import Box
from asperity.show.drive_sizes import drive_clearances, sizes
from asperity.show.drive_view import drive_view, reach_of
from asperity.show.placed_dimensions import place_dimensions, room_of_dimensions
from asperity.show.sheet import Circle, Text
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Taken


@pytest.fixture
def placed(planar_case):
    def place(name, paper, listed=frozenset(), scale=1.0):
        joint = joint_from_case(planar_case(name))
        outlines = [
            each for each in drive_view(joint, scale) if isinstance(each, Circle) and each.style == "outline"
        ]
        found = place_dimensions(
            sizes(joint, scale),
            drive_clearances(joint),
            outlines,
            view=Box(-reach_of(joint), reach_of(joint), -reach_of(joint), reach_of(joint)),
            paper=paper,
            taken=Taken(scale, paper),
            listed=listed,
        )
        return sizes(joint, scale), found, [item.text for item in found.items if isinstance(item, Text)]

    return place


WIDE = Box(-150.0, 150.0, -100.0, 100.0)


@pytest.mark.parametrize(
    "name", ["planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar", "wheel_pair"]
)
@pytest.mark.parametrize(
    "paper",
    [WIDE, Box(-75.0, 130.0, -95.0, 80.0), Box(-66.0, 66.0, -66.0, 66.0), Box(-60.0, 150.0, -20.0, 20.0)],
)
def test_every_size_is_shown_once_or_reported(placed, name, paper):
    wanted, found, texts = placed(name, paper)
    for number, size in enumerate(wanted):
        assert texts.count(size.label) == (number not in found.unplaced), size.label
    assert len(texts) == len(wanted) - len(found.unplaced) + len(found.letters)
    if paper is WIDE:
        assert [wanted[number].label for number in found.unplaced] == (
            ["wall of ring 30"] if name == "planetary_hollow" else []
        )
    if paper.right < 70.0:
        assert found.unplaced


def test_what_the_list_says_is_not_shown(placed):
    _, found, texts = placed("planetary", WIDE, listed=frozenset({0, 3}))
    assert "sun ⌀20" not in texts
    assert "ring inside ⌀100" not in texts
    assert not found.unplaced


def test_the_smallest_clearances_have_letters(placed):
    """Planets 3.311 apart, right and left roller of a planet 6.845, planets 9 from the ring."""
    _, found, texts = placed("planar", WIDE)
    assert found.letters == {0: "A", 1: "B", 2: "C"}
    assert {"A 3.311", "B 6.845", "C 9"} <= set(texts)


def test_the_room_beside_a_view_is_that_of_its_longest_texts(planar_case):
    """Below it one dimension line, whose text fits between its ends; on the left the clearances."""
    joint = joint_from_case(planar_case("planetary"))
    wanted, gaps = sizes(joint, 1.0), drive_clearances(joint)
    left, right, below = room_of_dimensions(wanted, gaps, frozenset(), right=58.0, scale=1.0)
    assert right > text_width("axes of planet ⌀60")
    assert left > text_width("A 11.96")
    assert 7.0 < below < 14.0
    every = frozenset(range(len(wanted)))
    assert room_of_dimensions(wanted, [], every, right=58.0, scale=1.0) == (0.0, 0.0, 0.0)
