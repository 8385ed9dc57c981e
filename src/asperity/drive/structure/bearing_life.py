"""Basic rating life and static safety of rolling bearings under a radial load."""

from __future__ import annotations

from typing import Literal

from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.types import Array, Real

#: Rolling elements of a bearing.
BearingKind = Literal["ball", "roller"]
#: Exponent of the load in the life.
LIFE_EXPONENTS: dict[BearingKind, float] = {"ball": 3.0, "roller": 10.0 / 3.0}
#: Load over dynamic rating up to which the basic rating life holds.
LARGEST_LOAD_RATIO = 0.5


class RatedBearing(Module):
    """A rolling bearing with the ratings of its catalogue. SI units.

    Parameters
    ----------
    dynamic_rating, static_rating : Real
        Basic dynamic and static radial load ratings C and C_0 [N].
    count : Real
        Number of bearings that share the load of the drive equally [-].
    outside_force : Real
        Radial force on one bearing that the drive does not know [N].
    kind : {"ball", "roller"}
        Its rolling elements.
    """

    dynamic_rating: Real
    static_rating: Real
    count: Real
    outside_force: Real
    kind: BearingKind = static()


def basic_rating_life(*, dynamic_rating: Real, load: Real, exponent: float) -> Array:
    r"""Life that nine bearings in ten reach, :math:`L_{10} = 10^6\,(C/P)^p`.

    Parameters
    ----------
    dynamic_rating : Real
        Basic dynamic radial load rating C [N].
    load : Real
        Equivalent load P, here the radial load, not negative [N].
    exponent : float
        p, :data:`LIFE_EXPONENTS` [-].

    Returns
    -------
    Array
        Life in revolutions [-]; infinite without a load.

    Notes
    -----
    For loads up to C/2, usual steel and cleanliness, no axial load, no misalignment: the modification factor
    :math:`a_{ISO}` is 1.

    References
    ----------
    ISO 281:2007, Rolling bearings – Dynamic load ratings and rating life; equation (L2) of :doc:`/equations`.

    Examples
    --------
    >>> float(basic_rating_life(dynamic_rating=2000.0, load=1000.0, exponent=3.0))
    8000000.0
    """
    loaded = xp.asarray(load) > 0.0
    ratio = dynamic_rating / xp.where(loaded, load, 1.0)
    life = xp.where(loaded, 1e6 * ratio**exponent, xp.inf)
    return xp.where(xp.isnan(load), xp.nan, life)


def static_safety(*, static_rating: Real, load: Real) -> Array:
    r"""Static safety of a bearing, :math:`S_0 = C_0/P_0`.

    Parameters
    ----------
    static_rating : Real
        Basic static radial load rating C_0 [N].
    load : Real
        Largest equivalent static load P_0, here the radial load, not negative [N].

    Returns
    -------
    Array
        Safety [-]; infinite without a load. Below 1 the raceways keep dents of more than a ten-thousandth of the
        rolling element's diameter.

    References
    ----------
    ISO 76:2006, Rolling bearings – Static load ratings; equation (L2) of :doc:`/equations`.
    """
    loaded = xp.asarray(load) > 0.0
    safety = xp.where(loaded, static_rating / xp.where(loaded, load, 1.0), xp.inf)
    return xp.where(xp.isnan(load), xp.nan, safety)
