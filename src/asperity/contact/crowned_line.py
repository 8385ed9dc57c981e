r"""Line contact of circularly crowned rollers: how the load spreads over its length, and the approach that this costs.

With the half-width a of the middle of the line, all lengths are measured by the contact length B:

.. math:: p = (a/B)^2 = \frac{4 P' R}{\pi E^* B^2}, \qquad \eta = \frac{4 R \delta}{B^2}, \qquad
    \rho = \frac{4 R}{B^2}\,\frac{B^2 \kappa}{8} = \frac{R \kappa}{2}

with the compression :math:`\delta` of the middle and the curvature :math:`\kappa` of the crowns. A slice at
:math:`t = 2y/B` follows the law of a line contact, :math:`\eta - \rho t^2 = p\,[2 \ln(2 s) - 2 - \ln p]`, with the
loaded share s of the length, and the slices carry the load.
"""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from asperity.contact.crown_shapes import CrownShape
from asperity.contact.strip_theory import strip_logarithm
from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop
from asperity.engine.derivatives import value_and_slope, with_rule
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Slices of one half of the line; the two halves are alike.
SLICES = 8

_NEWTON_STEPS = 3
_PROFILED_STEPS = 7
_LOGARITHM_MEAN = 2.0 - 2.0 * math.log(2.0)  # of ln 1/(1 - t^2) over the length
#: Of the middle slice: below, the contact is less than twice as long as wide
LEAST_TARGET = 2.2 - math.log(2.2)
_RESIDUAL = 1e-11


def _nodes() -> tuple[np.ndarray, np.ndarray]:
    """Places of the slices on the loaded half and their weights: Gauss–Legendre, denser towards the end."""
    x, w = np.polynomial.legendre.leggauss(SLICES)
    y = 0.5 * (1.0 - x)
    return 1.0 - y**2, w * y


_PLACE, _WEIGHT = _nodes()


class CrownedLine(Module):
    """A crowned line contact under load. SI units; the slices are the first axis of what is given for each.

    The first slice is the middle of the line, where load and width are largest; it has no length.

    Parameters
    ----------
    position : Array
        Distance of each slice from the middle, shape (slices, ...) [m].
    line_load : Array
        Normal force per length of each slice, shape (slices, ...) [N/m].
    half_width : Array
        Half-width of each slice, shape (slices, ...) [m].
    length_share : Array
        Share of the contact length that each slice stands for, shape (slices, ...) [-]; together the loaded share.
    end_line_load : Array
        Line load at the ends of the rollers, shape (...) [N/m]; 0 where the ends are free.
    loaded_share : Array
        Share of the contact length that is loaded, shape (...) [-].
    solved : Array
        True where the slices carry the load, shape (...) [-].
    """

    position: Array
    line_load: Array
    half_width: Array
    length_share: Array
    end_line_load: Array
    loaded_share: Array
    solved: Array


class CrownedLines(Module):
    """Crowned contacts without load, as :func:`crowned_line` and :func:`crown_compression` take them; of one shape.

    Parameters
    ----------
    crown_curvature : Array
        Curvatures of the crowns along the axis [1/m].
    contact_length, effective_radius : Array
        Length B and effective radius R [m].
    contact_modulus : Array
        E* [Pa].
    logarithmic : Array or None, optional
        Which of them have a logarithmic profile, 1, or a circle, 0 [-]; None where all have circles.
    """

    crown_curvature: Array
    contact_length: Array
    effective_radius: Array
    contact_modulus: Array
    logarithmic: Array | None = None


def _along(values: np.ndarray, like: Array) -> Array:
    """A number for each slice along a first axis."""
    return xp.asarray(values).reshape(-1, *(1,) * xp.ndim(like))


def _logarithm(compression: Array, factor: Array) -> Array:
    """Compression over squared width of a slice."""
    target = factor - xp.log(compression)
    return xp.asarray(strip_logarithm(xp.maximum(target, LEAST_TARGET)))


def _carried(approach: Array, crown: Array, logarithmic: Array | None = None) -> tuple[Array, Array]:
    """Load of the slices, as the squared width of a contact that is loaded evenly, and its slope over ln eta."""
    shape = CrownShape(approach, crown, logarithmic)
    drift = shape.factor_drift()
    place, weight = (_along(values, approach) for values in (_PLACE, _WEIGHT))
    compression, growing = shape.slices(place)
    logarithm = _logarithm(compression, shape.length_factor())
    squared_width = compression / logarithm
    growth = growing - squared_width * drift
    load = xp.sum(weight * squared_width, axis=0)
    slope = xp.sum(weight * growth / (logarithm - 1.0), axis=0)
    share = shape.loaded_share()
    return share * load, share * (slope + shape.share_growth() * load)


