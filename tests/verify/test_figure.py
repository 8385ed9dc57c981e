"""The figure of the comparison: means, ratios, and what a logarithmic axis cannot show."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.verify.figure import QUANTITIES, comparison_figure

FORCE = np.array([1.0, 10.0])


@pytest.fixture
def figure():
    found = {"normal_force": FORCE}
    for name in QUANTITIES:
        found[name] = np.array([[1.0, 8.0], [3.0, 12.0]])  # two seeds: means 2 and 10
        found[f"law_{name}"] = np.array([0.0, 15.0])  # no elastic spot at the smaller load
        found[f"persson_{name}"] = np.array([[2.0, 5.0], [6.0, 15.0]])  # means 4 and 10
    return comparison_figure([SimpleNamespace(fractal_dimension=1.4)], [SimpleNamespace(**found)])


def test_units_are_on_every_axis(figure, tmp_path):
    labels = [a.get_ylabel() for a in figure.axes] + [a.get_xlabel() for a in figure.axes[3:]]
    assert all("[" in label for label in labels)
    figure.savefig(tmp_path / "figure.png")


def test_curves_are_means_and_ratios_of_them(figure):
    above, below = figure.axes[0], figure.axes[3]
    points, law, theory = (above.lines[i].get_ydata() for i in (0, -2, -1))
    np.testing.assert_allclose(points, [2.0, 10.0])
    np.testing.assert_allclose(law, [np.nan, 15.0])
    np.testing.assert_allclose(theory, [4.0, 10.0])
    np.testing.assert_allclose(below.lines[0].get_ydata(), [np.nan, 1.5])
    np.testing.assert_allclose(below.lines[1].get_ydata(), [2.0, 1.0])
    # the scatter of the seeds, 1/2 and 2/10 of the mean, either way
    band = below.collections[0].get_paths()[0].vertices
    assert band[:, 1].max() == pytest.approx(1.5)
    assert band[:, 1].min() == pytest.approx(1.0 / 1.5)
    assert above.get_legend_handles_labels()[1] == ["D = 1.4"]
