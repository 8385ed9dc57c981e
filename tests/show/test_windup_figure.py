"""Wind-up as a picture: the loop, its deviation from a straight line, and the stiffness, of a known curve."""

import itertools
import math
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.show.windup_figure import windup_figure

ARCSECOND = math.pi / (180.0 * 3600.0)


def loop_of(**changes):
    torque = np.linspace(-4.0, 4.0, 9)
    straight, bow = 1e-4 * torque, 2e-6 * (16.0 - torque**2)
    return SimpleNamespace(
        torque=torque,
        stiffness=np.full(9, 1e4),
        angle=straight,
        unloading_angle=straight + bow,
        reloading_angle=straight - bow,
        stage_torque=np.array([0.0, 1.0, 2.0, 4.0]),
        stage_stiffness=np.array([1e4, 2e4, 3e4]),
        reverse_stage_stiffness=np.array([4e4, 5e4, 6e4]),
    )


@pytest.fixture
def panels():
    return windup_figure(loop_of(), title="a joint").axes


@pytest.fixture
def onset():
    """The sun turns 9 rad for each of the output; 0.002 rad of drift in a turn, 1e-4 rad of wind-up."""
    return SimpleNamespace(
        contacts=SimpleNamespace(input_angle=9.0, drift_per_output_turn=2e-3 * math.pi),
        angle=np.array([0.0, 0.1, 0.2]),
        lag=np.array([0.0, 2e-4, 4e-4]),
        windup=3e-4,
        missing_angle=1e-4,
        static_angle=0.02,
        steady_angle=0.15,
        still_angle=0.05,
        creep_share=0.01,
        swing_drift=np.array([0.0, 0.0, 3e-4]),
    )


@pytest.fixture
def turning(onset):
    return windup_figure(loop_of(), onset, title="a joint").axes[3:]


def test_tiny_angles_leave_room_for_the_panels_of_a_narrow_page(onset):
    """Long tick labels took all the width, the layout was given up, and the panels lay over each other."""
    curve = loop_of()
    for name in ("angle", "unloading_angle", "reloading_angle"):
        setattr(curve, name, getattr(curve, name) * 1e-3)
    figure = windup_figure(curve, onset, title="", stacked=True)
    FigureCanvasAgg(figure).draw()
    boxes = [panel.get_tightbbox() for panel in figure.axes]
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
    assert all(panel.get_position().width > 0.2 for panel in figure.axes)


def test_what_lies_beyond_the_capacity_is_shaded_where_it_is_near(onset):
    _, deviation, stiffness, *_ = windup_figure(loop_of(), title="", capacities=(4.5, 30.0)).axes
    for panel in (deviation, stiffness):
        (shaded,) = panel.patches[-1:]
        assert shaded.get_x() == pytest.approx(4.5)
        assert panel.get_xlim()[1] == pytest.approx(shaded.get_x() + shaded.get_width())
        assert panel.get_xlim()[0] == -panel.get_xlim()[1]
    named = [text.get_text() for text in stiffness.get_legend().get_texts()]
    assert named.count("beyond the standing torque capacity") == 1


@pytest.mark.parametrize(
    ("capacities", "said"), [((9.0, 8.0), ["standing torque capacity 8 N·m"]), ((math.inf,) * 2, [])]
)
def test_a_capacity_out_of_the_picture_is_said(capacities, said):
    _, deviation, stiffness, *_ = windup_figure(loop_of(), title="", capacities=capacities).axes
    named = [text.get_text() for text in stiffness.get_legend().get_texts()]
    assert [text for text in named if "capacity" in text] == said
    assert deviation.get_xlim()[1] < 5.0


def test_deviation_shows_the_hysteresis_that_the_loop_hides(panels):
    _, deviation, _ = panels
    first, unloading, reloading, _ = deviation.lines
    np.testing.assert_allclose(first.get_ydata(), 0.0, atol=1e-9)
    assert unloading.get_ydata()[4] == pytest.approx(3.2e-5 / ARCSECOND)
    np.testing.assert_allclose(reloading.get_ydata(), -unloading.get_ydata(), atol=1e-9)
    assert deviation.get_ylabel().endswith("[arcsec]")