@partial(with_rule, none_for_zero=True)
def _approach(load: Array, crown: Array) -> Array:
    """Approach eta under a load: Newton's method on the nearly straight ln load over ln eta."""
    logarithm = 2.0 * math.log(2.0) - 2.0 - xp.log(load)
    full = load * logarithm + crown / 3.0
    some = xp.where(crown > 0.0, 1.5 * load * logarithm * xp.sqrt(crown), 1.0)
    start = xp.where(full > crown, full, xp.exp(xp.log(some) * (2.0 / 3.0)))

    def improve(_: int, approach: Array) -> Array:
        value, slope = _carried(approach, crown)
        return approach * xp.exp(xp.log(load / value) * value / slope)

    return fori_loop(0, _NEWTON_STEPS, improve, start)


@_approach.defjvp
def _approach_jvp(
    primals: tuple[Array, Array], tangents: tuple[Array | None, Array | None]
) -> tuple[Array, Array]:
    """Implicit differentiation at the root."""
    (load, crown), (load_dot, crown_dot) = primals, tangents
    approach = _approach(load, crown)
    _, slope = _carried(approach, crown)
    rate = xp.zeros_like(load) if load_dot is None else load_dot
    if crown_dot is not None:
        rate = rate - value_and_slope(lambda rho: _carried(approach, rho)[0], (crown,), (crown_dot,))[1]
    return approach, rate * approach / slope


@partial(with_rule, none_for_zero=True)
def _profiled_approach(load: Array, crown: Array, logarithmic: Array) -> Array:
    """As :func:`_approach`, of contacts some of which have a logarithmic profile."""
    logarithm = 2.0 * math.log(2.0) - 2.0 - xp.log(load)
    profiled = logarithmic > 0.0
    mean, most = (
        xp.where(profiled, log, circle) for log, circle in ((_LOGARITHM_MEAN, 1.0 / 3.0), (1.5, 1.0))
    )
    full = load * logarithm + crown * mean
    some = xp.where(crown > 0.0, 1.5 * load * logarithm * xp.sqrt(crown), 1.0)
    start = xp.where(full > most * crown, full, xp.exp(xp.log(some) * (2.0 / 3.0)))

    def improve(_: int, approach: Array) -> Array:
        value, slope = _carried(approach, crown, logarithmic)
        return approach * xp.exp(xp.log(load / value) * value / slope)

    return fori_loop(0, _PROFILED_STEPS, improve, start)


@_profiled_approach.defjvp
def _profiled_approach_jvp(
    primals: tuple[Array, Array, Array], tangents: tuple[Array | None, Array | None, Array | None]
) -> tuple[Array, Array]:
    """Implicit differentiation at the root; which contacts are profiled does not change."""
    (load, crown, logarithmic), (load_dot, crown_dot, _) = primals, tangents
    approach = _profiled_approach(load, crown, logarithmic)
    _, slope = _carried(approach, crown, logarithmic)
    rate = xp.zeros_like(load) if load_dot is None else load_dot
    if crown_dot is not None:
        rate = (
            rate
            - value_and_slope(lambda rho: _carried(approach, rho, logarithmic)[0], (crown,), (crown_dot,))[1]
        )
    return approach, rate * approach / slope


