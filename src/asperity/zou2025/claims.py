"""All claims of the paper, judged on the computed curves."""

from __future__ import annotations

from asperity.zou2025 import claims_forces, claims_joint, claims_pair, preset
from asperity.zou2025.curves import Curves
from asperity.zou2025.verdict import Claim


def pair_claims(curves: Curves) -> tuple[Claim, ...]:
    """C1–C6, about a single roller pair.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    tuple of Claim
    """
    pairs = curves.pairs
    low = preset.DIMENSION_RANGE[0]
    return (
        claims_pair.normal_force_claim(
            normal_force=pairs["a"].values, stiffness=pairs["a"].tangential_stiffness
        ),
        claims_pair.tangential_force_claim(
            tangential_force=pairs["b"].values,
            stiffness=pairs["b"].tangential_stiffness,
            slip_force=preset.FRICTION_COEFFICIENT * preset.PAIR_NORMAL_FORCE,
        ),
        claims_pair.dimension_claim(
            dimension=pairs["c"].values,
            stiffness=pairs["c"].tangential_stiffness,
            stated=preset.PEAK_DIMENSION,
        ),
        claims_pair.roughness_claim(roughness=pairs["d"].values, stiffness=pairs["d"].tangential_stiffness),
        claims_pair.length_claim(
            length=pairs["f"].values,
            stiffness=pairs["f"].tangential_stiffness,
            low_stiffness=pairs["f_low"].tangential_stiffness,
            low_dimension=low,
        ),
        claims_pair.radius_claim(
            radius=pairs["e"].values,
            stiffness=pairs["e"].tangential_stiffness,
            low_stiffness=pairs["e_low"].tangential_stiffness,
            low_dimension=low,
        ),
    )


def joint_claims(curves: Curves) -> tuple[Claim, ...]:
    """C7–C13 and the design window, about the joint.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    tuple of Claim
    """
    loads, dimension, roughness = curves.loads, curves.dimension, curves.roughness
    length, friction, radius = curves.length, curves.friction, curves.radius
    torques = dimension.output_torque
    loaded = friction.output_torque > 0.0
    geometry = preset.table_2_joint(preset.operating_grid()).geometry
    return (
        claims_forces.load_claim(
            output_torque=loads.output_torque,
            normal_force=loads.normal_force[..., 0],
            tangential_force=loads.tangential_force[..., 0],
        ),
        claims_forces.contact_claim(
            output_torque=loads.output_torque,
            over_torque=loads.contact_torsional_stiffness[..., 0],
            over_dimension=dimension.contact_torsional_stiffness[:, -1],
            over_roughness=roughness.contact_torsional_stiffness[:, -1],
            sun_over_planet_radius=float(geometry.sun_radius) / float(geometry.planet_radius),
        ),
        claims_joint.peak_claim(
            output_torque=torques,
            dimension=dimension.values,
            stiffness=dimension.output_stiffness,
            stated=preset.PEAK_DIMENSION,
        ),
        claims_joint.roughness_claim(
            output_torque=torques, roughness=roughness.values, stiffness=roughness.output_stiffness
        ),
        claims_joint.torque_claim(
            output_torque=torques,
            stiffness={
                "7a": dimension.output_stiffness,
                "7b": roughness.output_stiffness,
                "8a": length.output_stiffness,
            },
        ),
        claims_joint.size_claim(
            output_torque=torques,
            length=length.values,
            stiffness=length.output_stiffness,
            radius_scale=radius.values,
            radius_stiffness=radius.output_stiffness,
        ),
        claims_joint.friction_claim(
            output_torque=friction.output_torque[loaded],
            friction=friction.values,
            stiffness=friction.output_stiffness[loaded],
            high_friction=curves.high_friction.values,
            high_stiffness=curves.high_friction.output_stiffness[loaded],
        ),
        claims_joint.window_claim(
            output_torque=torques,
            dimension=dimension.values,
            stiffness=dimension.output_stiffness,
            window=preset.DESIGN_WINDOW,
        ),
    )


def judge(curves: Curves) -> tuple[Claim, ...]:
    """C1–C13 and the design window, in this order.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    tuple of Claim
        Fourteen verdicts.
    """
    return pair_claims(curves) + joint_claims(curves)