def test_loop_and_stiffness_are_in_arcminutes(panels):
    loop, _, stiffness = panels
    assert loop.lines[0].get_xdata()[-1] == pytest.approx(4e-4 / (60.0 * ARCSECOND))
    assert stiffness.lines[0].get_ydata()[0] == pytest.approx(1e4 * 60.0 * ARCSECOND)
    steps = [patch.get_data() for patch in stiffness.patches]
    minutes = 60.0 * ARCSECOND
    np.testing.assert_allclose(steps[0].values, np.array([1e4, 2e4, 3e4]) * minutes)
    np.testing.assert_allclose(steps[0].edges, [0.0, 1.0, 2.0, 4.0])
    np.testing.assert_allclose(steps[1].values, np.array([6e4, 5e4, 4e4]) * minutes)
    np.testing.assert_allclose(steps[1].edges, [-4.0, -2.0, -1.0, 0.0])


def test_a_joint_that_turns(turning):
    """Sun: 9 * 0.1 rad is 51.57 degrees; drift of 1e-3 rad for each radian of the output."""
    beyond, _ = turning
    lines = {line.get_label(): line for line in beyond.lines}
    minutes = 60.0 * ARCSECOND
    assert lines["static curve: wind-up"].get_ydata()[0] == pytest.approx(3e-4 / minutes)
    behind = lines["angle behind"]
    np.testing.assert_allclose(behind.get_xdata(), np.degrees([0.0, 0.9, 1.8]))
    np.testing.assert_allclose(behind.get_ydata(), np.array([0.0, 2e-4, 4e-4]) / minutes)
    steady = lines["drift of steady rolling"]
    np.testing.assert_allclose(steady.get_ydata(), np.array([2e-4, 3e-4, 4e-4]) / minutes)
    assert lines["all contacts rolled 2a"].get_xdata()[0] == pytest.approx(math.degrees(1.35))
    assert beyond.patches[0].get_width() == pytest.approx(math.degrees(0.18))
    assert beyond.get_title() == "turning under 4 N·m\nshaded: creep below 1 %"
    assert beyond.get_xlim() == pytest.approx((0.0, math.degrees(1.8)))


def test_a_joint_that_swings(turning):
    """Steady drift counts the way there and the way back."""
    _, swings = turning
    lines = {line.get_label(): line for line in swings.lines}
    minutes = 60.0 * ARCSECOND
    np.testing.assert_allclose(
        lines["steady drift, both ways"].get_ydata(), 2.0 * np.array([0.0, 1e-4, 2e-4]) / minutes
    )
    np.testing.assert_allclose(lines["lost per swing"].get_ydata(), np.array([0.0, 0.0, 3e-4]) / minutes)
    assert lines["no drift up to here"].get_xdata()[0] == pytest.approx(math.degrees(0.45))


@pytest.mark.parametrize("stacked", [False, True])
@pytest.mark.parametrize("turns", [False, True])
def test_words_are_whole_and_apart_and_legends_cover_no_curve(onset, stacked, turns):
    figure = windup_figure(loop_of(), onset if turns else None, title="", stacked=stacked)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    assert len(figure.axes) == (5 if turns else 3)
    if stacked:  # fits a page of A4 with its caption
        assert figure.get_size_inches() == pytest.approx([7.0, 8.4 if turns else 5.6])
    words = [each for axes in figure.axes for each in (axes.xaxis.label, axes.yaxis.label, axes.title)]
    boxes = [each.get_window_extent() for each in words if each.get_text()]
    for index, box in enumerate(boxes):
        assert figure.bbox.x0 <= box.x0 < box.x1 <= figure.bbox.x1
        assert figure.bbox.y0 <= box.y0 < box.y1 <= figure.bbox.y1
        assert not any(box.overlaps(other) for other in boxes[index + 1 :])
        assert not any(box.overlaps(axes.bbox) for axes in figure.axes)
    for axes in figure.axes:
        legend = axes.get_legend()
        curves = [line for line in axes.lines if len(line.get_xdata()) > 2]
        assert curves
        for line in curves if legend else ():
            assert (
                not line.get_path()
                .transformed(line.get_transform())
                .intersects_bbox(legend.get_window_extent(), filled=False)
            )
