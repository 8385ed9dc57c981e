"""Status codes of a planetary joint in which one thing after the other goes wrong."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.description import ContactFit
from asperity.joint.loading_cam import CamOfJoint
from asperity.joint.status import STATUS_NAMES, joint_status

NAN = np.nan


def changed(tree, leaves):
    """A copy with other leaves, each named by its path."""
    for path, value in leaves.items():
        tree = changed_at(tree, path, value)
    return tree


def changed_at(tree, path, value):
    name, _, inner = path.partition(".")
    return dataclasses.replace(
        tree, **{name: changed_at(getattr(tree, name), inner, value) if inner else value}
    )


def warm_fit(thermal_change):
    """30 µm of interference at the assembly, and what a kelvin more changes [m]."""
    return ContactFit(30e-6, thermal_change, 20.0, 21.0, np.zeros(2))


def status(joint, result):
    return STATUS_NAMES[int(joint_status(joint, result))]


def test_a_joint_that_works_is_solved(planetary):
    joint, solution, _ = planetary
    assert status(joint, solution.result) == "solved"


@pytest.mark.parametrize(
    ("leaves", "expected"),
    [
        ({"rest.normal": np.array([100.0, 0.0])}, "unbalanced"),
        ({"rest.worst": np.array(1e-3)}, "unbalanced"),
        ({"diagnostics.hertz_half_width": np.array([1e-5, 30e-3])}, "contact_too_wide"),
        ({"walls_hold": np.array(False)}, "contact_too_wide"),
        # forces that are known, but balance with nothing, are a state beyond friction
        (
            {
                "forces.balance_residual": np.array(NAN),
                "forces.normal": np.array([100.0, 100.0]),
            },
            "beyond_standing_capacity",
        ),
        (
            {
                "forces.balance_residual": np.array(NAN),
                "forces.normal": np.array([NAN, NAN]),
            },
            "unbalanced",
        ),
        ({"forces.balance_residual": np.array(1e-3)}, "unbalanced"),
        ({"contact_law_holds": np.array(False)}, "all_spots_plastic"),
        # the first reason that applies
        ({"contact_law_holds": np.array(False), "walls_hold": np.array(False)}, "contact_too_wide"),
    ],
)
def test_each_reason_has_its_code(planetary, leaves, expected):
    joint, solution, _ = planetary
    assert status(joint, changed(solution.result, leaves)) == expected


@pytest.mark.parametrize(
    ("sizes", "expected"),
    [
        ({"drive.sectors": 8}, "no_place_for_rollers"),
        ({"drive.second_radius": np.array([20e-3, 50.1e-3])}, "no_place_for_rollers"),
        ({"drive.second_radius": np.array([20e-3, 49.9e-3])}, "no_place_for_rollers"),
        # a touching circle may miss by a billionth of its radius: 0.05 nm of 50 mm
        ({"drive.second_radius": np.array([20e-3, 50e-3 + 0.1e-9])}, "no_place_for_rollers"),
        ({"drive.second_radius": np.array([20e-3, 50e-3 + 0.01e-9])}, "solved"),
        ({"interference": -1e-6}, "no_interference_left"),
        ({"interference": 1e-6}, "solved"),
        ({"fit": warm_fit(-29e-6)}, "solved"),
        ({"fit": warm_fit(-31e-6)}, "no_interference_left"),
        ({"interference": -1e-6, "preload": 500.0, "drive.sectors": 8}, "no_place_for_rollers"),
    ],
)
def test_sizes_that_cannot_be_come_first(planetary, sizes, expected):
    joint, solution, _ = planetary
    assert status(changed(joint, sizes), solution.result) == expected


@pytest.mark.parametrize(("worst", "expected"), [(1e-3, "unbalanced"), (1e-12, "solved")])
def test_what_a_cam_presses_must_balance_too(planetary, worst, expected):
    joint, solution, _ = planetary
    rest = solution.result.rest
    cam = CamOfJoint(0.0, 0.0, changed(rest, {"worst": np.array(worst)}))
    assert status(joint, changed(solution.result, {"cam": cam})) == expected


def test_an_output_that_stands_still_has_a_code_of_its_own(planetary, monkeypatch):
    joint, solution, _ = planetary
    monkeypatch.setattr("asperity.joint.status.output_share", lambda drive: np.array(1e-12))
    assert status(joint, solution.result) == "output_stands_still"
