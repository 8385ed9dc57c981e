"""The picture of a turn: a line for each order, one turn, and the turn round the output."""

from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.accuracy import joint_accuracy
from asperity.show.accuracy_figure import accuracy_figure

FILE = Path(__file__).parents[2] / "examples" / "accuracy.toml"
ARCSECONDS = 648000.0 / np.pi


@pytest.fixture(scope="module")
def accuracy():
    return joint_accuracy(asperity.load(FILE).case)


@pytest.fixture(scope="module")
def axes(accuracy):
    return accuracy_figure(accuracy, title="accuracy.toml").axes


def test_spectrum_has_every_order_that_reaches_the_output(accuracy, axes):
    drawn = {
        (round(x, 6), round(y, 6))
        for line in axes[0].lines
        for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True)
    }
    largest = max(abs(one.transmission_error) for one in accuracy.forward.components)
    wanted = {
        (round(one.order, 6), round(abs(one.transmission_error) * ARCSECONDS, 6))
        for one in accuracy.forward.components
        if abs(one.transmission_error) > 1e-6 * largest
    }
    assert drawn == wanted


def test_turn_and_polar_picture_are_the_turn(accuracy, axes):
    turn, polar = axes[1].lines[0], axes[2].lines[1]
    error = accuracy.over_turn.transmission_error * ARCSECONDS
    np.testing.assert_array_equal(turn.get_ydata(), error)
    np.testing.assert_array_equal(polar.get_ydata(), error)
    np.testing.assert_allclose(polar.get_xdata(), np.radians(turn.get_xdata()))
