"""Plots of influences: lengths of bars, their order, units, and what is not known."""

import itertools

import numpy as np
import pytest

from asperity.study.tolerances.influence_plot import tornado_figure, uncertainty_figure

xarray = pytest.importorskip("xarray")

INPUTS = ["load.preload", "drive.sun_radius", "drive.planets"]


@pytest.fixture
def sensitivities():
    results = ["drift", "torque_capacity"]
    elasticity = np.array([[0.5, -2.0, np.nan], [1.0, 0.25, 1.0]])
    return xarray.Dataset(
        {
            "elasticity": (("result", "input"), elasticity),
            "value": ("input", [1000.0, 4e-3, 3.0]),
            "result_value": ("result", [np.pi / 10800.0, 13.0]),
        },
        coords={
            "result": results,
            "input": INPUTS,
            "result_unit": ("result", ["rad", "N*m"]),
            "result_name": ("result", ["drift", "largest torque that the drive at hand can carry"]),
            "input_name": ("input", ["preload", "sun radius", "planets"]),
        },
    )


def test_bars_are_ordered_by_the_first_result(sensitivities):
    figure = tornado_figure(sensitivities, result="drift", panels=("torque_capacity",))
    first, second = figure.axes
    assert [bar.get_width() for bar in first.patches][:2] == [-2.0, 0.5]
    assert [bar.get_width() for bar in second.patches] == [0.25, 1.0, 1.0]
    assert [label.get_text() for label in first.get_yticklabels()] == ["sun radius", "preload", "planets"]
    assert first.yaxis_inverted()
    # room for twice the longest bar, with powers of ten inside it
    assert first.get_xlim() == pytest.approx((-4.0, 4.0))
    assert first.get_xticks() == pytest.approx([-1.0, -0.1, 0.0, 0.1, 1.0])
    # one arcminute, and newton metres
    assert first.get_title() == "drift\n1 arcmin"
    assert second.get_title() == "largest torque that the drive\nat hand can carry\n13 N·m"


def test_tick_labels_do_not_run_together_on_a_narrow_figure(sensitivities):
    """A planetary drive with given interference: 1 % of its radii are a multiple of it."""
    sensitivities["elasticity"][:, 1] = [-1849.0, 339.0]
    figure = tornado_figure(sensitivities, result="drift", panels=("torque_capacity",), width=6.7)
    figure.savefig("/dev/null", format="png")
    for panel in figure.axes:
        ends = [label.get_window_extent() for label in panel.get_xticklabels()]
        assert len(ends) >= 5
        assert all(one.x1 < other.x0 for one, other in itertools.pairwise(ends))


def test_an_unknown_influence_is_no_bar_of_length_zero(sensitivities):
    first = tornado_figure(sensitivities, result="drift", panels=()).axes[0]
    assert [text.get_text().strip() for text in first.texts] == ["not known"]
    assert first.texts[0].get_position()[1] == 2
    assert sum(bar.get_width() == 0.0 for bar in first.patches) == 0


@pytest.fixture
def spread():
    samples = np.linspace(10.0, 20.0, 101)
    return xarray.Dataset(
        {
            "samples": (("result", "sample"), [np.where(samples > 15.0, np.nan, samples)]),
            "status": ("sample", np.where(samples > 15.0, 3, 0)),
            "quantiles": (("result", "quantile"), [[10.5, 12.5, 14.5]]),
            "nominal": ("result", [12.0]),
            "first_order": (("result", "input"), [[0.2, 0.7, np.nan]]),
            "total_order": (("result", "input"), [[0.25, 0.75, np.nan]]),
            "first_order_half_width": (("result", "input"), [[0.01, 0.02, np.nan]]),
            "total_order_half_width": (("result", "input"), [[0.01, 0.02, np.nan]]),
        },
        coords={
            "result": ["torque_capacity"],
            "input": INPUTS,
            "input_name": ("input", ["preload", "sun radius", "planets"]),
            "distribution": ("input", ["normal 2 sigma", "uniform", "uniform"]),
            "unit": ("result", ["N*m"]),
            "result_name": ("result", ["capacity of this drive"]),
        },
    )


def test_histogram_and_sobol_indices(spread):
    left, right = uncertainty_figure(spread, result="torque_capacity").axes
    assert left.get_ylabel() == "samples [-] (of 51, 50 fail)"
    assert left.get_xlabel() == "capacity of this drive [N·m]"
    assert sorted(line.get_xdata()[0] for line in left.lines) == [10.5, 12.0, 14.5]
    assert [bar.get_width() for bar in right.patches if np.isfinite(bar.get_width())] == [
        0.7,
        0.2,
        0.75,
        0.25,
    ]
    assert right.get_yticklabels()[0].get_text() == "sun radius\n(uniform)"
    assert [text.get_text().strip() for text in right.texts] == ["not known"]