def _approach_of(load: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Approach eta under a load of contacts of any shape."""
    return _approach(load, crown) if logarithmic is None else _profiled_approach(load, crown, logarithmic)


def _scaled(
    normal_force: Real,
    crown_curvature: Real,
    contact_length: Real,
    effective_radius: Real,
    modulus: Real,
    logarithmic: Real | None,
) -> tuple[Array, Array, Array | None]:
    load = 4.0 * normal_force * effective_radius / (math.pi * modulus * contact_length**3)
    load, crown = xp.broadcast_arrays(
        xp.asarray(load, dtype=float), xp.asarray(0.5 * effective_radius * crown_curvature, dtype=float)
    )
    if logarithmic is None:
        return load, crown, None
    return load, crown, xp.broadcast_to(xp.asarray(logarithmic, dtype=float), load.shape)


def crowned_line(
    *,
    normal_force: Real,
    crown_curvature: Real,
    contact_length: Real,
    effective_radius: Real,
    contact_modulus: Real,
    logarithmic: Real | None = None,
) -> CrownedLine:
    r"""How the load of a contact of crowned rollers spreads over its length.

    .. math:: \sum_j P'_j \Delta_j = N, \qquad
        \delta - \tfrac12 \kappa y_j^2 = \frac{P'_j}{\pi E^*}\left(2 \ln\frac{2 \ell}{\sqrt e\,a_j} - 1\right)

    with the loaded length :math:`\ell`.

    Parameters
    ----------
    normal_force : Real
        Normal force N [N], positive.
    crown_curvature : Real
        Curvature kappa of the crowns of both bodies along the axis, in the middle, the sum of :math:`1/R_c`, 0 for
        cylinders [1/m].
    contact_length : Real
        Length B of the rollers' contact line [m]; the crown is highest in its middle.
    effective_radius : Real
        Effective radius R in the rolling direction [m].
    contact_modulus : Real
        Contact modulus E* [Pa].
    logarithmic : Real or None, optional
        1 where the gap is logarithmic, :math:`A \ln 1/(1 - (2y/B)^2)` with :math:`A = \kappa B^2/8`, in place of a
        circle with the curvature of its middle, 0 elsewhere [-]; None where all crowns are circles.

    Returns
    -------
    CrownedLine
        Loads and widths of the slices.

    Notes
    -----
    Slices do not interact except through the loaded length. Compared with Hertz's ellipse, the peak pressure is 1 to
    2 % too high for contacts more than four times as long as wide, 3 % at three times and 5 % at twice; shorter ones
    are not solved. Loaded ends have no concentration of stress. Infinite radius gives the even load to rounding.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 4.2 and 5.6; equation (B4) of :doc:`/equations`.
    """
    load, crown, profiled = _scaled(
        normal_force, crown_curvature, contact_length, effective_radius, contact_modulus, logarithmic
    )
    approach = _approach_of(load, crown, profiled)
    shape = CrownShape(approach, crown, profiled)
    share, factor = shape.loaded_share(), shape.length_factor()
    at_end = shape.end_compression()

    def squared_width(compression: Array) -> Array:
        pressed = compression > 0.0
        some = xp.where(pressed, compression, approach)
        return xp.where(pressed, some / _logarithm(some, factor), 0.0)

    place, weight = (_along(np.insert(values, 0, 0.0), approach) for values in (_PLACE, _WEIGHT))
    compression = approach - crown * (share * place) ** 2 if profiled is None else shape.slices(place)[0]
    squared, end = squared_width(compression), squared_width(at_end)
    per_squared = math.pi * contact_modulus * contact_length**2 / (4.0 * effective_radius)
    carried, _ = _carried(approach, crown, profiled)
    return CrownedLine(
        position=xp.asarray(0.5 * contact_length * place * share),
        line_load=squared * per_squared,
        half_width=xp.sqrt(squared) * contact_length,
        length_share=weight * share,
        end_line_load=end * per_squared,
        loaded_share=share,
        solved=(xp.abs(carried / load - 1.0) < _RESIDUAL) & (factor - xp.log(approach) > LEAST_TARGET),
    )


def crown_compression(*, normal_force: Real, **line: Real) -> Array:
    r"""By how much more crowned rollers approach each other than cylinders under the same force.

    .. math::
        \Delta\delta = \delta + \frac{3 N}{\pi E^* \ell}
        - \frac{N}{\pi E^* B}\left(2 \ln\frac{2 B}{a} + 1\right)

    with the compression :math:`\delta` of the middle slice and the half-width a of the even contact.

    Parameters
    ----------
    normal_force : Real
        Normal force [N], positive.
    line : Real
        As for :func:`crowned_line`, without the force.

    Returns
    -------
    Array
        Added approach [m]: 0 without crown. Its derivative by the force is the added incremental compliance.

    Notes
    -----
    The last bracket is the middle of an evenly loaded line of length B on half-spaces. What both have in common, the
    bodies beyond a distance of B, is left to the law of the even contact. On half-spaces the sum of both is
    Hertz's approach for an ellipse within 2 % for contacts more than three times as long as wide.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, (4.25)–(4.28) for the ellipse; equation (B12) of :doc:`/equations`.
    """
    return compression_and_shortening(normal_force=normal_force, **line)[0]


def compression_and_shortening(
    *,
    normal_force: Real,
    crown_curvature: Real,
    contact_length: Real,
    effective_radius: Real,
    contact_modulus: Real,
    logarithmic: Real | None = None,
) -> tuple[Array, Array]:
    r"""What crowns add to the approach, and by how much they shorten the line on which that depends.

    .. math:: \Delta\delta, \qquad 1/\ell - 1/B

    Parameters
    ----------
    normal_force, crown_curvature, contact_length, effective_radius, contact_modulus, logarithmic : Real
        As for :func:`crowned_line`.

    Returns
    -------
    tuple of Array
        :func:`crown_compression` [m], and the difference of the reciprocal lengths [1/m]; both 0 without crown.

    References
    ----------
    Equation (B12) of :doc:`/equations`.
    """
    load, crown, profiled = _scaled(
        normal_force, crown_curvature, contact_length, effective_radius, contact_modulus, logarithmic
    )
    approach = _approach_of(load, crown, profiled)
    shape = CrownShape(approach, crown, profiled)
    shorter = 1.0 / shape.spread() - 1.0
    even = load * (2.0 * math.log(2.0) - 2.0 - xp.log(load))
    added = (approach - even) + 3.0 * load * shorter
    return added * contact_length**2 / (4.0 * effective_radius), shorter / contact_length


def crown_compliance(*, normal_force: Real, **line: Real) -> Array:
    r"""Incremental compliance that crowns add to a line contact, :math:`\mathrm d\,\Delta\delta/\mathrm dN`.

    Parameters
    ----------
    normal_force : Real
        Normal force [N], positive.
    line : Real
        As for :func:`crowned_line`, without the force.

    Returns
    -------
    Array
        Compliance [m/N]; 0 without crown.

    References
    ----------
    Equation (B12) of :doc:`/equations`.
    """
    force = xp.asarray(normal_force, dtype=float)
    return value_and_slope(
        lambda some: crown_compression(normal_force=some, **line), (force,), (xp.ones_like(force),)
    )[1]
