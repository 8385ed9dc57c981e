"""Load share and capacity over the size of a planet as a picture."""

import dataclasses
import itertools
import math
import types

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity.branches.size_errors import SizeErrorCurves
from asperity.joint.fit import Fit
from asperity.joint.temperature import TemperatureCurves
from asperity.results import RESULTS
from asperity.results.margins import Margin
from asperity.results.solved import SolvedJoint
from asperity.show.compliance_figure import (
    FAIL_COLOUR,
    PASS_COLOUR,
    compliance_figure,
    compliance_shares,
    draw_margins,
    draw_size_errors,
    draw_temperatures,
    drawn_margins,
)
from asperity.zou2025.kinematics import CONTACT_NAMES

SHARES = {
    "tangential_share": [0.1, 0.0, 0.0, 0.0, 0.0],
    "normal_share": [0.0, 0.2, 0.3, 0.0, 0.0],
    "ring_bending_share": 0.4,
    "pin_share": 0.0,
    "planet_support_share": 0.0,
    "input_shaft_share": 0.0,
    "output_shaft_share": 0.0,
    "loading_cam_share": 0.0,
}
FOUND = (
    Margin(RESULTS["slip_ratio"], "sp", 0.4, -math.inf, 1.0, True, "function"),
    Margin(RESULTS["pressure_over_first_yield"], "sp", 2.0, -math.inf, 1.0, False, "damage"),
    Margin(RESULTS["clearance"], "planet_to_ring", 1e-3, 0.0, math.inf, True, "function"),
    Margin(RESULTS["real_area_over_hertz_area"], "sp", 9.0, -math.inf, 1.0, False, "model"),
    Margin(RESULTS["balance_residual"], "", 1e-16, -math.inf, 1e-9, True, "function"),
)


@pytest.fixture
def solved():
    def level(output):
        return types.SimpleNamespace(output=output)

    result = types.SimpleNamespace(
        assembly=types.SimpleNamespace(stiffness=level(1e3), **SHARES),
        series_with_bulk=level(2e4),
        published=level(3e5),
        contact_names=CONTACT_NAMES,
    )
    pins = types.SimpleNamespace(pinned=(1,))
    joint = types.SimpleNamespace(body_model="exact", drive=pins, pin_stiffness=None, pin=None)
    return SolvedJoint(joint, result, None)


def test_springs_in_words_the_largest_first(solved):
    assert compliance_shares(solved) == {
        "ring bending": 0.4, "pwl normal": 0.3, "pwr normal": 0.2, "sp tangential": 0.1,
    }  # fmt: skip


def test_figure_is_in_percent_and_newton_metres_an_arcminute(solved):
    budget, levels = compliance_figure(solved, title="a joint").axes
    assert [bar.get_width() for bar in budget.patches] == pytest.approx([40.0, 30.0, 20.0, 10.0])
    (line,) = levels.lines
    assert line.get_xdata() == pytest.approx(
        [0.2908882, 5.817764, 87.26646], rel=1e-6
    )  # 1 arcmin is pi/10800
    assert [label.get_text() for label in levels.get_yticklabels()] == [
        "assembled\nupper bound: pins rigid", "bodies in series", "asperities alone",
    ]  # fmt: skip
    solved.joint.pin_stiffness = 5e7
    levels = compliance_figure(solved, title="a joint").axes[1]
    assert levels.get_yticklabels()[0].get_text() == "assembled"


@pytest.mark.parametrize(("bodies", "said"), [("exact", True), ("springs", False)])
def test_the_budget_says_that_springs_of_contacts_include_the_bending_of_bodies(solved, bodies, said):
    solved.joint.body_model = bodies
    budget, _ = compliance_figure(solved, title="a joint").axes
    assert ("the bending of a free ring" in " ".join(budget.get_xlabel().split())) is said


def test_the_budget_explains_a_share_below_nothing(solved):
    assert "negative share" not in compliance_figure(solved, title="a joint").axes[0].get_xlabel()
    solved.result.assembly.ring_bending_share = -0.1
    budget, _ = compliance_figure(solved, title="a joint").axes
    assert "a negative share: the other forces on its bodies" in " ".join(budget.get_xlabel().split())


