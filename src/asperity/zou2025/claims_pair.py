"""Claims C1–C6, about the tangential stiffness K_t of one roller pair (section 5.1, Fig. 4).

Each function evaluates one claim on the computed curves. Forces are in N, K_t in N/m, lengths in m.
"""

from __future__ import annotations

import numpy as np

from asperity.zou2025 import preset
from asperity.zou2025.criteria import (
    NONLINEAR,
    PEAK_NEAR,
    SLIGHT,
    Claim,
    Statement,
    falls,
    peak,
    relative_change,
    rises,
    slope_change,
)
from asperity.zou2025.curves import Curves


def _nonlinear(says: str, abscissa: np.ndarray, stiffness: np.ndarray) -> Statement:
    change = slope_change(abscissa, stiffness)
    return Statement(
        says=says,
        met=change >= NONLINEAR.limit,
        evidence=f"the mean slopes at the two ends of the range differ by {change:.0%} of the steeper slope "
        f"(required: at least {NONLINEAR.limit:.0%})",
        numbers={"slope_change": change},
    )


def _ends(stiffness: np.ndarray) -> tuple[str, dict[str, float]]:
    """First and last K_t as text and as numbers."""
    start, end = float(stiffness[0] / 1e3), float(stiffness[-1] / 1e3)
    numbers = {"K_t_start_N_per_mm": start, "K_t_end_N_per_mm": end}
    return f"K_t changes from {start:.4g} to {end:.4g} N/mm", numbers


def normal_force(curves: Curves) -> Claim:
    """C1: K_t increases with the normal force, nonlinearly."""
    force, stiffness = curves.pairs["a"].values, curves.pairs["a"].tangential_stiffness
    text, numbers = _ends(stiffness)
    return Claim(
        "C1",
        "K_t increases nonlinearly with the normal load",
        ("4a",),
        (
            Statement(
                says="K_t increases with F_n",
                met=rises(stiffness),
                evidence=f"{text} for F_n from {force[0]:g} to {force[-1]:g} N",
                numbers=numbers,
            ),
            _nonlinear("the increase is nonlinear", force, stiffness),
        ),
    )


def tangential_force(curves: Curves) -> Claim:
    """C2: K_t decreases with the tangential force, nonlinearly, and is zero from mu F_n on."""
    force, stiffness = curves.pairs["b"].values, curves.pairs["b"].tangential_stiffness
    slip_force = preset.FRICTION_COEFFICIENT * preset.PAIR_NORMAL_FORCE
    sticks = force < slip_force
    start = float(stiffness[0] / 1e3)
    remaining = float(stiffness[sticks][-1] / stiffness[0])
    beyond = stiffness[~sticks]
    largest = float(np.max(beyond, initial=0.0) / 1e3)
    return Claim(
        "C2",
        "K_t decreases with the tangential load and is zero for T >= mu F_n",
        ("4b",),
        (
            Statement(
                says="K_t decreases with T",
                met=falls(stiffness[sticks]),
                evidence=f"K_t is {start:.4g} N/mm at T = 0 and {remaining:.1%} of that at "
                f"T = {force[sticks][-1]:.1f} N",
                numbers={"K_t_start_N_per_mm": start, "share_left_before_slip": remaining},
            ),
            _nonlinear("the decrease is nonlinear", force[sticks], stiffness[sticks]),
            Statement(
                says="K_t is zero for T >= mu F_n",
                met=beyond.size > 0 and bool(np.all(beyond == 0.0)),
                evidence=f"the largest K_t of {beyond.size} points with T >= mu F_n = {slip_force:g} N is "
                f"{largest:g} N/mm",
                numbers={"slip_force_N": slip_force, "K_t_beyond_slip_N_per_mm": largest},
            ),
        ),
    )


