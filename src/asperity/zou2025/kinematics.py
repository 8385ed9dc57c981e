"""Contacts and speeds of the paper's drive: (A2).

The five contacts of one branch, in the order of every array with a contact axis (the first axis): sun–planet ``sp``,
planet–right and planet–left loading roller ``pwr``, ``pwl``, right and left loading roller–outer ring ``wro``, ``wlo``.
"""

from __future__ import annotations

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.engine.arrays import xp
from asperity.types import Real

#: The contacts of a branch in the order of the contact axis: name, driving and driven body.
CONTACT_BODIES: dict[str, tuple[str, str]] = {
    "sp": ("sun", "planet"),
    "pwr": ("planet", "loading_roller"),
    "pwl": ("planet", "loading_roller"),
    "wro": ("loading_roller", "ring"),
    "wlo": ("loading_roller", "ring"),
}
#: Names of the contacts of a branch, in the order of the contact axis.
CONTACT_NAMES = tuple(CONTACT_BODIES)


def speed_ratio(geometry: DriveGeometry) -> Real:
    r"""Speed ratio sun over carrier with the ring fixed.

    .. math:: \frac{\omega_s}{\omega_c} = -\frac{R_o - R_s}{R_s}

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].

    Returns
    -------
    Real
        Ratio [-]; negative: the carrier turns opposite to the sun.

    References
    ----------
    Equation (A2) of :doc:`/equations`.
    """
    return -(geometry.ring_radius - geometry.sun_radius) / geometry.sun_radius


def carrier_speed(*, geometry: DriveGeometry, sun_speed: Real) -> Real:
    """Angular velocity of the carrier, equation (A2).

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].
    sun_speed : Real
        Angular velocity of the sun [rad/s].

    Returns
    -------
    Real
        Angular velocity of the carrier [rad/s]; of opposite sign.
    """
    return sun_speed / speed_ratio(geometry)


def contact_radii(geometry: DriveGeometry) -> tuple[Real, Real, Real]:
    """Radii and kind of the five contacts.

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].

    Returns
    -------
    driving_radius, driven_radius : Real
        Radii of the driving and the driven body, shape (5, ...) [m].
    sign : Real
        +1 for the external contacts, −1 for those inside the ring, shape (5, 1, ...) [-].

    References
    ----------
    Zou et al. 2025, Table 2 and the two signs of equation (11).
    """
    names = ("sun", "planet", "loading_roller", "ring")
    values = xp.broadcast_arrays(*(getattr(geometry, f"{name}_radius") for name in names))
    radius = dict(zip(names, values, strict=True))
    driving, driven = (xp.stack([radius[body[side]] for body in CONTACT_BODIES.values()]) for side in (0, 1))
    inside = xp.array([body[1] == "ring" for body in CONTACT_BODIES.values()])
    sign = xp.where(inside, -1.0, 1.0).reshape((len(CONTACT_BODIES),) + (1,) * values[0].ndim)
    return driving, driven, sign
