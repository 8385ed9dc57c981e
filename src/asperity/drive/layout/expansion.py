r"""Thermal expansion of a drive: what strains of its bodies add to the interference of its contacts."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import Drive


def interference_of_strains(*, drive: Drive, strains: tuple[Array, Array], carrier: Array) -> Array:
    r"""Interference of each contact that uniform strains of the bodies add.

    .. math:: \delta_k = (\epsilon_1 - \epsilon_c)\,r_1 \pm (\epsilon_2 - \epsilon_c)\,r_2

    with the minus sign where the first body lies inside the second.

    Parameters
    ----------
    drive : Drive
        The drive.
    strains : tuple of Array
        Strains of the two tracks of each contact, those of the first body and those of the second, shape (contacts,)
        [-].
    carrier : Array
        Strain of the carrier, which moves the pins [-].

    Returns
    -------
    Array
        Interference, shape (contacts,) [m]; 0 where everything has one strain, which makes a similar drive.

    Notes
    -----
    Counted from the drive that is as large as the carrier makes it, so that its pins stay where they are. Of first
    order in the strains.

    References
    ----------
    The approach of two circles whose radii change; equation (I2) of :doc:`/equations`.
    """
    first, second = ((strain - carrier) for strain in strains)
    return interference_of_sizes(
        drive=drive, first=first * drive.first_radius, second=second * drive.second_radius
    )


def interference_of_sizes(*, drive: Drive, first: Array, second: Array) -> Array:
    r"""Interference of each contact that deviations of its radii add.

    .. math:: \delta_k = \varepsilon_1 \pm \varepsilon_2

    with the minus sign where the first body lies inside the second.

    Parameters
    ----------
    drive : Drive
        The drive.
    first, second : Array
        Deviations of the radii of the first and of the second track of each contact, larger positive, shape (contacts,)
        [m].

    Returns
    -------
    Array
        Interference, shape (contacts,) [m].

    References
    ----------
    The approach of two circles whose radii change; equations (I2) and (I4) of :doc:`/equations`.
    """
    inside = np.array([contact.internal for contact in drive.contacts])
    return first + jnp.where(inside, -1.0, 1.0) * second


def ring_interference(*, drive: Drive, forces: Array, interference: Array) -> Array:
    r"""Interference of the rings that does the work of given interferences of all contacts.

    .. math:: \delta = \frac{\sum_k N_k\,\delta_k}{\sum_{k\,\mathrm{internal}} N_k}

    Parameters
    ----------
    drive : Drive
        The drive.
    forces : Array
        Normal forces without torque over any scale, shape (contacts,) [-].
    interference : Array
        Interference of each contact, shape (contacts,) [m].

    Returns
    -------
    Array
        Interference of the drive [m]; where statics alone does not decide the forces, a mean of its rings.

    References
    ----------
    Virtual work, as in equation (I1) of :doc:`/equations`.
    """
    inside = np.array([contact.internal for contact in drive.contacts])
    return jnp.sum(forces * interference) / jnp.sum(jnp.where(inside, forces, 0.0))
