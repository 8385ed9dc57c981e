"""Claims C9–C13 and the design window, about the torsional stiffness K_T of the whole joint (Figs. 7 and 8).

Each function evaluates one claim on the computed curves. Torques are in N·m, K_T in N·m/rad, lengths in m.
"""

from __future__ import annotations

import numpy as np

from asperity.zou2025 import preset
from asperity.zou2025.criteria import (
    OPTIMAL,
    PEAK_NEAR,
    SATURATED,
    SIGNIFICANT,
    SLIGHT,
    Claim,
    Statement,
    falls,
    growth_per_doubling,
    interval_above,
    peak,
    relative_change,
    rises,
)
from asperity.zou2025.curves import Curves


def _torques(output_torque: np.ndarray) -> str:
    return ", ".join(f"{t:g}" for t in output_torque) + " N*m"


def fractal_dimension(curves: Curves) -> Claim:
    """C9: K_T has its maximum near the stated fractal dimension at every torque."""
    sweep, stated = curves.dimension, preset.PEAK_DIMENSION
    places = [peak(sweep.values, curve) for curve in sweep.output_stiffness]
    farthest = max(abs(place - stated) for place in places)
    inside = all(sweep.values[0] < place < sweep.values[-1] for place in places)
    return Claim(
        "C9",
        f"K_T has a maximum near D = {stated:g} at every torque",
        ("7a",),
        (
            Statement(
                says=f"at every torque K_T increases with D up to a maximum near D = {stated:g}, then decreases",
                met=inside and farthest <= PEAK_NEAR.limit,
                evidence=f"maxima between D = {min(places):.3f} and {max(places):.3f} at "
                f"{_torques(sweep.output_torque)}, at most {farthest:.3f} from {stated:g} (required: at most "
                f"{PEAK_NEAR.limit:g})",
                numbers={
                    f"peak_fractal_dimension_at_{t:g}_Nm": p
                    for t, p in zip(sweep.output_torque, places, strict=True)
                },
            ),
        ),
    )


def fractal_roughness(curves: Curves) -> Claim:
    """C10: K_T decreases with the fractal roughness at every torque."""
    sweep = curves.roughness
    factor = sweep.output_stiffness[:, 0] / sweep.output_stiffness[:, -1]
    least, most = float(np.min(factor)), float(np.max(factor))
    return Claim(
        "C10",
        "K_T decreases with the roughness parameter G",
        ("7b",),
        (
            Statement(
                says="K_T decreases gradually as G increases, at every torque",
                met=falls(sweep.output_stiffness),
                evidence=f"from {sweep.values[0] * 1e3:.3g} to {sweep.values[-1] * 1e3:.3g} mm K_T decreases by a "
                f"factor of {least:.1f} to {most:.1f} at {_torques(sweep.output_torque)}",
                numbers={"smallest_factor": least, "largest_factor": most},
            ),
        ),
    )


def output_torque(curves: Curves) -> Claim:
    """C11: K_T decreases slightly with the output torque."""
    panels = {"7a": curves.dimension, "7b": curves.roughness, "8a": curves.length}
    torque = curves.dimension.output_torque
    over_torque = np.concatenate([sweep.output_stiffness.T for sweep in panels.values()])
    change = relative_change(over_torque)
    low, high = float(np.min(change)), float(np.max(change))
    numbers = {"change_weakest": high, "change_strongest": low}
    steps = "at every step" if falls(over_torque) else "not at every step"
    return Claim(
        "C11",
        "K_T decreases slightly with the output torque",
        tuple(panels),
        (
            Statement(
                says="K_T decreases as the output torque increases",
                met=falls(over_torque),
                evidence=f"it decreases {steps} of {_torques(torque)} at all points of the panels",
                numbers=numbers,
            ),
            Statement(
                says="the decrease is slight",
                met=abs(low) < SLIGHT.limit and abs(high) < SLIGHT.limit,
                evidence=f"{high:+.1%} to {low:+.1%} from {torque[0]:g} to {torque[-1]:g} N*m (required: less than "
                f"{SLIGHT.limit:.0%})",
                numbers=numbers,
            ),
        ),
    )


