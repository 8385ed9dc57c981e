"""Torsional stiffness of a contact, equation (30), and of a joint, with the shares of its parts in the compliance."""

from __future__ import annotations

import math

from asperity.engine.module import Module
from asperity.types import Array, Real

#: One arcminute in radians.
ARCMINUTE = math.pi / 10800.0


class TorsionalStiffness(Module):
    """Torsional stiffness, at the input and at the output.

    Parameters
    ----------
    input : Real
        At the input with the output locked [N·m/rad].
    output : Real
        At the output with the input locked, as users of reducers quote it [N·m/rad].
    """

    input: Real
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


class Assembly(Module):
    """Stiffness of the assembled drive and where its compliance comes from.

    Parameters
    ----------
    stiffness : TorsionalStiffness
        At the input and at the output [N·m/rad]; 0 where the drive transmits no torque.
    tangential_share : Array
        Share of each contact's tangential spring in the compliance, shape (contacts, ...) [-].
    normal_share : Array
        Share of each contact's normal spring, which allows free rollers to float, shape (contacts, ...) [-].
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
