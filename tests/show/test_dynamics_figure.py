"""What the picture of a frequency response shows."""

import numpy as np
import pytest

from asperity.show.dynamics_figure import dynamics_figure
from asperity.standing.dynamics import Inertias, dynamics


@pytest.mark.slow
@pytest.mark.parametrize("speed", [0.0, 600.0])
def test_lines_axes_and_units(paper_joint, speed):
    found = dynamics(paper_joint(sun_speed=speed), Inertias(2e-6, 0.05, 0.02))
    amplitude, phase, torques, corner = dynamics_figure(found, title="joint").axes
    assert [axes.get_ylabel().split("[")[-1] for axes in (phase, torques, corner)] == ["deg]", "Hz]", "Hz]"]
    labels = [line.get_label() for line in amplitude.lines]
    assert labels == [
        f"{side} side, {state}"
        for state in (["standing", "turning"] if speed else ["standing"])
        for side in ("motor", "load")
    ]
    np.testing.assert_allclose(amplitude.lines[1].get_ydata(), np.abs(found.standing_load))
    np.testing.assert_allclose(torques.lines[2].get_ydata(), found.over_torque.locked_frequency)
    assert len(corner.lines) == (2 if speed else 0)
