"""Claims C9–C13 and the design window, about the torsional stiffness of the whole joint (Figs. 7 and 8)."""

from __future__ import annotations

import numpy as np

from asperity.zou2025.criteria import (
    OPTIMAL,
    PEAK_NEAR,
    SATURATED,
    SIGNIFICANT,
    SLIGHT,
    falls,
    growth_per_doubling,
    interval_above,
    peak,
    relative_change,
    rises,
)
from asperity.zou2025.verdict import Claim, Statement


def _torques(output_torque: np.ndarray) -> str:
    return ", ".join(f"{t:g}" for t in output_torque) + " N*m"


def peak_claim(
    *, output_torque: np.ndarray, dimension: np.ndarray, stiffness: np.ndarray, stated: float
) -> Claim:
    """C9: K_T(D) has its maximum near the stated fractal dimension at every torque.

    Parameters
    ----------
    output_torque : ndarray
        Shape (m,) [N·m].
    dimension : ndarray
        D, evenly spaced, shape (n,) [-].
    stiffness : ndarray
        K_T, shape (m, n) [N·m/rad].
    stated : float
        Where the paper sees the peak [-].

    Returns
    -------
    Claim
    """
    places = [peak(dimension, curve) for curve in stiffness]
    farthest = max(abs(place - stated) for place in places)
    inside = all(dimension[0] < place < dimension[-1] for place in places)
    return Claim(
        "C9",
        f"K_T has a maximum over D near {stated:g} at every torque",
        ("7a",),
        (
            Statement(
                says=f"at every torque K_T first grows with D, then falls from about D = {stated:g} on",
                met=inside and farthest <= PEAK_NEAR.limit,
                evidence=f"peaks between D = {min(places):.3f} and {max(places):.3f} at {_torques(output_torque)}, at "
                f"most {farthest:.3f} from {stated:g} (allowed {PEAK_NEAR.limit:g})",
                numbers={
                    f"peak_fractal_dimension_at_{t:g}_Nm": p
                    for t, p in zip(output_torque, places, strict=True)
                },
            ),
        ),
    )


def roughness_claim(*, output_torque: np.ndarray, roughness: np.ndarray, stiffness: np.ndarray) -> Claim:
    """C10: K_T falls with the fractal roughness at every torque.

    Parameters
    ----------
    output_torque : ndarray
        Shape (m,) [N·m].
    roughness : ndarray
        G, shape (n,) [m].
    stiffness : ndarray
        K_T, shape (m, n) [N·m/rad].

    Returns
    -------
    Claim
    """
    factor = stiffness[:, 0] / stiffness[:, -1]
    return Claim(
        "C10",
        "K_T falls with the roughness parameter G",
        ("7b",),
        (
            Statement(
                says="K_T gradually falls as G grows, at every torque",
                met=falls(stiffness),
                evidence=f"from {roughness[0] * 1e3:.3g} to {roughness[-1] * 1e3:.3g} mm K_T falls by a factor "
                f"{np.min(factor):.1f} to {np.max(factor):.1f} at {_torques(output_torque)}",
                numbers={"smallest_factor": float(np.min(factor)), "largest_factor": float(np.max(factor))},
            ),
        ),
    )


def torque_claim(*, output_torque: np.ndarray, stiffness: dict[str, np.ndarray]) -> Claim:
    """C11: K_T falls slightly as the output torque grows.

    Parameters
    ----------
    output_torque : ndarray
        Ascending from 0, shape (m,) [N·m].
    stiffness : dict
        Panel → K_T, shape (m, n) [N·m/rad].

    Returns
    -------
    Claim
    """
    changes = {panel: relative_change(k.T) for panel, k in stiffness.items()}
    low = float(min(np.min(c) for c in changes.values()))
    high = float(max(np.max(c) for c in changes.values()))
    return Claim(
        "C11",
        "K_T falls slightly with the output torque",
        tuple(stiffness),
        (
            Statement(
                says="K_T falls as the output torque grows",
                met=all(falls(k.T) for k in stiffness.values()),
                evidence=f"it falls at every step of {_torques(output_torque)} on every point of the panels"
                if all(falls(k.T) for k in stiffness.values())
                else f"it does not fall at every step of {_torques(output_torque)}",
                numbers={"change_weakest": high, "change_strongest": low},
            ),
            Statement(
                says="the fall is slight",
                met=abs(low) < SLIGHT.limit and abs(high) < SLIGHT.limit,
                evidence=f"{high:+.1%} to {low:+.1%} from {output_torque[0]:g} to {output_torque[-1]:g} N*m "
                f"(slight below {SLIGHT.limit:.0%})",
                numbers={"change_weakest": high, "change_strongest": low},
            ),
        ),
    )