def test_a_level_without_stiffness_has_no_point(solved):
    solved.result.published.output = 0.0
    _, levels = compliance_figure(solved, title="a joint").axes
    assert levels.lines[0].get_xdata()[:2] == pytest.approx([0.2908882, 5.817764], rel=1e-6)
    assert levels.lines[0].get_xdata()[2] != levels.lines[0].get_xdata()[2]  # nan
    assert "no value" in [text.get_text() for text in levels.texts]


def test_levels_close_to_each_other_have_more_than_one_tick(solved):
    solved.result.series_with_bulk.output, solved.result.published.output = 1.1e3, 1.5e3
    figure = compliance_figure(solved, title="a joint")
    figure.savefig("/dev/null", format="png")
    _, levels = figure.axes
    low, high = levels.get_xlim()
    assert sum(low <= tick <= high for tick in levels.get_xticks()) >= 2


@pytest.mark.parametrize("ratio", [1.5, 30.0, 94.0, 1e3])
def test_tick_labels_of_the_levels_do_not_run_together(solved, ratio):
    """A planetary drive's published stiffness may be a hundred times that of its assembly."""
    solved.result.assembly.stiffness.output = 742450.0
    solved.result.series_with_bulk.output, solved.result.published.output = 1.5e6, 742450.0 * ratio
    figure = compliance_figure(solved, title="a joint")
    figure.savefig("/dev/null", format="png")
    _, levels = figure.axes
    low, high = levels.get_xlim()
    labels = [
        label
        for place, label in zip(levels.get_xticks(), levels.get_xticklabels(), strict=True)
        if low <= place <= high
    ]
    assert len(labels) >= 2
    ends = [label.get_window_extent() for label in labels]
    assert all(one.x1 < other.x0 for one, other in itertools.pairwise(ends))


def test_shares_capacity_and_force_are_drawn():
    share = np.array([[0.3, 0.35, 0.35], [0.4, 0.3, 0.3]])
    curves = SizeErrorCurves(
        np.array([-2e-6, 2e-6]),
        share,
        share + 0.01,
        np.array([9.0, 13.0]),
        np.array([13.0, 14.0]),
        np.array([10.0, 20.0]),
        "planet",
        "planet",
    )
    panels = Figure().subplots(1, 3)
    draw_size_errors(panels, curves)
    assert panels[0].lines[0].get_ydata() == pytest.approx([30.0, 40.0])
    assert panels[0].lines[0].get_xdata() == pytest.approx([-2.0, 2.0])
    assert [line.get_ydata()[0] for line in panels[1].lines[:2]] == [9.0, 13.0]
    assert panels[2].lines[0].get_ydata() == pytest.approx([10.0, 20.0])


@pytest.mark.parametrize(("per_kelvin", "loose"), [(-0.5e-6, (46.0, 60.0)), (0.5e-6, (-6.0, -20.0))])
def test_curves_marks_and_where_the_drive_is_loose(per_kelvin, loose):
    temperature = np.linspace(-20.0, 60.0, 5)
    curves = TemperatureCurves(
        temperature, np.arange(5.0), np.array([1e4, 2e4, np.nan, 3e4, 4e4]), np.ones(5)
    )
    panels = Figure().subplots(1, 3)
    side = "above" if loose[0] > 20.0 else "below"
    lost = {"lost": "interference", "part": None, "temperature_degC": loose[0], "side": side}
    after = {"lost": "seat", "part": "ring", "temperature_degC": 1.1 * loose[0], "side": side}
    draw_temperatures(panels, curves, Fit(13e-6, per_kelvin, 20.0, 40.0), [lost, after])
    assert panels[0].lines[0].get_ydata() == pytest.approx(np.arange(5.0))
    assert panels[1].lines[0].get_ydata()[0] == pytest.approx(1e4 * np.pi / 10800)
    assert [line.get_xdata()[0] for line in panels[0].lines[1:]] == [20.0, 40.0]
    (span,) = panels[0].patches
    assert span.get_label() == "loose"
    assert sorted(span.get_extents().transformed(panels[0].transData.inverted()).intervalx) == pytest.approx(
        sorted(loose)
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
