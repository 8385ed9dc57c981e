r"""What shape a crown has: a circle, or a logarithmic profile without bound at the ends of the rollers.

All lengths as in :mod:`asperity.contact.crowned_line`: the approach :math:`\eta`, the crown :math:`\rho = R\kappa/2`
with the curvature :math:`\kappa` of the middle, and the place t over half of the length. The gap is :math:`\rho t^2` of
a circle and :math:`-\rho \ln(1 - t^2)` of a logarithmic profile of coefficient A, whose curvature is :math:`8A/B^2`.
Its ends are never loaded. ``logarithmic`` is 1 where a contact has such a profile and 0 where it has a circle, None
where all have.
"""

from __future__ import annotations

import math

from asperity.engine.arrays import xp
from asperity.types import Array

_POWER = 4  # of the smooth minimum of the free length of contact and the length of the rollers


def _free_power(approach: Array, crown: Array) -> Array:
    return ((crown / approach) ** 2) ** (_POWER // 2)


def _decay(approach: Array, crown: Array, logarithmic: Array) -> tuple[Array, Array]:
    """Approach over the crown of logarithmic profiles, and 1 of others; the exponential of minus that."""
    profiled = logarithmic > 0.0
    ratio = xp.where(profiled, approach / xp.where(profiled, crown, 1.0), 1.0)
    return ratio, xp.exp(-ratio)


def loaded_share(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Share of the length that is loaded."""
    free = approach < crown
    circle = xp.where(free, xp.sqrt(approach / xp.where(free, crown, 1.0)), 1.0)
    if logarithmic is None:
        return circle
    ratio, _ = _decay(approach, crown, logarithmic)
    return xp.where(logarithmic > 0.0, xp.sqrt(-xp.expm1(-ratio)), circle)


def spread(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """The loaded share without a kink where the load reaches the ends: the length on which compression depends."""
    circle = xp.exp(-0.5 / _POWER * xp.log1p(_free_power(approach, crown)))
    if logarithmic is None:
        return circle
    return xp.where(logarithmic > 0.0, loaded_share(approach, crown, logarithmic), circle)


def length_factor(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Compression over squared width of a slice plus the logarithm of the latter, 2 ln(2 s) − 2."""
    even = 2.0 * math.log(2.0) - 2.0
    circle = even - xp.log1p(_free_power(approach, crown)) / _POWER
    if logarithmic is None:
        return circle
    ratio, _ = _decay(approach, crown, logarithmic)
    return xp.where(logarithmic > 0.0, even + xp.log(-xp.expm1(-ratio)), circle)


def factor_drift(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Slope of :func:`length_factor` over the logarithm of the approach."""
    power = _free_power(approach, crown)
    circle = power / (1.0 + power)
    if logarithmic is None:
        return circle
    ratio, decay = _decay(approach, crown, logarithmic)
    return xp.where(logarithmic > 0.0, ratio * decay / -xp.expm1(-ratio), circle)


def compression_of_slices(
    approach: Array, crown: Array, logarithmic: Array | None, place: Array
) -> tuple[Array, Array]:
    """Compression at places over the loaded half, and its slope over the logarithm of the approach."""
    free = approach < crown
    circle = approach - xp.where(free, approach, crown) * place**2
    growth = xp.where(free, circle, approach)
    if logarithmic is None:
        return circle, growth
    profiled = logarithmic > 0.0
    _, decay = _decay(approach, crown, logarithmic)
    left = (1.0 - place**2) + place**2 * decay
    drift = factor_drift(approach, crown, logarithmic)
    found = approach + crown * xp.log(left)
    change = approach - crown * drift * (1.0 - left) / left
    return xp.where(profiled, found, circle), xp.where(profiled, change, growth)


def share_growth(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Slope of the logarithm of :func:`loaded_share` over that of the approach."""
    circle = xp.where(approach < crown, 0.5, 0.0)
    if logarithmic is None:
        return circle
    return xp.where(logarithmic > 0.0, 0.5 * factor_drift(approach, crown, logarithmic), circle)


def end_compression(approach: Array, crown: Array, logarithmic: Array | None) -> Array:
    """Compression at the ends of the rollers, 0 where they are free."""
    circle = xp.where(approach > crown, approach - crown, 0.0)
    return circle if logarithmic is None else xp.where(logarithmic > 0.0, 0.0, circle)
