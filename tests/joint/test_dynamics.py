"""Dynamics of the paper's joint: its own stiffness, creep and masses by hand."""

import dataclasses
import json
import math

import numpy as np
import pytest

from asperity.errors import AsperityError
from asperity.joint.dynamics import Inertias, dynamics, dynamics_document, response_columns
from asperity.joint.solve import solve

COUPLED = Inertias(2e-6, 0.05, 0.02)


@pytest.fixture(scope="module")
def found(paper_joint):
    return dynamics(paper_joint(), COUPLED)


def test_inertias_by_hand(found):
    """Steel cylinders of 5 mm: sun 4, planets 13.5, rollers 5 mm; the ratio is 9."""
    mass = {r: 7850.0 * math.pi * r**2 * 5e-3 for r in (4e-3, 13.5e-3, 5e-3)}
    sun = 0.5 * mass[4e-3] * 4e-3**2
    assert float(found.at_torque.input_inertia) == pytest.approx(81.0 * (2e-6 + sun), rel=1e-12)
    planet = mass[13.5e-3] * (17.5e-3**2 + 0.5 * 13.5e-3**2 * (40 / 13.5 + 1) ** 2)
    roller = mass[5e-3] * (35e-3**2 + 0.5 * 5e-3**2 * 7.0**2)
    assert float(found.at_torque.output_inertia) == pytest.approx(0.05 + 3 * (planet + 2 * roller), rel=1e-12)


def test_stiffness_and_frequency_are_those_of_the_solved_joint(paper_joint, found):
    k = float(solve(paper_joint()).result.assembly.stiffness.output)
    assert float(found.at_torque.stiffness) == pytest.approx(k, rel=1e-9)
    at = found.at_torque
    assert float(at.locked_frequency) == pytest.approx(
        math.sqrt(k / at.output_inertia) / (2 * math.pi), rel=1e-9
    )
    both = 1.0 / float(at.input_inertia) + 1.0 / float(at.output_inertia)
    assert float(at.free_frequency) == pytest.approx(math.sqrt(k * both) / (2 * math.pi), rel=1e-9)


def test_creep_damping_is_the_slope_of_the_lost_speed(paper_joint, found):
    torques = np.array([4.999, 5.001])
    lost = [
        float(solve(paper_joint(output_torque=t)).result.rolling.speed_loss) * 6000 * math.pi / 30 / 9
        for t in torques
    ]
    by_difference = np.diff(torques)[0] / (lost[1] - lost[0])
    assert float(found.at_torque.creep_damping) == pytest.approx(by_difference, rel=1e-6)
    corner = float(found.at_torque.stiffness) / by_difference / (2 * math.pi)
    assert float(found.at_torque.corner_frequency) == pytest.approx(corner, rel=1e-6)


def test_a_joint_that_stands_has_no_creep(paper_joint):
    found = dynamics(paper_joint(sun_speed=0.0), COUPLED)
    assert np.isinf(found.at_torque.creep_damping)
    assert float(found.at_torque.corner_frequency) == 0.0
    np.testing.assert_array_equal(found.turning_load, found.standing_load)
    assert dynamics_document(found, COUPLED)["at_torque"]["creep_damping_Nms_per_rad"] is None


def test_over_torque_up_to_nearly_the_capacity(paper_joint, found):
    over = found.over_torque
    assert over.output_torque[0] == 0.0
    capacity = float(solve(paper_joint()).capacity.output_torque)
    assert over.output_torque[-1] == pytest.approx(0.98 * capacity, rel=1e-9)
    assert np.all(np.diff(over.locked_frequency) < 0.0)
    reverse = dynamics(dataclasses.replace(paper_joint(), output_torque=np.asarray(-5.0)), COUPLED)
    assert reverse.over_torque.output_torque[-1] < 0.0


def test_columns_and_document(found):
    columns = response_columns(found)
    assert columns["standing_motor_phase_deg"][0] == pytest.approx(-180.0, abs=0.1)
    assert columns["standing_load_phase_deg"][0] == pytest.approx(-180.0, abs=0.1)
    # two masses moved as one, far below the resonance
    slow = columns["standing_load_rad_per_Nm"][0] * (2 * math.pi * columns["frequency_Hz"][0]) ** 2
    both = float(found.at_torque.input_inertia + found.at_torque.output_inertia)
    assert slow * both == pytest.approx(1.0, rel=1e-3)
    document = dynamics_document(found, COUPLED)
    json.dumps(document, allow_nan=False)
    assert document["inertia"] == {"input_kg_m2": 2e-6, "output_kg_m2": 0.05, "loss_factor": 0.02}
    assert len(document["over_torque"]["locked_frequency_Hz"]) == 25


def test_a_joint_that_slips_is_refused(paper_joint):
    with pytest.raises(AsperityError, match="beyond the torque capacity"):
        dynamics(paper_joint(output_torque=50.0), COUPLED)
