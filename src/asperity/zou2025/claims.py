"""All claims of the paper, evaluated on the computed curves: those about forces here, the others by name."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from asperity.zou2025 import claims_joint, claims_pair, preset
from asperity.zou2025.criteria import (
    NEARLY_SAME,
    SIGNIFICANT,
    TENDENCY,
    Claim,
    Statement,
    falls,
    relative_difference,
    rises,
    rising_share,
)
from asperity.zou2025.curves import Curves
from asperity.zou2025.kinematics import CONTACT_NAMES

SP, PWR, PWL, WRO, WLO = range(5)
_RIGHT = [SP, PWR, WRO]
_LEFT = [PWL, WLO]


def _trend(symbol: str, contacts: list[int], forces: np.ndarray, verb: str, torque: np.ndarray) -> Statement:
    """Whether the forces of some contacts all increase, or all decrease, with the output torque."""
    chosen, names = forces[contacts], [f"{symbol}_{CONTACT_NAMES[i]}" for i in contacts]
    ends = {name: (float(force[0]), float(force[-1])) for name, force in zip(names, chosen, strict=True)}
    words = ", ".join(f"{name} {start:.5g} -> {end:.5g}" for name, (start, end) in ends.items())
    return Statement(
        says=f"{', '.join(names[:-1])} and {names[-1]} {verb}",
        met=rises(chosen) if verb == "increase" else falls(chosen),
        evidence=f"from {torque[0]:g} to {torque[-1]:g} N*m: {words} N",
        numbers={
            f"{name}_{end}_N": force
            for name, pair in ends.items()
            for end, force in zip(("start", "end"), pair, strict=True)
        },
    )


def contact_forces(curves: Curves) -> Claim:
    """C7: how the contact forces depend on the output torque."""
    torque = curves.loads.output_torque
    normal, tangential = curves.loads.normal_force[..., 0], curves.loads.tangential_force[..., 0]
    change = tangential[:, -1] - tangential[:, 0]
    right, left = float(np.min(change[_RIGHT])), float(np.max(change[_LEFT]))
    return Claim(
        "C7",
        "an increasing output torque loads the right side of the wedge and unloads the left side",
        ("5a", "5b"),
        (
            _trend("N", _RIGHT, normal, "increase", torque),
            _trend("N", _LEFT, normal, "decrease", torque),
            _trend("T", [SP, PWR, PWL, WRO, WLO], tangential, "increase", torque),
            Statement(
                says="T_sp, T_pwr and T_wro change more than T_pwl and T_wlo",
                met=right > left,
                evidence=f"smallest change of T_sp, T_pwr and T_wro {right:.4g} N, largest change of T_pwl and T_wlo "
                f"{left:.4g} N",
                numbers={"smallest_right_change_N": right, "largest_left_change_N": left},
            ),
        ),
    )


def _alike(right: int, left: int, curves: Curves) -> Statement:
    """Whether a right and a left contact are equally stiff in both panels of Fig. 6."""
    panels = (curves.dimension, curves.roughness)
    worst = max(
        float(np.max(relative_difference(k[right], k[left])))
        for k in (panel.contact_torsional_stiffness[:, -1] for panel in panels)
    )
    torque, over_torque = curves.loads.output_torque, curves.loads.contact_torsional_stiffness[..., 0]
    difference = relative_difference(over_torque[right], over_torque[left])
    above = np.flatnonzero(difference > NEARLY_SAME.limit)
    until = float(torque[above[0] - 1]) if above.size and above[0] > 0 else float(torque[-1])
    return Statement(
        says=f"{CONTACT_NAMES[right]} and {CONTACT_NAMES[left]} are nearly the same",
        met=worst <= NEARLY_SAME.limit,
        evidence=f"at {torque[-1]:g} N*m they differ by up to {worst:.0%} in the two panels (required: at most "
        f"{NEARLY_SAME.limit:.0%}), because the torque loads one side of the wedge and unloads the other; at "
        f"D = {preset.FRACTAL_DIMENSION:g} they differ by less than {NEARLY_SAME.limit:.0%} up to {until:.2f} N*m",
        numbers={
            "largest_difference": worst,
            "difference_at_full_torque": float(difference[-1]),
            "torque_up_to_which_nearly_the_same_Nm": until,
        },
    )


def contact_stiffnesses(curves: Curves) -> Claim:
    """C8: left and right contacts are equally stiff, sun–planet is far stiffer; trends with D and G."""
    over_dimension = curves.dimension.contact_torsional_stiffness[:, -1]
    over_roughness = curves.roughness.contact_torsional_stiffness[:, -1]
    both = np.concatenate([over_dimension, over_roughness], axis=-1)
    above_next = both[SP] / np.max(both[1:], axis=0)
    ratio = float(np.min(above_next))
    with_sun_radius = float(np.max(above_next)) * (preset.SUN_RADIUS / preset.PLANET_RADIUS) ** 2
    share = float(np.min(rising_share(over_dimension)))
    gain = float(np.min(over_roughness[:, 0] / over_roughness[:, -1]))
    return Claim(
        "C8",
        "left and right contacts are nearly equally stiff, the sun-planet contact is the stiffest",
        ("6a", "6b"),
        (
            _alike(PWR, PWL, curves),
            _alike(WRO, WLO, curves),
            Statement(
                says="sp is significantly higher than all others",
                met=ratio >= 1.0 + SIGNIFICANT.limit,
                evidence=f"at least {ratio:.3g} times the next highest, with the radius of the driven roller in (30); "
                f"with the radius of the sun, as section 4 of the paper says, at most {with_sun_radius:.2f} times",
                numbers={"smallest_ratio": ratio, "largest_ratio_with_sun_radius": with_sun_radius},
            ),
            Statement(
                says="all tend to increase with D",
                met=share >= TENDENCY.limit,
                evidence=f"each increases over at least {share:.0%} of the range of D (required: at least "
                f"{TENDENCY.limit:.0%}) and decreases above its maximum",
                numbers={"rising_share": share},
            ),
            Statement(
                says="all increase as G decreases",
                met=falls(over_roughness),
                evidence=f"each is at least {gain:.3g} times higher at the smallest G than at the largest",
                numbers={"smallest_gain": gain},
            ),
        ),
    )


#: C1–C13 and the design window, in this order.
CLAIMS: tuple[Callable[[Curves], Claim], ...] = (
    claims_pair.normal_force,
    claims_pair.tangential_force,
    claims_pair.fractal_dimension,
    claims_pair.fractal_roughness,
    claims_pair.contact_length,
    claims_pair.roller_radius,
    contact_forces,
    contact_stiffnesses,
    claims_joint.fractal_dimension,
    claims_joint.fractal_roughness,
    claims_joint.output_torque,
    claims_joint.size,
    claims_joint.friction,
    claims_joint.design_window,
)


def judge(curves: Curves) -> tuple[Claim, ...]:
    """Every claim, in the order of :data:`CLAIMS`, with its verdict from all computed curves."""
    return tuple(claim(curves) for claim in CLAIMS)
