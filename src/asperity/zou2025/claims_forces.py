"""Claims C7 and C8, about the five contacts of the joint (section 5.2, Figs. 5 and 6)."""

from __future__ import annotations

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.zou2025.criteria import (
    NEARLY_SAME,
    SIGNIFICANT,
    TENDENCY,
    falls,
    relative_difference,
    rises,
    rising_share,
)
from asperity.zou2025.verdict import Claim, Statement

SP, PWR, PWL, WRO, WLO = range(5)
_RIGHT = (SP, PWR, WRO)
_LEFT = (PWL, WLO)


def _ends(symbol: str, contacts: tuple[int, ...], force: np.ndarray) -> tuple[str, dict[str, float]]:
    words, numbers = [], {}
    for i in contacts:
        name = f"{symbol}_{CONTACT_NAMES[i]}"
        words.append(f"{name} {force[i, 0]:.5g} -> {force[i, -1]:.5g}")
        numbers[f"{name}_start_N"], numbers[f"{name}_end_N"] = float(force[i, 0]), float(force[i, -1])
    return ", ".join(words) + " N", numbers


def load_claim(*, output_torque: np.ndarray, normal_force: np.ndarray, tangential_force: np.ndarray) -> Claim:
    """C7: the trends of the contact forces with the output torque.

    Parameters
    ----------
    output_torque : ndarray
        Shape (n,) [N·m].
    normal_force, tangential_force : ndarray
        Forces of sp, pwr, pwl, wro, wlo, shape (5, n) [N].

    Returns
    -------
    Claim
    """
    span = f"from {output_torque[0]:g} to {output_torque[-1]:g} N*m: "
    right_text, right = _ends("N", _RIGHT, normal_force)
    left_text, left = _ends("N", _LEFT, normal_force)
    all_text, all_numbers = _ends("T", (SP, PWR, PWL, WRO, WLO), tangential_force)
    change = tangential_force[:, -1] - tangential_force[:, 0]
    strong, weak = float(np.min(change[list(_RIGHT)])), float(np.max(change[list(_LEFT)]))
    return Claim(
        "C7",
        "with the output torque the right wedge loads up and the left one unloads",
        ("5a", "5b"),
        (
            Statement(
                "N_sp, N_pwr and N_wro rise", rises(normal_force[list(_RIGHT)]), span + right_text, right
            ),
            Statement("N_pwl and N_wlo fall", falls(normal_force[list(_LEFT)]), span + left_text, left),
            Statement("all tangential forces rise", rises(tangential_force), span + all_text, all_numbers),
            Statement(
                "T_sp, T_pwr and T_wro change more than T_pwl and T_wlo",
                strong > weak,
                f"smallest change of the former {strong:.4g} N, largest of the latter {weak:.4g} N",
                {"smallest_right_change_N": strong, "largest_left_change_N": weak},
            ),
        ),
    )


def _alike(
    right: int,
    left: int,
    output_torque: np.ndarray,
    over_torque: np.ndarray,
    over_dimension: np.ndarray,
    over_roughness: np.ndarray,
) -> Statement:
    worst = max(
        float(np.max(relative_difference(k[right], k[left]))) for k in (over_dimension, over_roughness)
    )
    along = relative_difference(over_torque[right], over_torque[left])
    apart = np.flatnonzero(along > NEARLY_SAME.limit)
    until = float(output_torque[apart[0] - 1]) if apart.size and apart[0] > 0 else float(output_torque[-1])
    names = f"{CONTACT_NAMES[right]} and {CONTACT_NAMES[left]}"
    return Statement(
        says=f"{names} are nearly the same",
        met=worst <= NEARLY_SAME.limit,
        evidence=f"over both panels they differ by up to {worst:.0%} (nearly the same up to {NEARLY_SAME.limit:.0%}) "
        f"at {output_torque[-1]:g} N*m, because the torque loads one side of the wedge and unloads the other; at "
        f"D = 1.4 they stay within {NEARLY_SAME.limit:.0%} up to {until:.2f} N*m",
        numbers={
            "largest_difference": worst,
            "difference_at_full_torque": float(along[-1]),
            "torque_up_to_which_nearly_the_same_Nm": until,
        },
    )


def contact_claim(
    *,
    output_torque: np.ndarray,
    over_torque: np.ndarray,
    over_dimension: np.ndarray,
    over_roughness: np.ndarray,
    sun_over_planet_radius: float,
) -> Claim:
    """C8: the contacts' own torsional stiffnesses: left and right alike, sun–planet far above, trends in D and G.

    Parameters
    ----------
    output_torque : ndarray
        Shape (m,) [N·m].
    over_torque : ndarray
        K_T of the contacts over the torque, shape (5, m) [N·m/rad].
    over_dimension, over_roughness : ndarray
        The same at the last torque over D and over G, both ascending, shape (5, n) [N·m/rad].
    sun_over_planet_radius : float
        R_s/R_p, to tell what the other choice of radius in (30) would give [-].

    Returns
    -------
    Claim
    """
    both = np.concatenate([over_dimension, over_roughness], axis=-1)
    ratio = float(np.min(both[SP] / np.max(both[1:], axis=0)))
    other = float(np.max(both[SP] / np.max(both[1:], axis=0))) * sun_over_planet_radius**2
    share = float(np.min(rising_share(over_dimension)))
    gain = float(np.min(over_roughness[:, 0] / over_roughness[:, -1]))
    alike = (output_torque, over_torque, over_dimension, over_roughness)
    return Claim(
        "C8",
        "left and right contacts are alike, sun-planet is the stiffest",
        ("6a", "6b"),
        (
            _alike(PWR, PWL, *alike),
            _alike(WRO, WLO, *alike),
            Statement(
                "sp is significantly higher than all others",
                ratio >= 1.0 + SIGNIFICANT.limit,
                f"at least {ratio:.3g} times the next one, with the radius of the driven roller in (30); with the "
                f"sun's own radius, as section 4 of the paper says, it would be at most {other:.2f} times",
                {"smallest_ratio": ratio, "largest_ratio_with_sun_radius": other},
            ),
            Statement(
                "all tend to rise with D",
                share >= TENDENCY.limit,
                f"each rises over at least {share:.0%} of the range of D (tendency from {TENDENCY.limit:.0%} on); "
                "above the peak they fall",
                {"rising_share": share},
            ),
            Statement(
                "all rise as G falls",
                falls(over_roughness),
                f"each is at least {gain:.3g} times higher at the smallest G than at the largest",
                {"smallest_gain": gain},
            ),
        ),
    )
