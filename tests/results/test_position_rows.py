"""Where the output is, from documents whose numbers are written out here."""

import math

import pytest

from asperity.results.position_rows import position_rows

ARCMINUTE = math.pi / 10800.0


def document(capacity=12.5, torque=5.0, both=(9.0, False, 8.0, False), slips=7.5):
    forward, lower, reverse, reverse_lower = both
    return {
        "rolling": {
            "drift_rad_per_output_turn": 40.0 * ARCMINUTE,
            "speed_loss": 1.85e-3,
            "torque_capacity_Nm": capacity,
        },
        "stiffness_bound": None,
        "torsional_stiffness": {"assembly": {"output_Nm_per_rad": 2.0 / ARCMINUTE}},
        "standing": {"forces": {"output_torque_Nm": torque}},
        "standing_torque_capacity": {
            "output_torque_Nm": forward,
            "is_lower_bound": lower,
            "first_slip": {"output_torque_Nm": slips},
            "reverse": {
                "output_torque_Nm": reverse,
                "is_lower_bound": reverse_lower,
                "first_slip": {"output_torque_Nm": slips},
            },
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
        "beyond, a contact slips; standing: 9 N·m",
    )
    assert found["stiffness at standstill"].meaning == "assembled, at this torque"
    assert rows(torque=-5.0)["torque capacity, rolling"].meaning.endswith("standing: 8 N·m")


@pytest.mark.parametrize(
    ("capacity", "both", "said"),
    [
        (12.5, (12.5, False, 12.5, True), "at least: what is computed ends there; standing: 12.5 N·m"),
        (11.0, (12.5, False, 12.5, True), "beyond, a contact slips; standing: 12.5 N·m"),
        (None, (None, False, None, False), "not limited by friction; standing: not limited by friction"),
        (
            math.inf,
            (math.inf, False, 1.0, False),
            "not limited by friction; standing: not limited by friction",
        ),
    ],
)
def test_what_ends_the_rolling(capacity, both, said):
    found = rows(capacity=capacity, both=both)["torque capacity, rolling"]
    assert found.meaning == said
    assert found.value == (capacity if capacity and math.isfinite(capacity) else None)


@pytest.mark.parametrize("torque", [5.0, -5.0])
def test_the_stiffness_of_the_others_says_nothing_of_what_comes_back(torque):
    """With a contact that slips, the torque is not carried by the springs that are left."""
    assert rows(torque=torque, slips=5.1)["torque over stiffness"].value == pytest.approx(
        0.5 * torque * ARCMINUTE
    )
    found = rows(torque=torque, slips=4.9)["torque over stiffness"]
    assert found.value is None
    assert "a contact slips" in found.meaning
