"""Crowned or profiled rollers: a line contact divided into slices along its axis, each after Hertz and Carter."""

from __future__ import annotations

from asperity.contact.carter import slip_ratio_at_creepage
from asperity.engine.arrays import xp
from asperity.engine.derivatives import with_rule
from asperity.types import Array, Real

#: Householder steps to the root.
_SLICE_STEPS = 2


@with_rule
def strip_logarithm(target: Array) -> Array:
    r"""Root :math:`v > 1` of :math:`v - \ln v = t`, with which the compression law of a slice is inverted.

    Parameters
    ----------
    target : Array
        t [-], above 1.

    Returns
    -------
    Array
        v [-]; no root below t = 1.

    Notes
    -----
    Two Householder steps of third order from the expansion around t = 1: to rounding. Derivatives are implicit.

    References
    ----------
    Equation (B4) of :doc:`/equations`.
    """
    beyond = xp.maximum(target - 1.0, 0.0)
    v = 1.0 + xp.sqrt(2.0 * beyond) + (2.0 / 3.0) * beyond
    for _ in range(_SLICE_STEPS):
        inverse = 1.0 / v
        per_slope = 1.0 / (1.0 - inverse)
        newton = (v - xp.log(v) - target) * per_slope
        bend = newton * inverse**2 * per_slope
        v = v - newton * (1.0 - 0.5 * bend) / (1.0 - bend - newton * bend * inverse / 3.0)
    return v


@strip_logarithm.defjvp
def _strip_logarithm_jvp(primals: tuple[Array], tangents: tuple[Array]) -> tuple[Array, Array]:
    v = strip_logarithm(*primals)
    return v, tangents[0] * v / (v - 1.0)


def strip_creepage(*, slip_ratio: Real, capacity: Real, gross_slip_creepage: Real) -> Real:
    r"""Creepage of a sliced contact under a tangential force, with equal creepage of all slices.

    In closed form: the slices that stick are those whose gross-slip creepage needs a larger force, and among them
    :math:`Q` is a quadratic in :math:`\xi`.

    Parameters
    ----------
    slip_ratio : Real
        Q/(mu N), of either sign [-].
    capacity : Real
        Friction of each slice mu P'_j Delta_j, slices first [N].
    gross_slip_creepage : Real
        mu a_j/R of each slice, slices first; 0 where a slice does not touch [-].

    Returns
    -------
    Real
        Creepage [-]; infinite where :math:`|q| > 1`.

    Notes
    -----
    The number of operations grows with the square of the number of slices.

    References
    ----------
    J. J. Kalker, Proc. Kon. Ned. Akad. Wetensch. B 70 (1967) 10; equation (B4) of :doc:`/equations`.
    """
    capacity, limits = xp.broadcast_arrays(
        xp.asarray(capacity, dtype=float), xp.asarray(gross_slip_creepage, dtype=float)
    )
    magnitude = xp.abs(slip_ratio)
    carried = magnitude <= 1.0
    share = capacity / xp.sum(capacity, axis=0)
    at_limit = xp.sum(
        share * slip_ratio_at_creepage(creepage=limits[:, None], gross_slip_creepage=limits), axis=1
    )
    largest = limits == xp.max(limits, axis=0)  # these carry the remaining force
    sticks = (limits > 0.0) & (largest | (at_limit > magnitude))
    safe = xp.where(sticks, limits, 1.0)
    slope = xp.sum(xp.where(sticks, share / safe, 0.0), axis=0)
    bend = xp.sum(xp.where(sticks, share / safe**2, 0.0), axis=0)
    slipped = xp.sum(xp.where(sticks, 0.0, share), axis=0)
    # = 2 slope xi - bend |xi| xi
    missing = xp.where(carried, slip_ratio, 0.0) - xp.sign(slip_ratio) * slipped
    root = slope**2 - bend * xp.abs(missing)
    some = root > 0.0
    steady = missing / (slope + xp.where(some, xp.sqrt(xp.where(some, root, 1.0)), 0.0))
    return xp.where(carried, steady, xp.sign(slip_ratio) * xp.inf)
