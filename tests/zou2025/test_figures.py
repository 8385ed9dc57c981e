"""What is drawn: labels with units, every curve, and texts that keep clear of each other."""

import itertools

import numpy as np
import pytest

from asperity.zou2025.figures import axis_label, engineering_exponent, overview_figure, panel_figure
from asperity.zou2025.panels import Axis, all_panels

NAMES = ["4a", "4b", "4c", "4d", "4e", "4f", "5a", "5b", "6a", "6b", "7a", "7b", "8a", "8b"]


@pytest.fixture(scope="module")
def drawn(curves):
    return {panel.name: (panel, panel_figure(panel)) for panel in all_panels(curves)}


@pytest.mark.parametrize(("largest", "exponent"), [(3.9e6, 6), (2.8e9, 9), (4.5e4, 3), (999.0, 0), (1e3, 0)])
def test_engineering_exponent(largest, exponent):
    assert engineering_exponent(np.array([0.0, largest])) == exponent


def test_axis_label_gives_unit_and_power():
    assert axis_label(Axis("force", "N", "force_N"), 0) == "force (N)"
    assert axis_label(Axis("force", "N", "force_N"), 3) == "force (10$^{3}$ N)"
    assert axis_label(Axis("fractal dimension", "", "d"), 0) == "fractal dimension"


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_all_curves_are_drawn_in_the_unit_of_the_axis(drawn, name):
    panel, figure = drawn[name]
    axes = figure.axes[0]
    assert panel.y.unit in axes.get_ylabel()
    assert panel.x.unit in axes.get_xlabel()
    power = next((e for e in (3, 6, 9) if f"10$^{{{e}}}$" in axes.get_ylabel()), 0)
    for line, values in zip(axes.lines, panel.curves.values(), strict=False):
        np.testing.assert_allclose(np.asarray(line.get_ydata()) * 10.0**power, values, rtol=1e-12)
    assert (panel.kind == "single") == (axes.get_legend() is None)


def _tick_labels(axis):
    """Labels within the view; matplotlib places others outside and does not draw them."""
    low, high = sorted(axis.get_view_interval())
    labels = zip(axis.get_ticklabels(), axis.get_ticklocs(), strict=True)
    return [label for label, at in labels if label.get_text() and low <= at <= high]


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_axes_have_several_ticks_and_texts_stay_inside_and_apart(drawn, name):
    _, figure = drawn[name]
    figure.draw_without_rendering()
    axes = figure.axes[0]
    ticks = [_tick_labels(axis) for each in (axes, *axes.child_axes) for axis in (each.xaxis, each.yaxis)]
    assert min(len(labels) for labels in ticks) >= 3
    texts = [axes.xaxis.label, axes.yaxis.label, axes._left_title, *axes.texts, *figure.texts]
    texts += itertools.chain.from_iterable(ticks)
    boxes = [(t.get_text(), t.get_window_extent()) for t in texts if t.get_text()]
    page = figure.bbox
    outside = [t for t, b in boxes if min(b.x0, b.y0) < 0.0 or b.x1 > page.x1 or b.y1 > page.y1]
    assert outside == []
    assert [(t, u) for (t, a), (u, b) in itertools.combinations(boxes, 2) if a.overlaps(b)] == []


def test_overview_draws_the_ring_wall_of_the_joint_and_its_stiffness(curves):
    drive, stiffness = overview_figure(curves).axes[:2]
    assert (drive.patches[0].r, drive.patches[0].width) == (
        100.0,
        60.0,
    )  # 40 mm inside, the assumed 60 mm wall
    assert len(stiffness.lines) == len(curves.dimension.output_torque) + 1  # and the marks of the peaks
    drawn = np.asarray(stiffness.lines[0].get_ydata()) * 1e9
    np.testing.assert_allclose(drawn, curves.dimension.output_stiffness[0])
    assert "N·m/rad" in stiffness.get_ylabel()
