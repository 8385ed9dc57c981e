"""Drawings of planar drives: every roller at its place, sizes as in the file."""

import math
from pathlib import Path

import pytest

from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import parse_any_case
from asperity.show.planar_sheet import planar_sheet
from asperity.show.sheet import Circle

EXAMPLES = Path(__file__).parents[2] / "examples"


def sheet(name):
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    return planar_sheet(planar_joint_from_case(parse_any_case(text, source=name)), name=name)


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
