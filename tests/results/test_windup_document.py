"""The document of a wind-up whose curve is a straight line, and the request that is refused."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.solve import Solution
from asperity.results import windup_document as module
from asperity.results.windup_document import (
    examined_windup,
    rolling_columns,
    windup_capacities,
    windup_columns,
    windup_document,
)
from asperity.zou2025.kinematics import CONTACT_NAMES

CAPACITIES = {"forward": {"output_torque_Nm": 13.0}, "reverse": {"output_torque_Nm": 12.0}}


@pytest.fixture
def document(monkeypatch):
    """12 N·m turn the output by 1.2 mrad; backwards the first stage is half as stiff."""
    monkeypatch.setattr(
        module,
        "capacities_document",
        lambda one, other: (
            CAPACITIES[one.standing_capacity] | {"reverse": CAPACITIES[other.reverse_standing_capacity]}
        ),
    )
    monkeypatch.setattr(module, "unknown_because", lambda joint, result: [f"no {result.name}"])
    torque = np.linspace(-12.0, 12.0, 5)
    curve = SimpleNamespace(
        torque=torque, angle=1e-4 * torque, hysteresis=2e-5, lost_motion=3e-5, dissipated_energy=4e-3,
        stage_torque=np.array([0.0, 4.0, 8.0, 12.0]), stage_stiffness=np.full(3, 1e4),
        reverse_stage_stiffness=np.array([5e3, 1e4, 1e4]),
    )  # fmt: skip
    contacts = SimpleNamespace(
        input_angle=9.0,
        drift_per_output_turn=0.011,
        half_width=1e-4 * np.arange(1.0, 6.0),
        share=np.full(5, 0.2),
    )
    onset = SimpleNamespace(
        contacts=contacts, creep_share=0.1, static_angle=1e-3, steady_angle=0.05, missing_angle=2e-4,
        still_angle=3e-3, width_angle=1e-2 * np.arange(1.0, 6.0),
    )  # fmt: skip
    solutions = tuple(object.__new__(Solution) for _ in range(2))
    for solution, name in zip(solutions, ("one", "other"), strict=True):
        result = SimpleNamespace(name=name, contact_names=CONTACT_NAMES)
        vars(solution).update(standing_capacity="forward", reverse_standing_capacity="reverse", result=result)
    joint = SimpleNamespace(
        contact_names=CONTACT_NAMES,
        unlike=None,
        drive=SimpleNamespace(pinned=()),
        pin_stiffness=None,
    )
    return windup_document(joint, curve, solutions, (onset, None), level="assembly")


def test_figures_of_both_directions(document):
    assert document["standing_torque_capacity"] == {
        "output_torque_Nm": 13.0,
        "reverse": {"output_torque_Nm": 12.0},
    }
    figures = ("largest_torque_Nm", "windup_rad", "reverse_windup_rad", "hysteresis_rad", "lost_motion_rad")
    assert [document[name] for name in figures] == pytest.approx([12.0, 1.2e-3, 1.2e-3, 2e-5, 3e-5])
    assert document["dissipated_energy_J"] == 4e-3
    assert document["stages"][0] == {
        "name": "K1", "from_Nm": 0.0, "to_Nm": 4.0, "stiffness_Nm_per_rad": 1e4, "reverse_stiffness_Nm_per_rad": 5e3,
    }  # fmt: skip
    assert [(stage["name"], stage["to_Nm"]) for stage in document["stages"]] == [
        ("K1", 4.0),
        ("K2", 8.0),
        ("K3", 12.0),
    ]


def test_angles_of_rolling_are_those_of_sun_and_output(document):
    """The sun turns nine times as far; a contact is twice its half-width wide."""
    found = document["rolling"]
    assert found["static_curve_up_to"] == pytest.approx({"input_rad": 9e-3, "output_rad": 1e-3})
    assert found["steady_creep_from"]["input_rad"] == pytest.approx(0.45)
    assert found["swing_without_drift"]["output_rad"] == 3e-3
    assert (found["creep_share_of_windup"], found["drift_line_offset_rad"]) == (0.1, -2e-4)
    wro = found["contacts"]["wro"]
    assert wro["width_m"] == pytest.approx(8e-4)
    assert wro["rolls_its_width_in"] == pytest.approx({"input_rad": 0.36, "output_rad": 0.04})
    assert wro["share_of_drift"] == 0.2


def test_a_direction_that_does_not_roll_says_why(document):
    assert document["rolling"]["unknown_because"] == []
    assert document["rolling"]["reverse"] == {"unknown_because": ["no other"]}


@pytest.mark.parametrize(("torque", "hint"), [(None, "state another one with --torque"), (0.0, "not zero$")])
def test_a_windup_needs_a_torque(torque, hint):
    options = {"level": "assembly", "stage_shares": (0.3, 0.6)}
    with pytest.raises(InputError, match=hint):
        examined_windup(SimpleNamespace(output_torque=0.0), largest_torque=torque, **options)


def test_columns_have_their_units():
    names = ("torque", "angle", "stiffness", "unloading_angle", "reloading_angle")
    columns = windup_columns(SimpleNamespace(**{name: name for name in names}))
    assert list(columns.values()) == ["torque", "angle", "stiffness", "unloading_angle", "reloading_angle"]
    onset = SimpleNamespace(
        contacts=SimpleNamespace(input_angle=9.0), angle=np.array([0.1, 0.2]), lag="lag", swing_drift="drift"
    )
    columns = rolling_columns(onset)
    np.testing.assert_allclose(columns["input_angle_rad"], [0.9, 1.8])
    assert (columns["angle_behind_rad"], columns["drift_per_swing_rad"]) == ("lag", "drift")


@pytest.mark.parametrize(
    ("forward", "reverse", "found"),
    [
        ((13.0, False), (12.5, False), (13.0, 12.5)),
        ((13.0, True), (12.5, False), (math.inf, 12.5)),
        ((None, False), (None, False), (math.inf, math.inf)),
    ],
)
def test_capacities_for_the_picture_leave_out_lower_bounds(forward, reverse, found):
    """Where only what is computed ends, the picture must not say that the joint carries no more."""
    one, other = (
        dict(zip(("output_torque_Nm", "is_lower_bound"), each, strict=True)) for each in (forward, reverse)
    )
    assert windup_capacities({"standing_torque_capacity": {**one, "reverse": other}}) == found
