"""Torque capacity: at it one limit is reached, before it none, whatever the limit is."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import AsperityError
from asperity.joint.solve import solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, capacity_document, limit_words

NAMES = ("sp", "pwr", "pwl", "wro", "wlo")
DIRECTION, WEDGE = math.radians(27.0830551), math.radians(13.1582)  # theta and beta of the paper's joint


def limit_of(found):
    contact = int(found.limiting_contact)
    return LIMIT_KINDS[int(found.limit)], (*NAMES, "none")[contact]


def capacity(joint):
    return solve_joint(joint).standing_capacity


def test_at_capacity_one_contact_is_at_its_limit(paper_joint):
    for mu in (0.05, 0.12, 0.2):
        small = {"friction_coefficient": mu, "output_torque": 1.0}
        found = capacity(paper_joint(**small))
        near = float(found.output_torque) * (1.0 - 1e-9)
        ratio = solve_joint(paper_joint(**small | {"output_torque": near})).result.diagnostics.slip_ratio
        assert ratio.max() == pytest.approx(1.0, rel=1e-6)
        assert limit_of(found) == ("gross_slip", NAMES[int(ratio.argmax())])


def test_lift_off_is_found(paper_joint):
    """At mu = 0.3 the left roller lifts off first."""
    found = capacity(paper_joint(friction_coefficient=0.3))
    assert limit_of(found) == ("lift_off", "pwl")
    torque = float(found.output_torque) * (1.0 - 1e-6)
    near = solve_joint(paper_joint(friction_coefficient=0.3, output_torque=torque)).result.forces.normal
    assert 0.0 < float(near[2]) < 1e-4 * 561.0  # 561 N at rest


def test_by_hand_the_sun_slips_near_mu_times_the_preload(solved_paper):
    """T_sp = T_out/(9 n R_s) = mu N_sp, and N_sp stays within five per cent of the preload."""
    by_hand = 0.12 * 1000.0 * 9.0 * 3.0 * 4e-3
    assert by_hand < float(solved_paper[1].standing_capacity.output_torque) < 1.05 * by_hand


@pytest.mark.long
def test_the_weak_contact_is_named_in_either_direction(paper_joint):
    def with_weak(contact):
        friction = tuple(np.asarray(0.05 if name == contact else 0.2) for name in NAMES)
        return solve_joint(
            dataclasses.replace(paper_joint(output_torque=1.0), friction_coefficients=friction)
        )

    left, right = with_weak("pwl"), with_weak("pwr")
    assert (
        limit_of(left.standing_capacity) == limit_of(left.reverse_standing_capacity) == ("gross_slip", "pwl")
    )
    assert limit_of(right.standing_capacity) == ("gross_slip", "pwr")
    assert float(right.standing_capacity.output_torque) == pytest.approx(
        float(left.reverse_standing_capacity.output_torque), rel=1e-9
    )


def test_a_steep_enough_friction_ends_in_lift_off(paper_joint):
    """A roller about to lift off has t = tan(theta/2) at the planet, t/(cos beta - t sin beta) = 0.262 at the ring."""
    at_planet = math.tan(DIRECTION / 2.0)
    steep = at_planet / (math.cos(WEDGE) - at_planet * math.sin(WEDGE))
    below, above = (
        solve_joint(paper_joint(friction_coefficient=factor * steep, sun_speed=0.0))
        for factor in (0.999, 1.001)
    )
    assert limit_of(below.standing_capacity) == ("gross_slip", "wlo")
    for found, roller in (
        (above.standing_capacity, ("pwl", "wlo")),
        (above.reverse_standing_capacity, ("pwr", "wro")),
    ):
        kind, contact = limit_of(found)
        assert kind == "lift_off"
        assert contact in roller  # without a centrifugal force both its contacts are unloaded together


@pytest.mark.long
def test_a_contact_that_grows_too_wide_is_the_limit_and_the_refusal_agrees(paper_joint):
    given = {"preload": 1e5, "friction_coefficient": 0.24, "ring_wall_thickness": 1.1e-3, "sun_speed": 0.0}

    def joint(torque):  # exact bodies refuse so thin a wall
        return paper_joint(**given, body_model="springs", output_torque=torque)

    found = capacity(joint(1.0))
    assert LIMIT_KINDS[int(found.limit)] == "contact_too_wide"
    torque = float(found.output_torque)
    solve_joint(joint(0.9999 * torque))
    with pytest.raises(AsperityError, match="too wide for line-contact theory"):
        solve_joint(joint(1.0001 * torque))


@pytest.mark.slow
def test_directions_of_a_symmetric_joint_are_alike_and_of_another_are_not(paper_joint):
    other = solve_joint(paper_joint(closure="constant_pin_force"))
    assert float(other.reverse_standing_capacity.output_torque) < 0.2 * float(
        other.standing_capacity.output_torque
    )
    alike = solve_joint(paper_joint(sun_speed=0.0))
    assert float(alike.standing_capacity.output_torque) == pytest.approx(
        float(alike.reverse_standing_capacity.output_torque), rel=1e-9
    )


def test_words_and_document(solved_paper):
    found = solved_paper[1].standing_capacity
    assert limit_words(found, contacts=NAMES) == "contact sp slips"
    document = capacity_document(found, contacts=NAMES)
    assert (document["limit"], document["limiting_contact"]) == ("gross_slip", "sp")
    never = dataclasses.replace(
        found, output_torque=math.inf, limit=np.asarray(0), limiting_contact=np.asarray(5)
    )
    assert capacity_document(never, contacts=NAMES) == {
        "output_torque_Nm": None,
        "limit": "none",
        "limiting_contact": None,
        "meaning": "no limit is reached at any torque",
        "is_lower_bound": False,
    }
