"""Sizes of drives: those of the files, computed by hand, and places on the outlines that have them."""

import math

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.show.drive_sizes import contact_interferences, drive_clearances, sizes
from asperity.show.drive_view import drive_view
from asperity.show.sheet import Circle

# multiroller: s + x_1 = 26; second row by the law of cosines in the triangle of axis, first and second row
FAR = 26.0 / math.sqrt(2.0) + math.sqrt(28.0**2 - 26.0**2 / 2.0)
SIZES = {
    "planetary": ["sun ⌀20", "3 × planet ⌀40", "axes of planet ⌀60", "ring inside ⌀99.94", "wall of ring 8"],
    "planetary_hollow": [
        "sun ⌀20", "3 × planet ⌀40", "3 × planet, bore ⌀26", "axes of planet ⌀60", "ring inside ⌀99.94",
        "wall of ring 30",
    ],
    "multiroller": [
        "sun ⌀20", "4 × first row ⌀32", "4 × first row ⌀20", "axes of first row ⌀52", "4 × second row ⌀36",
        "4 × second row ⌀18.8", f"axes of second row ⌀{2.0 * FAR:.6g}", f"ring inside ⌀{2.0 * (FAR + 9.4 - 0.04):.6g}",
        "wall of ring 12",
    ],
    "stepped_planet": [
        "sun ⌀20", "3 × planet ⌀40", "3 × planet ⌀36", "axes of planet ⌀60", "held ring inside ⌀99.94",
        "wall of held ring 10", "driven ring inside ⌀95.94", "wall of driven ring 10",
    ],
    "planar": [
        "sun ⌀8", "3 × planet ⌀27", "axes of planet ⌀35", "6 × right and left ⌀10", "axes of right and left ⌀70",
        "ring inside ⌀80 less 2 × interference", "wall of ring 20",
    ],
    "zou2025": [
        "sun ⌀8", "3 × planet ⌀27", "axes of planet ⌀35", "6 × right and left loading roller ⌀10",
        "axes of right and left loading roller ⌀70", "ring inside ⌀80 less 2 × interference",
        "wall of ring 60",
    ],
}  # fmt: skip


@pytest.fixture
def joint(planar_case):
    return lambda name: joint_from_case(planar_case(name))


@pytest.mark.parametrize("name", SIZES)
def test_every_size_is_that_of_the_file(joint, name):
    assert [size.label for size in sizes(joint(name), 1.0)] == SIZES[name]


def test_pins_are_drawn_where_the_file_gives_their_diameter(planar_case):
    pins = '[bearings]\npin_friction_coefficient = 0\npin_diameter = "3 mm"\nsun_torque = "0 N*m"\n'
    pins += 'loading_roller_torque = "0 N*m"\ncarrier_torque = "0 N*m"\n\n[model]'
    joint = joint_from_case(planar_case("zou2025", replaced={"[model]": pins}))
    (pin,) = (size for size in sizes(joint, 1.0) if "pin" in size.label)
    assert pin.label == "6 × right and left loading roller, pin ⌀3"
    circles = [item for item in drive_view(joint, 1.0) if isinstance(item, Circle)]
    drawn = [
        circle for circle in circles if circle.style == "outline" and circle.radius == pytest.approx(1.5)
    ]
    assert [math.hypot(*circle.centre) for circle in drawn] == pytest.approx(6 * [35.0])
    # both loading rollers of a planet go round on one circle
    assert [circle.radius for circle in circles if circle.style == "axis"] == pytest.approx([17.5, 35.0])


PRESSED = {'interference = "30 um"': 'preload = "1000 N"'}


def test_a_ring_is_made_smaller_by_its_interference(planar_case):
    """10 + 2 · 20 = 50 mm, less 30 µm; less 0.012345 µm to a hundredth of it; stated rings stay."""
    tight = planar_case("planetary", replaced={'"30 um"': '"0.012345 um"'})
    for case, interference, text in (
        (planar_case("planetary"), None, "ring inside ⌀99.94"),
        (planar_case("planetary"), 1.0, "ring inside ⌀99.94"),  # the file knows it
        (planar_case("planetary", replaced=PRESSED), 28.31e-6, "ring inside ⌀99.9434"),
        (planar_case("planetary", replaced=PRESSED), None, "ring inside ⌀100 less 2 × interference"),
        (tight, None, "ring inside ⌀99.9999753"),
        (planar_case("planar"), 13e-6, "ring inside ⌀79.974"),
    ):
        assert text in [size.label for size in sizes(joint_from_case(case), 1.0, interference)]


