"""Logarithmic profiles of rollers along their axes: Lundberg's, that of Johns and Gohar, and that of ISO/TS 16281."""

from __future__ import annotations

import math

from asperity.contact.tilted_line import PLACES, logarithmic_end_drop
from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Coefficient of the profile of ISO/TS 16281 over the diameter of the roller, for rollers up to the length below.
ISO_16281_SHARE = 0.00035
#: Greatest length of a roller over its diameter for which that coefficient holds.
ISO_16281_LENGTH = 2.5


def logarithmic_profile(*, coefficient: Real, end_share: Real) -> Array:
    r"""Drop of a roller with a logarithmic profile below its middle.

    .. math:: z(y) = A \ln\frac{1}{1 - c\,(2y/B)^2}

    Parameters
    ----------
    coefficient : Real
        A [m].
    end_share : Real
        c [-]: 1 for a drop without bound at the ends, below it :math:`1 - e^{-z_m/A}` for a drop of :math:`z_m`.

    Returns
    -------
    Array
        At :data:`~asperity.contact.tilted_line.PLACES`, shape (slices,) [m]; infinite at the ends for c = 1.

    Notes
    -----
    In the middle its radius is :math:`B^2/(8 A c)`.

    References
    ----------
    G. Lundberg, Forsch. Ing.-Wes. 10 (1939) 201; equation (B13) of :doc:`/equations`.
    """
    left = 1.0 - end_share * (2.0 * PLACES) ** 2
    some = left > 0.0
    return xp.where(some, -coefficient * xp.log(xp.where(some, left, 1.0)), xp.inf)  # (B13)


def lundberg_coefficient(*, line_load: Real, contact_modulus: Real) -> Real:
    r"""Coefficient of the profile that spreads a load evenly over parallel rollers.

    .. math:: A = \frac{P'}{\pi E^*}

    Parameters
    ----------
    line_load : Real
        Load per length P' for which the profile is made, shape (...) [N/m].
    contact_modulus : Real
        E* [Pa].

    Returns
    -------
    Real
        A of both bodies together, shape (...) [m].

    Notes
    -----
    Of bodies that are half-spaces; with a drop without bound at the ends, c = 1, no end is ever loaded.

    References
    ----------
    G. Lundberg, Forsch. Ing.-Wes. 10 (1939) 201; equation (B13) of :doc:`/equations`.
    """
    return line_load / (math.pi * contact_modulus)  # (B13)


def johns_gohar_share(*, even_half_width: Real, contact_length: Real) -> Array:
    r"""Share c of a profile with Lundberg's coefficient and the drop of Johns and Gohar at its ends.

    .. math:: c = 1 - e^{-z_m/A} = 1 - \frac{2 \cdot 0.3033\,b}{B}

    Parameters
    ----------
    even_half_width : Real
        Half-width b of the contact of cylinders under the load of the profile [m].
    contact_length : Real
        Length B [m].

    Returns
    -------
    Array
        Shape (...) [-].

    References
    ----------
    P. M. Johns and R. Gohar, Tribol. Int. 14 (1981) 131; equation (B13) of :doc:`/equations`.
    """
    coefficients = logarithmic_end_drop(even_half_width=even_half_width, contact_length=contact_length)
    return -xp.expm1(-coefficients)  # (B13)


def iso_16281_coefficient(*, roller_diameter: Real) -> Real:
    r"""Coefficient of the profile of rollers of ISO/TS 16281, whose other body has none.

    .. math:: A = 0.00035\,D_w, \qquad B \le 2.5\,D_w

    Parameters
    ----------
    roller_diameter : Real
        D_w [m].

    Returns
    -------
    Real
        A, shape (...) [m]; with c = 1.

    Notes
    -----
    It is Lundberg's coefficient of a roller of steel on a flat under 3.0 GPa. The standard has another profile for
    longer rollers, which is not here.

    References
    ----------
    ISO/TS 16281 as the manual of the MESYS software (www.mesys.ag/manual/crowning.html) and the Python package
    ``tribology`` (``profrolleriso``, of DIN 26281, with the range of length) state it; equation (B13) of
    :doc:`/equations`.
    """
    return ISO_16281_SHARE * roller_diameter  # (B13)
