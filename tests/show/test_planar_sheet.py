"""Drawings of planar drives: every roller at its place, sizes as in the file."""

import math
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import parse_any_case
from asperity.show.planar_sheet import planar_sheet
from asperity.show.sheet import Circle, Line
from asperity.show.sheet_figure import sheet_figure

EXAMPLES = Path(__file__).parents[2] / "examples"


def sheet(name):
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    return planar_sheet(planar_joint_from_case(parse_any_case(text, source=name)), name=name)


@pytest.mark.parametrize("name", ["planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar"])
def test_every_text_is_inside_the_frame_and_covers_no_other(name):
    figure = sheet_figure(sheet(name))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    texts = [text for text in figure.axes[0].texts if text.get_text()]
    boxes = [text.get_window_extent(canvas.get_renderer()) for text in texts]
    margin = 10.0 / 25.4 * figure.dpi
    for index, box in enumerate(boxes):
        assert margin < box.x0 < box.x1 < figure.bbox.width - margin
        assert margin < box.y0 < box.y1 < figure.bbox.height - margin
        assert not [
            t.get_text()
            for t, other in zip(texts[index + 1 :], boxes[index + 1 :], strict=True)
            if box.overlaps(other)
        ]


def test_sizes_that_the_view_does_not_say():
    """Neighbouring planets: 2 * 30 mm * sin(60 deg) less 40 mm."""
    texts = sheet("planetary").texts
    assert "ring: inside ⌀100, wall 8" in texts
    assert "3 × planet: ⌀40, axes on ⌀60" in texts
    assert f"  clearance between neighbours {60.0 * math.sin(math.pi / 3.0) - 40.0:.4g}" in texts
    assert "sun in, carrier out, ring grounded" in texts
    assert "pins of the carrier: planet" in texts
    assert "  sp: sun – planet" in texts
    assert "tracks of stepped rollers lie in different planes" not in texts


def test_a_thick_wall_is_broken_off_and_bores_are_drawn():
    """30 mm around an inner radius of 50 mm: drawn up to 65 mm; planets with a bore of 26 mm."""
    drawn = sheet("planetary_hollow")
    assert sorted({round(circle.radius, 6) for circle in outlines(drawn)}) == [10.0, 13.0, 20.0, 50.0]
    (wavy,) = [item for item in drawn.items if isinstance(item, Line) and item.style == "break"]
    radii = np.hypot(*np.array(wavy.points).T)
    assert radii.mean() == pytest.approx(65.0, rel=1e-3)
    assert any("bore ⌀26" in text for text in drawn.texts)
    assert "  its wall is broken off at the wavy line" in drawn.texts


def test_axes_go_through_the_centres():
    drawn = sheet("planetary")
    (orbit,) = [item for item in drawn.items if isinstance(item, Circle) and item.style == "axis"]
    assert orbit.radius == pytest.approx(30.0)
    crosses = [item.points for item in drawn.items if isinstance(item, Line) and item.style == "axis"]
    middles = [np.mean(points, axis=0) for points in crosses]
    assert sorted(round(float(np.hypot(*middle)), 6) for middle in middles) == [0.0] * 2 + [30.0] * 6
    for points, middle in zip(crosses, middles, strict=True):
        if np.hypot(*middle) > 1.0:  # one along the radius, one across it
            along = np.subtract(*points) / math.dist(*points)
            assert abs(abs(float(along @ middle)) / 30.0 - 0.5) == pytest.approx(0.5, abs=1e-9)
            assert 20.0 < 0.5 * math.dist(*points) <= 25.0


def outlines(drawn):
    return [item for item in drawn.items if isinstance(item, Circle) and item.style == "outline"]


def test_the_planetary_has_three_planets_that_touch_sun_and_ring():
    drawn = sheet("planetary")
    planets = [circle for circle in outlines(drawn) if circle.radius == pytest.approx(20.0)]
    assert len(planets) == 3
    for planet in planets:
        assert math.hypot(*planet.centre) == pytest.approx(30.0)
    assert {round(c.radius, 6) for c in outlines(drawn)} == {10.0, 20.0, 50.0, 58.0}
    assert "ratio 6" in drawn.texts
    assert "Planetary traction drive" in drawn.texts
    assert {"sp", "pr"} <= set(drawn.texts)


def test_the_multiroller_has_two_tracks_on_eight_rollers():
    drawn = sheet("multiroller")
    radii = [round(circle.radius, 6) for circle in outlines(drawn)]
    assert [radii.count(radius) for radius in (16.0, 18.0, 9.4)] == [4, 4, 4]
    assert radii.count(10.0) == 5  # the sun, and the small tracks of the first row
    assert any("4 × second row: ⌀36, ⌀18.8" in text for text in drawn.texts)
    assert "tracks of stepped rollers lie in different planes" in drawn.texts
