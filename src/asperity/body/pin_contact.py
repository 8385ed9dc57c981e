r"""Law of pins that press in the bores of their rollers: arc of contact, approach and compliance under a force.

The arc :math:`u` stores the least energy under the force F,

.. math:: \tfrac12 F^2 C(u) + F c\,(w_0(u) - 1) \to \min, \qquad -\tfrac12 F\,\frac{dC}{du} = c\,\frac{dw_0}{du},

with the radial clearance c and the share :math:`w_0` of :func:`asperity.body.conforming_pin.pressure_shares`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.body.conforming_pin import (
    clearance_share,
    clearance_slopes,
    conforming_compliance,
    fitting_load,
    fitting_slopes,
    half_angle,
    share_series,
)
from asperity.engine.arrays import xp
from asperity.engine.control import while_loop
from asperity.engine.derivatives import without_slopes
from asperity.engine.module import Module
from asperity.types import Array

#: Half-angle of a pin without clearance in a large plate [rad], and the relative change at which an arc is found.
FITTING_ANGLE = 1.4805269486
_FOUND, _ROUNDS = 1e-14, 60


class ForceSlopes(NamedTuple):
    """Derivatives of what pins do by their forces, shape (pins,).

    Parameters
    ----------
    angle, angle_curvature : Array
        First [rad/N] and second [rad/N^2] derivative of the half-angle of contact.
    approach : Array
        Derivative of the approach over the force [m/N^2].
    """

    angle: Array
    angle_curvature: Array
    approach: Array


class PinContact(Module):
    r"""Pins in bores.

    .. math:: C = C_1 + \frac{\hat C(u) + h_0 w_0^2 + \sum_k a_k \cos k\epsilon}{E' L}

    Parameters
    ----------
    shift : Array
        Compliance C_1 of the first mode, shape (pins,) [m/N].
    scale : Array
        :math:`1/(E'L)`, shape (pins,) [m/N]; 0 of pins that press in no bore.
    uniform : Array
        h_0: what the wall adds to the mode 0 of a large plate, shape (pins,) [-].
    waves : Array
        a_k: what it adds to the other modes, of cosines of the half-angle, shape (pins, cosines) [-].
    clearance : Array
        Radial clearance c of each pin, shape (pins,) [m].
    """

    shift: Array
    scale: Array
    uniform: Array
    waves: Array
    clearance: Array

    def compliance(self, angle: Array) -> Array:
        """Compliance C of each pin under a pressure over a half-angle, shape (pins,) [rad] to [m/N]."""
        arc = xp.sin(0.5 * angle) ** 2
        walls = self.uniform * (1.0 + clearance_share(arc=arc)) ** 2 + self._wall(angle)
        return self.shift + self.scale * (conforming_compliance(arc=arc) + walls)

    def angle(self, force: Array) -> Array:
        r"""Half-angle of the arc of contact under forces above 0, shape (pins,) [N] to [rad].

        Without clearance that of any force. (E7).
        """
        load = self.load(force)
        found = _searched(*without_slopes((self, load)))
        left, slope, _ = self.misfit(found, load)
        return found - left / slope  # of which the derivatives by the numbers are those of the root

    def load(self, force: Array) -> Array:
        """Radial clearance over the force, in units of F/(E'L), shape (pins,) [-]."""
        return self.clearance / (force * xp.where(self.scale > 0.0, self.scale, 1.0))

    def approach(self, force: Array, angle: Array) -> Array:
        r"""Approach of each pin from first touch over its force, shape (pins,) [m/N].

        .. math:: \frac\Delta F = C(u) + \frac{c\,(w_0(u) - 1)}F

        Of forces above 0 [N] and their half-angles [rad], shape (pins,); (E7).
        """
        spread = self.clearance * clearance_share(arc=xp.sin(0.5 * angle) ** 2) / force
        return xp.where(self.scale > 0.0, self.compliance(angle) + spread, 0.0)

    def slopes(self, force: Array, angle: Array) -> ForceSlopes:
        """What a larger force changes, of forces above 0 [N] and their half-angles [rad], shape (pins,)."""
        load = self.load(force)
        _, slope, curvature = self.misfit(angle, load)
        arc, by_angle = xp.sin(0.5 * angle) ** 2, 0.5 * xp.sin(angle)
        first = -load * arc / (force * slope)
        numerator = load * (2.0 * arc / force - by_angle * first) / force
        second = (numerator - first * (curvature * first + load * by_angle / force)) / slope
        share = clearance_share(arc=arc)
        by_force = clearance_slopes(arc)[0] * by_angle * first
        approach = -self.clearance / force * (by_force + share / force)
        return ForceSlopes(first, second, xp.where(self.scale > 0.0, approach, 0.0))

    def _wall(self, angle: Array) -> Array:
        return xp.sum(self.waves * xp.cos(angle[:, None] * self._numbers), axis=1)

    @property
    def _numbers(self) -> np.ndarray:
        return np.arange(self.waves.shape[1], dtype=float)

    def misfit(self, angle: Array, load: Array) -> tuple[Array, Array, Array]:
        r"""By how much the clearance that an arc fits exceeds the load, times u, and two derivatives by the angle [-].

        .. math:: u\,\frac{-dC/du}{2\,dw_0/du}\,E'L - u\,\frac{cE'L}{F}

        ``load`` is that of :meth:`load`, shape (pins,).
        """
        number, turn = self._numbers, angle[:, None] * self._numbers
        wall = [
            xp.sum(self.waves * part, axis=1)
            for part in (-number * xp.sin(turn), -(number**2) * xp.cos(turn), number**3 * xp.sin(turn))
        ]
        arc, first, second = xp.sin(0.5 * angle) ** 2, 0.5 * xp.sin(angle), 0.5 * xp.cos(angle)
        s_1, s_2, s_3 = clearance_slopes(arc)  # by u, then by the angle
        share = [
            s_1 * first,
            s_2 * first**2 + s_1 * second,
            s_3 * first**3 + 3.0 * s_2 * first * second - s_1 * first,
        ]
        # waves over the share of the clearance, with two derivatives
        ratio = wall[0] / share[0]
        slope = (wall[1] - ratio * share[1]) / share[0]
        bend = (wall[2] - 2.0 * slope * share[1] - ratio * share[2]) / share[0]
        factor = self.uniform * (1.0 + clearance_share(arc=arc)) + 0.5 * ratio + load
        factor_1 = self.uniform * share[0] + 0.5 * slope
        factor_2 = self.uniform * share[1] + 0.5 * bend
        f_1, f_2 = fitting_slopes(arc)
        return (
            fitting_load(arc=arc) - arc * factor,
            (f_1 - factor) * first - arc * factor_1,
            f_2 * first**2 + (f_1 - factor) * second - 2.0 * first * factor_1 - arc * factor_2,
        )


def pin_contact(*, shift: Array, scale: Array, wall: Array, pressed: Array, clearance: Array) -> PinContact:
    r"""The law of pins each of which presses several tracks of its roller.

    .. math:: F_t = \varphi_t F, \qquad \varphi_t = \frac{1/C_t}{\sum 1/C_t}, \qquad C = \sum_t \varphi_t^2 C_t

    with the shares of the tracks for a pin without clearance in a large plate.

    Parameters
    ----------
    shift, scale : Array
        Of each track, as of :class:`asperity.body.bore.BoreModes`, shape (pins, tracks) [m/N].
    wall : Array
        Likewise, shape (pins, tracks, modes) [-].
    pressed : Array
        Whether a pin presses a track, shape (pins, tracks) [-].
    clearance : Array
        Radial clearance of each pin, shape (pins,) [m].

    Returns
    -------
    PinContact
        Without tracks that are pressed, a pin in no bore.

    References
    ----------
    Springs side by side; equation (E7) of :doc:`/equations`.
    """
    uniform, waves = wall[..., 0], wall[..., 1:] @ share_series(power=2)
    flat = [part.reshape(-1, *part.shape[2:]) for part in (shift, scale, uniform, waves)]
    alone = PinContact(flat[0], flat[1], flat[2], flat[3], xp.zeros_like(flat[0]))
    conductance = xp.where(
        pressed, 1.0 / alone.compliance(xp.full_like(flat[0], FITTING_ANGLE)).reshape(shift.shape), 0.0
    )
    total = xp.sum(conductance, axis=1, keepdims=True)
    share = conductance / xp.where(total > 0.0, total, 1.0)
    scales = share**2 * scale
    together = xp.sum(scales, axis=1)
    over = scales / xp.where(together > 0.0, together, 1.0)[:, None]
    return PinContact(
        shift=xp.sum(share**2 * shift, axis=1),
        scale=together,
        uniform=xp.sum(over * uniform, axis=1),
        waves=xp.sum(over[..., None] * waves, axis=1),
        clearance=clearance,
    )


#: The last half-angles, bounds of their arcs on both sides, the last changes, and the number of rounds.
_Bracket = tuple[Array, Array, Array, Array, Array]


def _searched(contact: PinContact, load: Array) -> Array:
    """Half-angles of contact by Newton's method for their arcs, halved where it leads astray."""

    def unfinished(state: _Bracket) -> Array:
        arc, _, _, change, rounds = state
        return (rounds < _ROUNDS) & xp.any(xp.abs(change) > _FOUND * arc)

    def improve(state: _Bracket) -> _Bracket:
        arc, low, high, _, rounds = state
        angle = half_angle(arc)
        left, slope, _ = contact.misfit(angle, load)
        low, high = xp.where(left > 0.0, arc, low), xp.where(left > 0.0, high, arc)
        tried = arc - left * 0.5 * xp.sin(angle) / slope
        better = xp.where((tried >= low) & (tried <= high), tried, 0.5 * (low + high))
        return better, low, high, better - arc, rounds + 1

    none = xp.where(load > xp.inf, 1.0, 0.0)  # tied to the load, so that all of it is batched alike
    start = 1.0 / (0.5 * xp.pi * load + 1.0 / xp.sin(0.5 * FITTING_ANGLE) ** 2)
    begin = (start, none, none + 1.0, start, xp.sum(none).astype(int))
    return half_angle(while_loop(unfinished, improve, begin)[0])
