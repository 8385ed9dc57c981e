"""From tangential stiffnesses of the contacts to the torsional stiffness of the joint: equations (25)–(30).

In the published series (25) every roller turns about a fixed centre. With floating bodies (A8) a tangential force on
the planet displaces it laterally against the *normal* springs of its wedge
(:func:`asperity.drive.stiffness.network.network_stiffness`).
"""

from __future__ import annotations

import math

from asperity.drive.wedge.geometry import DriveGeometry, speed_ratio
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real

#: One arcminute in radians.
ARCMINUTE = math.pi / 10800.0


class TorsionalStiffness(Module):
    """Torsional stiffness, at the sun and at the output.

    Parameters
    ----------
    sun : Real
        At the sun with the carrier locked [N·m/rad].
    output : Real
        At the carrier with the sun locked, as users of reducers quote it [N·m/rad].
    """

    sun: Real
    output: Real

    @property
    def output_per_arcminute(self) -> Real:
        """Output-side stiffness [N·m/arcmin]."""
        return self.output * ARCMINUTE


def contact_torsional_stiffness(*, tangential_stiffness: Real, radius: Real) -> Real:
    r"""Torsional stiffness of one contact referred to a roller, :math:`K_T = K_t R^2`.

    Parameters
    ----------
    tangential_stiffness : Real
        K_t [N/m].
    radius : Real
        Radius R of the roller that the stiffness is referred to [m].

    Returns
    -------
    Real
        K_T [N·m/rad].

    References
    ----------
    Zou et al. 2025, equation (30). Fig. 6 of the paper uses the radius of the driven roller.
    """
    return tangential_stiffness * radius**2  # (30)


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
        K_t of the contacts in the order of :data:`asperity.drive.wedge.geometry.CONTACT_NAMES`, shape (5, ...) [N/m].

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
    return TorsionalStiffness(sun=at_sun, output=at_sun * speed_ratio(geometry) ** 2)


class Assembly(Module):
    """Stiffness of the assembled drive and where its compliance comes from.

    Parameters
    ----------
    stiffness : TorsionalStiffness
        At the sun and at the output [N·m/rad]; 0 where the drive transmits no torque.
    tangential_share : Array
        Share of each contact's tangential spring in the compliance, shape (5, ...) [-].
    normal_share : Array
        Share of each contact's normal spring, which allows the planet to float in its wedge, shape (5, ...) [-].
    ring_bending_share, pin_share, planet_support_share, input_shaft_share, output_shaft_share : Array
        Shares of the structure [-]. All shares add up to 1.
    loading_cam_share : Real, optional
        Share of a loading cam that follows the torque, :func:`asperity.drive.stiffness.loading_cam.with_cam` [-].
    """

    stiffness: TorsionalStiffness
    tangential_share: Array
    normal_share: Array
    ring_bending_share: Array
    pin_share: Array
    planet_support_share: Array
    input_shaft_share: Array
    output_shaft_share: Array
    loading_cam_share: Real = 0.0
