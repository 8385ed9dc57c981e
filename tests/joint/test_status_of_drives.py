"""Status codes of a planetary joint in which one thing after the other goes wrong."""

import operator

import equinox as eqx
import jax.numpy as jnp
import pytest

from asperity.joint.description import ContactFit
from asperity.joint.loading_cam import CamOfJoint
from asperity.joint.status import STATUS_NAMES, joint_status

NAN = jnp.nan


def changed(tree, leaves):
    """A copy with other leaves, each named by its path."""
    for path, value in leaves.items():
        tree = eqx.tree_at(operator.attrgetter(path), tree, value, is_leaf=lambda leaf: leaf is None)
    return tree


def warm_fit(thermal_change):
    """30 µm of interference at the assembly, and what a kelvin more changes [m]."""
    return ContactFit(30e-6, thermal_change, 20.0, 21.0, jnp.zeros(2))


def status(joint, result):
    return STATUS_NAMES[int(joint_status(joint, result))]


@pytest.mark.slow
def test_a_joint_that_works_is_solved(planetary):
    joint, solution, _ = planetary
    assert status(joint, solution.result) == "solved"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("leaves", "expected"),
    [
        ({"rest.normal": jnp.array([100.0, 0.0])}, "unbalanced"),
        ({"rest.worst": jnp.array(1e-3)}, "unbalanced"),
        ({"diagnostics.hertz_half_width": jnp.array([1e-5, 30e-3])}, "contact_too_wide"),
        ({"walls_hold": jnp.array(False)}, "contact_too_wide"),
        # forces that are known, but balance with nothing, are a state beyond friction
        (
            {
                "forces.balance_residual": jnp.array(NAN),
                "forces.normal": jnp.array([100.0, 100.0]),
            },
            "beyond_standing_capacity",
        ),
        (
            {
                "forces.balance_residual": jnp.array(NAN),
                "forces.normal": jnp.array([NAN, NAN]),
            },
            "unbalanced",
        ),
        ({"forces.balance_residual": jnp.array(1e-3)}, "unbalanced"),
        ({"contact_law_holds": jnp.array(False)}, "all_spots_plastic"),
        # the first reason that applies
        ({"contact_law_holds": jnp.array(False), "walls_hold": jnp.array(False)}, "contact_too_wide"),
    ],
)
def test_each_reason_has_its_code(planetary, leaves, expected):
    joint, solution, _ = planetary
    assert status(joint, changed(solution.result, leaves)) == expected


@pytest.mark.slow
@pytest.mark.parametrize(
    ("sizes", "expected"),
    [
        ({"drive.sectors": 8}, "no_place_for_rollers"),
        ({"drive.second_radius": jnp.array([20e-3, 50.1e-3])}, "no_place_for_rollers"),
        ({"drive.second_radius": jnp.array([20e-3, 49.9e-3])}, "no_place_for_rollers"),
        # a touching circle may miss by a billionth of its radius: 0.05 nm of 50 mm
        ({"drive.second_radius": jnp.array([20e-3, 50e-3 + 0.1e-9])}, "no_place_for_rollers"),
        ({"drive.second_radius": jnp.array([20e-3, 50e-3 + 0.01e-9])}, "solved"),
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


@pytest.mark.slow
@pytest.mark.parametrize(("worst", "expected"), [(1e-3, "unbalanced"), (1e-12, "solved")])
def test_what_a_cam_presses_must_balance_too(planetary, worst, expected):
    joint, solution, _ = planetary
    rest = solution.result.rest
    cam = CamOfJoint(0.0, 0.0, changed(rest, {"worst": jnp.array(worst)}))
    assert status(joint, changed(solution.result, {"cam": cam})) == expected


@pytest.mark.slow
def test_an_output_that_stands_still_has_a_code_of_its_own(planetary, monkeypatch):
    joint, solution, _ = planetary
    monkeypatch.setattr("asperity.joint.status.output_share", lambda drive: jnp.array(1e-12))
    assert status(joint, solution.result) == "output_stands_still"
