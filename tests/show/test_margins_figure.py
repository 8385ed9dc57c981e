"""Margins as bars: shares of the limits, the fullest first, pass and fail in words."""

import dataclasses
import itertools
import math

import pytest
from matplotlib.figure import Figure

from asperity.results import RESULTS
from asperity.results.margins import Margin
from asperity.show.margins_figure import FAIL_COLOUR, PASS_COLOUR, draw_margins, drawn_margins

FOUND = (
    Margin(RESULTS["slip_ratio"], "sp", 0.4, -math.inf, 1.0, True, "function"),
    Margin(RESULTS["pressure_over_first_yield"], "sp", 2.0, -math.inf, 1.0, False, "damage"),
    Margin(RESULTS["clearance"], "planet_to_ring", 1e-3, 0.0, math.inf, True, "function"),
    Margin(RESULTS["real_area_over_hertz_area"], "sp", 9.0, -math.inf, 1.0, False, "model"),
    Margin(RESULTS["balance_residual"], "", 1e-16, -math.inf, 1e-9, True, "function"),
)


def test_limits_of_the_model_and_those_without_a_share_are_not_drawn():
    assert [each.result.name for each in drawn_margins(FOUND)] == ["pressure_over_first_yield", "slip_ratio"]


def test_the_oil_film_is_drawn():
    film = Margin(RESULTS["film_ratio"], "sp", 3.0, -math.inf, 1.0, False, "accuracy")
    assert drawn_margins([*FOUND, film])[0] is film


def test_bars_are_percent_and_say_pass_or_fail():
    from matplotlib.colors import to_hex

    axes = Figure().subplots()
    draw_margins(axes, FOUND)
    bars = axes.patches
    assert [bar.get_width() for bar in bars] == [200.0, 40.0]
    assert [to_hex(bar.get_facecolor()) for bar in bars] == [FAIL_COLOUR, PASS_COLOUR]
    assert [text.get_text() for text in axes.texts] == ["200 %, FAIL", "40 %, pass"]
    for bar, text in zip(bars, axes.texts, strict=True):  # at the end of its bar, at the middle of its height
        assert text.xy == (bar.get_width(), bar.get_y() + bar.get_height() / 2.0)
    assert axes.yaxis_inverted()
    assert axes.get_xlim()[1] > 1.2 * 200.0
    assert axes.lines[0].get_xdata()[0] == 100.0
    assert axes.get_xlim()[0] == 0.0


@pytest.mark.parametrize("shares", [(0.85, 0.8, 0.27), (0.99, 0.7, 0.5), (8.0, 0.9, 0.3, 0.02)])
def test_no_words_lie_on_the_line_of_the_limit(shares):
    figure = Figure(figsize=(9.0, 5.0))
    axes = figure.subplots()
    found = [
        Margin(RESULTS["slip_ratio"], "sp", share, -math.inf, 1.0, share < 1.0, "function")
        for share in shares
    ]
    draw_margins(axes, found)
    figure.canvas.draw()
    for text in axes.texts:
        words = text.get_window_extent().transformed(axes.transData.inverted())
        assert not words.x0 <= 100.0 <= words.x1, text.get_text()
        assert words.x0 > 0.0
        assert words.x1 < axes.get_xlim()[1]


def test_long_names_have_two_lines_and_do_not_meet():
    label = "safety of a ring or hollow roller against yield, worst load of the duty"
    row = dataclasses.replace(RESULTS["slip_ratio"], label=label)
    places = ("planet", "planet, load 1", "ring", "ring, load 12")
    found = [Margin(row, place, 0.4, -math.inf, 1.0, True, "damage") for place in places]
    figure = Figure(figsize=(7.0, 1.0 + 0.35 * len(found)), layout="constrained")
    axes = figure.subplots()
    draw_margins(axes, found)
    figure.canvas.draw()
    names = axes.get_yticklabels()
    boxes = [name.get_window_extent() for name in names]
    assert {name.get_text().count("\n") for name in names} == {1}
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
    assert axes.get_position().width > 0.3
