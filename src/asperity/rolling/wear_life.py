r"""How long wear lets a joint carry its loads, of one joint or of many at once, with derivatives.

The first stage of :mod:`asperity.rolling.wear_course` alone, up to the first limit that is reached, as one pure
function: for the points of a study.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

from asperity.drive.layout.drive import incidence
from asperity.drive.state.first_limit import first_limit
from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, scan, traced_once, vectorised
from asperity.engine.derivatives import without_slopes
from asperity.joint.description import Joint, without_duty
from asperity.joint.machine import JointMachine, joint_machine
from asperity.rolling.wear_rates import Wearing, WearLoad, Worn, wear_state
from asperity.types import Array, Real

_GAUSS_POINTS = 24
#: Share of the interference up to which wear is followed, and of its curvature with which a crown counts as worn flat.
_MOST, _FLAT = 1.0 - 1e-5, 1e-3
#: Passes along the path of the contacts' interferences where the drive feels several numbers, and the largest change
#: of the time in the last one [-].
_PASSES, _SETTLED = 10, 1e-4
#: Halvings of the time for the state after a life; a last step takes the rest.
_HALVINGS = 40

_NODES, _WEIGHTS = legendre.leggauss(_GAUSS_POINTS)
#: Gauss points of y, 0 to 1; interference lost is the length of the stage times 1 − y².
_Y = 0.5 * (1.0 + _NODES)


def _integrals() -> np.ndarray:
    """Values at the Gauss points → Legendre coefficients of their integral from y = 0, shape (points + 1, points)."""
    degrees = np.arange(_GAUSS_POINTS)
    series = (legendre.legvander(_NODES, _GAUSS_POINTS - 1) * _WEIGHTS[:, None]).T
    series = series * ((2.0 * degrees + 1.0) / 2.0)[:, None]
    return 0.5 * np.stack([legendre.legint(column, lbnd=-1.0) for column in series.T], axis=1)


_INTEGRALS = _integrals()


class WearLife(NamedTuple):
    """How long wear lets a joint carry its loads.

    ``time`` up to the first limit, wear coefficient times time [s/Pa]: 0 where a limit is crossed at the start, nan
    where the joint works on beyond a crown that is worn flat, or the paths of the interferences do not settle;
    ``preload`` after the time that was asked for [N], nan beyond ``time``.
    """

    time: Array
    preload: Array


class _Loads(NamedTuple):
    """Loads of a joint, shape (loads,): torque at the output [N·m], speed of the input [rad/s], share of the time."""

    torque: Array
    speed: Array
    share: Array


class _Means(NamedTuple):
    """A state of wear under all loads: means of their rates, the excesses of all limits, and the joint alone.

    ``rates`` off the contacts, interferences then curvatures of crowns, shape (numbers,); ``drive_rate`` [m Pa/s],
    both per wear coefficient; ``excesses`` [-]; ``interference`` of the drive [m], ``preload`` [N].
    """

    rates: Array
    drive_rate: Array
    excesses: Array
    interference: Array
    preload: Array


def wear_life(joint: Joint, coefficients: Array, coefficient_time: Real) -> WearLife:
    r"""How long wear lets a joint carry its loads, and its preload after a time; pure; equation (W4).

    .. math::
        k t = \int_0^1 \frac{2 \Delta\, y}{w(\delta_0 - \Delta (1 - y^2))}\,dy

    where :math:`\Delta` is the interference that the drive loses until the first limit is reached.

    Parameters
    ----------
    joint : Joint
        Preloaded by an interference.
    coefficients : Array
        Wear coefficients of its bodies over the largest one, shape (bodies,) [-].
    coefficient_time : Real
        Time after which the preload is asked for, times the largest wear coefficient [s/Pa].

    Returns
    -------
    WearLife
        The time and the preload.

    Notes
    -----
    Of equal sectors with one way to be pressed the interferences of all contacts fall along a straight line, and one
    pass is exact; otherwise several passes follow it (Picard's iteration). 24 Gauss points: within 1e-6 of the course
    of :mod:`asperity.rolling.wear_course`.

    References
    ----------
    Equations (W1) to (W4) of :doc:`/equations`.
    """
    wearing = Wearing(joint_machine(without_duty(joint)), coefficients)
    loads = _loads(joint)
    start = _at(wearing, loads, _unworn(wearing.machine))
    whole = start.interference
    straight = start.rates / xp.where(start.drive_rate > 0.0, start.drive_rate, 1.0)
    guess = without_slopes(xp.clip(-xp.max(_known(start.excesses)), 1e-3, 1.0) * whole)
    first = _Path(_MOST * whole, 2.0 * _MOST * whole * _Y[:, None] * straight)

    def again(path: _Path, _: None) -> tuple[_Path, tuple[Array, Array, Array]]:
        found = first_limit(
            excesses=lambda lost: _excesses(wearing, loads, path.at(lost), lost, whole), first_guess=guess
        )
        length = xp.where(xp.isfinite(found.value), found.value, _MOST * whole)
        states = vectorised(lambda lost: _at(wearing, loads, path.at(lost)))(length * (1.0 - _Y**2))
        drive_rate = states.drive_rate
        per_y = 2.0 * length * _Y / xp.where(drive_rate > 0.0, drive_rate, 1.0)
        per_y = xp.where(drive_rate > 0.0, per_y, xp.nan)
        followed = _Path(length, per_y[:, None] * states.rates)
        return followed, (found.which, per_y, 0.5 * xp.sum(_WEIGHTS * per_y))

    passes = 1 if _feels_one_number(wearing.machine) else _PASSES
    path, (which, per_y, time) = scan(again, first, None, length=passes)
    settled = True if passes == 1 else abs(time[-1] - time[-2]) <= _SETTLED * time[-1]
    flat = which[-1] >= start.excesses.size + 1
    last = xp.where(settled & ~flat, time[-1], xp.nan)
    starts = xp.max(_known(start.excesses)) < 0.0
    last = xp.where(starts, last, 0.0)
    return WearLife(last, _preload_after(wearing, loads, path, per_y[-1], last, coefficient_time))


class _Path(NamedTuple):
    """What has worn off the contacts over the interference that the drive has lost since the start.

    ``length``, the last of them [m]; ``per_y``, what wears off per y at the Gauss points, shape (points, numbers).
    """

    length: Array
    per_y: Array

    def at(self, lost: Array) -> Array:
        """What has worn off, shape (numbers,); beyond the length along its last slope."""
        left = 1.0 - lost / self.length
        inside = left > 0.0
        y = xp.sqrt(xp.where(inside, left, 1.0)) * xp.where(inside, 1.0, 0.0)
        worn = _integral(xp.asarray(1.0), self.per_y) - _integral(y, self.per_y)
        slope = self.per_y[0] / (2.0 * self.length * _Y[0])
        return worn + xp.where(inside, 0.0, lost - self.length) * slope


def _integral(y: Array, values: Array) -> Array:
    """Integrals from 0 to y of functions that are known at the Gauss points, shape (points, ...)."""
    x = 2.0 * y - 1.0
    terms = [xp.ones_like(x), x]
    for n in range(1, _GAUSS_POINTS):
        terms.append(((2 * n + 1) * x * terms[n] - n * terms[n - 1]) / (n + 1))
    weights = xp.stack(terms) @ _INTEGRALS
    result: Array = xp.sum(weights.reshape(-1, *(1 for _ in values.shape[1:])) * values, axis=0)
    return result


def _loads(joint: Joint) -> _Loads:
    """The loads under which a joint wears: those of its duty, or its own."""
    duty = [(load.output_torque, load.input_speed, load.share) for load in joint.rolling.duty]
    points = duty or [(joint.output_torque, joint.input_speed, 1.0)]
    return _Loads(*(xp.stack([xp.asarray(point[i], dtype=float) for point in points]) for i in range(3)))


def _unworn(machine: JointMachine) -> Array:
    """Nothing worn off."""
    contacts = len(machine.drive.contacts)
    return xp.zeros(contacts if machine.contacts.crown_curvature is None else 2 * contacts)


@traced_once  # the whole chain, once for all states of wear
def _at(wearing: Wearing, loads: _Loads, worn: Array) -> _Means:
    """A state of wear under all loads; one that stands takes its share of the time, and nothing wears."""
    contacts = len(wearing.machine.drive.contacts)
    crowned = worn.size > contacts
    state = Worn(worn[:contacts], worn[contacts:] if crowned else None)
    turns = loads.speed != 0.0
    speed = xp.where(turns, loads.speed, 1.0)

    def under(torque: Array, speed: Array) -> _Means:
        found = wear_state(wearing, state, WearLoad(torque, speed, 1.0, xp.zeros(contacts)))
        rates = [found.rates.interference, *([] if not crowned else [found.rates.curvature])]
        return _Means(
            xp.concatenate(rates), found.drive_rate, found.excesses, found.interference, found.preload
        )

    each = vectorised(under)(loads.torque, speed)
    share = xp.where(turns, loads.share, 0.0)
    return _Means(
        rates=xp.sum(share[:, None] * xp.where(turns[:, None], each.rates, 0.0), axis=0),
        drive_rate=xp.sum(share * xp.where(turns, each.drive_rate, 0.0)),
        excesses=xp.where(turns[:, None], each.excesses, -1.0).reshape(-1),
        interference=each.interference[0],
        preload=xp.max(each.preload),
    )


def _known(excesses: Array) -> Array:
    """Excesses, of which those without a value are not exceeded."""
    return xp.where(xp.isnan(excesses), -1.0, excesses)


def _excesses(wearing: Wearing, loads: _Loads, worn: Array, lost: Array, whole: Array) -> Array:
    """Excesses of the limits of all loads, of the whole interference, then of crowns that are worn flat [-]."""
    found = [_at(wearing, loads, worn).excesses, (lost / (_MOST * whole) - 1.0)[None]]
    crowns, contacts = wearing.machine.contacts.crown_curvature, len(wearing.machine.drive.contacts)
    if crowns is not None:
        crowned = xp.asarray(crowns) > 0.0
        share = worn[contacts:] / xp.where(crowned, crowns, 1.0)
        found.append(xp.where(crowned, share - (1.0 - _FLAT), -1.0))
    return xp.concatenate(found)


def _feels_one_number(machine: JointMachine) -> bool:
    """Whether a drive feels one number of its interferences: equal sectors without crowns, pressed in one way."""
    if machine.joint.unlike is not None or machine.contacts.crown_curvature is not None:
        return False
    matrices = incidence(machine.drive)
    forces = len(machine.drive.contacts) + len(matrices.pins)
    return bool(forces - matrices.approach.shape[1] == 1)


def _preload_after(
    wearing: Wearing, loads: _Loads, path: _Path, per_y: Array, time: Array, asked: Real
) -> Array:
    """Preload after a time [N]; nan beyond the last one."""
    reached = asked <= time
    known = xp.where(reached, asked, 0.5 * time)

    def taken(y: Array) -> Array:
        return _integral(xp.asarray(1.0), per_y) - _integral(y, per_y)

    def halve(_: int, ends: tuple[Array, Array]) -> tuple[Array, Array]:
        low, high = ends
        middle = 0.5 * (low + high)
        more = taken(middle) > known  # time falls with y
        return xp.where(more, middle, low), xp.where(more, high, middle)

    low, high = fori_loop(0, _HALVINGS, halve, (xp.asarray(0.0), xp.asarray(1.0)))
    y = without_slopes(0.5 * (low + high))
    slope = without_slopes(_between(y, per_y))
    y = y + (taken(y) - known) / xp.where(slope > 0.0, slope, 1.0)
    lost = path.length * (1.0 - y**2)
    return xp.where(reached & (time > 0.0), _at(wearing, loads, path.at(lost)).preload, xp.nan)


def _between(y: Array, values: Array) -> Array:
    """Functions known at the Gauss points, between them, by their polynomial."""
    step = 1e-5
    return (_integral(xp.minimum(y + step, 1.0), values) - _integral(xp.maximum(y - step, 0.0), values)) / (
        xp.minimum(y + step, 1.0) - xp.maximum(y - step, 0.0)
    )
