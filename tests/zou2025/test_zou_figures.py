"""What is drawn: labels with units, every curve, and the scale told on the axis."""

import numpy as np
import pytest

from asperity.zou2025.curves import Curves
from asperity.zou2025.figures import axis_label, engineering_exponent, panel_figure
from asperity.zou2025.overview import overview_figure
from asperity.zou2025.panels import Axis, all_panels


@pytest.mark.parametrize(("largest", "exponent"), [(3.9e6, 6), (2.8e9, 9), (4.5e4, 3), (999.0, 0), (1e3, 0)])
def test_engineering_exponent(largest: float, exponent: int) -> None:
    assert engineering_exponent(np.array([0.0, largest])) == exponent


def test_axis_label_tells_unit_and_power() -> None:
    assert axis_label(Axis("force", "N", "force_N", False), 0) == "force (N)"
    assert axis_label(Axis("force", "N", "force_N", False), 3) == "force (10$^{3}$ N)"
    assert axis_label(Axis("fractal dimension", "", "d", False), 0) == "fractal dimension"


def test_every_panel_draws_all_its_curves_in_the_unit_of_its_axis(curves: Curves) -> None:
    for panel in all_panels(curves):
        axes = panel_figure(panel).axes[0]
        assert panel.y.unit in axes.get_ylabel()
        assert panel.x.unit in axes.get_xlabel()
        scale = (
            1.0
            if panel.y.logarithmic
            else 10.0 ** engineering_exponent(np.concatenate([s.values for s in panel.series]))
        )
        for line, series in zip(axes.lines, panel.series, strict=False):
            np.testing.assert_allclose(np.asarray(line.get_ydata()) * scale, series.values, rtol=1e-12)
        assert bool(panel.legend) == (axes.get_legend() is not None)


def test_overview_has_the_drive_and_the_stiffness(curves: Curves) -> None:
    figure = overview_figure(curves.dimension)
    drive, stiffness = figure.axes[:2]
    assert len(drive.patches) == 1 + 1 + 3 * 3 + 1  # ring, sun, three rollers a branch, the arrow
    assert "N·m/rad" in stiffness.get_ylabel()
