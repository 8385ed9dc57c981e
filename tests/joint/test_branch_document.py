"""Unequal branches as a part of the JSON document."""

import json
import math

import numpy as np

from asperity.joint.branch_document import branch_document
from asperity.joint.branch_results import BranchCapacity, BranchState, UnequalBranches
from asperity.joint.branch_sizes import BranchSizes


def found(support):
    state = BranchState(
        preload=np.array([1100.0, 900.0, 0.0]),
        torque=np.array([3.0, 2.0, 0.0]),
        slip_ratio=np.array([0.4, 0.5, np.nan]),
        sun_displacement=np.array([-3e-6, 4e-6]),
        sun_force=np.array([-150.0, 200.0]),
    )
    capacity = BranchCapacity(first_slip=8.0, branch=1, contact=0, all_slip=12.5, equal=13.0)
    whole = UnequalBranches(
        interference=np.array([14e-6, 12e-6, -1e-6]),
        preload=np.array([1100.0, 900.0, 0.0]),
        rest=state,
        standing=state,
        rolling=None,
        capacity=capacity,
        rolling_capacity=capacity,
    )
    sizes = BranchSizes(np.array([1e-6, 0.0, -7e-6]), np.zeros(3), np.zeros(3), support)
    return json.loads(json.dumps(branch_document(whole, sizes), allow_nan=False))


def test_the_document_has_numbers_where_there_are_any():
    document = found(5e7)
    assert document["branches"][2]["planet_deviation_m"] == -7e-6
    assert document["standing"]["share"] == [0.6, 0.4, 0.0]
    assert document["standing"]["slip_ratio"][2] is None
    assert document["rolling"] is None
    assert document["torque_capacity"]["first_branch"] == 2
    assert found(math.inf)["sun_support_stiffness_N_per_m"] is None

    assert document["torque_capacity"] == {
        "first_slip_Nm": 8.0,
        "first_branch": 2,
        "first_contact": "sp",
        "all_slip_Nm": 12.5,
        "equal_branches_Nm": 13.0,
    }
    assert document["without_torque"]["sun"] == {"displacement_m": [-3e-6, 4e-6], "force_N": [-150.0, 200.0]}
