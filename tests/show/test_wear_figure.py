"""The picture of wear: preload, capacity and drift over time, with both ends named."""

import numpy as np
import pytest
from tests.support.worn import COEFFICIENT, check_wear

from asperity.errors import InputError
from asperity.show.wear_figure import wear_figure


@pytest.fixture(scope="module")
def found():
    return check_wear(COEFFICIENT, 2000.0 * 3600.0)


@pytest.fixture(scope="module")
def figure(found):
    return wear_figure(found, title="check.toml")


def test_lines_are_the_course(found, figure):
    forces, capacity, drift, interference = figure.axes
    course, hours = found.wear.course, found.wear.course.coefficient_time / 1e-17 / 3600.0
    np.testing.assert_allclose(forces.lines[0].get_xdata(), hours)
    np.testing.assert_array_equal(forces.lines[0].get_ydata(), course.preload)
    np.testing.assert_allclose(interference.lines[0].get_ydata(), 1e6 * course.interference)
    known = np.isfinite(course.capacity)
    np.testing.assert_array_equal(capacity.lines[0].get_ydata(), course.capacity[known])
    np.testing.assert_allclose(drift.lines[0].get_ydata(), course.drift * 10800.0 / np.pi)
    np.testing.assert_allclose(drift.lines[1].get_ydata(), course.size_drift * 10800.0 / np.pi)
    assert drift.get_xlabel() == "time [h]"


def test_ends_and_life_are_named(found, figure):
    said = " ".join(text.get_text() for text in figure.axes[0].texts)
    hours = found.hours(found.wear.first_slide.coefficient_time)
    assert f"first contact slides (wlo): {hours:.4g} h" in said
    assert "nothing left (sp)" in said
    assert "required life: 2000 h" in said


def test_words_lie_in_the_panel(figure):
    figure.canvas.draw()
    panel = figure.axes[0].get_window_extent()
    for text in figure.axes[0].texts:
        box = text.get_window_extent()
        assert panel.x0 <= box.x0
        assert box.x1 <= panel.x1


def test_without_a_coefficient_the_axis_is_the_product():
    figure = wear_figure(check_wear(), title="check.toml")
    assert figure.axes[2].get_xlabel() == "wear coefficient times time [s/Pa]"


def test_a_force_that_stays_has_no_picture(found):
    still = found._replace(wear=found.wear._replace(course=None))
    with pytest.raises(InputError, match="no course to draw"):
        wear_figure(still, title="check.toml")
