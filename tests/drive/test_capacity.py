"""Torque capacity: every contact at or below mu N, one of them exactly at it."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.capacity import capacity_by_search, slip_ratio, torque_capacity
from asperity.drive.force_balance import force_balance
from asperity.drive.geometry import CONTACT_NAMES, DriveGeometry, triangle
from asperity.drive.mechanism import Bearings, Mechanism, NormalSprings, rest_state

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
SIDES = triangle(PAPER)


def at_rest(preload):
    return {
        "geometry": PAPER,
        "sides": SIDES,
        "rest": rest_state(geometry=PAPER, sides=SIDES, preload=preload),
        "preload": preload,
    }


def drive(preload=1000.0, closure="elastic", roller_torque=0.0, sun_torque=0.0):
    compliance = jnp.full(5, 7e-9)
    return Mechanism(
        **at_rest(preload),
        bearings=Bearings(sun_torque, roller_torque, 0.0, 0.0, 0.0),
        springs=NormalSprings(compliance, 0.9 * compliance),
        carrier_speed=0.0,
        planet_mass=0.02,
        loading_roller_mass=0.003,
        closure=closure,
    )


@jax.jit
def capacity(mechanism, friction):
    return torque_capacity(mechanism=mechanism, friction_coefficient=friction)


@jax.jit
def balanced(mechanism, torque):
    return force_balance(mechanism=mechanism, output_torque=torque)


def ratios(mechanism, torque, friction):
    forces = force_balance(mechanism=mechanism, output_torque=torque)
    return np.asarray(
        slip_ratio(
            normal_force=forces.normal, tangential_force=forces.tangential, friction_coefficient=friction
        )
    )


@pytest.mark.parametrize("mu", [0.05, 0.12, 0.2])
def test_at_capacity_one_contact_is_at_its_limit_and_none_beyond(mu):
    friction = jnp.array([mu])
    found = capacity(drive(), friction)
    at_limit = ratios(drive(), found.output_torque, friction)
    assert at_limit.max() == pytest.approx(1.0, rel=1e-9)
    assert int(found.limiting_contact) == int(at_limit.argmax())


def test_per_contact_friction_names_the_weak_contact():
    friction = jnp.array([0.2, 0.2, 0.05, 0.2, 0.2])
    found = capacity(drive(), friction)
    assert CONTACT_NAMES[int(found.limiting_contact)] == "pwl"
    assert ratios(drive(), found.output_torque, friction)[2] == pytest.approx(1.0, rel=1e-9)


def test_a_steep_enough_friction_never_slips():
    """Once the left roller has lifted, the traction coefficient stays at tan(theta/2) = 0.2408."""
    direction = math.radians(27.0830551)  # model values of the paper's joint
    limit = math.tan(direction / 2.0)
    assert math.isinf(float(capacity(drive(), jnp.array([1.001 * limit])).output_torque))
    assert math.isfinite(float(capacity(drive(), jnp.array([0.99 * limit])).output_torque))


def test_capacity_is_proportional_to_the_preload_of_a_linear_drive():
    """Linear springs and no speed: all forces scale with the load."""
    compliance = jnp.full(5, 7e-9)
    linear = lambda n: Mechanism(  # noqa: E731
        **at_rest(n), bearings=Bearings(0.0, 0.0, 0.0, 0.0, 0.0), springs=NormalSprings(compliance, compliance),
        carrier_speed=0.0, planet_mass=0.0, loading_roller_mass=0.0, closure="elastic",
    )  # fmt: skip
    friction = jnp.array([0.12])
    one, two = (float(capacity(linear(n), friction).output_torque) for n in (500.0, 1000.0))
    assert two == pytest.approx(2.0 * one, rel=1e-9)


def test_a_bearing_that_drags_too_hard_leaves_no_capacity():
    assert float(capacity(drive(roller_torque=5.0), jnp.array([0.12])).output_torque) == 0.0


def test_gradient_is_the_implicit_one():
    friction = jnp.array([0.12])

    def of_preload(n):
        return torque_capacity(mechanism=drive(preload=n), friction_coefficient=friction).output_torque

    slope = float(jax.jit(jax.grad(of_preload))(1000.0))
    difference = float(of_preload(1001.0) - of_preload(999.0)) / 2.0
    assert slope == pytest.approx(difference, rel=1e-6)


def test_slip_ratio_of_an_open_contact():
    assert float(slip_ratio(normal_force=0.0, tangential_force=1.0, friction_coefficient=0.1)) == math.inf
    assert float(slip_ratio(normal_force=0.0, tangential_force=0.0, friction_coefficient=0.1)) == 0.0


def used(limit):
    """Ratios of five contacts under a torque, as by hand: contact 3 slips at the limit [N·m], then lifts off."""

    def ratios_at(torque):
        share = torque / limit
        return np.array([0.5 * share, 0.2, 0.0, share**3 if share < 1.5 else np.inf, 0.9 * share**3])

    return ratios_at


@pytest.mark.parametrize("guess", [1e-3, 1.0, 7.0, 7.5, 1e6])
def test_search_finds_the_limit_from_any_guess(guess):
    calls = []

    def counted(torque):
        calls.append(torque)
        return used(7.0)(torque)

    found = capacity_by_search(slip_ratios=counted, first_guess=guess)
    assert float(found.output_torque) == pytest.approx(7.0, rel=1e-12)
    assert CONTACT_NAMES[int(found.limiting_contact)] == "wro"
    assert len(calls) < 70


def test_search_without_a_limit_at_rest_and_without_a_solution():
    never = capacity_by_search(slip_ratios=lambda torque: np.full(5, 0.99), first_guess=1.0)
    at_rest = capacity_by_search(slip_ratios=lambda torque: np.array([0.0, 2.0, 0, 0, 0]), first_guess=1.0)
    assert float(never.output_torque) == math.inf
    assert (float(at_rest.output_torque), int(at_rest.limiting_contact)) == (0.0, 1)
    for holes in ((0.0, 1.0), (6.9, 8.0), (6.9, math.inf)):

        def with_hole(torque, holes=holes):
            return np.full(5, np.nan) if holes[0] <= torque < holes[1] else used(7.0)(torque)

        assert math.isnan(float(capacity_by_search(slip_ratios=with_hole, first_guess=1.0).output_torque)), (
            holes
        )


@pytest.mark.parametrize("preload", [10.0, 1000.0, 1e5])
def test_search_and_compiled_bisection_agree(preload):
    """Two routes to the root of one equation."""
    friction = jnp.array([0.12])
    mechanism = drive(preload=jnp.asarray(preload))
    compiled = capacity(mechanism, friction)

    def ratios_at(torque):
        forces = balanced(mechanism, torque)
        return np.asarray(
            slip_ratio(
                normal_force=forces.normal, tangential_force=forces.tangential, friction_coefficient=friction
            )
        )

    found = capacity_by_search(slip_ratios=ratios_at, first_guess=0.01 * preload)
    assert float(found.output_torque) == pytest.approx(float(compiled.output_torque), rel=1e-11)
    assert int(found.limiting_contact) == int(compiled.limiting_contact)
