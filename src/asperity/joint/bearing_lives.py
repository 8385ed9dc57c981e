"""Lives of the rolling bearings of a joint at its load and under its duty."""

from __future__ import annotations

import dataclasses

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.rolling_fatigue import spectrum_life
from asperity.drive.bearing_life import LIFE_EXPONENTS, RatedBearing, basic_rating_life, static_safety
from asperity.joint.description import Joint, per_contact, with_one_rank
from asperity.joint.evaluation import JointResult, evaluate
from asperity.joint.working_loads import bearing_speeds, loads_at_rest, working_loads
from asperity.types import Real

#: Bearings of a joint, in the order of every bearing axis.
BEARING_NAMES = ("right_pin", "left_pin", "sun", "carrier")


class BearingLives(eqx.Module):
    """Lives of the bearings of :data:`BEARING_NAMES`, shape (4, ...). SI units; nan where a bearing has no ratings.

    Parameters
    ----------
    load : Array
        Radial load of one bearing under the joint's torque [N].
    life : Array
        Basic rating life at this load and speed [s]; infinite without a load, nan where the bearing stands.
    duty_life : Array
        The same under the duty [s]; nan without a duty.
    static_safety : Array
        Static rating over the largest load at rest, under the torque and under the duty [-].
    load_ratio : Array
        Largest load over dynamic rating under the torque and under the duty [-].
    """

    load: Array
    life: Array
    duty_life: Array
    static_safety: Array
    load_ratio: Array


def rated_bearings(joint: Joint) -> tuple[RatedBearing | None, ...]:
    """Ratings of the bearings.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    tuple of RatedBearing or None
        In the order of :data:`BEARING_NAMES`.
    """
    return (joint.pin_bearing, joint.pin_bearing, joint.sun_bearing, joint.carrier_bearing)


def _state(joint: Joint, result: JointResult) -> tuple[Array, Array]:
    """Loads and speeds of the bearings, shape (4, ...)."""
    speeds = bearing_speeds(joint, result)
    loads = _radial_loads(joint, working_loads(joint, result).pin_resultant)
    return loads, jnp.stack(jnp.broadcast_arrays(*speeds.pin, speeds.sun, speeds.carrier))


def _radial_loads(joint: Joint, pin_forces: Array) -> Array:
    """Load of one bearing of each kind: equal branches load the pins only."""
    from_drive = (*pin_forces, 0.0, 0.0)
    found = [
        jnp.nan if bearing is None else force / bearing.count + bearing.outside_force
        for bearing, force in zip(rated_bearings(joint), from_drive, strict=True)
    ]
    return jnp.stack(jnp.broadcast_arrays(*map(jnp.asarray, found), pin_forces[0])[:4])


def bearing_lives(joint: Joint, result: JointResult) -> BearingLives:
    r"""Lives, static safeties and load ratios of a joint's bearings; pure.

    .. math:: L_{10} = 10^6 \left(\frac CP\right)^p, \qquad
              \frac1T = \sum_j \varphi_j \frac{\omega_j}{2\pi L_{10,j}}, \qquad S_0 = \frac{C_0}{\max_j P_j}

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        Its result.

    Returns
    -------
    BearingLives
        Nine bearings in ten reach these lives; the reliability of the joint file is that of the tracks.

    References
    ----------
    Equation (L2) of :doc:`/equations`.
    """
    joint = with_one_rank(joint)
    load, speed = _state(joint, result)
    rest = _radial_loads(joint, loads_at_rest(joint).pin_resultant)
    life = _spectrum(joint, load[None], speed[None], jnp.ones(1))
    largest, duty_life = load, jnp.full_like(life, jnp.nan)
    if joint.rolling.duty:
        points = per_contact(joint.rolling.duty)
        loads, speeds = _under_duty(joint, points.output_torque, points.sun_speed)
        duty_life = _spectrum(joint, loads, speeds, points.share)
        largest = jnp.maximum(load, jnp.max(loads, axis=0))
    nothing = jnp.full_like(load[0], jnp.nan)
    safety, ratio = [], []
    for index, bearing in enumerate(rated_bearings(joint)):
        if bearing is None:
            safety.append(nothing)
            ratio.append(nothing)
            continue
        peak = jnp.maximum(largest[index], rest[index])
        safety.append(static_safety(static_rating=bearing.static_rating, load=peak))
        ratio.append(largest[index] / bearing.dynamic_rating)
    return BearingLives(
        load=load,
        life=jnp.where(speed > 0.0, life, jnp.nan),
        duty_life=duty_life,
        static_safety=jnp.stack(jnp.broadcast_arrays(*safety)),
        load_ratio=jnp.stack(jnp.broadcast_arrays(*ratio)),
    )


def _under_duty(joint: Joint, torques: Array, speeds: Array) -> tuple[Array, Array]:
    """Loads and speeds under the loads of the duty, which are the first axis."""
    alone = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=()))

    def under(torque: Array, speed: Array) -> tuple[Array, Array]:
        loaded = dataclasses.replace(alone, output_torque=torque, sun_speed=speed)
        return _state(loaded, evaluate(loaded))

    found: tuple[Array, Array] = jax.vmap(under)(torques, speeds)
    return found


def _spectrum(joint: Joint, loads: Array, speeds: Array, shares: Real) -> Array:
    """Life in time of each bearing under loads along the first axis, shape (4, ...) [s]."""
    shares = jnp.asarray(shares)
    lives: list[Real] = []
    for index, bearing in enumerate(rated_bearings(joint)):
        load, speed = loads[:, index], speeds[:, index]
        if bearing is None:
            lives.append(jnp.full_like(load[0], jnp.nan))
            continue
        turns = basic_rating_life(
            dynamic_rating=bearing.dynamic_rating, load=load, exponent=LIFE_EXPONENTS[bearing.kind]
        )
        share = shares.reshape(shares.shape + (1,) * (load.ndim - shares.ndim))
        rates = jnp.where(speed > 0.0, speed, 0.0) / (2.0 * jnp.pi)
        rates = jnp.where(jnp.isnan(speed), jnp.nan, rates)
        lives.append(spectrum_life(lives=turns, cycle_rates=rates, time_shares=share))
    return jnp.stack(jnp.broadcast_arrays(*map(jnp.asarray, lives)))
