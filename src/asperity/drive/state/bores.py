r"""Rollers that the pins of the carrier press in their bores: what pin and contacts do to each other.

A pin presses one half of the bore, outward whatever the sign of its force F. With the forces N and T of the contacts
and those without torque, :math:`N_0`, the body stores

.. math:: U = \tfrac12 c F^2 + F\,(a_n N + a_t T) - |F|\,(r_n (N - N_0) + r_t T),

of which pin and contacts have their displacements. Without torque the pin fits its bore.
"""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.linear import product
from asperity.types import Real

#: Force over the largest one of a contact below which a pin is about to change the half of the bore that it presses.
_TURNOVER = 1e-4


class Bores(eqx.Module):
    """Compliances between pins and contacts, shape (contacts, pins), of :func:`asperity.body.bore.bore_compliance`.

    Parameters
    ----------
    along_normal, along_tangential : Array
        Approach and slip of the contacts under the force of each pin: the part that changes its sign with it [m/N].
    around_normal, around_tangential : Array
        The part that does not, counted outward and counter-clockwise [m/N].
    push_compliance : Array
        Of each pin along its push, shape (pins,) [m/N].
    """

    along_normal: Array
    along_tangential: Array
    around_normal: Array
    around_tangential: Array
    push_compliance: Array

    def by_pin(self, side: Array) -> tuple[Array, Array]:
        """Approach and slip over a small change of each pin's force, shape (contacts, pins) [m/N].

        These are the compliances of the pin under forces of the contacts too. ``side`` is the sign of the force of each
        roller on its pin along the push, shape (pins,).
        """
        return (
            self.along_normal - side * self.around_normal,
            self.along_tangential - side * self.around_tangential,
        )

    def moved(self, force: Array, largest: Real) -> tuple[Array, Array]:
        """Approach and slip of the contacts under the forces of the pins, shape (contacts,) [m]."""
        _, size, _ = sides(force, largest)
        return (
            product(self.along_normal, force) - product(self.around_normal, size),
            product(self.along_tangential, force) - product(self.around_tangential, size),
        )

    def pin_moved(
        self, force: Array, largest: Real, normal: Array, change: Array, tangential: Array
    ) -> Array:
        """Displacement of each pin along its push under the forces of the contacts, shape (pins,) [m].

        Without that under the pin's own force. ``force`` is that of each roller on its pin along the push, shape
        (pins,) [N], ``largest`` the scale of the forces [N]; normal forces, what the torque has added to them, and
        tangential forces have the shape (contacts,) [N].
        """
        side, _, _ = sides(force, largest)
        opened = product(self.around_normal.T, change) + product(self.around_tangential.T, tangential)
        return (
            product(self.along_normal.T, normal)
            + product(self.along_tangential.T, tangential)
            - side * opened
        )


def sides(force: Array, largest: Real) -> tuple[Array, Array, Array]:
    r"""Which half of its bore each pin presses, how much, and how fast that changes with its force.

    .. math:: \frac{F}{\sqrt{F^2 + \varepsilon^2}}, \qquad \sqrt{F^2 + \varepsilon^2} - \varepsilon

    Parameters
    ----------
    force : Array
        Of each roller on its pin [N].
    largest : Real
        Scale of the forces [N]; :math:`\varepsilon` is a ten-thousandth of it, so that equations with F have slopes.

    Returns
    -------
    tuple of Array
        The sign of F [-], its size [N], and the slope of the sign [1/N].

    References
    ----------
    Elementary.
    """
    small = _TURNOVER * largest
    smooth_force = jnp.sqrt(force**2 + small**2)
    return force / smooth_force, smooth_force - small, small**2 / smooth_force**3
