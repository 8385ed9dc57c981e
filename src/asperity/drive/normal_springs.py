"""Normal springs of contacts around their preload, even and crowned ones."""

from __future__ import annotations

import math

from asperity.contact.crowned_line import CrownedLines, crown_compliance, crown_compression
from asperity.engine.arrays import xp
from asperity.engine.derivatives import with_rule
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Least load of a contact over its load at rest, below which its compression is continued as a straight line [-].
SMALL_LOAD = 1e-6


class CrownedSprings(Module):
    """What crowns add to the normal springs of the contacts around their preload; arrays of one shape.

    Parameters
    ----------
    lines : CrownedLines
        The contacts.
    rest_compression : Array
        Approach that the crowns add at rest, shape (contacts, ...) [m].
    steepest_compliance : Array
        Compliance that they add to a contact about to lift off, shape (contacts, ...) [m/N].
    """

    lines: CrownedLines
    rest_compression: Array
    steepest_compliance: Array


def crowned_springs(*, lines: CrownedLines, rest_force: Array) -> CrownedSprings:
    """What crowns add to the normal springs of contacts.

    Parameters
    ----------
    lines : CrownedLines
        The contacts.
    rest_force : Array
        Normal forces at rest, shape (contacts, ...) [N].

    Returns
    -------
    CrownedSprings
        Around these forces.

    References
    ----------
    Equation (B12) of :doc:`/equations`.
    """
    return CrownedSprings(
        lines=lines,
        rest_compression=crown_compression(normal_force=rest_force, **vars(lines)),
        steepest_compliance=crown_compliance(normal_force=SMALL_LOAD * rest_force, **vars(lines)),
    )


class NormalSprings(Module):
    r"""Compression of the contacts around their preload, exact for every logarithmic line-contact law.

    .. math:: \delta(N) = N \left[s_0 - (s_0 - t_0) \ln (N/N_0)\right] + \Delta\delta(N)

    Parameters
    ----------
    secant_compliance, incremental_compliance : Array
        s_0 = delta/N and t_0 = d delta/dN of the even contacts at the preload N_0, shape (contacts, ...) [m/N].
    crowns : CrownedSprings or None
        Crowned contacts, whose rollers approach by :math:`\Delta\delta` more; None where none is crowned.
    """

    secant_compliance: Array
    incremental_compliance: Array
    crowns: CrownedSprings | None = None


def compression(*, springs: NormalSprings, normal_force: Real, rest_force: Real) -> Real:
    r"""Approach of the two bodies of each contact beyond their state at rest.

    .. math:: \delta(N) - \delta(N_0), \quad \delta(N) = N \left[s_0 - (s_0 - t_0) \ln (N/N_0)\right]

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].
    normal_force, rest_force : Real
        Normal force N and its value N_0 at rest [N].

    Returns
    -------
    Real
        Approach [m]. Below a millionth of the rest force the tangent is continued; only intermediate
        iterates of the solver reach this range.

    References
    ----------
    The Johnson and the Weber–Banaschek compressions, :mod:`asperity.contact.hertz_line`, are both of this form.
    """
    secant = springs.secant_compliance
    even = rest_force * _compression_shape(
        normal_force * (1.0 / rest_force), secant, secant - springs.incremental_compliance
    )
    if springs.crowns is None:
        return even
    return even + _crown(springs.crowns, normal_force, rest_force)


def total_approach(*, springs: NormalSprings, normal_force: Real, rest_force: Real) -> Real:
    r"""Approach of the two bodies of each contact from first touch, :math:`\delta(N)`.

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].
    normal_force, rest_force : Real
        Normal force N and its value N_0 at rest [N].

    Returns
    -------
    Real
        Approach [m], as far from that at rest as :func:`compression` says.

    References
    ----------
    As for :func:`compression`; equation (B12) of :doc:`/equations` for crowned contacts.
    """
    beyond = compression(springs=springs, normal_force=normal_force, rest_force=rest_force)
    even = beyond + springs.secant_compliance * rest_force
    return even if springs.crowns is None else even + springs.crowns.rest_compression


def _crown(crowns: CrownedSprings, normal_force: Real, rest_force: Real) -> Array:
    """Approach by the crowns beyond that at rest, with a tangent below the smallest load."""
    pressed = xp.maximum(normal_force, SMALL_LOAD * rest_force)
    at_load = crown_compression(normal_force=pressed, **vars(crowns.lines))
    return at_load - crowns.rest_compression + (normal_force - pressed) * crowns.steepest_compliance


@with_rule
def _compression_shape(ratio: Array, secant: Array, bend: Array) -> Array:
    """Compression over the rest force, in n = N/N_0: s_0 (n − 1) − (s_0 − t_0) n ln n."""
    safe = xp.maximum(ratio, SMALL_LOAD)
    return secant * (ratio - 1.0) - bend * _bent(ratio, safe, xp.log(safe))


@_compression_shape.defjvp
def _compression_shape_jvp(
    primals: tuple[Array, Array, Array], tangents: tuple[Array, Array, Array]
) -> tuple[Array, Array]:
    """Without a division, which would cost the solver a pass over memory."""
    (ratio, secant, bend), (ratio_dot, secant_dot, bend_dot) = primals, tangents
    safe = xp.maximum(ratio, SMALL_LOAD)
    log = xp.log(safe)
    bent = _bent(ratio, safe, log)
    slope = secant - bend * (1.0 + log)
    value = secant * (ratio - 1.0) - bend * bent
    return value, slope * ratio_dot + (ratio - 1.0) * secant_dot - bent * bend_dot


def _bent(ratio: Array, safe: Array, log: Array) -> Array:
    """The product n ln n, continued below the smallest load by its tangent."""
    return safe * log + (ratio - safe) * (1.0 + math.log(SMALL_LOAD))
