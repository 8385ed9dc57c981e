r"""What shape a crown has: a circle, or a logarithmic profile without bound at the ends of the rollers.

All lengths as in :mod:`asperity.contact.crowned_line`: the approach :math:`\eta`, the crown :math:`\rho = R\kappa/2`
with the curvature :math:`\kappa` of the middle, and the place t over half of the length. The gap is :math:`\rho t^2` of
a circle and :math:`-\rho \ln(1 - t^2)` of a logarithmic profile of coefficient A, whose curvature is :math:`8A/B^2`.
Its ends are never loaded. ``logarithmic`` is 1 where a contact has such a profile and 0 where it has a circle, None
where all have.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from asperity.engine.arrays import xp
from asperity.types import Array

_POWER = 4  # of the smooth minimum of the free length of contact and the length of the rollers
_EVEN = 2.0 * math.log(2.0) - 2.0  # of the whole length


class CrownShape(NamedTuple):
    """Crowns of contacts under an approach, arrays of one shape (contacts, ...) [-]; equations (B4) and (B13)."""

    approach: Array
    crown: Array
    logarithmic: Array | None

    def _free_power(self) -> Array:
        return ((self.crown / self.approach) ** 2) ** (_POWER // 2)

    def _of(self, profile: Array, circle: Array) -> Array:
        """The one of logarithmic profiles, the other of circles."""
        assert self.logarithmic is not None
        return xp.where(self.logarithmic > 0.0, profile, circle)

    def _ratio(self) -> Array:
        """Approach over the crown of logarithmic profiles, and 1 of others."""
        assert self.logarithmic is not None
        profiled = self.logarithmic > 0.0
        return xp.where(profiled, self.approach / xp.where(profiled, self.crown, 1.0), 1.0)

    def loaded_share(self) -> Array:
        """Share of the length that is loaded."""
        free = self.approach < self.crown
        circle = xp.where(free, xp.sqrt(self.approach / xp.where(free, self.crown, 1.0)), 1.0)
        if self.logarithmic is None:
            return circle
        return self._of(xp.sqrt(-xp.expm1(-self._ratio())), circle)

    def spread(self) -> Array:
        """The loaded share without a kink where the load reaches the ends: that on which compression depends."""
        circle = xp.exp(-0.5 / _POWER * xp.log1p(self._free_power()))
        return circle if self.logarithmic is None else self._of(self.loaded_share(), circle)

    def length_factor(self) -> Array:
        """Compression over squared width of a slice plus the logarithm of the latter, 2 ln(2 s) − 2."""
        circle = _EVEN - xp.log1p(self._free_power()) / _POWER
        if self.logarithmic is None:
            return circle
        return self._of(_EVEN + xp.log(-xp.expm1(-self._ratio())), circle)

    def factor_drift(self) -> Array:
        """Slope of the factor over the logarithm of the approach."""
        power = self._free_power()
        circle = power / (1.0 + power)
        if self.logarithmic is None:
            return circle
        ratio = self._ratio()
        return self._of(ratio * xp.exp(-ratio) / -xp.expm1(-ratio), circle)

    def share_growth(self) -> Array:
        """Slope of the logarithm of the loaded share over that of the approach."""
        circle = xp.where(self.approach < self.crown, 0.5, 0.0)
        return circle if self.logarithmic is None else self._of(0.5 * self.factor_drift(), circle)

    def slices(self, place: Array | float) -> tuple[Array, Array]:
        """Compression at places over the loaded half, and its slope over the logarithm of the approach."""
        free = self.approach < self.crown
        circle = self.approach - xp.where(free, self.approach, self.crown) * place**2
        growth = xp.where(free, circle, self.approach)
        if self.logarithmic is None:
            return circle, growth
        left = (1.0 - place**2) + place**2 * xp.exp(-self._ratio())
        found = self.approach + self.crown * xp.log(left)  # (B13)
        change = self.approach - self.crown * self.factor_drift() * (1.0 - left) / left
        return self._of(found, circle), self._of(change, growth)

    def end_compression(self) -> Array:
        """Compression at the ends of the rollers, 0 where they are free."""
        circle = xp.where(self.approach > self.crown, self.approach - self.crown, 0.0)
        return circle if self.logarithmic is None else self._of(xp.zeros_like(circle), circle)
