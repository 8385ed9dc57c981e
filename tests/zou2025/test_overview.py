"""The picture of the joint beside its stiffness."""

import numpy as np

from asperity.zou2025.overview import overview_figure


def test_overview_draws_the_ring_wall_of_the_joint_and_its_stiffness(curves):
    drive, stiffness = overview_figure(curves).axes[:2]
    assert (drive.patches[0].r, drive.patches[0].width) == (
        100.0,
        60.0,
    )  # 40 mm inside, the assumed 60 mm wall
    assert len(stiffness.lines) == len(curves.dimension.output_torque) + 1  # and the marks of the peaks
    drawn = np.asarray(stiffness.lines[0].get_ydata()) * 1e9
    np.testing.assert_allclose(drawn, curves.dimension.output_stiffness[0])
    assert "N·m/rad" in stiffness.get_ylabel()
