"""Where the output is, from documents whose numbers are written out here."""

import math

import pytest

from asperity.views.position import position_rows

ARCMINUTE = math.pi / 10800.0


def document(capacity=12.5, torque=5.0, both=(9.0, 8.0), slips=7.5, ends="contact sp slips"):
    forward, reverse = both
    turning = {"output_torque_Nm": capacity, "meaning": ends}
    first = {"first_slip": {"output_torque_Nm": slips}}
    return {
        "rolling": {
            "drift_rad_per_output_turn": 40.0 * ARCMINUTE,
            "speed_loss": 1.85e-3,
            "torque_capacity": {**turning, "reverse": turning},
        },
        "stiffness_bound": None,
        "torsional_stiffness": {"assembly": {"output_Nm_per_rad": 2.0 / ARCMINUTE}},
        "standing": {"forces": {"output_torque_Nm": torque}},
        "standing_torque_capacity": {
            "output_torque_Nm": forward,
            "meaning": "no limit is reached at any torque",
            **first,
            "reverse": {"output_torque_Nm": reverse, **first},
        },
    }


def rows(**changes):
    return {row.label: row for row in position_rows(document(**changes))}


def test_drift_stands_beside_the_stiffness():
    """5 N·m on 2 N·m/arcmin are 2.5 arcmin that come back; 40 arcmin a turn do not."""
    found = rows()
    assert found["drift per output turn"].value == pytest.approx(40.0 * ARCMINUTE)
    assert found["torque over stiffness"].value == pytest.approx(2.5 * ARCMINUTE)
    assert found["torque capacity, rolling"][1:] == (
        12.5,
        "N*m",
        "contact sp slips; standing: 9 N·m",
    )
    assert found["stiffness at standstill"].meaning == "assembled, at this torque"
    assert rows(torque=-5.0)["torque capacity, rolling"].meaning.endswith("standing: 8 N·m")


def test_what_ends_the_rolling_is_said_by_its_limit():
    lifts = rows(capacity=11.0, ends="contact pwl lifts off")["torque capacity, rolling"]
    assert lifts[1:] == (11.0, "N*m", "contact pwl lifts off; standing: 9 N·m")
    never = rows(capacity=None, both=(None, None), ends="no limit is reached at any torque")
    assert never["torque capacity, rolling"][1:] == (
        None,
        "N*m",
        "no limit is reached at any torque; standing: no limit is reached at any torque",
    )


@pytest.mark.parametrize("torque", [5.0, -5.0])
def test_the_stiffness_of_the_others_says_nothing_of_what_comes_back(torque):
    """With a contact that slips, the torque is not carried by the springs that are left."""
    assert rows(torque=torque, slips=5.1)["torque over stiffness"].value == pytest.approx(
        0.5 * torque * ARCMINUTE
    )
    found = rows(torque=torque, slips=4.9)["torque over stiffness"]
    assert found.value is None
    assert "a contact slips" in found.meaning
