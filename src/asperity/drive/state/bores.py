r"""Rollers that the pins of the carrier press in their bores: what pin and contacts do to each other.

A pin presses one side of the bore, outward whatever the sign of its force F. With the forces N and T of the contacts,
those without torque, :math:`N_0`, and the shares :math:`w_n` of the modes of its pressure, the body stores

.. math:: U = \int \Delta\,dF + F\,(a_n N + a_t T) + \sum_n g_n(F)\,\bigl(r_{nn} (N - N_0) + r_{nt} T\bigr), \qquad
    g_n = F w_n(F) \;\text{(n odd)}, \quad -|F|\,w_n(F) \;\text{(n even)},

of which pin and contacts have their displacements. Without torque the pin fits its bore, with its clearance all round.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.body.conforming_pin import MODES, SHARED, clearance_share, clearance_slopes, share_series
from asperity.body.pin_contact import PinContact
from asperity.engine.arrays import xp
from asperity.engine.control import traced_once
from asperity.engine.module import Module
from asperity.linear import product
from asperity.types import Array, Real

#: Force over the largest one of a contact below which a pin is about to change the side of the bore that it presses.
TURNOVER = 1e-4
_COSINES = MODES + 2


class PressedBores(NamedTuple):
    """What the pins do in their bores under their forces.

    Parameters
    ----------
    amplitude, slope, curvature : Array
        Amplitudes [N] that make g_n, and their first [-] and second derivatives by the force [1/N], shape (pins,
        amplitudes): minus the size of F times w_0, then F and minus its size, each times cosines of the half-angle.
    approach, compliance : Array
        Approach of each pin from first touch of its bore under its own force [m], and its slope [m/N], shape (pins,).
    """

    amplitude: Array
    slope: Array
    curvature: Array
    approach: Array
    compliance: Array


def by_amplitude(modes: Array) -> Array:
    """What the amplitudes of :class:`PressedBores` do, from what the modes of a pressure do, along the last axis."""
    series, odd = share_series(power=1), SHARED[1:] % 2 == 1
    signs = [modes[..., 1:] @ (series * chosen[:, None]) for chosen in (odd, ~odd)]
    return xp.concatenate([modes[..., :1], *signs], axis=-1)


class Bores(Module):
    """Compliances between pins and contacts, of :func:`asperity.body.bore.bore_modes`.

    Parameters
    ----------
    along_normal, along_tangential : Array
        Approach and slip of the contacts under the force of each pin, by the first mode of its pressure, shape
        (contacts, pins) [m/N].
    rim_normal, rim_tangential : Array
        The same by the other modes, for the amplitudes of :class:`PressedBores`, shape (contacts, pins, amplitudes)
        [m/N]; of :func:`by_amplitude`.
    contact : PinContact
        Pins and bores by themselves.
    """

    along_normal: Array
    along_tangential: Array
    rim_normal: Array
    rim_tangential: Array
    contact: PinContact

    def under(self, force: Array, largest: Real) -> PressedBores:
        """Pins under forces of the rollers on them along their push, shape (pins,) [N]; ``largest`` is their scale."""
        return _pressed(self.contact, force, TURNOVER * xp.asarray(largest))

    def beyond_turnover(self, force: Array) -> PressedBores:
        """The same of forces that press one side of the bore, whose size is above 0."""
        return _pressed(self.contact, force, xp.zeros(()))

    def moved(self, force: Array, pressed: PressedBores) -> tuple[Array, Array]:
        """Approach and slip of the contacts under the forces of the pins, shape (contacts,) [m]."""
        return (
            product(self.along_normal, force) + xp.sum(self.rim_normal * pressed.amplitude, axis=(1, 2)),
            product(self.along_tangential, force)
            + xp.sum(self.rim_tangential * pressed.amplitude, axis=(1, 2)),
        )

    def by_pin(self, pressed: PressedBores) -> tuple[Array, Array]:
        """Approach and slip over a small change of each pin's force, shape (contacts, pins) [m/N].

        These are the compliances of the pin under forces of the contacts too.
        """
        return (
            self.along_normal + xp.sum(self.rim_normal * pressed.slope, axis=2),
            self.along_tangential + xp.sum(self.rim_tangential * pressed.slope, axis=2),
        )

    def pin_moved(self, pressed: PressedBores, normal: Array, change: Array, tangential: Array) -> Array:
        """Displacement of each pin along its push, its own bending not counted, shape (pins,) [m].

        Normal forces of the contacts, what the torque has added to them, and tangential forces have the shape
        (contacts,) [N].
        """
        return (
            pressed.approach
            + product(self.along_normal.T, normal)
            + product(self.along_tangential.T, tangential)
            + xp.sum(pressed.slope * self._moves(change, tangential), axis=1)
        )

    def pin_slope(self, pressed: PressedBores, change: Array, tangential: Array) -> Array:
        """Slope of :meth:`pin_moved` by the force of each pin, shape (pins,) [m/N]."""
        return pressed.compliance + xp.sum(pressed.curvature * self._moves(change, tangential), axis=1)

    def _moves(self, change: Array, tangential: Array) -> Array:
        """Motion of each amplitude of the bores under forces of the contacts, shape (pins, amplitudes) [m]."""
        return xp.sum(
            self.rim_normal * change[:, None, None] + self.rim_tangential * tangential[:, None, None], axis=0
        )


@traced_once  # traced once for all equations and slopes
def _pressed(contact: PinContact, force: Array, small: Array) -> PressedBores:
    """Pins under forces; ``small`` is the force within which they change sides [N]."""
    size = xp.sqrt(force**2 + small**2)
    side, turning = force / size, small**2 / size**3  # slopes of the size
    angle = contact.angle(size)
    by_size, approach = contact.slopes(size, angle), contact.approach(size, angle)

    def by_force(first: Array, second: Array) -> tuple[Array, Array]:
        """Derivatives by the force from those by the half-angle."""
        slope = by_size.angle * side
        bend = by_size.angle_curvature * side**2 + by_size.angle * turning
        return first * slope[:, None], second * slope[:, None] ** 2 + first * bend[:, None]

    number = np.arange(_COSINES, dtype=float)
    turn = angle[:, None] * number
    waves, sines = xp.cos(turn), -number * xp.sin(turn)
    arc, first, second = xp.sin(0.5 * angle) ** 2, 0.5 * xp.sin(angle), 0.5 * xp.cos(angle)
    by_arc, bend, _ = clearance_slopes(arc)
    even = xp.concatenate([(1.0 + clearance_share(arc=arc))[:, None], waves], axis=1)
    even_1 = xp.concatenate([(by_arc * first)[:, None], sines], axis=1)
    even_2 = xp.concatenate([(bend * first**2 + by_arc * second)[:, None], -(number**2) * waves], axis=1)
    even_1, even_2 = by_force(even_1, even_2)
    inward, sides, turns, along = (part[:, None] for part in (small - size, -side, -turning, force))
    odd, odd_1, odd_2 = (part[:, 1:] for part in (even, even_1, even_2))

    def together(of_even: Array, of_odd: Array) -> Array:
        return xp.concatenate([of_even[:, :1], of_odd, of_even[:, 1:]], axis=1)

    return PressedBores(
        amplitude=together(inward * even, along * odd),
        slope=together(sides * even + inward * even_1, odd + along * odd_1),
        curvature=together(
            turns * even + 2.0 * sides * even_1 + inward * even_2, 2.0 * odd_1 + along * odd_2
        ),
        approach=force * approach,
        compliance=approach + force * side * by_size.approach,
    )
