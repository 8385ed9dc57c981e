"""The page about a pair of wheels: a drive without pins, rings and sectors."""

import math

import numpy as np
import pytest

from asperity.page.answer import joint_answer
from asperity.page.description import form_of
from asperity.page.joint_request import JointRequest


@pytest.fixture(scope="module")
def request_of(zou_file):
    """Maker of a request about the example, with changes."""
    text = zou_file.with_name("wheel_pair.toml").read_text(encoding="utf-8")
    return lambda **changes: JointRequest(
        "wheels.toml", text, {k.replace("__", "."): v for k, v in changes.items()}
    )


def test_its_form_has_its_own_sections(request_of):
    form = form_of(request_of().solved_case())
    groups = {group["name"] for group in form["groups"]}
    assert {"drive", "load", "input_bearing", "output_bearing"} <= groups
    assert "branch" not in groups
    assert form["contacts"] == ["dd"]
    (choice,) = [choice for choice in form["choices"] if choice["key"] == "drive.pressed_by"]
    assert choice["words"] == ["force", "spring", "fixed_centres"]


def test_its_answer_draws_both_wheels_with_the_forces_in_their_bearings(request_of):
    answer = joint_answer(request_of(load__output_torque="1.6 N*m"))
    drive = answer["drawing"]
    assert [(roller["body"], roller["y_m"], roller["radius_m"]) for roller in drive["rollers"]] == [
        ("driver", 0.0, 0.02),
        ("driven", pytest.approx(0.06), 0.04),
    ]
    assert drive["rings"] == []
    for body in drive["bodies"]:
        forces = {force["name"]: force["force_N"] for force in body["forces"] if force["kind"] == "pin"}
        assert math.hypot(*forces["bearing"]) == pytest.approx(math.hypot(1000.0, 40.0), rel=1e-9)
        total = np.sum([force["force_N"] for force in body["forces"]], axis=0)
        np.testing.assert_allclose(total, 0.0, atol=1e-9)
