"""Claims C1–C6, about the tangential stiffness of one roller pair (section 5.1, Fig. 4).

Each function turns computed arrays into a verdict; it knows nothing of where they come from.
"""

from __future__ import annotations

import numpy as np

from asperity.zou2025.criteria import (
    NONLINEAR,
    PEAK_NEAR,
    SLIGHT,
    falls,
    peak,
    relative_change,
    rises,
    slope_change,
)
from asperity.zou2025.verdict import Claim, Statement


def _nonlinear(says: str, abscissa: np.ndarray, stiffness: np.ndarray) -> Statement:
    change = slope_change(abscissa, stiffness)
    return Statement(
        says=says,
        met=change >= NONLINEAR.limit,
        evidence=f"the slopes at both ends of the range differ by {change:.0%} of the steeper one "
        f"(nonlinear from {NONLINEAR.limit:.0%} on)",
        numbers={"slope_change": change},
    )


def normal_force_claim(*, normal_force: np.ndarray, stiffness: np.ndarray) -> Claim:
    """C1: K_t grows with the normal force, nonlinearly.

    Parameters
    ----------
    normal_force : ndarray
        F_n, shape (n,) [N].
    stiffness : ndarray
        K_t, shape (n,) [N/m].

    Returns
    -------
    Claim
    """
    return Claim(
        "C1",
        "K_t grows with the normal load, nonlinearly",
        ("4a",),
        (
            Statement(
                says="K_t grows with F_n",
                met=rises(stiffness),
                evidence=f"K_t goes from {stiffness[0] / 1e3:.3g} to {stiffness[-1] / 1e3:.4g} N/mm as F_n goes from "
                f"{normal_force[0]:g} to {normal_force[-1]:g} N",
                numbers={
                    "K_t_start_N_per_mm": float(stiffness[0] / 1e3),
                    "K_t_end_N_per_mm": float(stiffness[-1] / 1e3),
                },
            ),
            _nonlinear("the growth is nonlinear", normal_force, stiffness),
        ),
    )


def tangential_force_claim(
    *, tangential_force: np.ndarray, stiffness: np.ndarray, slip_force: float
) -> Claim:
    """C2: K_t falls with the tangential force, nonlinearly, and is zero from mu F_n on.

    Parameters
    ----------
    tangential_force : ndarray
        T, reaching beyond the slip force, shape (n,) [N].
    stiffness : ndarray
        K_t, shape (n,) [N/m].
    slip_force : float
        mu F_n [N].

    Returns
    -------
    Claim
    """
    sticking = tangential_force < slip_force
    stick_force, stick_stiffness = tangential_force[sticking], stiffness[sticking]
    beyond = stiffness[~sticking]
    left = float(stick_stiffness[-1] / stick_stiffness[0])
    return Claim(
        "C2",
        "K_t falls with the tangential load and is zero from mu F_n on",
        ("4b",),
        (
            Statement(
                says="K_t falls with T",
                met=falls(stick_stiffness),
                evidence=f"K_t goes from {stick_stiffness[0] / 1e3:.4g} N/mm without T to {left:.1%} of that at "
                f"{stick_force[-1]:.1f} N",
                numbers={
                    "K_t_start_N_per_mm": float(stick_stiffness[0] / 1e3),
                    "share_left_before_slip": left,
                },
            ),
            _nonlinear("the fall is nonlinear", stick_force, stick_stiffness),
            Statement(
                says="K_t is zero once T reaches mu F_n",
                met=beyond.size > 0 and bool(np.all(beyond == 0.0)),
                evidence=f"{beyond.size} points from T = mu F_n = {slip_force:g} N on, largest K_t "
                f"{np.max(beyond, initial=0.0) / 1e3:g} N/mm",
                numbers={
                    "slip_force_N": slip_force,
                    "K_t_beyond_slip_N_per_mm": float(np.max(beyond, initial=0.0) / 1e3),
                },
            ),
        ),
    )


def dimension_claim(*, dimension: np.ndarray, stiffness: np.ndarray, stated: float) -> Claim:
    """C3: K_t(D) has its maximum near the stated fractal dimension.

    Parameters
    ----------
    dimension : ndarray
        D, evenly spaced, shape (n,) [-].
    stiffness : ndarray
        K_t, shape (n,) [N/m].
    stated : float
        Where the paper sees the peak [-].

    Returns
    -------
    Claim
    """
    place = peak(dimension, stiffness)
    return Claim(
        "C3",
        f"K_t has a maximum over D, near {stated:g}",
        ("4c",),
        (
            Statement(
                says=f"K_t first grows with D, then falls, with the peak at about D = {stated:g}",
                met=dimension[0] < place < dimension[-1] and abs(place - stated) <= PEAK_NEAR.limit,
                evidence=f"peak of {np.max(stiffness) / 1e3:.4g} N/mm at D = {place:.3f}, "
                f"{abs(place - stated):.3f} from {stated:g} (allowed {PEAK_NEAR.limit:g}); "
                f"{_coarse_peak(dimension, stiffness)}",
                numbers={
                    "peak_fractal_dimension": place,
                    "peak_K_t_N_per_mm": float(np.max(stiffness) / 1e3),
                },
            ),
        ),
    )


