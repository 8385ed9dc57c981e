"""The view of a drive: radii as in the file, the ring's real wall or a break line, clearances where they are."""

import math

import pytest

from asperity.show.drive_view import drive_view, gaps, ring_as_drawn
from asperity.show.sheet import Circle, Line, Text

RADII = {"sun": 4.0, "planet": 13.5, "roller": 5.0, "ring": 40.0}  # mm, Table 2


def outlines(items):
    return sorted(item.radius for item in items if isinstance(item, Circle) and item.style == "outline")


def texts(items):
    return [item.text for item in items if isinstance(item, Text)]


def test_radii_are_those_of_the_file_and_a_thin_wall_is_drawn_in_full(joint_of):
    items = drive_view(
        joint_of(drive__ring_wall_thickness=12e-3), scale=1.0, labels_from=90.0, interference=0.0
    )
    expected = [4.0] + 3 * [13.5] + 6 * [5.0] + [40.0, 52.0]
    assert outlines(items) == pytest.approx(sorted(expected))
    assert not [
        item for item in items if isinstance(item, Line) and item.style == "break" and len(item.points) > 2
    ]
    assert {"⌀80", "⌀104", "sun ⌀8", "planet ⌀27", "loading roller ⌀10"} <= set(texts(items))
    assert {"axes of planets ⌀35", "axes of loading rollers ⌀70"} <= set(
        texts(items)
    )  # 2 (4 + 13.5), 2 (40 - 5)


def test_a_thick_wall_is_broken_off_at_a_wavy_line(joint_of):
    joint = joint_of()  # 60 mm around 40 mm
    ring = ring_as_drawn(joint)
    assert (ring.inner, ring.outer) == pytest.approx((40.0, 100.0))
    assert ring.broken
    items = drive_view(joint, scale=1.0, labels_from=90.0)
    assert max(outlines(items)) == pytest.approx(40.0)
    (wavy,) = [
        item for item in items if isinstance(item, Line) and item.style == "break" and len(item.points) > 2
    ]
    assert all(40.0 < math.hypot(*point) < 56.0 for point in wavy.points)
    assert "⌀200" not in texts(items)


@pytest.mark.parametrize("planets", [2, 3])
def test_marks_span_the_clearances_between_the_bodies(joint_of, planets):
    joint = joint_of(drive__planets=float(planets))
    found = gaps(joint)
    assert [gap.size for gap in found] == sorted(gap.size for gap in found)
    for gap in found:
        assert math.dist(*gap.ends) == pytest.approx(gap.size, rel=1e-9)  # measured in the drawing
    by_name = {gap.words: gap.size for gap in found}
    assert by_name["planet to ring"] == pytest.approx(40.0 - 4.0 - 27.0)
    if planets == 3:
        assert by_name["neighbouring planets"] == pytest.approx(17.5 * math.sqrt(3.0) - 27.0)


def test_pins_are_drawn_where_the_file_gives_their_diameter(joint_of):
    pins = {"bearings__pin_diameter": 3e-3, "bearings__pin_friction_coefficient": 0.0}
    joint = joint_of(
        **pins, bearings__sun_torque=0.0, bearings__loading_roller_torque=0.0, bearings__carrier_torque=0.0
    )
    items = drive_view(joint, scale=1.0, labels_from=90.0)
    assert outlines(items)[:6] == pytest.approx(6 * [1.5])
    assert "pin ⌀3" in texts(items)
