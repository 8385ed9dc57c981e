"""Crowned or profiled rollers: a line contact divided into slices along its axis, each after Hertz and Carter."""

from __future__ import annotations

import math
from collections.abc import Callable

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array, lax

from asperity.contact.carter import slip_ratio_at_creepage
from asperity.contact.hertz_line import half_width as hertz_half_width
from asperity.implicit import implicit_root
from asperity.types import Real

#: Steps of a slice's load, and the largest number of those of the approach; residual of the normal force.
_SLICE_STEPS, _MOST_STEPS, _RESIDUAL = 2, 100, 1e-11


@jax.custom_jvp
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
    beyond = jnp.maximum(target - 1.0, 0.0)
    v = 1.0 + jnp.sqrt(2.0 * beyond) + (2.0 / 3.0) * beyond
    for _ in range(_SLICE_STEPS):
        inverse = 1.0 / v
        per_slope = 1.0 / (1.0 - inverse)
        newton = (v - jnp.log(v) - target) * per_slope
        bend = newton * inverse**2 * per_slope
        v = v - newton * (1.0 - 0.5 * bend) / (1.0 - bend - newton * bend * inverse / 3.0)
    return v


@strip_logarithm.defjvp
def _strip_logarithm_jvp(primals: tuple[Array], tangents: tuple[Array]) -> tuple[Array, Array]:
    v = strip_logarithm(*primals)
    return v, tangents[0] * v / (v - 1.0)


class StripLoads(eqx.Module):
    """Normal load of a contact over its slices; the slices are the first axis.

    Parameters
    ----------
    line_load : Array
        Normal force per length of each slice [N/m]; 0 where it does not touch.
    half_width : Array
        Half-width of each slice [m].
    approach : Array
        Local compression at the point of zero profile, without the slices' axis [m]; excludes the far field.
    solved : Array
        True where the slices carry the normal force, without the slices' axis [-].
    """

    line_load: Array
    half_width: Array
    approach: Array
    solved: Array


def circular_crown(*, position: Real, crown_radius: Real) -> Real:
    r"""Profile of a crowned roller, :math:`z = y^2/(2 R_c)`.

    Parameters
    ----------
    position : Real
        Distance y along the axis from the highest place [m].
    crown_radius : Real
        Radius R_c of the crown in the axial plane, infinite for a cylinder [m].

    Returns
    -------
    Real
        Drop below the highest place [m].

    Notes
    -----
    Parabola instead of a circle: y much smaller than R_c. Tilt by an angle adds that angle times y.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 4.1.
    """
    return 0.5 * position**2 / crown_radius


def compression_length(*, contact_length: Real) -> Real:
    r"""Length on which the compression of a slice depends, in addition to its width, :math:`D = 2 B/\sqrt e`.

    Parameters
    ----------
    contact_length : Real
        Length B of the contact along the axis [m]: of the line, or of the part that touches where the ends lift off.

    Returns
    -------
    Real
        D [m].

    Notes
    -----
    With it the slices give Hertz's long ellipse exactly, in the limit of a length much larger than the width. A load
    that is even along the axis does not depend on it.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (4.25)–(4.28) for b much larger than a; equation (B4) of
    :doc:`/equations`.
    """
    return 2.0 * contact_length / math.sqrt(math.e)


def slice_line_load(
    *, compression: Real, effective_radius: Real, contact_modulus: Real, compression_length: Real
) -> Array:
    r"""Normal force per length of a slice from its compression.

    .. math:: \delta = \frac{P'}{\pi E^*}\left(2\ln\frac{D}{b} - 1\right), \qquad b^2 = \frac{4 P' R}{\pi E^*}

    solved for P'; D represents the length over which the load acts.

    Parameters
    ----------
    compression : Real
        delta [m]; a slice with delta <= 0 does not touch.
    effective_radius : Real
        Effective radius R [m].
    contact_modulus : Real
        Contact modulus E* [Pa].
    compression_length : Real
        D [m], :func:`compression_length`.

    Returns
    -------
    Real
        Line load P' [N/m].

    Notes
    -----
    With :math:`v = 2\ln(D/b) - 1` the law is :math:`v e^{-v} = 4 e R\delta/D^2`, solved to rounding for b < 0.2 D.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 5.6; equation (B4) of :doc:`/equations`.
    """
    touching = jnp.asarray(compression) > 0.0
    safe = jnp.where(touching, compression, 1e-9 * compression_length)
    target = -jnp.log(4.0 * math.e * effective_radius * safe / compression_length**2)
    v = strip_logarithm(target)
    return jnp.where(touching, math.pi * contact_modulus * safe / v, 0.0)  # (B4)