def test_interferences_are_those_of_the_contacts_on_rings(planar_case):
    joint = joint_from_case(planar_case("stepped_planet"))
    assert contact_interferences(joint) == [0.0, 30e-6, 30e-6]
    pressed = joint_from_case(planar_case("planetary", replaced=PRESSED))
    assert contact_interferences(pressed) == [0.0, None]
    assert contact_interferences(pressed, 2e-6) == [0.0, 2e-6]


def test_places_lie_on_the_outline_that_has_the_size(joint):
    found = {size.label: size for size in sizes(joint("planetary_hollow"), 1.0)}
    for label, radius, orbit in (
        ("sun ⌀20", 10.0, 0.0),
        ("3 × planet ⌀40", 20.0, 30.0),
        ("3 × planet, bore ⌀26", 13.0, 30.0),
        ("axes of planet ⌀60", 30.0, 0.0),
        ("ring inside ⌀99.94", 50.0, 0.0),
    ):
        for (x, y), (e, f), _ in found[label].places:
            assert math.hypot(x - radius * e, y - radius * f) == pytest.approx(orbit, abs=1e-9)
    assert found["ring inside ⌀99.94"].radius == pytest.approx(50.0)
    assert not found["wall of ring 30"].places  # its outer edge is not drawn
    assert found["wall of ring 30"].listed == "wall 30, broken off at the wavy line"


def test_a_housing_has_its_outer_diameter(planar_case):
    """58 mm of the ring, 150 mm outside: the circle of 75 mm is drawn, and measured."""
    housed = {
        'ring_support = "free"': 'ring_support = "rigid_housing"',
        "[load]": '[housing]\nouter_diameter = "150 mm"\ninterference = "60 um"\nfriction_coefficient = 0.12\n\n[load]',
        'ring = "52100"': 'ring = "52100"\nhousing = "52100"',
    }
    joint = joint_from_case(planar_case("planetary", replaced=housed))
    (housing,) = (size for size in sizes(joint, 1.0) if size.of == "housing")
    assert housing.label == "housing outside ⌀150"
    assert {round(math.hypot(*place.tip), 9) for place in housing.places} == {75.0}
    drawn = [item.radius for item in drive_view(joint, 1.0) if isinstance(item, Circle)]
    assert pytest.approx(75.0) in drawn


def test_a_wall_is_measured_from_edge_to_edge(joint):
    (wall,) = (size for size in sizes(joint("multiroller"), 1.0) if size.label == "wall of ring 12")
    for place in wall.places:
        assert sorted(math.hypot(*point) for point in place.mark[0].points) == pytest.approx(
            [FAR + 9.4, FAR + 21.4]
        )
        assert math.hypot(*place.tip) == pytest.approx(FAR + 15.4)


def test_clearances_are_measured_in_the_view_where_nothing_lies_between(joint):
    """Planets 2 · 17.5 sin 60° − 27, right to left 70 sin 13.925° − 10, to the ring 40 − 31, next 70 sin 60° − 10."""
    found = drive_clearances(joint("planar"))
    assert [gap.words for gap in found] == [
        "planet to planet",
        "right to left",
        "planet to ring",
        "right to right",
        "left to left",
    ]
    expected = (
        35.0 * math.sin(math.pi / 3.0) - 27.0,
        6.845,
        9.0,
        *[70.0 * math.sin(math.pi / 3.0) - 10.0] * 2,
    )
    assert [gap.size for gap in found] == pytest.approx(expected, rel=1e-4)
    for gap in found[:3]:
        assert len({place.tip for place in gap.places}) >= 3
        for place in gap.places:
            assert math.dist(*place.mark[0].points) == pytest.approx(gap.size)
    assert not found[3].places  # planets lie between them
    (first, second) = drive_clearances(joint("multiroller"))
    assert first.size == pytest.approx(52.0 * math.sin(math.pi / 4.0) - 32.0)
    assert first.places
    assert second.size == pytest.approx(2.0 * FAR * math.sin(math.pi / 4.0) - 36.0)
    assert not second.places  # the first row lies between them


def test_planets_on_both_sides_of_the_sun_have_no_line_through_it(planar_case):
    opposite = joint_from_case(planar_case("planetary", replaced={"planets = 3": "planets = 2"}))
    (gap,) = drive_clearances(opposite)
    assert (gap.size, gap.places) == (pytest.approx(20.0), ())


def test_of_many_rollers_only_the_smallest_clearances_to_others_are_said(idlers_case):
    """Twelve rollers around the axis, 30 degrees apart on 68 mm; copies of one are on opposite sides."""
    found = drive_clearances(joint_from_case(idlers_case(6)))
    assert [gap.size for gap in found] == pytest.approx(
        [136.0 * math.sin(math.pi / 12.0) - 16.0] * 3 + [120.0] * 6
    )
    assert [gap.alike for gap in found] == [False] * 3 + [True] * 6