def fractal_dimension(curves: Curves) -> Claim:
    """C3: K_t has its maximum near the stated fractal dimension."""
    dimension, stiffness = curves.pairs["c"].values, curves.pairs["c"].tangential_stiffness
    stated, place, top = preset.PEAK_DIMENSION, peak(dimension, stiffness), float(np.max(stiffness) / 1e3)
    coarse = np.arange(dimension[0], dimension[-1] + 1e-9, 0.05)  # the steps in which a table would list D
    coarse_place = coarse[np.argmax(np.interp(coarse, dimension, stiffness))]
    return Claim(
        "C3",
        f"K_t has a maximum near D = {stated:g}",
        ("4c",),
        (
            Statement(
                says=f"K_t increases with D up to a maximum near D = {stated:g}, then decreases",
                met=dimension[0] < place < dimension[-1] and abs(place - stated) <= PEAK_NEAR.limit,
                evidence=f"maximum of {top:.4g} N/mm at D = {place:.3f}, {abs(place - stated):.3f} from {stated:g} "
                f"(required: at most {PEAK_NEAR.limit:g}); in steps of 0.05 the maximum is at D = "
                f"{coarse_place:.2f}",
                numbers={"peak_fractal_dimension": place, "peak_K_t_N_per_mm": top},
            ),
        ),
    )


def fractal_roughness(curves: Curves) -> Claim:
    """C4: K_t decreases with the fractal roughness."""
    roughness, stiffness = curves.pairs["d"].values, curves.pairs["d"].tangential_stiffness
    exponent = float(np.log(stiffness[-1] / stiffness[0]) / np.log(roughness[-1] / roughness[0]))
    text, numbers = _ends(stiffness)
    return Claim(
        "C4",
        "K_t decreases with the roughness parameter G",
        ("4d",),
        (
            Statement(
                says="K_t decreases gradually as G increases",
                met=falls(stiffness),
                evidence=f"{text} for G from {roughness[0] * 1e3:.3g} to {roughness[-1] * 1e3:.3g} mm, on average "
                f"in proportion to G^{exponent:.2f}",
                numbers={**numbers, "exponent": exponent},
            ),
        ),
    )


def _size(curves: Curves, *, name: str, title: str, case: str, symbol: str) -> Claim:
    """Claim C5 or C6: the influence of a varied size on the stiffness of a pair."""
    size, stiffness = curves.pairs[case].values, curves.pairs[case].tangential_stiffness
    change = float(relative_change(stiffness))
    low_change = float(relative_change(curves.pairs[f"{case}_low"].tangential_stiffness))
    text, _ = _ends(stiffness)
    return Claim(
        name,
        title,
        (f"4{case}",),
        (
            Statement(
                says=f"K_t increases with {symbol}",
                met=rises(stiffness),
                evidence=f"{text} for {symbol} from {size[0] * 1e3:g} to {size[-1] * 1e3:g} mm at D = "
                f"{preset.FRACTAL_DIMENSION:g}, the only D that the paper shows; at D = "
                f"{preset.DIMENSION_RANGE[0]:g} (no part of the verdict) it changes by {low_change:+.1%}",
                numbers={"change": change, "change_at_lowest_D": low_change},
            ),
            Statement(
                says=f"the influence of {symbol} is limited",
                met=abs(change) < SLIGHT.limit,
                evidence=f"{change:+.1%} over the range (required: less than {SLIGHT.limit:.0%})",
                numbers={"change": change},
            ),
            _nonlinear("the increase is nonlinear", size, stiffness),
        ),
    )


def contact_length(curves: Curves) -> Claim:
    """C5: K_t increases with the contact length, slightly and nonlinearly."""
    title = "K_t increases slightly with the contact length"
    return _size(curves, name="C5", title=title, case="f", symbol="B")


def roller_radius(curves: Curves) -> Claim:
    """C6: K_t increases with the roller radius, slightly and nonlinearly."""
    title = "K_t increases slightly with the roller radius"
    return _size(curves, name="C6", title=title, case="e", symbol="R_2")
