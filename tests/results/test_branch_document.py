"""Unequal branches as a part of the JSON document."""

import json
import math

from asperity.results.branch_document import branch_document


def test_the_document_has_numbers_where_there_are_any(unequal_branches):
    document = json.loads(json.dumps(branch_document(unequal_branches()), allow_nan=False))
    assert document["branches"][2]["planet_deviation_m"] == -7e-6
    assert document["standing"]["share"] == [0.6, 0.4, 0.0]
    assert document["standing"]["slip_ratio"][2] is None
    assert document["rolling"] is None
    assert document["torque_capacity"]["first_branch"] == 2
    assert branch_document(unequal_branches(math.inf))["sun_support_stiffness_N_per_m"] is None

    assert document["torque_capacity"] == {
        "first_slip_Nm": 8.0,
        "first_branch": 2,
        "first_contact": "sp",
        "first_event": "slips",
        "all_slip_Nm": 12.5,
        "equal_branches_Nm": 13.0,
    }
    assert document["without_torque"]["sun"] == {"displacement_m": [-3e-6, 4e-6], "force_N": [-150.0, 200.0]}
    assert document["branches"][0]["preload_over_equal_branches"] == 1.1
    assert document["life_hours_like_the_worst_branch"] is None
    assert document["standing"]["contacts"]["wlo"] == {"pressure_over_first_yield": [0.72, 0.66, None]}
