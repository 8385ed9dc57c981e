"""Load share and capacity over the size of a planet as a picture."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity.branches.size_errors import SizeErrorCurves
from asperity.show.branch_figure import draw_size_errors


def test_shares_capacity_and_force_are_drawn():
    share = np.array([[0.3, 0.35, 0.35], [0.4, 0.3, 0.3]])
    curves = SizeErrorCurves(
        np.array([-2e-6, 2e-6]),
        share,
        share + 0.01,
        np.array([9.0, 13.0]),
        np.array([13.0, 14.0]),
        np.array([10.0, 20.0]),
    )
    panels = Figure().subplots(1, 3)
    draw_size_errors(panels, curves)
    assert panels[0].lines[0].get_ydata() == pytest.approx([30.0, 40.0])
    assert panels[0].lines[0].get_xdata() == pytest.approx([-2.0, 2.0])
    assert [line.get_ydata()[0] for line in panels[1].lines[:2]] == [9.0, 13.0]
    assert panels[2].lines[0].get_ydata() == pytest.approx([10.0, 20.0])
