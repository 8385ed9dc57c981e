"""How a line contact resists a tilt of its rollers while it is pressed over its whole length, or has free ends."""

from __future__ import annotations

import math

import numpy as np

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.tilted_line import PLACES
from asperity.engine.arrays import xp
from asperity.types import Array, Real


def line_load_stiffness(*, half_width: Real, loaded_length: Real, contact_modulus: Real) -> Real:
    r"""Load per length of a slice over its approach, incremental.

    .. math:: \frac{\mathrm dP'}{\mathrm d\delta} = \frac{\pi E^*}{2 \ln\frac{2 \ell}{\sqrt e\,a} - 2}

    Parameters
    ----------
    half_width : Real
        Half-width a of the slice, shape (...) [m].
    loaded_length : Real
        Length of the contact that is loaded, B of cylinders [m].
    contact_modulus : Real
        E* [Pa].

    Returns
    -------
    Real
        Stiffness, shape (...) [N/m²].

    Notes
    -----
    The slope of the law of slices, (B4), at one loaded length; positive for contacts longer than 2.3 times their width.

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    logarithm = xp.log(2.0 * loaded_length / (math.sqrt(math.e) * half_width))
    return math.pi * contact_modulus / (2.0 * logarithm - 2.0)  # (B14)


def tilt_stiffness(*, line_load_stiffness: Real, contact_length: Real) -> Real:
    r"""Moment over tilt of a contact of parallel cylinders.

    .. math:: K = \frac{\mathrm dP'}{\mathrm d\delta}\,\frac{B^3}{12}

    Parameters
    ----------
    line_load_stiffness : Real
        Of the even load, :func:`line_load_stiffness` [N/m²].
    contact_length : Real
        Length B [m].

    Returns
    -------
    Real
        Stiffness, shape (...) [N·m/rad].

    Notes
    -----
    Without tilt; 2 % less where one end comes free, (B14).

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    return line_load_stiffness * contact_length**3 / 12.0  # (B14)


def freeing_tilt(*, line_load: Real, line_load_stiffness: Real, contact_length: Real) -> Real:
    r"""Tilt near which one end of a contact of cylinders comes free.

    .. math:: \varphi_e = \frac{2 \delta_e}{B}, \qquad \delta_e = \frac{P'}{\mathrm dP'/\mathrm d\delta}

    Parameters
    ----------
    line_load : Real
        Mean load per length P' [N/m].
    line_load_stiffness : Real
        Of the even load, :func:`line_load_stiffness` [N/m²].
    contact_length : Real
        Length B [m].

    Returns
    -------
    Real
        Tilt, shape (...) [rad].

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    return 2.0 * line_load / (line_load_stiffness * contact_length)  # (B14)


def pressed_end_pressure(*, peak_pressure: Real, tilt: Real, freeing_tilt: Real) -> Real:
    r"""Pressure of the last slice of a tilted cylinder while both ends are pressed.

    .. math:: p_{end} \approx p_0 \sqrt{1 + \varphi/\varphi_e}

    Parameters
    ----------
    peak_pressure : Real
        Hertz pressure p_0 of the even load [Pa].
    tilt, freeing_tilt : Real
        Tilt, and that at which an end comes free, :func:`freeing_tilt` [rad].

    Returns
    -------
    Real
        Pressure, shape (...) [Pa]; without the stress of the edge, which has no bound.

    Notes
    -----
    Within 1 % of slices for tilts up to :math:`\varphi_e`.

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    return peak_pressure * xp.sqrt(1.0 + tilt / freeing_tilt)  # (B14)


def sliced_tilt_stiffness(
    *, line: CrownedLine, loaded_length: Real, contact_length: Real, contact_modulus: Real
) -> Array:
    r"""Moment over tilt of a contact with crowns or profiles, without tilt.

    .. math:: K = \sum_j \frac{\mathrm dP'_j}{\mathrm d\delta}\,y_j^2\,\Delta_j

    Parameters
    ----------
    line : CrownedLine
        Its load along the line, :func:`asperity.contact.crowned_line.crowned_line`.
    loaded_length : Real
        Length on which its compression depends, B where the ends are loaded [m].
    contact_length : Real
        Length B [m].
    contact_modulus : Real
        E* [Pa].

    Returns
    -------
    Array
        Stiffness, shape (...) [N·m/rad].

    Notes
    -----
    A circular crown of radius :math:`R_c` with free ends has :math:`K = N R_c`, at any tilt that leaves both ends free.

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    slices = line_load_stiffness(
        half_width=line.half_width, loaded_length=loaded_length, contact_modulus=contact_modulus
    )
    return xp.sum(slices * line.position**2 * line.length_share, axis=0) * contact_length  # (B14)


def tilting_moment(*, line_load: Array, contact_length: Real) -> Array:
    r"""Moment of the load along a line about its middle.

    .. math:: M = \int P'\,y\,\mathrm dy

    Parameters
    ----------
    line_load : Array
        At :data:`~asperity.contact.tilted_line.PLACES`, shape (slices,) [N/m].
    contact_length : Real
        Length B [m].

    Returns
    -------
    Array
        Moment [N·m].

    References
    ----------
    Equation (B14) of :doc:`/equations`.
    """
    moments = line_load * PLACES * contact_length
    step = contact_length / (np.size(PLACES) - 1)
    return xp.sum(0.5 * (moments[:-1] + moments[1:])) * step  # (B14)