def size_claim(
    *,
    output_torque: np.ndarray,
    length: np.ndarray,
    stiffness: np.ndarray,
    radius_scale: np.ndarray,
    radius_stiffness: np.ndarray,
) -> Claim:
    """C12: K_T grows with the contact length and the roller radii, both "significantly".

    Parameters
    ----------
    output_torque : ndarray
        Shape (m,) [N·m].
    length : ndarray
        B, shape (n,) [m].
    stiffness : ndarray
        K_T over the length, shape (m, n) [N·m/rad].
    radius_scale : ndarray
        Factor on all radii, from 1 on, shape (k,) [-].
    radius_stiffness : ndarray
        K_T over the factor, shape (m, k) [N·m/rad].

    Returns
    -------
    Claim
    """
    change, radius_change = relative_change(stiffness), relative_change(radius_stiffness)
    least, most = float(np.min(change)), float(np.max(change))
    radius_least = float(np.min(radius_change))
    lever = float(radius_scale[-1] ** 2 - 1.0)
    return Claim(
        "C12",
        "K_T grows significantly with the contact length and the roller radius",
        ("8a",),
        (
            Statement(
                says="K_T grows with B at every torque",
                met=rises(stiffness),
                evidence=f"{least:+.1%} to {most:+.1%} from {length[0] * 1e3:g} to {length[-1] * 1e3:g} mm at "
                f"{_torques(output_torque)}",
                numbers={"smallest_change": least, "largest_change": most},
            ),
            Statement(
                says="the growth with B is significant",
                met=least >= SIGNIFICANT.limit,
                evidence=f"{most:+.1%} at most for {length[-1] / length[0]:g} times the length (significant from "
                f"{SIGNIFICANT.limit:.0%} on): B enters the contact law through the factor (11) alone, to the power "
                "1/(2R) with R in mm, and the load that the spots share stays the same",
                numbers={"largest_change": most},
            ),
            Statement(
                says="the growth with the roller radius is significant (conclusions; no figure shows it)",
                met=rises(radius_stiffness) and radius_least >= SIGNIFICANT.limit,
                evidence=f"all radii times {radius_scale[-1]:g} at the same preload and torque: {radius_least:+.0%} at "
                f"least, of which the lever arm R^2 of (30) alone makes {lever:+.0%}",
                numbers={"smallest_change": radius_least, "change_by_lever_arm": lever},
            ),
        ),
    )


