"""The paper's drive through the general chain against its own solver, and derivatives."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from asperity.joint.evaluation import evaluate
from asperity.joint_file.build import joint_from_case

from asperity.compilation import compile_fast
from asperity.joint.description import Crowns
from asperity.joint.planar.evaluation import evaluate_planar
from asperity.joint.rolling_conditions import DutyPoint
from asperity.joint_file.planar_build import planar_joint_from_case

pytestmark = pytest.mark.slow


def solved(function, joint):
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    return jax.tree.map(np.asarray, compile_fast(function, numbers)(numbers))


@pytest.fixture(scope="module")
def both(case, as_planar):
    joint = joint_from_case(case)
    return solved(evaluate, joint), solved(evaluate_planar, as_planar(joint))


def test_the_papers_drive_agrees_with_its_own_solver(both):
    """Its forces differ by at most 0.1 %: its own solver takes the direction of the forces as those of the layout."""
    own, general = both
    assert bool(general.solved)
    assert float(general.speed_ratio) == pytest.approx(float(own.speed_ratio), rel=1e-12)
    assert float(general.interference) == pytest.approx(float(own.interference), rel=1e-3)
    rolled, expected = general.rolling, own.rolling
    np.testing.assert_allclose(rolled.normal, expected.normal, rtol=2e-3)
    np.testing.assert_allclose(rolled.tangential, expected.tangential, rtol=2e-3)
    assert float(rolled.speed_loss) == pytest.approx(float(expected.speed_loss), rel=2e-3)
    assert float(rolled.power.efficiency) == pytest.approx(float(expected.power.efficiency), rel=1e-4)
    assert float(rolled.life_hours.drive) == pytest.approx(float(expected.life_hours.drive), rel=0.02)
    np.testing.assert_allclose(rolled.shakedown_ratio, expected.shakedown_ratio, rtol=2e-3)
    # at rest the published closure shares the traction equally, the general one by the springs
    for level in ("published", "series_with_bulk"):
        assert float(getattr(general, level).output) == pytest.approx(
            float(getattr(own, level).output), rel=5e-3
        )
    assert float(general.assembly.stiffness.output) == pytest.approx(
        float(own.assembly.stiffness.output), rel=5e-3
    )


@pytest.mark.long
def test_skewed_rollers_of_the_papers_drive_agree_with_its_own_solver(case, as_planar):
    """Skew counts at the traction of the drive at rest, which the published closure shares in another way."""
    joint = dataclasses.replace(joint_from_case(case), body_model="springs")
    skew = (1e-3, 5e-4, -3e-4, 8e-4, -1e-3)
    joint = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, skew=skew))
    expected, found = solved(evaluate, joint).rolling, solved(evaluate_planar, as_planar(joint)).rolling
    for name in ("tangential", "creepage", "skew_creepage_factor", "capacity_loss", "axial_force"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-2, err_msg=name)
    np.testing.assert_allclose(
        found.axial_thrust, expected.axial_thrust, rtol=5e-3, atol=5e-3 * np.max(np.abs(expected.axial_force))
    )
    np.testing.assert_allclose(found.power.skew, expected.power.skew, rtol=5e-3)
    assert float(found.speed_loss) == pytest.approx(float(expected.speed_loss), rel=2e-3)
    assert float(found.power.efficiency) == pytest.approx(float(expected.power.efficiency), rel=1e-4)


@pytest.mark.long
def test_crowned_rollers_of_the_papers_drive_agree_with_its_own_solver(case, as_planar):
    """Planets with crowns of 0.5 m and of infinite radius; the latter are cylinders."""
    joint = dataclasses.replace(joint_from_case(case), body_model="springs")
    crowned, flat = (
        dataclasses.replace(joint, crowns=Crowns(sun=0.0, planet=curvature, loading_roller=0.0, ring=0.0))
        for curvature in (2.0, 0.0)
    )
    expected, found = solved(evaluate, crowned), solved(evaluate_planar, as_planar(crowned))
    assert bool(found.solved)
    assert float(found.interference) == pytest.approx(float(expected.interference), rel=1e-3)
    for name in ("hertz_pressure", "loaded_length_share", "peak_line_load_ratio"):
        own, general = getattr(expected.diagnostics, name), getattr(found.diagnostics, name)
        np.testing.assert_allclose(general, own, rtol=2e-3, err_msg=name)
    for name in ("normal", "tangential", "creepage", "crown_creepage_factor", "shakedown_ratio"):
        own, general = getattr(expected.rolling, name), getattr(found.rolling, name)
        np.testing.assert_allclose(general, own, rtol=5e-3, err_msg=name)
    for get in (
        lambda result: result.rolling.speed_loss,
        lambda result: result.published.output,
        lambda result: result.series_with_bulk.output,
        lambda result: result.assembly.stiffness.output,
    ):
        assert float(get(found)) == pytest.approx(float(get(expected)), rel=5e-3)
    assert float(found.rolling.life_hours.drive) == pytest.approx(
        float(expected.rolling.life_hours.drive), rel=0.02
    )
    cylinders, even = solved(evaluate_planar, as_planar(flat)), solved(evaluate_planar, as_planar(joint))
    assert float(cylinders.interference) == pytest.approx(float(even.interference), rel=1e-9)
    np.testing.assert_allclose(cylinders.forces.tangential, even.forces.tangential, rtol=1e-7)
    np.testing.assert_allclose(cylinders.rolling.creepage, even.rolling.creepage, rtol=1e-7)
    for name in ("published", "series_with_bulk"):
        assert float(getattr(cylinders, name).output) == pytest.approx(
            float(getattr(even, name).output), rel=1e-7
        )
    assert float(cylinders.assembly.stiffness.output) == pytest.approx(
        float(even.assembly.stiffness.output), rel=1e-7
    )
    assert float(found.assembly.stiffness.output) < 0.97 * float(even.assembly.stiffness.output)


def test_no_skew_is_skew_zero(case, as_planar):
    joint = dataclasses.replace(as_planar(joint_from_case(case)), body_model="springs")
    parallel, zero = (
        solved(
            evaluate_planar, dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, skew=skew))
        )
        for skew in (None, (0.0,))
    )
    for (path, value), other in zip(
        jax.tree_util.tree_leaves_with_path(parallel.rolling), jax.tree.leaves(zero.rolling), strict=True
    ):
        name = jax.tree_util.keystr(path)
        if "residual" not in name:
            np.testing.assert_allclose(other, value, rtol=1e-9, atol=1e-12, equal_nan=True, err_msg=name)


def test_every_state_satisfies_the_published_balance(both):
    """Equations (1) to (4) for the general chain's state at rest under the torque, without masses' share in (2)."""
    _, general = both
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


def test_derivatives_are_those_of_differences(case, as_planar):
    joint = as_planar(joint_from_case(case))
    joint = dataclasses.replace(joint, body_model="springs", input_speed=0.0)

    def loss(torque):
        found = evaluate_planar(dataclasses.replace(joint, output_torque=torque))
        return jnp.stack([found.rolling.speed_loss * 1e3, found.assembly.stiffness.output * 1e-3])

    compiled = jax.jit(jax.jacfwd(loss))
    value = jax.jit(loss)
    step = 1e-4
    expected = (value(5.0 + step) - value(5.0 - step)) / (2.0 * step)
    np.testing.assert_allclose(compiled(5.0), expected, rtol=1e-5)


@pytest.mark.long
def test_derivatives_by_crown_and_skew_are_those_of_differences(case, as_planar):
    joint = joint_from_case(case)
    joint = dataclasses.replace(as_planar(joint), body_model="springs", input_speed=100.0)

    def results(numbers):
        crown, skew = numbers
        found = evaluate_planar(
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


def test_a_duty_of_a_planetary_drive(planar_case):
    """Its loads as the joint that is solved under each; sizes of the springs alone make the program small."""
    springs = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free" ': 'ring_support = "rigid_housing" ',
    }
    joint = planar_joint_from_case(planar_case("planetary", replaced=springs))
    speed = float(joint.input_speed)
    found, alike, braking = (
        solved(evaluate_planar, with_duty(joint, *loads)).rolling
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
    alone = solved(evaluate_planar, with_duty(other, (10.0, speed, 0.5), (20.0, speed, 0.5))).rolling
    assert float(found.duty_load_hours[1]) == pytest.approx(float(alone.life_hours.drive), rel=1e-9)
    # Palmgren and Miner; sun and planets wear in one proportion, their tracks bear equal forces
    miner = 1.0 / (0.25 / own + 0.75 / float(found.duty_load_hours[1]))
    assert float(found.duty_life_hours) == pytest.approx(miner, rel=1e-3)
    assert float(np.sum(found.duty_damage_shares)) == pytest.approx(1.0, rel=1e-12)
    assert float(braking.duty_load_hours[1]) == pytest.approx(own, rel=2e-2)
    # a load beyond the capacity has no life, and neither has the duty
    beyond = solved(evaluate_planar, with_duty(joint, (10.0, speed, 0.5), (1e4, speed, 0.5))).rolling
    assert np.isnan(float(beyond.duty_life_hours))
    assert float(beyond.life_hours.drive) == pytest.approx(own, rel=1e-9)


def test_bearings_of_the_papers_drive(case, as_planar):
    """Shafts as in its own chain. Its equation (5) leaves out what the rollers' bearings do to the carrier."""
    joint = joint_from_case(case)
    shafts = dataclasses.replace(joint.bearings, sun_torque=2e-3, carrier_torque=2e-2)
    with_it = dataclasses.replace(as_planar(joint), bearings=shafts)
    own = solved(evaluate, dataclasses.replace(joint, bearings=shafts)).rolling
    found = solved(evaluate_planar, with_it).rolling
    assert float(found.power.bearings) == pytest.approx(float(own.power.bearings), rel=1e-4)
    assert float(found.power.efficiency) == pytest.approx(float(own.power.efficiency), rel=1e-4)
    np.testing.assert_allclose(found.tangential, own.tangential, rtol=3e-3)
    rollers = dataclasses.replace(
        shafts, loading_roller_torque=1e-3, pin_friction_coefficient=0.01, pin_diameter=4e-3
    )
    result = solved(evaluate_planar, dataclasses.replace(with_it, bearings=rollers))
    rolled = result.rolling
    power = rolled.power
    own = solved(evaluate, dataclasses.replace(joint, bearings=rollers)).rolling
    assert float(power.bearings) == pytest.approx(float(own.power.bearings), rel=1e-2)
    # all that enters is the torque of the balance of forces: nothing is lost but by creep and bearings
    lost = float(np.sum(power.creep)) + float(power.bearings)
    assert float(power.loss) == pytest.approx(lost, rel=1e-12)
    torque = (3.0 * float(rolled.tangential[0]) * 4e-3 + 2.0 * 2e-3) * float(joint.sun_speed)
    assert float(power.input) == pytest.approx(torque, rel=1e-8)
