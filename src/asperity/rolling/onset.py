r"""From wind-up to drift: how far the output falls behind after a step of torque while the joint turns.

The angle behind is the wind-up plus the creep of the contacts since they began to roll:

.. math::
    \varphi(\psi) = \varphi_0 + \frac{D}{2\pi} \sum_k c_k \left[\psi - \frac{L_k}{v_k}\,
    \varphi_{ri}\!\left(\frac{v_k \psi}{s_{0,k}}\right)\right], \qquad \sum_k c_k = 1

with the drift D per output turn, the angle psi turned by the output, the distance v rolled per angle of the output, the
onset of rolling of each contact (:mod:`asperity.contact.rolling_in`) and its share c of the drift.
"""

from __future__ import annotations

import numpy as np

from asperity.contact.rolling_in import rolling_in_lag, rolling_in_shift, still_stroke, swing_drift_share
from asperity.drive.layout.drive import Drive, creeping_speeds, driving_sense, speeds
from asperity.drive.state.creep import drift_per_turn
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, fori_loop
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.rolling.rolling import RollingResult
from asperity.types import Array, Real


class ContactsInSeries(Module):
    """What the creep of each contact adds to the angle of the output; arrays of shape (contacts,). SI units.

    Half-width [m]; ``slip_ratio``, share of the width that slips in Carter's sense, 1 − (c/a)² [-], T/(mu N) without
    skew; ``share`` in the drift [-], which add up to 1; ``distance`` that the contact rolls per angle of the output
    [m/rad]. ``input_angle`` per angle of the output [-]; ``drift_per_output_turn``, angle lost in one turn of the
    output in steady rolling [rad].
    """

    half_width: Array
    slip_ratio: Array
    share: Array
    distance: Array
    input_angle: Array
    drift_per_output_turn: Array


def contacts_in_series(*, drive: Drive, rolling: RollingResult, half_width: Array) -> ContactsInSeries:
    r"""Shares of the contacts in the drift of a joint.

    .. math:: c_k = \frac{T_k s_k}{\sum_j T_j s_j}, \qquad s_k = \xi_k V_k

    Parameters
    ----------
    drive : Drive
        The drive.
    rolling : RollingResult
        Its steady rolling; its creepages and forces count with the sense of the drive, as in a joint's result.
    half_width : Array
        Half-widths of its contacts in rolling, shape (contacts,) [m].

    Returns
    -------
    ContactsInSeries
        Where the torque drives the rotation: of the rotation that the same forces resist.

    Notes
    -----
    The speed that the output loses times its torque is the power of the creep, contact by contact.

    References
    ----------
    Equations (B1), (B10) and (M3) of :doc:`/equations`.
    """
    out = drive.members.index(drive.output)
    ideal = speeds(drive)
    forwards = driving_sense(drive) * rolling.creepage
    ahead, _ = creeping_speeds(drive=drive, creepage=forwards)
    resisted = xp.where(xp.abs(ahead[out]) > xp.abs(ideal[out]), -1.0, 1.0)
    speed, rolled = creeping_speeds(drive=drive, creepage=resisted * forwards)
    work = xp.abs(rolling.tangential * rolling.creepage) * rolled
    loss = 1.0 - speed[out] / ideal[out]
    turned = xp.abs(speed[out])
    return ContactsInSeries(
        half_width=half_width,
        slip_ratio=1.0 - xp.asarray(rolling.stick_fraction) ** 2,
        share=work / xp.sum(work),
        distance=rolled / turned,
        input_angle=1.0 / turned,
        drift_per_output_turn=drift_per_turn(loss),
    )


_POINTS = 241
_HALVINGS = 60


class RollingOnset(Module):
    """Up to which angle a wind-up holds, and the curve beyond. SI units; angles of the output, without sign.

    Parameters
    ----------
    contacts : ContactsInSeries
        The contacts.
    windup : Array
        Angle of the static curve at the torque [rad].
    creep_share : Array
        Creep over wind-up up to which the static curve is said to hold [-].
    static_angle : Array
        Angle turned by then [rad].
    width_angle : Array
        Angle in which each contact rolls its own width 2a, shape (contacts,) [rad].
    steady_angle : Array
        The largest of them, from which the creep of the joint is steady [rad].
    missing_angle : Array
        Angle by which the drift line starts below the static angle [rad].
    still_angle : Array
        Largest swing to and fro in which no contact drifts [rad].
    angle : Array
        Angles turned, from 0, shape (n,) [rad].
    lag : Array
        Angle behind after turning by them, shape (n,) [rad].
    swing_drift : Array
        Angle lost in each swing by them, to and fro, once the swings repeat, shape (n,) [rad].
    """

    contacts: ContactsInSeries
    windup: Array
    creep_share: Array
    static_angle: Array
    width_angle: Array
    steady_angle: Array
    missing_angle: Array
    still_angle: Array
    angle: Array
    lag: Array
    swing_drift: Array


