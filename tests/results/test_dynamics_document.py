"""The dynamics of a joint as a document and as columns."""

import json

import numpy as np
import pytest

from asperity.results.dynamics_document import dynamics_document, response_columns
from asperity.standing.dynamics import Dynamics, Inertias, JointDynamics

FIELDS = {
    "output_torque": ("output_torque_Nm", 5.0),
    "stiffness": ("stiffness_output_Nm_per_rad", 3e4),
    "input_inertia": ("input_inertia_at_output_kg_m2", 2e-4),
    "spin_inertia": ("spin_inertia_at_output_kg_m2", 1e-4),
    "output_inertia": ("output_inertia_kg_m2", 0.05),
    "locked_frequency": ("locked_frequency_Hz", 123.0),
    "free_frequency": ("free_frequency_Hz", 1950.0),
    "creep_damping": ("creep_damping_Nms_per_rad", np.inf),
    "corner_frequency": ("corner_frequency_Hz", 0.0),
}
# two free masses, far below and far above a resonance: half a turn behind, then a whole one; once round in between
ANGLE = -1e-3 * np.array([1.0 + 0.0j, 1.0j, -2.0])


@pytest.fixture
def found():
    at_torque = JointDynamics(**{name: np.asarray(value) for name, (_, value) in FIELDS.items()})
    over = JointDynamics(**{name: np.array([value, 2.0 * value]) for name, (_, value) in FIELDS.items()})
    return Dynamics(
        at_torque=at_torque,
        over_torque=over,
        frequency=np.array([1.0, 10.0, 100.0]),
        standing_motor=ANGLE,
        standing_load=2.0 * ANGLE,
        turning_motor=3.0 * ANGLE,
        turning_load=np.conj(ANGLE),
    )


def test_every_number_has_its_unit_and_what_is_not_known_is_none(found):
    document = dynamics_document(found, Inertias(2e-6, 0.05, 0.02))
    json.dumps(document, allow_nan=False)
    assert document["inertia"] == {"input_kg_m2": 2e-6, "output_kg_m2": 0.05, "loss_factor": 0.02}
    known = {key: None if np.isinf(value) else value for key, value in FIELDS.values()}
    assert document["at_torque"] == known
    assert document["over_torque"] == {
        key: [None, None] if value is None else [value, 2.0 * value] for key, value in known.items()
    }
    assert document["response"]["frequency_Hz"] == [1.0, 10.0, 100.0]


def test_phases_begin_at_half_a_turn_behind_and_do_not_jump(found):
    columns = response_columns(found)
    assert len(columns) == 9
    assert columns["standing_motor_rad_per_Nm"] == pytest.approx([1e-3, 1e-3, 2e-3], rel=1e-12)
    assert columns["turning_motor_rad_per_Nm"] == pytest.approx([3e-3, 3e-3, 6e-3], rel=1e-12)
    assert columns["standing_load_phase_deg"] == pytest.approx([-180.0, -90.0, 0.0], abs=1e-12)
    assert columns["turning_load_phase_deg"] == pytest.approx([-180.0, -270.0, -360.0], abs=1e-12)