def size(curves: Curves) -> Claim:
    """C12: K_T increases with the contact length and the roller radii, both "significantly"."""
    length, radius = curves.length, curves.radius
    change = relative_change(length.output_stiffness)
    least, most = float(np.min(change)), float(np.max(change))
    radius_least = float(np.min(relative_change(radius.output_stiffness)))
    lever = float(radius.values[-1] ** 2 - 1.0)
    return Claim(
        "C12",
        "K_T increases significantly with the contact length and the roller radius",
        ("8a",),
        (
            Statement(
                says="K_T increases with B at every torque",
                met=rises(length.output_stiffness),
                evidence=f"{least:+.1%} to {most:+.1%} from {length.values[0] * 1e3:g} to "
                f"{length.values[-1] * 1e3:g} mm at {_torques(length.output_torque)}",
                numbers={"smallest_change": least, "largest_change": most},
            ),
            Statement(
                says="the increase with B is significant",
                met=least >= SIGNIFICANT.limit,
                evidence=f"at most {most:+.1%} for {length.values[-1] / length.values[0]:g} times the length "
                f"(required: at least {SIGNIFICANT.limit:.0%}); B enters the contact law only through the contact "
                "factor (11), to the power 1/(2R) with R in mm, and the load on the asperities does not depend on B",
                numbers={"largest_change": most},
            ),
            Statement(
                says="the increase with the roller radius is significant (conclusions; no figure shows it)",
                met=rises(radius.output_stiffness) and radius_least >= SIGNIFICANT.limit,
                evidence=f"at least {radius_least:+.0%} for {radius.values[-1]:g} times all radii at the same preload "
                f"and torque; the lever arm R^2 of (30) alone gives {lever:+.0%}",
                numbers={"smallest_change": radius_least, "change_by_lever_arm": lever},
            ),
        ),
    )


def friction(curves: Curves) -> Claim:
    """C13: K_T increases with the friction coefficient, saturates, and is called non-monotonic."""
    loaded = curves.friction.output_torque > 0.0
    torque, mu = curves.friction.output_torque[loaded], curves.friction.values
    stiffness = curves.friction.output_stiffness[loaded]
    high_mu, high_stiffness = curves.high_friction.values, curves.high_friction.output_stiffness[loaded]
    sticks = [curve > 0.0 for curve in stiffness]
    growth = float(np.max(growth_per_doubling(high_stiffness)))
    rest = float(np.max(relative_change(high_stiffness)))
    drops = int(np.count_nonzero(np.diff(stiffness) < 0.0))
    onset = float(max(mu[s][0] for s in sticks))
    return Claim(
        "C13",
        "K_T increases with the friction coefficient, saturates and is non-monotonic",
        ("8b",),
        (
            Statement(
                says="K_T increases with mu",
                met=all(rises(curve[s]) for curve, s in zip(stiffness, sticks, strict=True)),
                evidence=f"at {_torques(torque)}, for mu = {mu[0]:.2f} to {mu[-1]:.2f}; below mu = {onset:.3f} a "
                f"contact slips at {torque[-1]:g} N*m and K_T is 0",
                numbers={"friction_from_which_all_stick": onset},
            ),
            Statement(
                says="the increase saturates",
                met=growth <= SATURATED.limit,
                evidence=f"the second of the two doublings from mu = {high_mu[0]:g} to {high_mu[1]:g} and "
                f"{high_mu[2]:g} adds at most {growth:.0%} of what the first adds (required: at most "
                f"{SATURATED.limit:.0%}); both together add at most {rest:.1%}",
                numbers={"largest_growth_per_doubling": growth, "largest_growth_beyond_the_range": rest},
            ),
            Statement(
                says="the dependence is non-monotonic",
                met=drops > 0,
                evidence=f"K_T decreases with mu at {drops} of {stiffness.size - len(stiffness)} steps; mu enters "
                "only through (1 - T/(mu F_n))^(1/3), which increases with mu; the explanation in the paper also "
                "describes an increase that saturates",
                numbers={"falling_steps": float(drops)},
            ),
        ),
    )


def design_window(curves: Curves) -> Claim:
    """The design window: the stiffness is said to be optimal for D within it."""
    dimension, stiffness = curves.dimension.values, curves.dimension.output_stiffness
    lower, upper = preset.DESIGN_WINDOW
    inside = (dimension >= lower - 1e-9) & (dimension <= upper + 1e-9)
    share = float(np.min(np.min(stiffness[:, inside], axis=1) / np.max(stiffness, axis=1)))
    places = [peak(dimension, curve) for curve in stiffness]
    outside = max(max(lower - place, place - upper, 0.0) for place in places)
    ends = [interval_above(dimension, curve, OPTIMAL.limit) for curve in stiffness]
    low, high = max(e[0] for e in ends), min(e[1] for e in ends)
    return Claim(
        "window",
        f"the stiffness is optimal for {lower:g} <= D <= {upper:g}",
        ("7a",),
        (
            Statement(
                says="the maximum of K_T lies in the window",
                met=outside <= PEAK_NEAR.limit,
                evidence=f"the maximum lies at D = {min(places):.3f} to {max(places):.3f}, at most {outside:.3f} "
                f"outside (allowed: {PEAK_NEAR.limit:g})",
                numbers={"distance_outside": outside},
            ),
            Statement(
                says="K_T is close to its maximum everywhere in the window",
                met=share >= OPTIMAL.limit,
                evidence=f"the lowest K_T in the window is {share:.0%} of the maximum (required: at least "
                f"{OPTIMAL.limit:.0%}); at {_torques(curves.dimension.output_torque)} K_T is at least "
                f"{OPTIMAL.limit:.0%} of the maximum for {low:.3f} <= D <= {high:.3f}",
                numbers={"smallest_share": share, "optimal_from_D": low, "optimal_to_D": high},
            ),
        ),
    )
