"""All claims of the paper, evaluated on the computed curves."""

from __future__ import annotations

from collections.abc import Callable

from asperity.zou2025 import claims_forces, claims_joint, claims_pair
from asperity.zou2025.curves import Curves
from asperity.zou2025.verdict import Claim

#: C1–C13 and the design window, in this order.
CLAIMS: tuple[Callable[[Curves], Claim], ...] = (
    claims_pair.normal_force,
    claims_pair.tangential_force,
    claims_pair.fractal_dimension,
    claims_pair.fractal_roughness,
    claims_pair.contact_length,
    claims_pair.roller_radius,
    claims_forces.contact_forces,
    claims_forces.contact_stiffnesses,
    claims_joint.fractal_dimension,
    claims_joint.fractal_roughness,
    claims_joint.output_torque,
    claims_joint.size,
    claims_joint.friction,
    claims_joint.design_window,
)


def judge(curves: Curves) -> tuple[Claim, ...]:
    """Every claim with its verdict.

    Parameters
    ----------
    curves : Curves
        All computed curves.

    Returns
    -------
    tuple of Claim
        In the order of :data:`CLAIMS`.
    """
    return tuple(claim(curves) for claim in CLAIMS)
