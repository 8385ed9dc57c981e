"""Bodies of drives drawn apart: every force has its arrow and its number, and no text covers another."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.layout.drive import driving_sense
from asperity.drive.state.loads import member_loads
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.show.box import text_box
from asperity.show.drive_sheet import drive_sheet, forces_sheet
from asperity.show.free_bodies import body_forces, drawn_apart, free_bodies
from asperity.show.sheet import Circle, Line, Text

ROOM = 143.0
EXAMPLES = ("planetary", "multiroller", "stepped_planet", "zou2025", "wheel_pair")


def solved(joint):
    """Forces that are made up: 100, 101, ... N, and 10, 11, ... N, and pins of 1, 2, ... N."""
    count, pins = len(joint.drive.contacts), len(joint.drive.pinned)
    forces = SimpleNamespace(
        normal=100.0 + np.arange(count),
        tangential=10.0 + np.arange(count),
        pins=1.0 + np.arange(pins),
        input_torque=1.5,
        output_torque=7.5,
    )
    return SimpleNamespace(forces=forces)


@pytest.fixture(scope="module", params=EXAMPLES)
def drawn(request, planar_case):
    joint = joint_from_case(planar_case(request.param))
    return joint, free_bodies(joint, solved(joint), middle=(0.0, 0.0), room=ROOM, scale=1.0)


@pytest.mark.slow
def test_every_force_has_an_arrow_and_every_number_stands_once(drawn):
    joint, items = drawn
    names = {joint.drive.bodies[number].name for number in drawn_apart(joint.drive)}
    forces = [each for each in body_forces(joint, solved(joint)) if each.body in names]
    arrows = [item for item in items if isinstance(item, Line)]
    assert len(arrows) == len(forces)
    for force, arrow in zip(forces, arrows, strict=True):
        (x, y), (u, v) = arrow.points
        along = np.array([u - x, v - y]) / np.hypot(u - x, v - y)
        assert along == pytest.approx(np.array(force.direction) * np.sign(force.size), abs=1e-9)
    texts = [item.text for item in items if isinstance(item, Text)]
    for k, contact in enumerate(joint.drive.contacts):
        assert texts.count(f"{contact.name}: N = {100 + k} N") == 1
        assert texts.count(f"T = {10 + k} N") == 1
    for k in range(len(joint.drive.pinned)):
        assert texts.count(f"pin: F = {1 + k} N") == 1
    held = [body for body in joint.drive.bodies if body.place == "held"]  # their bearings carry N and T
    assert texts.count(f"bearing: F = {np.hypot(100.0, 10.0):.1f} N") == len(held)
    assert {name.replace("_", " ") for name in names} <= set(texts)


def test_bodies_lie_apart_around_the_middle_and_texts_beside_them(drawn):
    joint, items = drawn
    largest = {}
    for circle in (item for item in items if isinstance(item, Circle)):
        largest[circle.centre] = max(circle.radius, largest.get(circle.centre, 0.0))
    assert len(largest) == (len(joint.drive.floating) or 2)  # both wheels in a frame
    bodies = list(largest.items())
    for k, ((x, y), radius) in enumerate(bodies):
        assert abs(x) + radius < 75.0
        assert abs(y) + radius < 60.0
        for (u, v), other in bodies[k + 1 :]:
            assert np.hypot(u - x, v - y) >= radius + other + 25.9
    boxes = []
    for text in (item for item in items if isinstance(item, Text)):
        wide = 1.7 * len(text.text)
        left = text.at[0] - {"left": 0.0, "center": 0.5, "right": 1.0}[text.align] * wide
        boxes.append((left, left + wide, text.at[1], text.at[1] + 2.5))
        assert left + wide < 0.5 * ROOM
        if text.align != "center":  # the name in a body
            for (x, y), radius in bodies:
                nearest = np.clip(x, left, left + wide), np.clip(y, text.at[1], text.at[1] + 2.5)
                assert np.hypot(nearest[0] - x, nearest[1] - y) >= radius - 0.5, text.text
    for k, one in enumerate(boxes):
        for other in boxes[k + 1 :]:
            apart = one[1] <= other[0] or other[1] <= one[0] or one[3] <= other[2] or other[3] <= one[2]
            assert apart


def test_a_force_of_nothing_is_not_drawn(planar_case):
    joint = joint_from_case(planar_case("planetary"))
    result = solved(joint)
    result.forces.tangential = np.zeros(2)
    result.forces.pins = np.zeros(1)
    items = free_bodies(joint, result, middle=(0.0, 0.0), room=ROOM, scale=2.0)
    assert len([item for item in items if isinstance(item, Line)]) == 2
    assert not any(item.text.startswith(("T", "pin")) for item in items if isinstance(item, Text))
    (circle,) = (item for item in items if isinstance(item, Circle))
    assert circle.radius == pytest.approx(10.0)  # 20 mm on paper


def test_a_view_that_is_too_wide_reaches_beyond_its_room_on_the_left(planar_case):
    joint = joint_from_case(planar_case("multiroller"))
    wide, narrow = (
        free_bodies(joint, solved(joint), middle=(0.0, 0.0), room=room, scale=1.0) for room in (500.0, 100.0)
    )
    moved = [
        one.at[0] - other.at[0] for one, other in zip(wide, narrow, strict=True) if isinstance(one, Text)
    ]
    ends = [text_box(text, 1.0).right for text in narrow if isinstance(text, Text)]
    assert moved == pytest.approx([moved[0]] * len(moved))
    assert moved[0] > 10.0
    assert max(ends) == pytest.approx(50.0, abs=1.5)


def test_positions_on_a_sheet_at_another_scale_and_place(planar_case):
    joint = joint_from_case(planar_case("multiroller"))
    once, twice = (
        free_bodies(joint, solved(joint), middle=middle, room=ROOM, scale=scale)
        for middle, scale in (((0.0, 0.0), 1.0), ((30.0, -7.0), 2.0))
    )
    for one, other in zip(once, twice, strict=True):
        if isinstance(one, Text):
            assert other.at == pytest.approx((30.0 + 0.5 * one.at[0], -7.0 + 0.5 * one.at[1]))


def test_neighbours_lie_in_the_direction_of_their_contact(drawn):
    joint, items = drawn
    circles = [item for item in items if isinstance(item, Circle)]
    centres = list(dict.fromkeys(circle.centre for circle in circles))
    names = [joint.drive.bodies[number].name for number in joint.drive.floating]
    contacts = [each for each in joint.drive.contacts if each.sector == 0]
    for contact in (each for each in contacts if {each.first, each.second} <= set(names)):
        one, other = (np.array(centres[names.index(name)]) for name in (contact.first, contact.second))
        (place,) = (
            each.place
            for each in body_forces(joint, solved(joint))
            if (each.body, each.name, each.kind) == (contact.first, contact.name, "N")
        )
        assert (other - one) / np.hypot(*(other - one)) == pytest.approx(np.array(place), abs=1e-9)
        return  # the first contact of two bodies places the second


def test_a_hollow_roller_has_its_bore(planar_case):
    joint = joint_from_case(planar_case("planetary_hollow"))
    items = free_bodies(joint, solved(joint), middle=(0.0, 0.0), room=ROOM, scale=1.0)
    outer, bore = (item.radius for item in items if isinstance(item, Circle))
    shape = next(shape for shape in joint.shapes if shape.kind == "hollow")
    assert bore / outer == pytest.approx(0.5 * float(shape.size) / float(joint.drive.first_radius[-1]))


def test_sheets_with_forces(planar_case):
    joint = joint_from_case(planar_case("multiroller"))
    plain, large = drive_sheet(joint, name="x"), drive_sheet(joint, name="x", result=solved(joint))
    own = forces_sheet(joint, solved(joint))
    for sheet in (large, own):
        assert "Torque at the sun 1.5 N·m, at the ring 7.5 N·m." in " ".join(" ".join(sheet.texts).split())
        assert "sf: N = 100 N" in sheet.texts
        left, right, low, high = sheet.window
        for text in (item for item in sheet.items if isinstance(item, Text)):
            assert left < text.at[0] < right
            assert low < text.at[1] < high
    assert not any("N = " in text for text in plain.texts)


def test_bodies_that_touch_only_those_on_the_axis_stand_in_rows(idlers_case):
    joint = joint_from_case(idlers_case(5))
    items = free_bodies(joint, solved(joint), middle=(0.0, 0.0), room=ROOM, scale=1.0)
    centres = [item.centre for item in items if isinstance(item, Circle)]
    assert len(set(centres)) == 5
    assert len({round(y, 6) for _, y in centres}) == 3  # two, two and one
    assert max(x for x, _ in centres) - min(x for x, _ in centres) < ROOM - 40.0


@pytest.mark.parametrize("count", [1, 5])
def test_a_sheet_of_forces_is_as_large_as_its_bodies_need(idlers_case, count):
    joint = joint_from_case(idlers_case(count))
    sheet = forces_sheet(joint, solved(joint))
    left, right, low, high = sheet.window
    for item in sheet.items:
        if isinstance(item, Circle):
            (x, y), radius = item.centre, item.radius
            assert left < x - radius < x + radius < right
            assert low < y - radius < y + radius < high
        elif isinstance(item, Text):
            box = text_box(item, 1.0)
            assert left < box.left + 0.8 < box.right - 0.8 < right
            assert low < item.at[1] < high
    assert (sheet.height == 140.0) == (count == 1)


@pytest.fixture
def forces_drawn(zou_file):
    """Joint and loads of an example under any forces of its contacts, and the forces that are forces_drawn."""

    def make(name):
        joint = joint_from_case(read_case(zou_file.with_name(f"{name}.toml")))
        count = len(joint.drive.contacts)
        normal, tangential = 1000.0 + 100.0 * np.arange(count), 50.0 + 7.0 * np.arange(count) ** 2
        loads = member_loads(
            drive=joint.drive,
            normal=normal,
            tangential=np.asarray(driving_sense(joint.drive)) * tangential,
            body_force=np.zeros((len(joint.drive.floating), 2)),
        )
        forces = SimpleNamespace(normal=normal, tangential=tangential, pins=np.asarray(loads.pin))
        return joint, loads, body_forces(joint, SimpleNamespace(forces=forces))

    return make


def radius_of(joint, force):
    drive = joint.drive
    contact = next(each for each in drive.contacts if each.name == force.name)
    radii = drive.first_radius if contact.first == force.body else drive.second_radius
    return float(radii[drive.contacts.index(contact)])


@pytest.mark.parametrize("name", ["planetary", "multiroller", "stepped_planet", "planar", "zou2025"])
def test_forces_and_moments_on_each_roller_are_those_of_the_balance(forces_drawn, name):
    """Whatever the contacts do, what pins do not hold is left over on the rollers."""
    joint, loads, found = forces_drawn(name)
    for row, number in enumerate(joint.drive.floating):
        body = joint.drive.bodies[number].name
        mine = [each for each in found if each.body == body]
        total = sum(each.size * np.array(each.direction) for each in mine)
        np.testing.assert_allclose(total, np.asarray(loads.unbalanced)[row], atol=1e-9)
        moment = sum(
            radius_of(joint, each)
            * each.size
            * (each.place[0] * each.direction[1] - each.place[1] * each.direction[0])
            for each in mine
            if each.kind == "T"
        )
        assert moment == pytest.approx(float(loads.moments[number]), abs=1e-9)


def test_bearings_in_a_frame_balance_a_wheel(forces_drawn):
    """The contact pushes with 1000 N and drags with 2 N·m over 40 mm."""
    _, _, found = forces_drawn("wheel_pair")
    for wheel in ("driver", "driven"):
        mine = [each for each in found if each.body == wheel]
        assert [each.name for each in mine] == ["dd", "dd", "bearing"]
        total = sum(each.size * np.array(each.direction) for each in mine)
        np.testing.assert_allclose(total, 0.0, atol=1e-9)
        assert mine[-1].size == pytest.approx(math.hypot(*(each.size for each in mine[:2])), rel=1e-12)


def test_a_planetary_by_hand(forces_drawn):
    """The first planet is above the sun: pushed up by it and down by the ring; its pin holds it back."""
    _, _, found = forces_drawn("planetary")
    planet = {(each.name, each.kind): each for each in found if each.body == "planet"}
    assert set(planet) == {("sp", "N"), ("sp", "T"), ("pr", "N"), ("pr", "T"), ("pin", "F")}
    sun = planet["sp", "N"]
    assert sun.place == pytest.approx((0.0, -1.0), abs=1e-12)
    assert sun.size * np.array(sun.direction) == pytest.approx((0.0, 1000.0), abs=1e-9)
    ring = planet["pr", "N"]
    assert ring.place == pytest.approx((0.0, 1.0), abs=1e-12)
    assert ring.size * np.array(ring.direction) == pytest.approx((0.0, -1100.0), abs=1e-9)
    # the sun turns counter-clockwise: sun and ring push the planet to the left, 50 N and 57 N, the pin to the right
    pin = planet["pin", "F"]
    assert pin.size * np.array(pin.direction) == pytest.approx((107.0, 0.0), abs=1e-9)
    of_ring = [each for each in found if each.body == "ring" and each.kind == "N"]
    assert [each.size * each.direction[1] for each in of_ring] == pytest.approx([1100.0])
    assert math.hypot(*of_ring[0].place) == pytest.approx(1.0)
