"""The state of a rough contact by any law, and its springs in series with those of the elastic bodies."""

from __future__ import annotations

from asperity.contact.hertz_line import partial_slip_compliance
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real


class Interface(Module):
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
    Elementary: both springs carry the same force, their elongations add.
    """
    total = stiffness_1 + stiffness_2
    return stiffness_1 * (stiffness_2 / xp.where(total > 0.0, total, 1.0))


def bulk_tangential_stiffness(
    *,
    normal_compliance: Real,
    logarithmic_compliance: Real,
    normal_force: Real,
    tangential_force: Real,
    friction_coefficient: Real,
) -> Real:
    r"""Tangential stiffness of the smooth bodies of a line contact.

    .. math:: \frac1{K_t} = \frac1{K_n} + \sum_{i=1,2} \frac{1-\nu_i^2}{\pi E_i B} \, \ln\frac{1}{1 - T/(\mu N)}

    Parameters
    ----------
    normal_compliance : Real
        Incremental normal compliance 1/K_n of the bodies [m/N].
    logarithmic_compliance : Real
        Sum of :func:`asperity.contact.hertz_line.logarithmic_compliance` over both bodies [m/N].
    normal_force, tangential_force : Real
        N and T >= 0 [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        Incremental (tangent) stiffness on first loading [N/m]; 0 from gross slip on and where N is not positive.

    Notes
    -----
    In plane strain the displacement of a half-plane under shear follows the same logarithm of the distance as under
    compression, so that a contact in full stick is equally stiff in both. Far from the contact a roller differs from a
    half-plane; the ratio of the two stiffnesses is then about 1, not exactly.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 2.8; :func:`asperity.contact.hertz_line.partial_slip_compliance`.
    """
    added = partial_slip_compliance(
        logarithmic_compliance=logarithmic_compliance,
        normal_force=normal_force,
        tangential_force=tangential_force,
        friction_coefficient=friction_coefficient,
    )
    holds = xp.isfinite(added) & xp.isfinite(normal_compliance)
    compliance = xp.where(holds, normal_compliance, 0.5) + xp.where(holds, added, 0.5)
    return xp.where(holds, 1.0 / compliance, 0.0)


class RoughContact(Module):
    """The state of one rough contact under load; arrays of one broadcast shape, SI units.

    Parameters
    ----------
    largest_area, critical_area : Array
        Largest spot a_l and critical spot a_c [m^2]; nan for a law without spots.
    real_contact_area : Array
        Real area of contact A_r [m^2]; nan for a law without spots.
    elastic_load, plastic_load : Array
        Shares F_e and F_p of the normal force carried by elastic and by plastic spots [N].
    tangential_stiffness, normal_stiffness : Array
        K_t and K_n of all elastic spots together [N/m].
    layer_stiffness : Array
        Normal force over the approach in which the pressure rises by the factor e [N/m]; K_n of the published law.
    domain_extension_factor, contact_factor : Array
        psi and lambda [-]; nan for a law without spots.
    """

    largest_area: Array
    critical_area: Array
    real_contact_area: Array
    elastic_load: Array
    plastic_load: Array
    tangential_stiffness: Array
    normal_stiffness: Array
    layer_stiffness: Array
    domain_extension_factor: Array
    contact_factor: Array
