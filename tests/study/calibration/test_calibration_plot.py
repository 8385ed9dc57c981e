"""What the pictures of calibrations show is what the fit says, in the unit of the label."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.study.calibration.calibration_plot import calibration_figure, posterior_figure
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import unit_of
from asperity.study.design.design_problem import Variable

ARCMINUTE = np.pi / 180.0 / 60.0
TORQUE = np.array([3.0, 1.0, 2.0, 0.0])


def fitted(*, angle=None, stiffness=None, time=None, repetition=None):
    """A calibration that misses the first point by 1 % and meets the others."""
    measured = np.asarray(angle if angle is not None else stiffness)
    repetition = np.zeros(4) if repetition is None else repetition
    residual = np.array([0.01 * measured[0], 0.0, 0.0, 0.0])
    curve = SimpleNamespace(
        measurement=Measurement(TORQUE, angle, stiffness, time, repetition, "synthetic"),
        prediction=measured - residual,
        residual=residual,
        standard_deviation=2.0 * ARCMINUTE / 60.0,
        durbin_watson=1.234,
    )
    return SimpleNamespace(
        curves=(curve,),
        unknowns=(
            Variable("load.preload", 500.0, 2000.0, True),
            Variable("play.angle", 0.0, ARCMINUTE, False),
        ),
        estimates=(
            SimpleNamespace(value=1000.0, lower=900.0, upper=1100.0, determined=True),
            SimpleNamespace(value=0.25 * ARCMINUTE, lower=-np.inf, upper=np.inf, determined=False),
        ),
    )


def test_angles_are_drawn_in_arcminutes_and_their_residuals_in_arcseconds():
    figure = calibration_figure(
        fitted(angle=np.array([3.0, 1.0, 2.0, 0.0]) * ARCMINUTE, time=100.0 + 10.0 * np.arange(4))
    )
    curve, against, in_time = figure.axes
    assert (curve.get_xlabel(), curve.get_ylabel()) == ("output torque [N·m]", "angle [arcmin]")
    data, fit = curve.get_lines()
    np.testing.assert_allclose(data.get_xydata(), np.transpose([TORQUE, [3.0, 1.0, 2.0, 0.0]]), atol=1e-12)
    # a history is drawn in its own order, not sorted by torque
    np.testing.assert_allclose(fit.get_xydata(), np.transpose([TORQUE, [2.97, 1.0, 2.0, 0.0]]), atol=1e-12)
    assert "residual 2 arcsec (standard deviation), Durbin–Watson 1.23" in curve.get_title()
    assert against.get_ylabel() == "residual [arcsec]"
    for axes, across in ((against, TORQUE), (in_time, [0.0, 10.0, 20.0, 30.0])):
        points = axes.get_lines()[0].get_xydata()
        np.testing.assert_allclose(points, np.transpose([across, [1.8, 0.0, 0.0, 0.0]]), atol=1e-9)
    assert in_time.get_xlabel() == "time [s]"


def test_repetitions_are_told_apart_and_rows_stand_for_a_missing_time():
    figure = calibration_figure(fitted(angle=TORQUE * ARCMINUTE, repetition=np.array([1.0, 1.0, 2.0, 2.0])))
    curve, _, in_time = figure.axes
    texts = [text.get_text() for text in curve.get_legend().get_texts()]
    assert texts == ["measured, repetition 1", "measured, repetition 2", "fit"]
    assert [line.get_xdata().tolist() for line in curve.get_lines()[:2]] == [[3.0, 1.0], [2.0, 0.0]]
    assert in_time.get_xlabel() == "row of the file"
    assert in_time.get_lines()[0].get_xdata().tolist() == [0, 1, 2, 3]


def test_stiffnesses_are_drawn_over_sorted_torques():
    figure = calibration_figure(fitted(stiffness=np.array([3.0, 1.0, 2.0, 4.0]) / ARCMINUTE))
    curve, against, _ = figure.axes
    assert curve.get_ylabel() == "stiffness [N·m/arcmin]"
    assert against.get_ylabel() == "residual [N·m/arcmin]"
    np.testing.assert_allclose(
        curve.get_lines()[-1].get_xydata(), [[0.0, 4.0], [1.0, 1.0], [2.0, 2.0], [3.0, 2.97]], rtol=1e-12
    )


def test_draws_of_a_posterior_in_the_units_of_the_unknowns():
    calibration = fitted(angle=TORQUE * ARCMINUTE)
    scaled_values = np.array([[0.0, 0.0], [0.5, 0.25], [1.0, 1.0]])
    notes = ("", "cut by lower bound")
    drawn = SimpleNamespace(scaled_values=scaled_values, note=notes.__getitem__)
    first, above, pair, second = posterior_figure(calibration, drawn).axes
    # from 500 to 2000 N on a logarithmic scale the middle is 1000 N; play from 0 to 1 arcmin
    np.testing.assert_allclose(
        pair.get_lines()[0].get_xydata(), [[500.0, 0.0], [1000.0, 0.25], [2000.0, 1.0]], rtol=1e-12
    )
    np.testing.assert_allclose(pair.get_lines()[1].get_xydata(), [[1000.0, 0.25]], rtol=1e-12)
    assert above.texts[0].get_text() == "+1.00"  # the draws rise together
    assert "cut by lower bound" in " ".join(text.get_text() for text in second.texts) + second.get_title()
    assert "preload" in pair.get_xlabel()
    assert "[N]" in pair.get_xlabel()
    assert "[arcmin]" in second.get_xlabel()
    reds = [line.get_xdata()[0] for line in first.get_lines() if line.get_color() == "C3"]
    assert 1000.0 in np.round(reds, 9)
    (bar,) = (line for line in first.get_lines() if line.get_marker() == "|")
    np.testing.assert_allclose(bar.get_xdata(), [900.0, 1100.0])
    assert 0.0 < bar.get_ydata()[0] < first.get_ylim()[1]


@pytest.mark.parametrize(
    ("path", "unit"),
    [
        ("offset 2", "arcmin"),
        ("drift", "arcmin/min"),
        ("play.take_up_torque", "N*m"),
        ("drive.sun_radius", "mm"),
    ],
)
def test_units_of_unknowns(path, unit):
    assert unit_of(path) == unit
