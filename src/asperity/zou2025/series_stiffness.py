"""From the tangential stiffnesses of the five contacts to the torsional stiffness of the paper's joint: (25)–(29).

In this series every roller turns about a fixed centre. With floating bodies (A8) a tangential force on the planet
displaces it laterally against the *normal* springs of its wedge
(:func:`asperity.drive.stiffness.network.network_stiffness`).
"""

from __future__ import annotations

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.stiffness.torsional_stiffness import TorsionalStiffness, contact_torsional_stiffness
from asperity.engine.arrays import xp
from asperity.types import Array, Real
from asperity.zou2025.kinematics import speed_ratio


def driven_radii(geometry: DriveGeometry) -> Real:
    """Radius of the driven roller of each contact: R_p for ``sp``, R_w for the other four.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.

    Returns
    -------
    Real
        Radii, shape (5, ...) [m].

    References
    ----------
    Zou et al. 2025, equation (30) as used in Fig. 6; only this choice gives the order of the curves there.
    """
    planet, roller = xp.broadcast_arrays(geometry.planet_radius, geometry.loading_roller_radius)
    return xp.stack([planet, roller, roller, roller, roller])


def referred_to_sun(*, torsional_stiffness: Real, sun_radius: Real, radius: Real) -> Real:
    r"""Torsional stiffness at another roller referred to the sun, :math:`K_T (R_s/R)^2`.

    Parameters
    ----------
    torsional_stiffness : Real
        Local stiffness at the roller of radius R [N·m/rad].
    sun_radius, radius : Real
        R_s and R [m].

    Returns
    -------
    Real
        Stiffness at the sun [N·m/rad].

    References
    ----------
    Zou et al. 2025, equations (26) and (27).
    """
    return torsional_stiffness * (sun_radius / radius) ** 2  # (26), (27)


def series_torsional_stiffness(*, geometry: DriveGeometry, tangential_stiffness: Array) -> TorsionalStiffness:
    r"""Torsional stiffness of the joint from its five tangential stiffnesses in series and parallel.

    .. math::
        K_T = \frac{n}{1/K_{T,sp} + 1/K'_{T,pw} + 1/K'_{T,wo}}, \quad
        K_{T,pw} = K_{T,pwr} + K_{T,pwl}, \quad K_{T,wo} = K_{T,wro} + K_{T,wlo}

    where the primed stiffnesses are referred to the sun.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive with n planets.
    tangential_stiffness : Array
        K_t of the contacts in the order of :data:`asperity.zou2025.kinematics.CONTACT_NAMES`, shape (5, ...) [N/m].

    Returns
    -------
    TorsionalStiffness
        At the sun and at the output; 0 where one of the three stages has none.

    Notes
    -----
    Includes the tangential springs only: bodies, planet float, pins and shafts are taken as rigid.

    References
    ----------
    Zou et al. 2025, equations (25)–(30); (A7) of :doc:`/equations` is the same in one line.
    """
    sun, planet, roller = geometry.sun_radius, geometry.planet_radius, geometry.loading_roller_radius
    sp, pwr, pwl, wro, wlo = tangential_stiffness
    stage_sp = contact_torsional_stiffness(tangential_stiffness=sp, radius=sun)  # (30)
    stage_pw = contact_torsional_stiffness(tangential_stiffness=pwr + pwl, radius=planet)  # (28)
    stage_wo = contact_torsional_stiffness(tangential_stiffness=wro + wlo, radius=roller)  # (29)
    stages = (
        stage_sp,
        referred_to_sun(torsional_stiffness=stage_pw, sun_radius=sun, radius=planet),
        referred_to_sun(torsional_stiffness=stage_wo, sun_radius=sun, radius=roller),
    )
    holds = (stages[0] > 0.0) & (stages[1] > 0.0) & (stages[2] > 0.0)
    compliance = sum(1.0 / xp.where(holds, stage, 1.0) for stage in stages)
    at_sun = xp.where(holds, geometry.planet_count / compliance, 0.0)  # (25)
    return TorsionalStiffness(input=at_sun, output=at_sun * speed_ratio(geometry) ** 2)
