"""Preload, stiffness and capacity over temperature as a picture."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity.joint.fit import Fit
from asperity.joint.temperature_curves import TemperatureCurves
from asperity.show.temperature_figure import draw_temperatures


@pytest.mark.parametrize(("per_kelvin", "loose"), [(-0.5e-6, (46.0, 60.0)), (0.5e-6, (-6.0, -20.0))])
def test_curves_marks_and_where_the_drive_is_loose(per_kelvin, loose):
    temperature = np.linspace(-20.0, 60.0, 5)
    curves = TemperatureCurves(
        temperature, np.arange(5.0), np.array([1e4, 2e4, np.nan, 3e4, 4e4]), np.ones(5)
    )
    panels = Figure().subplots(1, 3)
    draw_temperatures(panels, curves, Fit(13e-6, per_kelvin, 20.0, 40.0))
    assert panels[0].lines[0].get_ydata() == pytest.approx(np.arange(5.0))
    assert panels[1].lines[0].get_ydata()[0] == pytest.approx(1e4 * np.pi / 10800)
    assert [line.get_xdata()[0] for line in panels[0].lines[1:]] == [20.0, 40.0]
    (span,) = panels[0].patches
    assert sorted(span.get_extents().transformed(panels[0].transData.inverted()).intervalx) == pytest.approx(
        sorted(loose)
    )
