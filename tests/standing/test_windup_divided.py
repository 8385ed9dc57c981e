"""Wind-up beyond the torques at which a contact begins to slide: by a closed form, and without finer steps."""

import dataclasses

import numpy as np
import pytest

from asperity.drive.layout.drive import Closure
from asperity.joint.play import NO_PLAY
from asperity.joint_file.build import joint_from_case
from asperity.standing.windup import windup, windup_of

STAGES = (1.0 / 3.0, 2.0 / 3.0)


def test_a_curve_is_divided_where_its_compliance_is_infinite():
    """A spring of 1 in series with one that gives way as (1 - T/d)^(-1/3) up to d, and is constant beyond."""
    division, largest = 2.3, 6.0

    def compliances(torque):
        left = 1.0 - np.abs(torque) / division
        slip = np.where(left > 0.0, np.abs(left) ** (-1.0 / 3.0), 4.0)
        return 1.0 + slip, np.ones_like(torque)

    options = {"largest_torque": largest, "stage_shares": STAGES, "play": NO_PLAY}
    slipped = 1.5 * division + 4.0 * (largest - division)
    divided = windup_of(compliances, **options, divisions=np.array([division / largest]))
    assert float(divided.angle[-1]) == pytest.approx(largest + slipped, rel=1e-6)
    assert float(divided.angle[0]) == pytest.approx(-largest - slipped, rel=1e-6)
    assert abs(float(windup_of(compliances, **options).angle[-1]) / (largest + slipped) - 1.0) > 1e-5


@pytest.mark.long
def test_a_joint_beyond_its_first_slip_needs_no_more_steps(case):
    """12 N·m, where one loading roller slides from 9.59 N·m on: the loop is that of eight times as many steps."""
    found = joint_from_case(case)
    joint = dataclasses.replace(found, drive=dataclasses.replace(found.drive, closure=Closure()))
    coarse, fine = (windup(joint, largest_torque=12.0, level="assembly", steps=steps) for steps in (20, 160))
    assert float(coarse.hysteresis) == pytest.approx(float(fine.hysteresis), rel=5e-6)
    assert float(coarse.dissipated_energy) == pytest.approx(float(fine.dissipated_energy), rel=5e-6)
    assert float(coarse.angle[-1]) == pytest.approx(float(fine.angle[-1]), rel=1e-7)
