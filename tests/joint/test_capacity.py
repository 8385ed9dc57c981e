"""Torque capacity: at it one limit is reached, before it none, whatever the limit is."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import AsperityError
from asperity.joint.capacity import (
    LIMIT_KINDS,
    LIMITING_CONTACTS,
    capacity_document,
    limit_words,
    torque_capacity,
)
from asperity.joint.planar.evaluation import evaluate_planar
from asperity.joint.planar.solve import solve_planar

DIRECTION, WEDGE = math.radians(27.0830551), math.radians(13.1582)  # theta and beta of the paper's joint


@jax.jit
def capacity(joint, direction):
    return torque_capacity(joint, direction=direction)


@jax.jit
def solved(joint):
    return evaluate_planar(joint)


def limit_of(found):
    contact = int(found.limiting_contact)
    return LIMIT_KINDS[int(found.limit)], LIMITING_CONTACTS[contact]


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.05, 0.12, 0.2])
def test_at_capacity_one_contact_is_at_its_limit_and_none_beyond(paper_joint, mu):
    found = capacity(paper_joint(friction_coefficient=mu), 1.0)
    ratio = np.asarray(
        solved(
            paper_joint(friction_coefficient=mu, output_torque=float(found.output_torque))
        ).diagnostics.slip_ratio
    )
    assert ratio.max() == pytest.approx(1.0, rel=1e-9)
    assert limit_of(found) == ("gross_slip", CONTACT_NAMES[int(ratio.argmax())])


@pytest.mark.slow
@pytest.mark.parametrize(
    "options", [{}, {"xla_backend_optimization_level": 0, "xla_cpu_use_fusion_emitters": False}]
)
def test_lift_off_is_found_whatever_the_rounding(paper_joint, options):
    """At mu = 0.3 the left roller lifts off first; beyond, its force is nothing but rounding, of either sign."""
    joint = paper_joint(friction_coefficient=0.3)
    program = jax.jit(torque_capacity, static_argnames="direction").lower(joint, direction=1.0)
    try:
        found = program.compile(compiler_options=options)(joint)
    except jax.errors.JaxRuntimeError as error:
        if "No such compile option" not in str(error):
            raise
        pytest.skip("this release of XLA has no such option")
    assert limit_of(found) == ("lift_off", "pwl")
    torque = float(found.output_torque)
    near = solved(paper_joint(friction_coefficient=0.3, output_torque=torque * (1.0 - 1e-6))).forces.normal
    assert 0.0 < float(near[2]) < 1e-4 * 561.0  # 561 N at rest


def test_by_hand_the_sun_slips_near_mu_times_the_preload(paper_joint):
    """T_sp = T_out/(9 n R_s) = mu N_sp, and N_sp stays within five per cent of the preload."""
    by_hand = 0.12 * 1000.0 * 9.0 * 3.0 * 4e-3
    assert by_hand < float(capacity(paper_joint(), 1.0).output_torque) < 1.05 * by_hand


@pytest.mark.slow
def test_the_weak_contact_is_named_in_either_direction(paper_joint):
    joint = dataclasses.replace(
        paper_joint(), friction_coefficients=tuple(map(np.asarray, (0.2, 0.2, 0.05, 0.2, 0.2)))
    )
    forward, reverse = capacity(joint, 1.0), capacity(joint, -1.0)
    assert limit_of(forward) == limit_of(reverse) == ("gross_slip", "pwl")
    mirrored = dataclasses.replace(
        joint, friction_coefficients=tuple(map(np.asarray, (0.2, 0.05, 0.2, 0.2, 0.2)))
    )
    other = capacity(mirrored, 1.0)
    assert limit_of(other) == ("gross_slip", "pwr")
    assert float(other.output_torque) == pytest.approx(float(reverse.output_torque), rel=1e-10)


@pytest.mark.slow
def test_a_steep_enough_friction_ends_in_lift_off(paper_joint):
    """A roller about to lift off has t = tan(theta/2) at the planet, t/(cos beta - t sin beta) = 0.262 at the ring."""
    at_planet = math.tan(DIRECTION / 2.0)
    steep = at_planet / (math.cos(WEDGE) - at_planet * math.sin(WEDGE))
    below = capacity(paper_joint(friction_coefficient=0.999 * steep, sun_speed=0.0), 1.0)
    assert limit_of(below) == ("gross_slip", "wlo")
    for direction, roller in ((1.0, ("pwl", "wlo")), (-1.0, ("pwr", "wro"))):
        above = capacity(paper_joint(friction_coefficient=1.001 * steep, sun_speed=0.0), direction)
        kind, contact = limit_of(above)
        assert kind == "lift_off"
        assert contact in roller  # without a centrifugal force both its contacts are unloaded together
    torque = float(above.output_torque)
    normal = [
        float(solved(paper_joint(output_torque=-t * torque, sun_speed=0.0)).forces.normal[1])
        for t in (0.999, 0.99999)
    ]
    assert normal[1] == pytest.approx(1e-2 * normal[0], rel=0.2)


@pytest.mark.slow
def test_a_contact_that_grows_too_wide_is_the_limit_and_the_refusal_agrees(paper_joint):
    """Before this, the capacity was a torque at which the joint was refused for another reason."""
    joint = paper_joint(preload=1e5, friction_coefficient=0.24, ring_wall_thickness=1.1e-3, sun_speed=0.0)
    joint = dataclasses.replace(joint, body_model="springs")  # exact bodies refuse so thin a wall
    found = solve_planar(dataclasses.replace(joint, output_torque=np.asarray(1.0))).capacity
    assert LIMIT_KINDS[int(found.limit)] == "contact_too_wide"
    torque = float(found.output_torque)
    solve_planar(dataclasses.replace(joint, output_torque=np.asarray(0.9999 * torque)))
    with pytest.raises(AsperityError, match="too wide for line-contact theory"):
        solve_planar(dataclasses.replace(joint, output_torque=np.asarray(1.0001 * torque)))


def test_pins_that_lock_and_bearings_that_drag_leave_no_capacity(paper_joint):
    pins = capacity(paper_joint(pin_friction_coefficient=2.0, pin_diameter=8e-3), 1.0)
    assert float(pins.output_torque) == 0.0
    assert LIMIT_KINDS[int(pins.limit)] == "pins_lock"
    drags = capacity(paper_joint(loading_roller_torque=5.0), 1.0)
    assert float(drags.output_torque) == 0.0


def test_directions_of_a_symmetric_joint_are_alike_and_of_another_are_not(paper_joint):
    friction = {"loading_roller_torque": 1e-3, "pin_friction_coefficient": 0.01, "pin_diameter": 4e-3}
    at_rest = [capacity(paper_joint(sun_speed=0.0, **friction), each) for each in (1.0, -1.0)]
    assert float(at_rest[0].output_torque) == pytest.approx(float(at_rest[1].output_torque), rel=1e-12)
    other = [capacity(paper_joint(closure="constant_pin_force"), each) for each in (1.0, -1.0)]
    assert float(other[1].output_torque) < 0.2 * float(other[0].output_torque)


@pytest.mark.slow
def test_a_batch_is_as_one_by_one(paper_joint):
    """Preloads from 10 N to 1e5 N times friction coefficients, and both directions, in one call."""
    preload = np.repeat([10.0, 1e3, 1e5], 3)
    friction = np.tile([0.05, 0.12, 0.3], 3)
    together = capacity(paper_joint(preload=preload, friction_coefficient=friction), 1.0)
    for index in range(preload.size):
        alone = capacity(paper_joint(preload=preload[index], friction_coefficient=friction[index]), 1.0)
        assert float(together.output_torque[index]) == pytest.approx(float(alone.output_torque), rel=1e-11)
        assert int(together.limit[index]) == int(alone.limit)
        assert int(together.limiting_contact[index]) == int(alone.limiting_contact)


@pytest.mark.slow
@pytest.mark.parametrize(("mu", "kind"), [(0.12, "gross_slip"), (0.3, "lift_off")])
def test_gradients_are_the_implicit_ones(paper_joint, mu, kind):
    def of_preload(preload):
        joint = dataclasses.replace(paper_joint(friction_coefficient=mu), preload=preload)
        return torque_capacity(joint, direction=1.0)

    assert LIMIT_KINDS[int(of_preload(1000.0).limit)] == kind
    slope = float(jax.jit(jax.grad(lambda preload: of_preload(preload).output_torque))(1000.0))
    difference = float(of_preload(1020.0).output_torque - of_preload(980.0).output_torque) / 40.0
    assert slope == pytest.approx(difference, rel=1e-4)


def test_words_and_document(paper_joint):
    found = jax.tree.map(np.asarray, capacity(paper_joint(), 1.0))
    assert limit_words(found) == "contact sp slips"
    document = capacity_document(found)
    assert (document["limit"], document["limiting_contact"]) == ("gross_slip", "sp")
    never = dataclasses.replace(
        found, output_torque=jnp.inf, limit=np.asarray(0), limiting_contact=np.asarray(5)
    )
    assert capacity_document(never) == {
        "output_torque_Nm": None,
        "limit": "none",
        "limiting_contact": None,
        "meaning": "no limit is reached at any torque",
        "is_lower_bound": False,
    }
