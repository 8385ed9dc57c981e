"""Dimension lines and leaders: their ends, arrows and texts."""

import pytest

from asperity.show.dimension_lines import (
    diameter,
    dimension,
    distance_mark,
    leader,
    made_bore,
    toleranced,
    widths_below,
)


@pytest.mark.parametrize(
    ("value", "text"), [(20.0, "20"), (79.00693, "79.0069"), (0.5, "0.5"), (1e-3, "0.001")]
)
def test_a_length_has_six_digits_and_no_trailing_zeros(value, text):
    assert dimension(value) == text


@pytest.mark.parametrize(("align", "side"), [("left", 1.0), ("right", -1.0)])
def test_a_leader_ends_level_beside_its_text(align, side):
    line, text = leader((1.0, 2.0), (side * 30.0, 8.0), "sun ⌀20", scale=2.0, align=align)
    assert line.points == ((1.0, 2.0), (side * 28.5, 8.0), (side * 30.0, 8.0))  # a shoulder of 3 mm on paper
    assert (line.arrows, text.text, text.align) == ("start", "sun ⌀20", align)
    assert side * text.at[0] > 30.0
    assert leader((1.0, 2.0), (30.0, 8.0), "A 4", scale=2.0, arrow=False)[0].arrows == ""


def test_widths_stand_below_each_other_between_lines_from_their_circles():
    rows = widths_below([(48.0, "⌀96"), (50.0, "⌀100")], -60.0, scale=1.0)
    levels = []
    for half, row in zip((48.0, 50.0), rows, strict=True):
        left, right, across, text = row.items
        assert row.ends == ((-half, 0.0), (half, 0.0))
        assert (left.points[0], right.points[0]) == ((-half, 0.0), (half, 0.0))
        (x, y), (u, v) = across.points
        assert (x, u, y == v, across.arrows) == (-half, half, True, "both")
        assert left.points[1][1] < y < -60.0
        assert 0.0 < text.at[0] < half
        assert text.at[1] > y
        levels.append(y)
    assert levels[0] - levels[1] == pytest.approx(7.0)


def test_a_text_that_is_too_wide_stands_beside_its_dimension_line():
    ((_, _, across, text),) = (
        row.items for row in widths_below([(10.0, "driven ring inside ⌀20")], -15.0, scale=1.0)
    )
    assert text.at[0] > across.points[1][0]


def test_arrows_of_a_short_distance_come_from_outside():
    (inside,) = distance_mark(((0.0, 0.0), (8.0, 0.0)), scale=1.0)
    assert (inside.points, inside.arrows) == (((0.0, 0.0), (8.0, 0.0)), "both")
    one, between, other = distance_mark(((0.0, 0.0), (3.0, 0.0)), scale=1.0)
    assert (one.points, one.arrows) == (((-5.0, 0.0), (0.0, 0.0)), "end")
    assert (between.points, between.arrows) == (((0.0, 0.0), (3.0, 0.0)), "")
    assert (other.points, other.arrows) == (((8.0, 0.0), (3.0, 0.0)), "end")
    assert len(distance_mark(((0.0, 0.0), (3.0, 0.0)), scale=5.0)) == 1  # 15 mm on paper


@pytest.mark.parametrize(
    ("value", "tolerance", "text"),
    [
        (20.0, 0.0, "20"),
        (20.0, 0.005, "20.0000 ±0.0050"),
        (79.00693, 0.01, "79.007 ±0.010"),
        (14.0, 0.1, "14.00 ±0.10"),
        (140.0, 25.0, "140 ±25"),
    ],
)
def test_a_length_is_rounded_to_a_twentieth_of_its_tolerance(value, tolerance, text):
    assert toleranced(value, tolerance) == text
    if tolerance:
        written, spread = (float(part) for part in text.split(" ±"))
        assert abs(written - value) <= 0.05 * tolerance
        assert spread == tolerance


def test_a_diameter_has_twice_the_tolerance_of_the_radius_and_its_grade():
    """20 mm ± 4 µm on the radius: 40 mm ± 8 µm, 16 µm wide, which is IT6 of the range 30 to 50 mm; IT5 is 11 µm."""
    assert diameter(20.0, 0.004) == "⌀40.0000 ±0.0080 (IT6)"
    assert diameter(20.0, 0.0039) == "⌀40.0000 ±0.0078 (IT5)"
    assert diameter(20.0, 0.0) == "⌀40"
    assert diameter(300.0, 0.004) == "⌀600.0000 ±0.0080"  # the table ends at 500 mm
    assert made_bore(50.0, 30e-6, 0.002) == "⌀99.9400 ±0.0040 (IT3)"
    assert made_bore(50.0, None, 0.002) == "⌀100.0000 ±0.0040 (IT3) less 2 × interference"
