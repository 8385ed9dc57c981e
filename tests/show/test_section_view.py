"""Sections along the axis: every contact touches, lengths are those of the file, planes are told apart."""

import math

import pytest

from asperity.joint.description import places
from asperity.joint_file.build import joint_from_case
from asperity.show.section_view import body_section, draw_section, drive_section, heights, planes
from asperity.show.sheet import Line

NAMES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "zou2025", "planar", "wheel_pair")


@pytest.fixture
def joint(planar_case):
    return lambda name, replaced=None: joint_from_case(planar_case(name, replaced=replaced or {}))


@pytest.mark.parametrize(
    ("name", "groups"),
    [
        ("planetary", [["sp", "pr"]]),
        ("zou2025", [["sp", "pwr", "pwl", "wro", "wlo"]]),
        ("multiroller", [["sf"], ["fsl", "fsr"], ["sr"]]),
        ("stepped_planet", [["sp", "pr1"], ["pr2"]]),
    ],
)
def test_contacts_on_one_track_lie_in_one_plane(joint, name, groups):
    made = joint(name)
    assert [[made.contact_names[number] for number in group] for group in planes(made)] == groups


def test_heights_add_up_the_radii_from_the_sun_to_the_ring(joint):
    """4 + 13.5, and 13.5 + 5 more; the ring of 40 mm has its centre where its track touches, at 41 mm."""
    made = joint("zou2025")
    names = [body.name for body in made.drive.bodies]
    placed = {names[body]: height for body, height in heights(made).items()}
    assert placed["planet"] == pytest.approx(17.5)
    assert placed["left_loading_roller"] == placed["right_loading_roller"] == pytest.approx(36.0)
    assert placed["ring"] + 40.0 == pytest.approx(41.0)


@pytest.mark.parametrize("name", NAMES)
def test_every_contact_touches_in_the_section(joint, name):
    """A block of the first body ends where one of the second begins, at the same place along the axis."""
    made = joint(name)
    placed = heights(made)
    blocks = drive_section(made, 1.0).blocks
    first, _ = places(made.drive)
    for number, contact in enumerate(made.drive.contacts):
        height = placed[first[number]] + 1e3 * float(made.drive.first_radius[number])
        below = [(b.left, b.right) for b in blocks if math.isclose(b.high, height)]
        above = [(b.left, b.right) for b in blocks if math.isclose(b.low, height)]
        assert any(math.isclose(a[0], b[0], abs_tol=1e-9) for a in below for b in above), contact.name


def test_lengths_are_those_of_contacts_and_of_longer_bodies(joint):
    longer = {
        'contact_length = "10 mm"': 'planet_length = "14 mm"\ncontact_length = { sp = "9 mm", pr = "12 mm" }'
    }
    section = drive_section(joint("planetary", longer), 1.0)
    assert {length.words: length.right - length.left for length in section.lengths} == pytest.approx(
        {"sp: 9": 9.0, "pr: 12": 12.0}
    )
    above = [block for block in section.blocks if block.high > 0.0]
    assert sorted(block.right - block.left for block in above) == pytest.approx([9.0, 12.0, 14.0])
    assert section.width == pytest.approx(14.0)


def test_names_that_are_too_long_for_a_length_are_counted(joint):
    made = joint("planar", {'"pwr"': f'"{"x" * 60}"'})
    assert [length.words for length in drive_section(made, 1.0).lengths] == ["5 contacts: 5"]


def test_a_ring_is_cut_twice_and_a_bore_is_seen(joint):
    made = joint("planetary_hollow")
    ring = body_section(made, 2, 1.0)
    assert sorted((block.low, block.high) for block in ring.blocks if block.hatched) == [
        (-80.0, -50.0),
        (50.0, 80.0),
    ]
    planet = body_section(made, 1, 1.0)
    assert sorted((block.low, block.high, block.hatched) for block in planet.blocks) == [
        (-20.0, -13.0, -1),
        (-13.0, 13.0, 0),
        (13.0, 20.0, -1),
    ]


def test_hatching_stays_in_the_wall_at_45_degrees(joint):
    section = drive_section(joint("planetary"), 1.0)
    walls = [block for block in section.blocks if block.hatched]
    assert [(wall.low, wall.high) for wall in walls] == [(50.0, 58.0), (-58.0, -50.0)]
    items, dimensions = draw_section(section, 0.0, low=-2.0, scale=1.0)
    hatching = [item.points for item in items if isinstance(item, Line) and item.style == "thin"]
    assert len(hatching) > 6
    for (x, y), (u, v) in hatching:
        assert v - y == pytest.approx(u - x)
        assert any(
            wall.left - 1e-9 <= min(x, u) <= max(x, u) <= wall.right + 1e-9
            and wall.low - 1e-9 <= min(y, v) <= max(y, v) <= wall.high + 1e-9
            for wall in walls
        )
    assert [math.dist(*dimension.ends) for dimension in dimensions] == pytest.approx([10.0])


@pytest.mark.parametrize("name", NAMES)
def test_the_section_is_the_same_on_both_sides_of_the_axis_except_in_a_frame(joint, name):
    made = joint(name)
    blocks = {(b.low, b.high, b.left, b.right, abs(b.hatched)) for b in drive_section(made, 1.0).blocks}
    mirrored = {(-high, -low, *others) for low, high, *others in blocks}
    assert (mirrored == blocks) == (not made.drive.layout.in_frame)


def test_the_bore_of_a_ring_is_seen_where_no_roller_hides_it(joint):
    """The small tracks of the second row end 9.4 mm before their axes; between them the ring is open."""
    made = joint("multiroller")
    section = drive_section(made, 1.0)
    second_row = max(heights(made)[body] for body in heights(made) if body != len(made.drive.bodies) - 1)
    (ring,) = {(b.left, b.right) for b in section.blocks if b.hatched}
    assert sorted(section.edges) == [
        (pytest.approx((x, -second_row + 9.4)), pytest.approx((x, second_row - 9.4))) for x in ring
    ]


HOUSED = {
    'ring_support = "free"': 'ring_support = "rigid_housing"',
    "[load]": '[housing]\nouter_diameter = "150 mm"\ninterference = "60 um"\nfriction_coefficient = 0.12\n\n[load]',
    'ring = "52100"': 'ring = "52100"\nhousing = "52100"',
}


def test_a_housing_is_cut_around_its_ring_and_hatched_the_other_way(joint):
    """A wall of 8 mm around 50 mm, in a housing of 150 mm."""
    section = drive_section(joint("planetary", HOUSED), 1.0)
    cut = {(block.low, block.high): block.hatched for block in section.blocks if block.hatched}
    assert cut[50.0, 58.0] == -cut[58.0, 75.0] != 0
    assert cut[-58.0, -50.0] == -cut[-75.0, -58.0] != 0
