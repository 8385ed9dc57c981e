r"""Thermal expansion of a drive: what strains of its bodies add to the interference of its contacts.

By virtual work, as for any other change of the sizes. A ring that a housing of another material holds expands with it.
A drive of one material throughout keeps its interference.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from asperity.body.press_fit import rim_compliance
from asperity.drive.layout.drive import Drive
from asperity.engine.arrays import xp
from asperity.types import Array, Real


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
    return first + xp.where(inside, -1.0, 1.0) * second


def ring_interference(*, drive: Drive, forces: Array, interference: Array) -> Array:
    r"""Interference of the rings that does the work of given interferences of all contacts.

    .. math:: \delta = \frac{\sum_k N_k\,\delta_k}{\sum_{k\,\mathrm{internal}} N_k}

    In a drive without rings that of all contacts.

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
    inside = inside if inside.any() else ~inside
    return xp.sum(forces * interference) / xp.sum(xp.where(inside, forces, 0.0))


def ring_expansion(
    *,
    ring: Real,
    housing: Real,
    inner_radius: Real,
    wall_thickness: Real,
    youngs_modulus: Real,
    poisson_ratio: Real,
    housing_stiffness: Real,
    plane_state: Literal["plane_strain", "plane_stress"],
) -> Array:
    r"""Expansion coefficient of the inner radius of a ring that a housing of another material holds.

    .. math::
        \alpha = \alpha_r + (\alpha_h - \alpha_r)\, \frac{k c}{1 + k c}\, \frac{2}{1 - \nu + (1 + \nu)\,a^2/b^2}

    with the compliance c of its outer rim by :func:`~asperity.body.press_fit.rim_compliance`.

    Parameters
    ----------
    ring, housing : Real
        Expansion coefficients of both [1/K].
    inner_radius, wall_thickness : Real
        Inner radius a and wall b − a of the ring [m].
    youngs_modulus, poisson_ratio : Real
        E [Pa] and nu [-] of the ring.
    housing_stiffness : Real
        Pressure over radial displacement k of the housing [N/m^3]: 0 for a ring that carries itself, ``math.inf`` for a
        rigid housing, which moves the outer rim as it expands itself.
    plane_state : {"plane_strain", "plane_stress"}
        Of the ring; in plane strain E/(1 − nu^2) and nu/(1 − nu) take the place of E and nu.

    Returns
    -------
    Array
        Change of the inner radius over radius and temperature [1/K].

    Notes
    -----
    The outer rim of the ring stays on the housing, which therefore must press or hold it at every temperature. A thick
    ring pulled by its housing widens by more than the housing does, as every hole in a stretched plate does.

    References
    ----------
    Equation (I2) of :doc:`/equations`; Lamé's solution with a free inner rim, S. P. Timoshenko and J. N. Goodier,
    Theory of Elasticity, 3rd ed. 1970, section 28.
    """
    outer = inner_radius + wall_thickness
    modulus, poisson = youngs_modulus, poisson_ratio
    if plane_state == "plane_strain":
        modulus, poisson = modulus / (1.0 - poisson**2), poisson / (1.0 - poisson)
    narrowing = 1.0 - poisson + (1.0 + poisson) * (inner_radius / outer) ** 2
    compliance = rim_compliance(rim=outer, other=inner_radius, youngs_modulus=modulus, poisson_ratio=poisson)
    rigid = xp.isinf(xp.asarray(housing_stiffness))
    held = xp.where(rigid, 0.0, housing_stiffness) * compliance
    share = xp.where(rigid, 1.0, held / (1.0 + held))
    return xp.asarray(ring + (housing - ring) * share * 2.0 / narrowing)


def loosening_rise(*, interference: Real, change_per_kelvin: Real) -> Array:
    r"""Rise of temperature at which a drive has no interference, :math:`-\delta/(\mathrm{d}\delta/\mathrm{d}T)` [K].

    From the interference at the assembly [m] and what a kelvin adds to it [m/K]; of either sign, infinite for a drive
    that temperature does not change. Equation (I2) of :doc:`/equations`, which is linear in the temperature.
    """
    moves = xp.asarray(change_per_kelvin) != 0.0
    return xp.where(moves, -interference / xp.where(moves, change_per_kelvin, 1.0), math.inf)
