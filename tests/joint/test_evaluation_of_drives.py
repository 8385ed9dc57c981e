"""The chain of the paper's drive and of a planetary one: balances, limiting cases, a duty, and derivatives."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.bearings import Bearings
from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.joint.evaluation import evaluate
from asperity.joint_file.build import joint_from_case
from asperity.rolling.conditions import DutyPoint

pytestmark = pytest.mark.slow


def solved(function, joint):
    numbers = as_numbers(joint)
    return at_once(function, numbers)


@pytest.fixture(scope="module")
def springs(paper_joint):
    """The paper's joint with springs as bodies, which make the program small."""
    return paper_joint(ring_wall_thickness=60e-3, body_model="springs")


def crowned(joint, curvature):
    """Planets with crowns."""
    return dataclasses.replace(joint, crown_curvatures=(curvature, curvature, curvature, 0.0, 0.0))


@pytest.mark.long
def test_crowns_of_infinite_radius_are_cylinders(springs):
    """And planets with crowns of 0.5 m are softer."""
    round_ones, cylinders, even = (
        solved(evaluate, joint) for joint in (crowned(springs, 2.0), crowned(springs, 0.0), springs)
    )
    assert bool(round_ones.solved)
    assert float(cylinders.interference) == pytest.approx(float(even.interference), rel=1e-9)
    np.testing.assert_allclose(cylinders.forces.tangential, even.forces.tangential, rtol=1e-7)
    np.testing.assert_allclose(cylinders.rolling.creepage, even.rolling.creepage, rtol=1e-7)
    for get in (
        lambda result: result.published.output,
        lambda result: result.series_with_bulk.output,
        lambda result: result.assembly.stiffness.output,
    ):
        assert float(get(cylinders)) == pytest.approx(float(get(even)), rel=1e-7)
    assert float(round_ones.assembly.stiffness.output) < 0.97 * float(even.assembly.stiffness.output)


@pytest.mark.long
def test_no_skew_is_skew_zero(springs):
    joint = springs
    parallel, zero = (
        solved(evaluate, dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, skew=skew)))
        for skew in (None, (0.0,))
    )
    for (path, value), other in zip(
        jax.tree_util.tree_leaves_with_path(parallel.rolling), jax.tree.leaves(zero.rolling), strict=True
    ):
        name = jax.tree_util.keystr(path)
        if "residual" not in name:
            np.testing.assert_allclose(other, value, rtol=1e-9, atol=1e-12, equal_nan=True, err_msg=name)


def test_every_state_satisfies_the_published_balance(springs):
    """Equations (1) to (4) for the general chain's state at rest under the torque, without masses' share in (2)."""
    general = solved(evaluate, springs)
    theta, beta = math.radians(27.083145), math.radians(13.158247)
    normal, tangential = np.asarray(general.forces.normal), np.asarray(general.forces.tangential)
    # planet: moment about its own axis, (1)
    assert tangential[0] == pytest.approx(tangential[1] + tangential[2], rel=1e-9)
    # planet across its radius
    across = (
        (normal[1] - normal[2]) * math.sin(theta)
        - (tangential[1] + tangential[2]) * math.cos(theta)
        - tangential[0]
    )
    assert abs(across) < 1e-5 * normal[0]
    assert beta > 0.0


@pytest.mark.long
def test_derivatives_are_those_of_differences(springs):
    joint = dataclasses.replace(springs, input_speed=0.0)

    def loss(torque):
        found = evaluate(dataclasses.replace(joint, output_torque=torque))
        return jnp.stack([found.rolling.speed_loss * 1e3, found.assembly.stiffness.output * 1e-3])

    compiled = jax.jit(jax.jacfwd(loss))
    value = jax.jit(loss)
    step = 1e-4
    expected = (value(5.0 + step) - value(5.0 - step)) / (2.0 * step)
    np.testing.assert_allclose(compiled(5.0), expected, rtol=1e-5)


@pytest.mark.long
def test_derivatives_by_crown_and_skew_are_those_of_differences(springs):
    joint = dataclasses.replace(springs, input_speed=100.0)

    def results(numbers):
        crown, skew = numbers
        found = evaluate(
            dataclasses.replace(
                joint,
                crown_curvatures=(crown, crown, crown, 0.0 * crown, 0.0 * crown),
                rolling=dataclasses.replace(joint.rolling, skew=(skew,)),
            )
        )
        rolling = found.rolling
        return jnp.stack(
            [
                jnp.log(rolling.speed_loss),
                jnp.log(found.assembly.stiffness.output),
                jnp.log(rolling.life_turns.drive),
                1e-2 * rolling.axial_force[0],
            ]
        )

    at, steps = jnp.array([1.0, 3e-4]), jnp.array([1e-4, 1e-8])
    value = jax.jit(results)
    found = jax.jit(jax.jacfwd(results))(at)
    for column, step in enumerate(steps):
        change = jnp.zeros(2).at[column].set(step)
        expected = (value(at + change) - value(at - change)) / (2.0 * step)
        np.testing.assert_allclose(found[:, column], expected, rtol=1e-4, atol=1e-6)


