"""A rough contact on elastic bodies: asperities and bulk as springs in series, normally and tangentially."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp

from asperity.contact.asperity import slip_factor
from asperity.contact.hertz_line import mindlin_ratio
from asperity.types import Real


class Interface(eqx.Module):
    """Stiffnesses of a contact by source; arrays of one broadcast shape [N/m].

    Parameters
    ----------
    asperity_normal, asperity_tangential : Real
        Of the rough interface, :mod:`asperity.contact.fractal` [N/m].
    bulk_normal, bulk_tangential : Real
        Of the two smooth bodies, :mod:`asperity.contact.hertz_line`, incremental [N/m].
    """

    asperity_normal: Real
    asperity_tangential: Real
    bulk_normal: Real
    bulk_tangential: Real

    @property
    def normal(self) -> Real:
        """Normal stiffness of asperities and bulk in series [N/m]."""
        return series_stiffness(self.asperity_normal, self.bulk_normal)

    @property
    def tangential(self) -> Real:
        """Tangential stiffness of asperities and bulk in series [N/m]."""
        return series_stiffness(self.asperity_tangential, self.bulk_tangential)

    @property
    def asperity_share_normal(self) -> Real:
        """Share of the normal compliance that is the asperities' [-]."""
        return compliance_share(self.asperity_normal, self.bulk_normal)

    @property
    def asperity_share_tangential(self) -> Real:
        """Share of the tangential compliance that is the asperities' [-]."""
        return compliance_share(self.asperity_tangential, self.bulk_tangential)


def series_stiffness(stiffness_1: Real, stiffness_2: Real) -> Real:
    r"""Stiffness of two springs in series, :math:`k_1 k_2/(k_1 + k_2)`; 0 where one of them is 0.

    Parameters
    ----------
    stiffness_1, stiffness_2 : Real
        Stiffnesses [N/m].

    Returns
    -------
    Real
        Stiffness [N/m].

    References
    ----------
    Elementary: the same force passes both springs, their elongations add.
    """
    total = stiffness_1 + stiffness_2
    return stiffness_1 * (stiffness_2 / jnp.where(total > 0.0, total, 1.0))


def compliance_share(stiffness_1: Real, stiffness_2: Real) -> Real:
    r"""Share of the first of two springs in series in their compliance, :math:`k_2/(k_1 + k_2)`.

    Parameters
    ----------
    stiffness_1, stiffness_2 : Real
        Stiffnesses [N/m].

    Returns
    -------
    Real
        Share [-]; nan where both are 0.

    References
    ----------
    Elementary: elongation of the first spring over that of both under the same force.
    """
    total = stiffness_1 + stiffness_2
    return jnp.where(total > 0.0, stiffness_2 / jnp.where(total > 0.0, total, 1.0), jnp.nan)


def bulk_tangential_stiffness(
    *,
    bulk_normal_stiffness: Real,
    contact_modulus: Real,
    tangential_contact_modulus: Real,
    normal_force: Real,
    tangential_force: Real,
    friction_coefficient: Real,
) -> Real:
    r"""Tangential stiffness of the smooth bodies.

    .. math:: K_t = K_n \frac{4G^*}{E} \left(1 - \frac{T}{\mu N}\right)^{1/3}

    Parameters
    ----------
    bulk_normal_stiffness : Real
        Incremental normal stiffness of the bodies [N/m].
    contact_modulus, tangential_contact_modulus : Real
        E and G* [Pa].
    normal_force, tangential_force : Real
        N and T >= 0 [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        Stiffness [N/m].

    Notes
    -----
    Ratio and slip factor are those of point contacts, see :func:`asperity.contact.hertz_line.mindlin_ratio`.

    References
    ----------
    R. D. Mindlin, J. Appl. Mech. 16 (1949) 259.
    """
    ratio = mindlin_ratio(
        contact_modulus=contact_modulus, tangential_contact_modulus=tangential_contact_modulus
    )
    slip = slip_factor(
        tangential_force=tangential_force,
        normal_force=normal_force,
        friction_coefficient=friction_coefficient,
    )
    return bulk_normal_stiffness * ratio * slip
