r"""How long wear lets a joint carry its loads, of one joint or of many at once, with derivatives.

The first stage of :mod:`asperity.rolling.wear_course` alone, up to the first limit that is reached, as one pure
function: for the points of a study.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import incidence
from asperity.drive.state.first_limit import first_limit
from asperity.engine.arrays import xp
from asperity.engine.control import scan, traced_once, vectorised
from asperity.engine.derivatives import without_slopes
from asperity.implicit import elementwise_root
from asperity.joint.description import Joint, without_duty
from asperity.joint.machine import JointMachine, joint_machine
from asperity.rolling.wear_integral import PLACES, integral_from
from asperity.rolling.wear_rates import MOST, Wearing, WearLoad, Worn, flat_excess, wear_state
from asperity.types import Array, Real

#: Passes along the path of the contacts' interferences where the drive feels several numbers, and the largest change
#: of the time in the last one [-].
_PASSES, _SETTLED = 10, 1e-4


class WearLife(NamedTuple):
    """How long wear lets a joint carry its loads.

    ``time`` up to the first limit, wear coefficient times time [s/Pa]: nan where a limit is crossed at the start,
    nothing turns, the joint works on beyond a crown that is worn flat, or the interferences do not settle;
    ``preload`` after the time that was asked for [N], nan beyond ``time``.
    """

    time: Array
    preload: Array


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
    pass is exact; otherwise several passes follow it (Picard's iteration). Against the course of
    :mod:`asperity.rolling.wear_course` 1e-12 with one pass, 1e-6 with several, 2e-5 with crowns.

    References
    ----------
    Equations (W1) to (W4) of :doc:`/equations`.
    """
    wearing = Wearing(joint_machine(without_duty(joint)), coefficients)
    loads = _loads(joint)
    start = _at(wearing, loads, _unworn(wearing.machine))
    room = MOST * start.interference
    straight = start.rates / xp.where(start.drive_rate > 0.0, start.drive_rate, 1.0)
    guess = without_slopes(xp.clip(-xp.max(start.excesses), 1e-3, 1.0) * room)

    def again(path: _Path, _: None) -> tuple[_Path, tuple[Array, Array]]:
        found = first_limit(
            excesses=lambda lost: _excesses(wearing, loads, path.at(lost), lost / room), first_guess=guess
        )
        length = xp.where(found.value > 0.0, found.value, room)
        states = vectorised(lambda lost: _at(wearing, loads, path.at(lost)))(length * (1.0 - PLACES**2))
        wears = states.drive_rate > 0.0
        time = xp.where(wears, 2.0 * length * PLACES / xp.where(wears, states.drive_rate, 1.0), xp.nan)
        return _Path(length, time[:, None] * states.rates, time), (found.which, integral_from(0.0, time))

    passes = 1 if _feels_one_number(wearing.machine) else _PASSES
    first = _Path(room, 2.0 * room * PLACES[:, None] * straight, 0.0 * PLACES * room)
    path, (which, times) = scan(again, first, None, length=passes)
    settles = abs(times[-1] - times[-2]) <= _SETTLED * times[-1] if passes > 1 else True
    of_crown = which[-1] > start.excesses.size
    known = (xp.max(start.excesses) < 0.0) & settles & ~of_crown
    time = xp.where(known, times[-1], xp.nan)
    return WearLife(time, _preload_after(wearing, loads, path, time, coefficient_time))


class _Path(NamedTuple):
    """A stage over the interference that the drive has lost since the start.

    ``length``, the last of them [m]; per y at :data:`~asperity.rolling.wear_integral.PLACES` ``worn``, what wears off
    the contacts, shape (points, numbers), and ``time``, shape (points,) [s/Pa].
    """

    length: Array
    worn: Array
    time: Array

    def at(self, lost: Array) -> Array:
        """What has worn off, shape (numbers,); beyond the length along its last slope."""
        left = 1.0 - lost / self.length
        inside = left > 0.0
        y = xp.where(inside, xp.sqrt(xp.where(inside, left, 1.0)), 0.0)
        slope = self.worn[0] / (2.0 * self.length * PLACES[0])
        return integral_from(y, self.worn) + xp.where(inside, 0.0, lost - self.length) * slope


