r"""Wear of a rolling contact by Archard's law: what partial slip, or an oil film that shears everywhere, takes away.

Archard's law is local, :math:`\dot h = k\,p\,|v|`. Where a dry contact slips, it bears :math:`q = \mu p`, so that
:math:`\int p\,|v|\,dA = P/\mu` with the power P of its friction, however the slip is spread: sticking surfaces do not
wear. The product of normal force and creepage would be :math:`\mu N/T` times too much.
"""

from __future__ import annotations

import math

from asperity.engine.arrays import xp
from asperity.types import Array, Real


def slipping_load_power(*, friction_power: Real, friction_coefficient: Real) -> Real:
    r"""Pressure times speed of slip over a dry contact, :math:`\int p\,|v|\,dA = P/\mu`.

    Parameters
    ----------
    friction_power : Real
        Power P of the tangential forces on the slip, along and across the rolling direction [W].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        What Archard's law multiplies by the wear coefficient [W].

    Notes
    -----
    Exact wherever the friction is mu p where the contact slips: in partial slip, with skew, and in gross slip.

    References
    ----------
    Equation (W1) of :doc:`/equations`.
    """
    return friction_power / friction_coefficient


def mixed_load_power(*, asperity_share: Real, normal_force: Real, slip_speed: Real) -> Real:
    r"""Pressure of the asperities times speed of slip over a contact whose oil film shears everywhere, :math:`A N v`.

    Parameters
    ----------
    asperity_share : Real
        Share A of the asperities in the load [-].
    normal_force : Real
        N [N].
    slip_speed : Real
        Speed v of slip, along and across the rolling direction together [m/s].

    Returns
    -------
    Real
        What Archard's law multiplies by the wear coefficient [W].

    Notes
    -----
    The asperities are taken to slip with the film over the whole width. Where they carry most of the load they stick in
    a part of it, and this is too much, by mu N/T at most.

    References
    ----------
    A. Winkler, M. Marian, S. Tremmel and S. Wartzack, Lubricants 8 (2020) 58, on wear of a rolling bearing by the share
    of the asperities; equation (W1) of :doc:`/equations`.
    """
    return asperity_share * normal_force * slip_speed


def worn_volume_rate(*, wear_coefficient: Real, load_power: Real) -> Real:
    r"""Volume that a surface loses per time, :math:`\dot V = k \int p\,|v|\,dA`.

    Parameters
    ----------
    wear_coefficient : Real
        k of this surface [1/Pa]; 1e-15 1/Pa is 1e-6 mm^3/(N m).
    load_power : Real
        :func:`slipping_load_power` or :func:`mixed_load_power` [W].

    Returns
    -------
    Real
        Volume per time [m^3/s].

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981; equation (W1) of :doc:`/equations`.
    """
    return wear_coefficient * load_power


def worn_depth_rate(*, volume_rate: Real, track_radius: Real, contact_length: Real) -> Array:
    r"""Depth that a track loses per time, :math:`\dot h = \dot V/(2\pi R B)`.

    Parameters
    ----------
    volume_rate : Real
        Volume per time that all contacts on the track take of one body [m^3/s].
    track_radius : Real
        Radius R of the track [m].
    contact_length : Real
        Length B of the contact line [m].

    Returns
    -------
    Array
        Mean depth per time [m/s].

    Notes
    -----
    The body turns relative to its contacts, so that all of the track wears alike.

    References
    ----------
    Elementary; equation (W2) of :doc:`/equations`.
    """
    return xp.asarray(volume_rate / (2.0 * math.pi * track_radius * contact_length))