def with_duty(joint, *loads):
    points = tuple(DutyPoint(*map(float, load)) for load in loads)
    return dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=points))


@pytest.mark.long
def test_a_duty_of_a_planetary_drive(planar_case):
    """Its loads as the joint that is solved under each; sizes of the springs alone make the program small."""
    springs = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free" ': 'ring_support = "rigid_housing" ',
    }
    joint = joint_from_case(planar_case("planetary", replaced=springs))
    speed = float(joint.input_speed)
    found, alike, braking = (
        solved(evaluate, with_duty(joint, *loads)).rolling
        for loads in (
            ((10.0, speed, 0.25), (20.0, 2.0 * speed, 0.75)),
            ((10.0, speed, 0.5), (10.0, speed, 0.5)),
            ((10.0, speed, 0.5), (-10.0, speed, 0.5)),
        )
    )
    # a load that is the joint's own has its life, and so has a duty of nothing else
    own = float(found.life_hours.drive)
    assert float(found.duty_load_hours[0]) == pytest.approx(own, rel=1e-9)
    assert float(alike.duty_life_hours) == pytest.approx(own, rel=1e-9)
    assert np.asarray(alike.duty_damage_shares) == pytest.approx([0.5, 0.5], rel=1e-9)
    turns = own * 3600.0 * float(found.output_speed) / (2.0 * math.pi)
    assert float(alike.duty_life_turns) == pytest.approx(turns, rel=1e-9)
    # the joint solved under the other load lives as long as the duty says
    other = dataclasses.replace(joint, output_torque=20.0, input_speed=2.0 * speed)
    alone = solved(evaluate, with_duty(other, (10.0, speed, 0.5), (20.0, speed, 0.5))).rolling
    assert float(found.duty_load_hours[1]) == pytest.approx(float(alone.life_hours.drive), rel=1e-9)
    # Palmgren and Miner; sun and planets wear in one proportion, their tracks bear equal forces
    miner = 1.0 / (0.25 / own + 0.75 / float(found.duty_load_hours[1]))
    assert float(found.duty_life_hours) == pytest.approx(miner, rel=1e-3)
    assert float(np.sum(found.duty_damage_shares)) == pytest.approx(1.0, rel=1e-12)
    assert float(braking.duty_load_hours[1]) == pytest.approx(own, rel=2e-2)
    # a load beyond the capacity has no life, and neither has the duty
    beyond = solved(evaluate, with_duty(joint, (10.0, speed, 0.5), (1e4, speed, 0.5))).rolling
    assert np.isnan(float(beyond.duty_life_hours))
    assert float(beyond.life_hours.drive) == pytest.approx(own, rel=1e-9)


def test_power_is_lost_by_creep_and_bearings_alone(springs):
    """All that enters is the torque of the balance of forces, by equation (1)."""
    friction = Bearings(
        input_torque=2e-3,
        roller_torque=1e-3,
        output_torque=2e-2,
        pin_friction_coefficient=0.01,
        pin_friction_diameter=4e-3,
    )
    rolled = solved(evaluate, dataclasses.replace(springs, bearings=friction)).rolling
    power, speed = rolled.power, float(springs.input_speed)
    lost = float(np.sum(power.creep)) + float(power.bearings)
    assert float(power.loss) == pytest.approx(lost, rel=1e-12)
    torque = (3.0 * float(rolled.tangential[0]) * 4e-3 + 2.0 * 2e-3) * speed
    assert float(power.input) == pytest.approx(torque, rel=1e-8)
    # two bearings of each shaft; the rollers turn (35/5 + 1)/9 times as fast as the sun on their pins
    shafts = 2.0 * (2e-3 + 2e-2 / 9.0) * speed
    rollers = 2.0 * 3.0 * 2.0 * 1e-3 * 8.0 / 9.0 * speed
    assert float(power.bearings) > shafts + rollers
    without_pins = dataclasses.replace(friction, pin_friction_coefficient=0.0)
    found = solved(evaluate, dataclasses.replace(springs, bearings=without_pins)).rolling
    assert float(found.power.bearings) == pytest.approx(shafts + rollers, rel=3e-3)  # creep slows them