def _loads(joint: Joint) -> WearLoad:
    """The loads under which a joint wears, shape (loads,): those of its duty, or its own; no contact slides."""
    duty = [(load.output_torque, load.input_speed, load.share) for load in joint.rolling.duty]
    points = duty or [(joint.output_torque, joint.input_speed, 1.0)]
    torque, speed, share = (
        xp.stack([xp.asarray(point[i], dtype=float) for point in points]) for i in range(3)
    )
    return WearLoad(torque, speed, share, np.zeros((len(points), len(joint.drive.contacts))))


def _unworn(machine: JointMachine) -> Array:
    """Nothing worn off."""
    contacts = len(machine.drive.contacts)
    return xp.zeros(contacts if machine.contacts.crown_curvature is None else 2 * contacts)


@traced_once  # the whole chain, once for all states of wear
def _at(wearing: Wearing, loads: WearLoad, worn: Array) -> _Means:
    """A state of wear under all loads; one that stands takes its share of the time, and nothing wears."""
    contacts = len(wearing.machine.drive.contacts)
    crowned = worn.size > contacts
    state = Worn(worn[:contacts], worn[contacts:] if crowned else None)
    turns = loads.input_speed != 0.0
    turning = loads._replace(input_speed=xp.where(turns, loads.input_speed, 1.0))

    def under(load: WearLoad) -> _Means:
        found = wear_state(wearing, state, load)
        rates = [found.rates.interference, *([found.rates.curvature] if crowned else [])]
        return _Means(
            xp.concatenate(rates), found.drive_rate, found.excesses, found.interference, found.preload
        )

    each = vectorised(under)(turning)
    share = xp.where(turns, loads.share, 0.0)
    exceeded = turns[:, None] & ~xp.isnan(each.excesses)
    return _Means(
        rates=xp.sum(share[:, None] * xp.where(turns[:, None], each.rates, 0.0), axis=0),
        drive_rate=xp.sum(share * xp.where(turns, each.drive_rate, 0.0)),
        excesses=xp.where(exceeded, each.excesses, -1.0).reshape(-1),
        interference=each.interference[0],
        preload=xp.max(each.preload),
    )


def _excesses(wearing: Wearing, loads: WearLoad, worn: Array, lost_share: Array) -> Array:
    """Excesses of the limits of all loads, of the whole interference, then of crowns that are worn flat [-]."""
    found = [_at(wearing, loads, worn).excesses, (lost_share - 1.0)[None]]
    contacts = len(wearing.machine.drive.contacts)
    if worn.size > contacts:
        found.append(flat_excess(wearing.machine, worn[contacts:]))
    return xp.concatenate(found)


def _feels_one_number(machine: JointMachine) -> bool:
    """Whether a drive feels one number of its interferences: equal sectors without crowns, pressed in one way."""
    if machine.joint.unlike is not None or machine.contacts.crown_curvature is not None:
        return False
    matrices = incidence(machine.drive)
    forces = len(machine.drive.contacts) + len(matrices.pins)
    return bool(forces - matrices.approach.shape[1] == 1)


def _preload_after(wearing: Wearing, loads: WearLoad, path: _Path, time: Array, asked: Real) -> Array:
    """Preload after a time [N]; nan beyond the last one."""
    reached = asked <= time
    known = xp.where(reached, asked, 0.5 * integral_from(0.0, path.time))

    def later(given: tuple[Array, Array], y_lost: Array) -> Array:
        of_time, at = given
        return integral_from(1.0 - y_lost, of_time) / at - 1.0

    start = xp.zeros_like(known)
    y = 1.0 - elementwise_root(later, (path.time, known), start, start + 1.0, start + 0.5)
    preload = _at(wearing, loads, path.at(path.length * (1.0 - y**2))).preload
    return xp.where(reached, preload, xp.nan)
