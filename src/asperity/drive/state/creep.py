r"""Creep law of the contacts of a rolling drive, and the angle that its output loses."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.derivatives import with_rule
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Largest relative residual of a rolling state that is accepted as solved.
ROLLING_TOLERANCE = 1e-9

_NEAR_SLIP = 0.999  # Carter's curve is continued as a line above this share of friction, for iterates only


class CreepLaw(Module):
    r"""Carter's creep of the contacts.

    .. math:: \xi = \kappa\sqrt N\,\left[1-\sqrt{1-q}\right], \qquad q = \frac{|T|}{\mu N}

    Parameters
    ----------
    friction_coefficient : Real
        mu, shape (contacts or 1, ...) [-].
    gross_slip_scale : Real
        kappa: creepage at gross slip over the root of the normal force, shape (contacts, ...) [1/√N]. For Carter's
        contact :math:`\mu a/(R\sqrt N)`, times the factors of asperities, crowns and skew.
    """

    friction_coefficient: Real
    gross_slip_scale: Real


def creepages(*, law: CreepLaw, normal: Array, tangential: Array) -> Array:
    r"""Creepage of contacts under given forces.

    .. math:: \xi = \kappa\sqrt N\,\frac{q}{1 + \sqrt{1-|q|}}, \qquad q = \frac{T}{\mu N}

    Parameters
    ----------
    law : CreepLaw
        The law of each contact.
    normal, tangential : Array
        Forces, shape (contacts, ...) [N]; the tangential ones of either sign.

    Returns
    -------
    Array
        Creepages, shape (contacts, ...) [-]; above 99.9 % of friction the tangent is continued, for iterates of
        a solver only.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (B1) of :doc:`/equations`.
    """
    touching = normal > 0.0
    safe_normal = xp.where(touching, normal, 1.0)
    q = tangential / (law.friction_coefficient * safe_normal)
    return xp.where(touching, law.gross_slip_scale * _creep_shape(safe_normal, q), 0.0)


@with_rule
def _creep_shape(normal: Array, q: Array) -> Array:
    """Carter's curve, √N [1 − √(1 − q)] with the sign of q, and its tangent near gross slip."""
    return xp.sqrt(normal) * _carter(q)[0]


@_creep_shape.defjvp
def _creep_shape_jvp(primals: tuple[Array, Array], tangents: tuple[Array, Array]) -> tuple[Array, Array]:
    (normal, q), (normal_dot, q_dot) = primals, tangents
    share, slope = _carter(q)
    size = xp.sqrt(normal)
    return size * share, (0.5 * share / size) * normal_dot + (size * slope) * q_dot


def _carter(q: Array) -> tuple[Array, Array]:
    """1 − √(1 − q) with the sign of q, and its slope."""
    size = xp.abs(q)
    held = xp.minimum(size, _NEAR_SLIP)
    root = xp.sqrt(1.0 - held)
    slope = 0.5 / root
    return xp.sign(q) * (held / (1.0 + root) + slope * (size - held)), slope


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
    share = xp.asarray(loss)
    return 2.0 * xp.pi * share / (1.0 - share)