def friction_claim(
    *,
    output_torque: np.ndarray,
    friction: np.ndarray,
    stiffness: np.ndarray,
    high_friction: np.ndarray,
    high_stiffness: np.ndarray,
) -> Claim:
    """C13: K_T grows with the friction coefficient, saturates, and is called non-monotonic.

    Parameters
    ----------
    output_torque : ndarray
        Torques above 0, shape (m,) [N·m].
    friction : ndarray
        mu, shape (n,) [-].
    stiffness : ndarray
        K_T, 0 where a contact slips, shape (m, n) [N·m/rad].
    high_friction : ndarray
        The end of the range, and twice and four times as much, shape (3,) [-].
    high_stiffness : ndarray
        K_T there, shape (m, 3) [N·m/rad].

    Returns
    -------
    Claim
    """
    sticking = [curve > 0.0 for curve in stiffness]
    grows = all(rises(curve[s]) for curve, s in zip(stiffness, sticking, strict=True))
    ratio = float(np.max(growth_per_doubling(high_stiffness)))
    rest = float(np.max(relative_change(high_stiffness)))
    drops = int(sum(np.count_nonzero(np.diff(curve) < 0.0) for curve in stiffness))
    onset = float(max(friction[s][0] for s in sticking))
    return Claim(
        "C13",
        "K_T grows with the friction coefficient and saturates, non-monotonically",
        ("8b",),
        (
            Statement(
                says="K_T grows with mu",
                met=grows,
                evidence=f"at {_torques(output_torque)}, over mu = {friction[0]:.2f} to {friction[-1]:.2f}; below "
                f"mu = {onset:.3f} a contact slips at {output_torque[-1]:g} N*m and K_T is 0",
                numbers={"friction_from_which_all_stick": onset},
            ),
            Statement(
                says="the growth saturates",
                met=ratio <= SATURATED.limit,
                evidence=f"from mu = {high_friction[0]:g} to {high_friction[1]:g} and on to {high_friction[2]:g} the "
                f"second doubling adds at most {ratio:.0%} of what the first adds (saturates up to "
                f"{SATURATED.limit:.0%}); both together add at most {rest:.1%}",
                numbers={"largest_growth_per_doubling": ratio, "largest_growth_beyond_the_range": rest},
            ),
            Statement(
                says="the dependence is non-monotonic",
                met=drops > 0,
                evidence=f"K_T falls with mu at {drops} of {stiffness.size - len(stiffness)} steps: mu enters through "
                "(1 - T/(mu F_n))^(1/3) alone, which only grows; the paper's own explanation describes growth that "
                "saturates, too",
                numbers={"falling_steps": float(drops)},
            ),
        ),
    )


def window_claim(
    *,
    output_torque: np.ndarray,
    dimension: np.ndarray,
    stiffness: np.ndarray,
    window: tuple[float, float],
) -> Claim:
    """The design window: the stiffness is said to be optimal for D within it.

    Parameters
    ----------
    output_torque : ndarray
        Shape (m,) [N·m].
    dimension : ndarray
        D, evenly spaced, shape (n,) [-].
    stiffness : ndarray
        K_T, shape (m, n) [N·m/rad].
    window : tuple of float
        Lower and upper fractal dimension [-].

    Returns
    -------
    Claim
    """
    inside = (dimension >= window[0] - 1e-9) & (dimension <= window[1] + 1e-9)
    share = np.min(stiffness[:, inside], axis=1) / np.max(stiffness, axis=1)
    places = [peak(dimension, curve) for curve in stiffness]
    off = max(max(window[0] - p, p - window[1], 0.0) for p in places)
    ends = [interval_above(dimension, curve, OPTIMAL.limit) for curve in stiffness]
    low, high = max(e[0] for e in ends), min(e[1] for e in ends)
    return Claim(
        "window",
        f"optimal stiffness for {window[0]:g} <= D <= {window[1]:g}",
        ("7a",),
        (
            Statement(
                says="the window holds the maximum of K_T",
                met=off <= PEAK_NEAR.limit,
                evidence=f"the maximum lies at most {off:.3f} outside (allowed {PEAK_NEAR.limit:g}), at "
                f"D = {min(places):.3f} to {max(places):.3f}",
                numbers={"distance_outside": off},
            ),
            Statement(
                says="everywhere in the window K_T is close to its maximum",
                met=float(np.min(share)) >= OPTIMAL.limit,
                evidence=f"at its worst place K_T is {np.min(share):.0%} of the maximum (asked: {OPTIMAL.limit:.0%}); "
                f"at {_torques(output_torque)} K_T holds {OPTIMAL.limit:.0%} for {low:.3f} <= D <= {high:.3f}",
                numbers={"smallest_share": float(np.min(share)), "optimal_from_D": low, "optimal_to_D": high},
            ),
        ),
    )
