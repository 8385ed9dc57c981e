"""A drive to scale: every patch, its radius and its place."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Wedge

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.errors import InputError
from asperity.zou2025.drive_drawing import draw_drive, rollers


def drive(sun, planet, roller, ring, count):
    return DriveGeometry(sun * 1e-3, planet * 1e-3, roller * 1e-3, ring * 1e-3, float(count), 0.0, 0.0)


@pytest.mark.parametrize(
    ("radii", "count", "wall"),
    [((4.0, 13.5, 5.0, 40.0), 3, 60.0), ((20.0, 12.0, 4.5, 48.0), 4, 7.5)],  # Table 2, and a wide sun
    ids=["table-2", "four-planets"],
)
def test_rollers_touch_where_they_should_and_the_ring_has_its_wall(radii, count, wall):
    sun, planet, roller, ring = radii
    axes = Figure().subplots()
    draw_drive(axes, drive(*radii, count), ring_wall_thickness=wall * 1e-3)
    rings = [patch for patch in axes.patches if isinstance(patch, Wedge)]
    assert [(w.r, w.width, w.center) for w in rings] == [
        (pytest.approx(ring + wall), pytest.approx(wall), (0, 0))
    ]
    circles = [patch for patch in axes.patches if isinstance(patch, Circle)]
    assert len(circles) == 1 + 3 * count
    drawn_sun, branches = circles[0], np.reshape(np.array(circles[1:], dtype=object), (count, 3))
    assert (drawn_sun.radius, drawn_sun.center) == (pytest.approx(sun), (0.0, 0.0))
    for number, (middle, right, left) in enumerate(branches):
        assert [c.radius for c in (middle, right, left)] == pytest.approx([planet, roller, roller])
        turn = 2.0 * math.pi * number / count  # planets evenly spaced, the first one straight above the sun
        orbit = sun + planet
        assert middle.center == pytest.approx((-orbit * math.sin(turn), orbit * math.cos(turn)), abs=1e-9)
        for each in (right, left):  # tangency with planet and ring
            assert math.dist(each.center, middle.center) == pytest.approx(planet + roller)
            assert math.hypot(*each.center) == pytest.approx(ring - roller)
        (x, y), (a, b) = middle.center, right.center
        assert x * b - y * a < 0.0  # right: clockwise of the planet
        assert math.dist(right.center, (0.0, 0.0)) == pytest.approx(math.dist(left.center, (0.0, 0.0)))
        assert math.dist(right.center, left.center) == pytest.approx(2.0 * abs(x * b - y * a) / orbit)
    low, high = axes.get_xlim()
    assert low < -(ring + wall) < ring + wall < high
    assert axes.get_aspect() == 1.0
    assert f"wall {wall:g} mm" in axes.get_legend().get_texts()[-1].get_text()


def test_rollers_are_named_by_body():
    assert [r.body for r in rollers(drive(4.0, 13.5, 5.0, 40.0, 1))] == [
        "sun",
        "planet",
        "right loading roller",
        "left loading roller",
    ]


def test_a_drive_whose_rollers_cannot_touch_is_refused():
    with pytest.raises(InputError, match="cannot be drawn"):
        rollers(drive(4.0, 13.5, 3.0, 60.0, 3))
