r"""Forces, creepages and speeds of a rolling drive, without further assumptions.

A drive at rest needs an assumption on how the two loading rollers of a planet share its torque. In a rolling
drive both connect the same two surfaces, the planet's and the ring's, so that their creepages determine the split:

.. math::
    \prod_{k \in \{pwr, wro\}} \frac{1-\xi_k/2}{1+\xi_k/2} = \prod_{k \in \{pwl, wlo\}} \frac{1-\xi_k/2}{1+\xi_k/2},
    \qquad \xi_k = \kappa_k \sqrt{N_k}\left[1 - \sqrt{1 - T_k/(\mu_k N_k)}\right]

(Carter's creep of each contact; creepage is the difference of the surface speeds over their mean.) With (1)–(5) and
the closure (A3) these are as many equations as forces.
"""

from __future__ import annotations

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import DriveGeometry
from asperity.types import Real

#: Largest relative residual of a rolling state that is accepted as solved.
ROLLING_TOLERANCE = 1e-9

_NEAR_SLIP = 0.999  # Carter's curve is continued as a line above this share of friction, for iterates only


class CreepLaw(eqx.Module):
    r"""Creep of the five contacts, :math:`\xi = \kappa\sqrt N\,[1-\sqrt{1-T/(\mu N)}]`.

    Parameters
    ----------
    friction_coefficient : Real
        mu, shape (1 or 5, ...) [-].
    gross_slip_scale : Real
        kappa: creepage at gross slip over the root of the normal force, shape (5, ...) [1/√N]. For Carter's contact
        :math:`\mu a/(R\sqrt N)`, times the factor of an elastic layer.
    """

    friction_coefficient: Real
    gross_slip_scale: Real


class RollingState(eqx.Module):
    """Forces, creepages and speeds of a drive in steady rolling. SI units; contact axis first.

    Parameters
    ----------
    normal, tangential : Array
        Forces of the contacts ``sp, pwr, pwl, wro, wlo``, shape (5, ...) [N].
    pin_left, pin_right : Array
        Carrier pin forces [N].
    left_bearing_torque, right_bearing_torque : Array
        Friction torque of one bearing of the left and of the right loading roller [N·m].
    creepage : Array
        Creepages xi, shape (5, ...) [-], with the sign of the tangential forces.
    speed_loss : Array
        Share of the output speed, and of the output angle, lost by creep [-]; negative where the torque drives
        the rotation.
    residual : Array
        Largest relative residual of closure, carrier moment and equal creep [-]; nan where a contact is open
        or in gross slip.
    """

    normal: Array
    tangential: Array
    pin_left: Array
    pin_right: Array
    left_bearing_torque: Array
    right_bearing_torque: Array
    creepage: Array
    speed_loss: Array
    residual: Array


def creepages(*, law: CreepLaw, normal: Array, tangential: Array) -> Array:
    r"""Creepage of contacts under given forces.

    .. math:: \xi = \kappa\sqrt N\,\frac{q}{1 + \sqrt{1-|q|}}, \qquad q = \frac{T}{\mu N}

    Parameters
    ----------
    law : CreepLaw
        The law of each contact.
    normal, tangential : Array
        Forces, shape (5, ...) [N]; the tangential ones of either sign.

    Returns
    -------
    Array
        Creepages, shape (5, ...) [-]; above 99.9 % of friction the tangent is continued, for iterates of
        a solver only.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (B1) of :doc:`/equations`.
    """
    touching = normal > 0.0
    safe_normal = jnp.where(touching, normal, 1.0)
    q = tangential / (law.friction_coefficient * safe_normal)
    return jnp.where(touching, law.gross_slip_scale * _creep_shape(safe_normal, q), 0.0)


@jax.custom_jvp
def _creep_shape(normal: Array, q: Array) -> Array:
    """Carter's curve, √N [1 − √(1 − q)] with the sign of q, and its tangent near gross slip."""
    return jnp.sqrt(normal) * _carter(q)[0]


@_creep_shape.defjvp
def _creep_shape_jvp(primals: tuple[Array, Array], tangents: tuple[Array, Array]) -> tuple[Array, Array]:
    (normal, q), (normal_dot, q_dot) = primals, tangents
    share, slope = _carter(q)
    size = jnp.sqrt(normal)
    return size * share, (0.5 * share / size) * normal_dot + (size * slope) * q_dot


def _carter(q: Array) -> tuple[Array, Array]:
    """1 − √(1 − q) with the sign of q, and its slope."""
    size = jnp.abs(q)
    held = jnp.minimum(size, _NEAR_SLIP)
    root = jnp.sqrt(1.0 - held)
    slope = 0.5 / root
    return jnp.sign(q) * (held / (1.0 + root) + slope * (size - held)), slope


def lost_speed(creepage: Array) -> Array:
    r"""Logarithm of the speed of the driving surface over that of the driven one.

    .. math:: \ln\frac{1 + \xi/2}{1 - \xi/2} = 2\operatorname{artanh}\frac\xi2

    Parameters
    ----------
    creepage : Array
        Difference of the surface speeds over their mean [-].

    Returns
    -------
    Array
        Logarithm [-], which adds up over contacts in series.

    References
    ----------
    The definition of creepage; equation (B3) of :doc:`/equations`.
    """
    return 2.0 * jnp.arctanh(0.5 * creepage)


def drift_per_turn(loss: Real) -> Array:
    r"""Angle that the output falls behind in one of its turns, :math:`2\pi s/(1-s)`.

    Parameters
    ----------
    loss : Real
        Speed loss s of the drive [-].

    Returns
    -------
    Array
        Angle [rad]; negative where the creep runs ahead.

    References
    ----------
    Equation (B3) of :doc:`/equations`.
    """
    share = jnp.asarray(loss)
    return 2.0 * jnp.pi * share / (1.0 - share)


def speed_loss(*, geometry: DriveGeometry, creepage: Array) -> Array:
    r"""Exact share of the output speed that is lost by creep.

    .. math::
        1 - \frac{\omega_c}{\omega_{c,0}} = 1 - \rho\,\frac{R_o - R_s}{R_o - \rho R_s}
        \approx \xi_\Sigma \frac{R_o}{R_o-R_s},
        \qquad \rho = \prod \frac{1-\xi_k/2}{1+\xi_k/2}

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    creepage : Array
        Creepages, shape (5, ...) [-]; those in series on the right side are used, in a rolling state both sides agree.

    Returns
    -------
    Array
        Loss [-].

    References
    ----------
    Equation (B3) of :doc:`/equations`: in the carrier's frame the ring's surface is slower than the sun's by the
    product over the contacts in series.
    """
    missing = -jnp.expm1(-(lost_speed(creepage[0]) + lost_speed(creepage[1]) + lost_speed(creepage[3])))
    ring, sun = geometry.ring_radius, geometry.sun_radius
    return missing * ring / (ring - sun * (1.0 - missing))
