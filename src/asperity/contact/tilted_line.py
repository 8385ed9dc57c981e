"""Line contact of rollers of any profile, also with tilted axes, in slices as :mod:`asperity.contact.crowned_line`."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from asperity.contact.crowned_line import LEAST_TARGET
from asperity.contact.strip_theory import strip_logarithm
from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, traced_once
from asperity.types import Array, Real

#: Places of the slices over the contact length, from its middle: both ends and the middle are among them.
PLACES: NDArray[np.float64] = np.linspace(-0.5, 0.5, 201)
_HALVINGS = 60
_WITHOUT_ENDS = 1.1


class ProfiledLine(NamedTuple):
    """A line contact of any profile under load. SI units.

    ``line_load`` of the slices, shape (slices,) [N/m]; ``peak_pressure``, the largest of all slices, nan of a contact
    less than twice as long as wide [Pa]; ``end_line_load``, the larger of both ends, without the concentration of
    stress of an edge [N/m]; ``end_gap``, the smaller of both ends under load, negative where an end is pressed [m].
    """

    line_load: Array
    peak_pressure: Array
    end_line_load: Array
    end_gap: Array


@traced_once
def profiled_line(
    *, gap: Array, normal_force: Real, contact_length: Real, effective_radius: Real, contact_modulus: Real
) -> ProfiledLine:
    r"""How the load of a line contact spreads over its length, whatever the gap along it.

    .. math:: \int P'\,\mathrm dy = N, \qquad
        \delta - g(y) = \frac{P'}{\pi E^*}\left(2 \ln\frac{2 \ell}{\sqrt e\,a} - 1\right) \ge 0

    Parameters
    ----------
    gap : Array
        Gap g of the unloaded rollers at :data:`PLACES`, over any constant, shape (slices,) [m]; infinite at an end with
        a drop without bound, and nowhere else.
    normal_force, contact_length, effective_radius, contact_modulus : Real
        As for :func:`asperity.contact.crowned_line.crowned_line`.

    Returns
    -------
    ProfiledLine
        Loads of the slices, and the largest pressure.

    Notes
    -----
    Slices do not interact except through the loaded length :math:`\ell`. Where the ends are free the largest pressure
    is within 4 % of that of boundary elements, also under a tilt; that of a loaded sharp end is not known to slices.

    References
    ----------
    Equations (B4) and (B13) of :doc:`/equations`.
    """
    per_approach = 4.0 * effective_radius / contact_length**2
    gaps = per_approach * xp.asarray(gap, dtype=float)
    load = per_approach * normal_force / (math.pi * contact_modulus * contact_length)

    def factor(above: Array) -> Array:
        first, second = above[:-1], above[1:]
        apart = xp.abs(first) + xp.abs(second)
        pressed = xp.maximum(first, 0.0) + xp.maximum(second, 0.0)
        share = xp.mean(pressed / xp.where(apart > 0.0, apart, 1.0))  # loaded, of the length
        return 2.0 * xp.log(2.0 * share) - 2.0

    def squared_width(above: Array) -> Array:
        pressed = above > 0.0
        some = xp.where(pressed, above, 1.0)
        return xp.where(
            pressed, some / strip_logarithm(xp.maximum(factor(above) - xp.log(some), LEAST_TARGET)), 0.0
        )

    def halve(_: int, bounds: tuple[Array, Array]) -> tuple[Array, Array]:
        low, high = bounds
        middle = 0.5 * (low + high)
        squared = squared_width(middle - gaps)
        enough = xp.mean(0.5 * (squared[:-1] + squared[1:])) >= load
        return xp.where(enough, low, middle), xp.where(enough, middle, high)

    even = load * (2.0 * math.log(2.0) - 2.0 - xp.log(load))
    ends = xp.isfinite(gaps)
    more = xp.where(xp.all(ends), 1.0, _WITHOUT_ENDS)  # for what the slices at free ends do not carry
    farthest = xp.max(xp.where(ends, gaps, xp.min(gaps))) + more * even
    _, approach = fori_loop(0, _HALVINGS, halve, (xp.min(gaps), farthest))
    above = approach - gaps
    squared = squared_width(above)
    is_long = factor(above) - xp.log(xp.max(above)) > LEAST_TARGET
    peak = 0.5 * contact_modulus * contact_length / effective_radius * xp.sqrt(xp.max(squared))
    line_load = squared * math.pi * contact_modulus / per_approach
    return ProfiledLine(
        line_load=line_load,
        peak_pressure=xp.where(is_long, peak, xp.nan),
        end_line_load=xp.maximum(line_load[0], line_load[-1]),
        end_gap=-xp.maximum(above[0], above[-1]) / per_approach,
    )


def logarithmic_drop(*, even_half_width: Real, contact_length: Real) -> Array:
    r"""Drop of a logarithmic profile over that at its ends.

    .. math:: \frac{z}{z_m} = \frac{A}{z_m} \ln\frac{1}{1 - (1 - e^{-z_m/A})(2y/B)^2}, \qquad
        \frac{z_m}{A} = \ln\frac{B}{2 \cdot 0.3033\,b} = 1.193 + \ln\frac{B}{2b}

    Parameters
    ----------
    even_half_width : Real
        Half-width b of the contact of cylinders under the same load [m].
    contact_length : Real
        Length B [m].

    Returns
    -------
    Array
        At :data:`PLACES`, shape (slices,) [-].

    Notes
    -----
    Lundberg's coefficient :math:`A = P'/(\pi E^*)` makes the load of parallel rollers even. Fujiwara and Kawase
    multiply it for tilted ones; this is their profile without a straight part, with the drop over the coefficient of
    Johns and Gohar.

    References
    ----------
    G. Lundberg, Forsch. Ing.-Wes. 10 (1939) 201; P. M. Johns and R. Gohar, Tribol. Int. 14 (1981) 131; H. Fujiwara and
    T. Kawase, NTN Tech. Rev. 75 (2007) 140. Equation (B13) of :doc:`/equations`.
    """
    coefficients = logarithmic_end_drop(even_half_width=even_half_width, contact_length=contact_length)
    return -xp.log1p(xp.expm1(-coefficients) * (2.0 * PLACES) ** 2) / coefficients


def logarithmic_end_drop(*, even_half_width: Real, contact_length: Real) -> Array:
    r"""Drop of a logarithmic profile at its ends over its coefficient, after Johns and Gohar.

    .. math:: \frac{z_m}{A} = \ln\frac{B}{2 \cdot 0.3033\,b} = 1.193 + \ln\frac{B}{2b}

    Parameters
    ----------
    even_half_width, contact_length : Real
        As for :func:`logarithmic_drop` [m].

    Returns
    -------
    Array
        Shape (...) [-].

    References
    ----------
    P. M. Johns and R. Gohar, Tribol. Int. 14 (1981) 131; equation (B13) of :doc:`/equations`.
    """
    return -xp.log(2.0 * 0.3033 * xp.asarray(even_half_width) / contact_length)