def creep_lag(*, contacts: ContactsInSeries, angle: Real) -> Array:
    r"""Angle by which the output falls behind by creep after a step of torque, from rest or in rolling.

    .. math::
        \frac{D}{2\pi} \sum_k c_k \left[\psi - \frac{L_k}{v_k}\,
        \varphi_{ri}\!\left(\frac{v_k \psi}{s_{0,k}}\right)\right]

    Parameters
    ----------
    contacts : ContactsInSeries
        The contacts.
    angle : Real
        Angle psi turned by the output, not negative, shape (...) [rad].

    Returns
    -------
    Array
        Angle, shape (...) [rad].

    Notes
    -----
    Starts with half the drift per angle and goes over into the drift line, whose slope is exact. The forces of steady
    rolling are taken from the start.

    References
    ----------
    Equation (B10) of :doc:`/equations`; :func:`asperity.contact.rolling_in.rolling_in_shift`.
    """
    turned = xp.asarray(angle)

    def along(values: Array) -> Array:
        return values.reshape(-1, *(1,) * turned.ndim)

    distance = along(contacts.distance)
    rolled = rolling_in_shift(
        rolled_distance=distance * turned,
        half_width=along(contacts.half_width),
        slip_ratio=along(contacts.slip_ratio),
        creepage=1.0,
    )
    per_angle = contacts.drift_per_output_turn / (2.0 * xp.pi)
    return per_angle * xp.sum(along(contacts.share) * rolled / distance, axis=0)


def swing_drift(*, contacts: ContactsInSeries, angle: Real) -> Array:
    r"""Angle that the output loses in each swing to and fro under a constant torque, once the swings repeat.

    .. math:: \frac{D}{2\pi}\, 2\psi \sum_k c_k\, g(v_k \psi, q_k)

    Parameters
    ----------
    contacts : ContactsInSeries
        The contacts.
    angle : Real
        Stroke psi of the output in one direction, not negative, shape (...) [rad].

    Returns
    -------
    Array
        Angle, shape (...) [rad].

    Notes
    -----
    The forces of steady rolling are taken throughout; g is :func:`asperity.contact.rolling_in.swing_drift_share`.

    References
    ----------
    Equation (B10) of :doc:`/equations`.
    """
    turned = xp.asarray(angle)

    def along(values: Array) -> Array:
        return values.reshape(-1, *(1,) * turned.ndim)

    kept = swing_drift_share(
        stroke=along(contacts.distance) * turned,
        half_width=along(contacts.half_width),
        slip_ratio=along(contacts.slip_ratio),
    )
    per_angle = contacts.drift_per_output_turn / (2.0 * xp.pi)
    return 2.0 * turned * per_angle * xp.sum(along(contacts.share) * kept, axis=0)


def rolling_onset(
    *, joint: Joint, result: JointResult, windup: Real, creep_share: float
) -> RollingOnset | None:
    """Up to which angles of a joint that turns its wind-up holds, and the curve beyond."""
    if not (np.isfinite(creep_share) and creep_share > 0.0):
        raise InputError(f"the creep share {creep_share:g} is not allowed; it must be positive, e.g. 0.05")
    if not np.all(np.isfinite(np.asarray(result.rolling.residual))):
        return None
    grown = np.sqrt(np.asarray(result.rolling.normal) / np.asarray(result.forces.normal))  # Hertz
    width = np.asarray(result.diagnostics.hertz_half_width) * grown
    numbers = as_numbers((joint.drive, result.rolling, width, windup, creep_share))
    found: RollingOnset = at_once(_onset, *numbers)
    return found


def _onset(
    drive: Drive, rolling: RollingResult, half_width: Array, windup: Array, creep_share: Array
) -> RollingOnset:
    contacts = contacts_in_series(drive=drive, rolling=rolling, half_width=half_width)
    allowed = creep_share * windup
    drift = contacts.drift_per_output_turn / (2.0 * xp.pi)

    def halve(_: int, ends: tuple[Array, Array]) -> tuple[Array, Array]:
        middle = 0.5 * (ends[0] + ends[1])
        below = creep_lag(contacts=contacts, angle=middle) < allowed
        return xp.where(below, middle, ends[0]), xp.where(below, ends[1], middle)

    # the creep grows with the angle and is never below half the drift
    ends = xp.zeros_like(allowed), 2.01 * allowed / drift
    static = fori_loop(0, _HALVINGS, halve, ends)[1]
    width = 2.0 * contacts.half_width / contacts.distance
    steady = xp.max(width)
    lag = rolling_in_lag(half_width=contacts.half_width, slip_ratio=contacts.slip_ratio)
    still = still_stroke(half_width=contacts.half_width, slip_ratio=contacts.slip_ratio)
    angle = xp.maximum(3.0 * steady, 1.2 * static) * xp.linspace(0.0, 1.0, _POINTS)
    return RollingOnset(
        contacts=contacts,
        windup=windup,
        creep_share=creep_share,
        static_angle=static,
        width_angle=width,
        steady_angle=steady,
        missing_angle=drift * xp.sum(contacts.share * lag / contacts.distance),
        still_angle=xp.min(still / contacts.distance),
        angle=angle,
        lag=windup + creep_lag(contacts=contacts, angle=angle),
        swing_drift=swing_drift(contacts=contacts, angle=angle),
    )