def _coarse_peak(dimension: np.ndarray, stiffness: np.ndarray) -> str:
    """The peak as a sweep in steps of 0.05, as a paper would tabulate it, sees it."""
    coarse = np.arange(dimension[0], dimension[-1] + 1e-9, 0.05)
    return f"in steps of 0.05 it is at D = {coarse[np.argmax(np.interp(coarse, dimension, stiffness))]:.2f}"


def roughness_claim(*, roughness: np.ndarray, stiffness: np.ndarray) -> Claim:
    """C4: K_t falls with the fractal roughness.

    Parameters
    ----------
    roughness : ndarray
        G, shape (n,) [m].
    stiffness : ndarray
        K_t, shape (n,) [N/m].

    Returns
    -------
    Claim
    """
    slope = float(np.log(stiffness[-1] / stiffness[0]) / np.log(roughness[-1] / roughness[0]))
    return Claim(
        "C4",
        "K_t falls with the roughness parameter G",
        ("4d",),
        (
            Statement(
                says="K_t gradually falls as G grows",
                met=falls(stiffness),
                evidence=f"K_t goes from {stiffness[0] / 1e3:.4g} to {stiffness[-1] / 1e3:.4g} N/mm as G goes from "
                f"{roughness[0] * 1e3:.3g} to {roughness[-1] * 1e3:.3g} mm, as G to the power {slope:.2f}",
                numbers={
                    "K_t_start_N_per_mm": float(stiffness[0] / 1e3),
                    "K_t_end_N_per_mm": float(stiffness[-1] / 1e3),
                    "exponent": slope,
                },
            ),
        ),
    )


def _size_claim(
    *,
    name: str,
    title: str,
    panel: str,
    symbol: str,
    size: np.ndarray,
    stiffness: np.ndarray,
    low_stiffness: np.ndarray,
    low_dimension: float,
) -> Claim:
    change = float(relative_change(stiffness))
    low_change = float(relative_change(low_stiffness))
    span = f"{symbol} goes from {size[0] * 1e3:g} to {size[-1] * 1e3:g} mm"
    return Claim(
        name,
        title,
        (panel,),
        (
            Statement(
                says=f"K_t grows with {symbol}",
                met=rises(stiffness),
                evidence=f"K_t goes from {stiffness[0] / 1e3:.4g} to {stiffness[-1] / 1e3:.4g} N/mm as {span}; not "
                f"judged, because the paper shows D = 1.4 only: at D = {low_dimension:g} it changes by "
                f"{low_change:+.1%}",
                numbers={"change": change, "change_at_lowest_D": low_change},
            ),
            Statement(
                says=f"the influence of {symbol} is limited",
                met=abs(change) < SLIGHT.limit,
                evidence=f"{change:+.1%} over the range (limited below {SLIGHT.limit:.0%})",
                numbers={"change": change},
            ),
            _nonlinear("the growth is nonlinear", size, stiffness),
        ),
    )


def length_claim(
    *, length: np.ndarray, stiffness: np.ndarray, low_stiffness: np.ndarray, low_dimension: float
) -> Claim:
    """C5: K_t grows with the contact length, weakly and nonlinearly.

    Parameters
    ----------
    length : ndarray
        B, shape (n,) [m].
    stiffness, low_stiffness : ndarray
        K_t at the paper's D and at a low one, shape (n,) [N/m].
    low_dimension : float
        The low D, for the record only [-].

    Returns
    -------
    Claim
    """
    return _size_claim(
        name="C5",
        title="K_t grows with the contact length, weakly",
        panel="4f",
        symbol="B",
        size=length,
        stiffness=stiffness,
        low_stiffness=low_stiffness,
        low_dimension=low_dimension,
    )


def radius_claim(
    *, radius: np.ndarray, stiffness: np.ndarray, low_stiffness: np.ndarray, low_dimension: float
) -> Claim:
    """C6: K_t grows with the roller radius, weakly and nonlinearly.

    Parameters
    ----------
    radius : ndarray
        R_2, shape (n,) [m].
    stiffness, low_stiffness : ndarray
        K_t at the paper's D and at a low one, shape (n,) [N/m].
    low_dimension : float
        The low D, for the record only [-].

    Returns
    -------
    Claim
    """
    return _size_claim(
        name="C6",
        title="K_t grows with the roller radius, weakly",
        panel="4e",
        symbol="R_2",
        size=radius,
        stiffness=stiffness,
        low_stiffness=low_stiffness,
        low_dimension=low_dimension,
    )
