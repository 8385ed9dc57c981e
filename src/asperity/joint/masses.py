"""Masses of the rollers of the paper's drive."""

from __future__ import annotations

import math

from asperity.joint.description import Joint
from asperity.types import Real


def roller_mass(*, density: Real, radius: Real, length: Real, bore: Real) -> Real:
    r"""Mass of a roller, :math:`m = \rho \pi (R^2 - d^2/4) L`.

    Parameters
    ----------
    density : Real
        Density [kg/m^3].
    radius, length : Real
        Radius R and length L [m].
    bore : Real
        Diameter d of its bore [m]; 0 for a solid roller.

    Returns
    -------
    Real
        Mass [kg].
    """
    return density * math.pi * (radius**2 - 0.25 * bore**2) * length


def planet_mass(joint: Joint) -> Real:
    """Mass of one planet.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Real
        Mass [kg].
    """
    return roller_mass(
        density=joint.bodies.planet.density,
        radius=joint.geometry.planet_radius,
        length=joint.planet_length,
        bore=0.0 if joint.planet_bore is None else joint.planet_bore,
    )


def loading_roller_mass(joint: Joint) -> Real:
    """Mass of one loading roller.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Real
        Mass [kg].
    """
    return roller_mass(
        density=joint.bodies.loading_roller.density,
        radius=joint.geometry.loading_roller_radius,
        length=joint.loading_roller_length,
        bore=0.0 if joint.loading_roller_bore is None else joint.loading_roller_bore,
    )
