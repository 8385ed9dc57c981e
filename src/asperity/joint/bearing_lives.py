"""Lives of the rolling bearings of a joint at its load and under its duty."""

from __future__ import annotations

from typing import Any, NamedTuple

from asperity.contact.rolling_fatigue import spectrum_life
from asperity.drive.layout.drive import Drive
from asperity.drive.state.loads import drag_pairs
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws
from asperity.drive.state.states import loaded_states
from asperity.drive.structure.bearing_life import (
    LIFE_EXPONENTS,
    RatedBearing,
    basic_rating_life,
    static_safety,
)
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import vectorised
from asperity.engine.module import Module
from asperity.joint.assembled import Pressed
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.fit import per_contact
from asperity.joint.laws import creep_under, rolling_load
from asperity.joint.loading_cam import pressed_at
from asperity.joint.machine import joint_machine
from asperity.joint.working_loads import (
    forces_on_axis,
    member_speeds,
    pin_speeds,
    working_forces,
    working_loads,
)
from asperity.types import Array, Real


class BearingLives(Module):
    """Lives of the bearings of a joint, shape (bearings, ...). SI units; nan where a bearing has no ratings.

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


class BearingState(NamedTuple):
    """What the drive does to its bearings, those of one place together, shape (bearings, ...); loads of a duty first.

    Radial force [N], and the angular velocity of one ring relative to the other, without its sign [rad/s].
    """

    force: Any
    speed: Any


def lives_of_bearings(
    rated: tuple[RatedBearing | None, ...],
    *,
    working: BearingState,
    rest: Array,
    duty: BearingState | None = None,
    shares: Array | None = None,
) -> BearingLives:
    r"""Lives, static safeties and load ratios of bearings, whatever their drive; nine in ten reach these lives; pure.

    .. math:: L_{10} = 10^6 \left(\frac CP\right)^p, \qquad
              \frac1T = \sum_j \varphi_j \frac{\omega_j}{2\pi L_{10,j}}, \qquad S_0 = \frac{C_0}{\max_j P_j}

    ``rest``: radial forces without torque [N]; ``shares`` of the loads of the duty in the time [-]. Equation (L2) of
    :doc:`/equations`.
    """
    load, at_rest = _radial_loads(rated, working.force), _radial_loads(rated, rest)
    life = _spectrum(rated, load[None], working.speed[None], xp.ones(1))
    largest, duty_life = load, xp.full_like(life, xp.nan)
    if duty is not None:
        assert shares is not None
        loads = vectorised(lambda force: _radial_loads(rated, force))(duty.force)
        duty_life = _spectrum(rated, loads, duty.speed, shares)
        largest = xp.maximum(load, xp.max(loads, axis=0))
    nothing = xp.full_like(load[0], xp.nan)
    safety, ratio = [], []
    for index, bearing in enumerate(rated):
        if bearing is None:
            safety.append(nothing)
            ratio.append(nothing)
            continue
        peak = xp.maximum(largest[index], at_rest[index])
        safety.append(static_safety(static_rating=bearing.static_rating, load=peak))
        ratio.append(largest[index] / bearing.dynamic_rating)
    return BearingLives(
        load=load,
        life=xp.where(working.speed > 0.0, life, xp.nan),
        duty_life=duty_life,
        static_safety=xp.stack(xp.broadcast_arrays(*safety)),
        load_ratio=xp.stack(xp.broadcast_arrays(*ratio)),
    )


def _radial_loads(rated: tuple[RatedBearing | None, ...], forces: Array) -> Array:
    """Load of one bearing at each place."""
    radial_loads = [
        xp.nan if bearing is None else force / bearing.count + bearing.outside_force
        for bearing, force in zip(rated, forces, strict=True)
    ]
    return xp.stack(xp.broadcast_arrays(*map(xp.asarray, radial_loads), forces[0])[:-1])


def _spectrum(rated: tuple[RatedBearing | None, ...], loads: Array, speeds: Array, shares: Real) -> Array:
    """Life in time of each bearing under loads along the first axis, shape (bearings, ...) [s]."""
    shares = xp.asarray(shares)
    lives: list[Real] = []
    for index, bearing in enumerate(rated):
        load, speed = loads[:, index], speeds[:, index]
        if bearing is None:
            lives.append(xp.full_like(load[0], xp.nan))
            continue
        turns = basic_rating_life(
            dynamic_rating=bearing.dynamic_rating, load=load, exponent=LIFE_EXPONENTS[bearing.kind]
        )
        share = shares.reshape(shares.shape + (1,) * (load.ndim - shares.ndim))
        rates = xp.where(speed > 0.0, speed, 0.0) / (2.0 * xp.pi)
        rates = xp.where(xp.isnan(speed), xp.nan, rates)
        lives.append(spectrum_life(lives=turns, cycle_rates=rates, time_shares=share))
    return xp.stack(xp.broadcast_arrays(*map(xp.asarray, lives)))


def joint_bearing_lives(joint: Joint, result: JointResult, laws: ContactLaws) -> BearingLives:
    """Lives, static safeties and load ratios of the bearings of a drive, (L2) of :doc:`/equations`; pure.

    Of the rollers on pins, then of input and output, which only unlike sectors load.
    """
    drive, under = joint.drive, {}
    if joint.rolling.duty:
        points = per_contact(joint.rolling.duty)
        duty = _under_duty(joint, Pressed(laws, result.rest), points.output_torque, points.input_speed)
        under = {"duty": duty, "shares": points.share}
    pins, at_rest = working_loads(joint, result).pin, result.rest
    loaded = forces_on_axis(joint, *working_forces(joint, result), pins)
    working = _state(drive, pins, loaded, member_speeds(joint, result))
    without = forces_on_axis(joint, at_rest.normal, at_rest.tangential, at_rest.pin_force)
    rest = _state(drive, at_rest.pin_force, without, xp.zeros(len(drive.members))).force
    return lives_of_bearings(joint.rated_bearings, working=working, rest=rest, **under)


def _state(drive: Drive, pin_force: Array, axis_force: Array, speeds: Array) -> BearingState:
    """The bearings of pins, input and output."""
    ends = xp.array([drive.members.index(drive.input), drive.members.index(drive.output)])
    return BearingState(
        xp.concatenate([xp.abs(pin_force), axis_force[ends]]),
        xp.concatenate([pin_speeds(drive, speeds), xp.abs(speeds[ends])]),
    )


def _under_duty(joint: Joint, without_torque: Pressed, torques: Array, speeds: Array) -> BearingState:
    """The bearings under the loads of the duty, which are the first axis."""
    machine = joint_machine(joint, without_torque.laws.rims)
    pressed = pressed_at(machine, without_torque)

    def under(torque: Array, speed: Array) -> BearingState:
        laws, rest = pressed(torque)
        both = loaded_states(
            drive=machine.drive,
            laws=laws,
            rest=rest,
            load=rolling_load(machine.under(torque, speed)),
            creep_of=creep_under(machine),
        )
        state = trees.map(lambda rests, rolls: xp.where(speed > 0.0, rolls, rests), *both)
        known = xp.where(state.residual < STATE_TOLERANCE, 1.0, xp.nan)
        tangential = state.tangential + drag_pairs(joint.drive, state.drag)
        loaded = forces_on_axis(joint, state.normal, tangential, state.pin_force)
        return _state(
            joint.drive,
            known * state.pin_force,
            known * loaded,
            xp.where(speed > 0.0, known * state.speed * speed, 0.0),
        )

    return vectorised(under)(torques, speeds)
