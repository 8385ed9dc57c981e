"""Dimension lines and leaders: their ends, arrows and texts."""

import pytest

from asperity.show.dimension_lines import dimension, distance_mark, leader, widths_below


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
    for half, ((left, right), (across, text)) in zip((48.0, 50.0), rows, strict=True):
        assert (left.points[0], right.points[0]) == ((-half, 0.0), (half, 0.0))
        (x, y), (u, v) = across.points
        assert (x, u, y == v, across.arrows) == (-half, half, True, "both")
        assert left.points[1][1] < y < -60.0
        assert 0.0 < text.at[0] < half
        assert text.at[1] > y
        levels.append(y)
    assert levels[0] - levels[1] == pytest.approx(7.0)


def test_a_text_that_is_too_wide_stands_beside_its_dimension_line():
    ((_, (across, text)),) = widths_below([(10.0, "driven ring inside ⌀20")], -15.0, scale=1.0)
    assert text.at[0] > across.points[1][0]


def test_arrows_of_a_short_distance_come_from_outside():
    (inside,) = distance_mark(((0.0, 0.0), (8.0, 0.0)), scale=1.0)
    assert (inside.points, inside.arrows) == (((0.0, 0.0), (8.0, 0.0)), "both")
    one, between, other = distance_mark(((0.0, 0.0), (3.0, 0.0)), scale=1.0)
    assert (one.points, one.arrows) == (((-5.0, 0.0), (0.0, 0.0)), "end")
    assert (between.points, between.arrows) == (((0.0, 0.0), (3.0, 0.0)), "")
    assert (other.points, other.arrows) == (((8.0, 0.0), (3.0, 0.0)), "end")
    assert len(distance_mark(((0.0, 0.0), (3.0, 0.0)), scale=5.0)) == 1  # 15 mm on paper
