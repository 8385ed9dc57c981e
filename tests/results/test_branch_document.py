"""Unequal branches as a part of the JSON document."""

import json
import math

import numpy as np


def test_the_document_has_numbers_where_there_are_any(document_of_branches):
    document = json.loads(json.dumps(document_of_branches(), allow_nan=False))
    assert document["branches"][2]["planet_deviation_m"] == -7e-6
    assert document["branches"][0]["preload_over_equal_branches"] == 1.1
    assert document["standing"]["share"] == [0.6, 0.4, 0.0]
    assert document["standing"]["slip_ratio"] == [0.4, 0.5, None]  # the largest of the contacts of each
    assert document["standing"]["torques_Nm"] == {"sun": 1.5}
    assert document["rolling"] is None
    assert document_of_branches(math.inf)["sun_support_stiffness_N_per_m"] is None
    assert document["standing_torque_capacity"] == {
        "first_slip_Nm": 8.0,
        "first_branch": 2,
        "first_contact": "sp",
        "first_event": "contact sp_2 slips",
        "all_slip_Nm": 12.5,
    }
    assert document["rolling_torque_capacity"]["first_branch"] is None  # not a limit of a contact
    assert document["rolling_torque_capacity"]["first_event"] == "the force balance has no solution"
    assert document["without_torque"]["sun"] == {"displacement_m": [-3e-6, 4e-6], "force_N": [-150.0, 200.0]}


def test_the_note_says_how_hard_the_branches_are_pressed(document_of_branches):
    assert (
        "contact by contact: planet 1 is pressed 1.1 times as hard as equal ones"
        in document_of_branches()["note"]
    )
    alike = document_of_branches(preload=np.full(3, 1200.0))["note"]
    assert "every planet is pressed 1.2 times as hard" in alike
