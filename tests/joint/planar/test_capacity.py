"""Torque capacity of planar joints by hand."""

import numpy as np
import pytest

from asperity.joint.planar.capacity import smaller_sizes

ORBIT, COUNT = 30e-3, 3  # of the planetary example


def test_capacity_of_the_planetary_by_hand(planetary):
    """The sun's contact slips first: its normal force is the smaller one by the centrifugal force."""
    _, solution, document = planetary
    capacity = document["torque_capacity"]
    normal = float(solution.result.forces.normal[0])
    assert (capacity["limit"], capacity["limiting_contact"]) == ("gross_slip", "sp")
    by_hand = 2.0 * COUNT * ORBIT * 0.08 * normal
    assert capacity["output_torque_Nm"] == pytest.approx(by_hand, rel=1e-3)  # N changes a little with T
    assert capacity["reverse"]["output_torque_Nm"] == pytest.approx(capacity["output_torque_Nm"], rel=1e-9)
    assert document["rolling"]["torque_capacity_Nm"] == pytest.approx(capacity["output_torque_Nm"], rel=1e-9)


def test_a_strip_stays_below_the_smaller_radius_or_wall(planar_joint):
    """Sun 10 mm against planet 20 mm; ring wall 8 mm; a bore of 26 mm leaves a wall of 7 mm."""
    np.testing.assert_allclose(smaller_sizes(planar_joint("planetary")), [10e-3, 8e-3])
    bored = planar_joint(
        "planetary_hollow", {'ring_wall_thickness = "30 mm"': 'ring_wall_thickness = "6 mm"'}
    )
    np.testing.assert_allclose(smaller_sizes(bored), [7e-3, 6e-3])