def _newton_from_above(residual: Callable[[Array], Array], start: Array) -> Array:
    """Root of a convex, growing function from a start at or above it: every step stays on that side."""

    def unfinished(state: tuple[Array, Array, Array]) -> Array:
        count, _, missing = state
        return (count < _MOST_STEPS) & jnp.any(jnp.abs(missing) > _RESIDUAL)

    def step(state: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
        count, approach, missing = state
        _, slope = jax.jvp(residual, (approach,), (jnp.ones_like(approach),))
        approach = approach - missing / slope
        return count + 1, approach, residual(approach)

    return lax.while_loop(unfinished, step, (jnp.asarray(0), start, residual(start)))[1]


def strip_loads(
    *,
    normal_force: Real,
    profile: Real,
    slice_length: Real,
    effective_radius: Real,
    contact_modulus: Real,
    compression_length: Real,
) -> StripLoads:
    r"""Normal load of a profiled contact over its slices.

    .. math:: \sum_j P'(\delta - z_j)\,\Delta_j = N

    solved for the local compression :math:`\delta` at the highest place.

    Parameters
    ----------
    normal_force : Real
        Normal force N [N]; where it is not positive no slice is loaded.
    profile : Real
        Drop z_j of the pair's profile in the middle of each slice, slices first [m]: crown, tilt and end relief.
    slice_length : Real
        Length of each slice along the axis, slices first or one for all [m].
    effective_radius : Real
        Effective radius R in the rolling direction [m].
    contact_modulus : Real
        Contact modulus E* [Pa].
    compression_length : Real
        D [m], :func:`compression_length`.

    Returns
    -------
    StripLoads
        Loads and half-widths of the slices; check ``solved``.

    Notes
    -----
    Slices do not interact: accurate for a contact much longer than wide, errors up to 25 % for one as long as wide
    (Kalker 1967); below about three times as long as wide the law has no solution. Compared with Hertz's ellipse the
    error of the peak pressure is below 2 % for 1 : 10. No load concentration at sharp ends. Derivatives are those of
    the balance at its root.

    References
    ----------
    J. J. Kalker, Proc. Kon. Ned. Akad. Wetensch. B 70 (1967) 10; equation (B4) of :doc:`/equations`.
    """
    profile = jnp.asarray(profile, dtype=float)
    lengths = jnp.broadcast_to(jnp.asarray(slice_length, dtype=float), profile.shape)
    touching = jnp.asarray(normal_force) > 0.0
    force = jnp.where(touching, normal_force, 1.0)

    def loads(approach: Array) -> Array:
        return slice_line_load(
            compression=approach - profile,
            effective_radius=effective_radius,
            contact_modulus=contact_modulus,
            compression_length=compression_length,
        )

    def excess(approach: Array) -> Array:
        return jnp.sum(loads(approach) * lengths, axis=0) / force - 1.0

    def width(line_load: Real) -> Array:
        loaded = line_load > 0.0
        some = hertz_half_width(
            normal_force=jnp.where(loaded, line_load, 1.0),
            contact_length=1.0,
            effective_radius=effective_radius,
            contact_modulus=contact_modulus,
        )
        return jnp.where(loaded, some, 0.0)

    # the lowest k slices alone, each compressed as if they shared N evenly, carry at least N, whatever k
    order = jnp.argsort(profile, axis=0)
    lowest = jnp.take_along_axis(profile, order, axis=0)
    even = force / jnp.cumsum(jnp.take_along_axis(lengths, order, axis=0), axis=0)
    logarithm = 2.0 * jnp.log(compression_length / width(even)) - 1.0
    ample = jnp.where(logarithm > 1.0, lowest + even / (math.pi * contact_modulus) * logarithm, jnp.inf)
    start = jnp.min(ample, axis=0)  # infinite, and then not solved, where the law has no such load
    approach = implicit_root(
        excess, start, _newton_from_above, lambda linear, y: y / linear(jnp.ones_like(y))
    )
    line_load = jnp.where(touching, loads(approach), 0.0)
    return StripLoads(
        line_load=line_load,
        half_width=width(line_load),
        approach=jnp.where(touching, approach, lowest[0]),
        solved=~touching | (jnp.abs(excess(approach)) <= _RESIDUAL),
    )


def strip_slip_ratio(*, creepage: Real, capacity: Real, gross_slip_creepage: Real) -> Real:
    r"""Tangential force over friction of a sliced contact whose slices share one creepage.

    .. math:: \frac{Q}{\mu N} = \frac{\sum_j \mu P'_j \Delta_j\, q(\xi/\xi_{max,j})}{\sum_j \mu P'_j \Delta_j}

    with Carter's :math:`q` of (B1).

    Parameters
    ----------
    creepage : Real
        Creepage xi of all slices, of either sign [-].
    capacity : Real
        Friction of each slice mu P'_j Delta_j, slices first [N].
    gross_slip_creepage : Real
        mu a_j/R of each slice, slices first; 0 where a slice does not touch [-].

    Returns
    -------
    Real
        Q/(mu N) [-].

    References
    ----------
    J. J. Kalker, Proc. Kon. Ned. Akad. Wetensch. B 70 (1967) 10; equation (B4) of :doc:`/equations`.
    """
    ratios = slip_ratio_at_creepage(creepage=creepage, gross_slip_creepage=gross_slip_creepage)
    return jnp.sum(capacity * ratios, axis=0) / jnp.sum(capacity, axis=0)


def strip_creepage(*, slip_ratio: Real, capacity: Real, gross_slip_creepage: Real) -> Real:
    r"""Creepage of a sliced contact under a tangential force, with equal creepage of all slices.

    The inverse of :func:`strip_slip_ratio` in closed form: the slices that stick are those whose gross-slip creepage
    needs a larger force, and among them :math:`Q` is a quadratic in :math:`\xi`.

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
    capacity, limits = jnp.broadcast_arrays(
        jnp.asarray(capacity, dtype=float), jnp.asarray(gross_slip_creepage, dtype=float)
    )
    magnitude = jnp.abs(slip_ratio)
    carried = magnitude <= 1.0
    share = capacity / jnp.sum(capacity, axis=0)
    at_limit = jnp.sum(
        share * slip_ratio_at_creepage(creepage=limits[:, None], gross_slip_creepage=limits), axis=1
    )
    largest = limits == jnp.max(limits, axis=0)  # these carry the remaining force
    sticks = (limits > 0.0) & (largest | (at_limit > magnitude))
    safe = jnp.where(sticks, limits, 1.0)
    slope = jnp.sum(jnp.where(sticks, share / safe, 0.0), axis=0)
    bend = jnp.sum(jnp.where(sticks, share / safe**2, 0.0), axis=0)
    slipped = jnp.sum(jnp.where(sticks, 0.0, share), axis=0)
    missing = (
        jnp.where(carried, slip_ratio, 0.0) - jnp.sign(slip_ratio) * slipped
    )  # = 2 slope xi - bend |xi| xi
    root = slope**2 - bend * jnp.abs(missing)
    some = root > 0.0
    steady = missing / (slope + jnp.where(some, jnp.sqrt(jnp.where(some, root, 1.0)), 0.0))
    return jnp.where(carried, steady, jnp.sign(slip_ratio) * jnp.inf)
