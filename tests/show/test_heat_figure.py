"""The picture of losses and heat that leaves."""

import numpy as np
import pytest

from asperity.rolling.heat import HeatBalance, HeatFlow
from asperity.show.heat_figure import heat_figure

FLOW = HeatFlow(25.0, 3.0, 0.0, 120.0)
WARM = np.linspace(25.0, 120.0, 24)


def drawn(gain):
    balance = HeatBalance(FLOW, 40.0, 40.0, gain, 20.0, WARM, np.where(WARM < 80.0, 5.0, np.nan))
    (axes,) = heat_figure(balance, title="joint").axes
    return axes


def test_lines_meet_where_the_joint_settles():
    axes = drawn(0.0)
    losses, leaves, point = axes.lines
    assert np.asarray(losses.get_ydata())[0] == 5.0
    assert np.interp(40.0, leaves.get_xdata(), leaves.get_ydata()) == pytest.approx(5.0)
    assert point.get_xdata() == pytest.approx([40.0])
    assert point.get_ydata() == pytest.approx([5.0])
    assert axes.get_xlabel() == "temperature of rollers and oil [°C]"
    assert "settles at 40 degC with 5 W" in axes.get_title(loc="left")


def test_runaway_has_no_point():
    axes = drawn(np.nan)
    assert len(axes.lines) == 2
    assert "thermal runaway" in axes.get_title(loc="left")
