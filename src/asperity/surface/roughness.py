r"""Roughness parameters of a profile: behind the filters :math:`\lambda_s` and :math:`\lambda_c`, over five sections.

The roughness profile is what the Gaussian filter of cut-off :math:`\lambda_c` leaves of the levelled profile, with the
waves shorter than :math:`\lambda_s` removed before. Sections of the length :math:`\lambda_c` in the middle are
evaluated, five where they fit; at least half a cut-off at either end, where the filter lacks heights, is not.
Values of a profile without a filter are not these: they are Pa, Pq, Pt (:mod:`asperity.surface.height_parameters`).

References
----------
Parameters: ISO 21920-2:2021 (Ra, Rq, Rsk, Rku, Rt and Rmr of the evaluation length, Rz, Rp and Rv as means of the
sections); cut-offs by Ra: ISO 4288:1996, table 1, and ISO 21920-3:2021; :math:`\lambda_s` and the largest spacing:
ISO 3274:1996, table 1; filter: ISO 16610-21:2011; Rk, Rpk, Rvk: ISO 13565-2:1996.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.height_parameters import element_width
from asperity.surface.levelling import gaussian_lowpass
from asperity.surface.roughness_average import CUT_OFFS_EVALUATED, STANDARD_CUT_OFFS
from asperity.surface.topography import Topography
from asperity.units import format_quantity

#: Points in a cut-off below which there are no roughness parameters.
FEWEST_POINTS = 10
#: Points in lambda_s below which this filter is left out, by the largest spacing of ISO 3274.
POINTS_IN_SHORT_CUT_OFF = 5
#: Share of the material ratio curve that the secant of the core spans (ISO 13565-2).
SECANT = 0.4
#: Material ratio of the level from which the depths of relative material ratios count.
REFERENCE_RATIO = 0.05
#: Cut-off [m] → lambda_s [m] of ISO 3274; of others it is a three-hundredth.
SHORT_CUT_OFFS = {0.08e-3: 2.5e-6, 0.25e-3: 2.5e-6, 0.8e-3: 2.5e-6, 2.5e-3: 8e-6, 8e-3: 25e-6}


@dataclass(frozen=True)
class Roughness:
    """Roughness parameters of a profile.

    ``cut_off``: lambda_c [m], and the reason of its ``choice``; ``short_cut_off``: lambda_s [m], None where the points
    lie too far apart for it; ``sections`` of the length lambda_c that are evaluated, 1 to 5. By symbol: ``lengths`` Ra,
    Rq, Rz, Rp, Rv, Rt, Rk, Rpk, Rvk, and RSm where there is a full profile element [m]; ``numbers`` Rsk, Rku (nan of a
    flat profile), Rmrk1, Rmrk2 (Mr1 and Mr2 of ISO 13565-2), Rmr(5 %, Rz/4) [-].
    """

    cut_off: float
    choice: str
    short_cut_off: float | None
    sections: int
    lengths: dict[str, float]
    numbers: dict[str, float]


def roughness(
    *, topography: Topography, cut_off: float | None, short_cut_off: float | None
) -> Roughness | str:
    """Roughness parameters of a levelled profile without missing points, or the reason why there are none.

    ``cut_off``: lambda_c [m], None for the smallest of 0.08, 0.25, 0.8, 2.5 and 8 mm whose class holds the Ra behind
    it; only then there may be a reason. ``short_cut_off``: lambda_s [m], None for that of ISO 3274, or for no such
    filter if the spacing is more than a fifth of it. An ``InputError`` if the profile has missing points or the given
    cut-offs do not suit it.

    The filter is the linear one, also for Rk, Rpk and Rvk, for which ISO 13565-1 filters twice: deep valleys pull its
    mean line down.
    """
    if topography.missing_points:
        raise InputError(f"{topography.source}: roughness parameters need a profile without missing points")
    if cut_off is not None:
        _check_cut_off(topography, cut_off)
        return _behind(topography, cut_off, short_cut_off, "as chosen")
    shortest, tried = max(FEWEST_POINTS * topography.spacing, 1.001 * (short_cut_off or 0.0)), None
    choice = "the class of ISO 21920-3 for this Ra"
    if shortest > STANDARD_CUT_OFFS[0][1]:
        choice = "the smallest of ISO 21920-3 that the points and lambda_s allow"
    for largest, standard in STANDARD_CUT_OFFS:
        if standard < shortest:
            continue
        if _sections(topography, standard) < 1:
            break
        tried = _behind(topography, standard, short_cut_off, choice)
        if tried.lengths["Ra"] <= largest:
            return tried
        choice = "the class of ISO 21920-3 for this Ra"
    profile = f"the profile of {format_quantity(topography.size[0], 'mm')}"
    if tried is None:
        return (
            f"{profile}, with points {format_quantity(topography.spacing, 'um')} apart, does not hold two cut-offs of "
            f"ISO 21920-3 (0.08 to 8 mm) of at least {FEWEST_POINTS} points"
        )
    return (
        f"Ra is {format_quantity(tried.lengths['Ra'], 'um', digits=3)} behind the cut-off "
        f"{format_quantity(tried.cut_off, 'mm')}, more than its class holds, and {profile} is shorter than two of the "
        "next; choose the cut-off"
    )


def standard_short_cut_off(*, cut_off: float) -> float:
    """lambda_s [m] that belongs to a cut-off lambda_c [m]: 2.5, 8 and 25 µm by ISO 3274, else a three-hundredth.

    Examples
    --------
    >>> standard_short_cut_off(cut_off=0.8e-3)
    2.5e-06
    """
    known = (short for long, short in SHORT_CUT_OFFS.items() if math.isclose(long, cut_off, rel_tol=1e-9))
    return next(known, cut_off / 300.0)


def material_ratio_parameters(*, heights: NDArray[np.float64]) -> tuple[float, float, float, float, float]:
    """Rk, Rpk, Rvk in the unit of the heights, and Rmrk1, Rmrk2 [-], from the material ratio curve.

    The straight line of least squares through the 40 % of the curve where its secant is least steep (the highest such
    part) ends at the heights between which the core lies, Rk apart. Rpk and Rvk are the heights of the triangles that
    have the areas of the curve above and below, on the ratios Rmrk1 and 1 - Rmrk2.

    References
    ----------
    ISO 13565-2:1996, 4.2 to 4.4.

    Examples
    --------
    >>> Rk, *_ = material_ratio_parameters(heights=np.linspace(0.0, 1.0, 1001))
    >>> round(Rk, 3)
    1.001
    """
    z = np.sort(heights)[::-1]
    span = max(1, round(SECANT * z.size))
    ratio = (np.arange(z.size) + 0.5) / z.size
    first = int(np.argmin(z[:-span] - z[span:]))
    part = slice(first, first + span + 1)
    slope, upper = np.polyfit(ratio[part], z[part], 1)
    lower, rounding = upper + slope, 1e-9 * float(z[0] - z[-1])
    peaks, valleys = z[z > upper + rounding] - upper, lower - z[z < lower - rounding]
    return (
        float(-slope),
        2.0 * float(peaks.mean()) if peaks.size else 0.0,
        2.0 * float(valleys.mean()) if valleys.size else 0.0,
        peaks.size / z.size,
        1.0 - valleys.size / z.size,
    )


def relative_material_ratio(*, heights: NDArray[np.float64], depth: float) -> float:
    """Rmr(p, dc) [-]: share of the heights above a level dc = ``depth`` below the one above which the share p is.

    p is :data:`REFERENCE_RATIO`; the depth is in the unit of the heights.

    References
    ----------
    ISO 21920-2:2021, relative material ratio; ISO 4287:1997, 4.5.4.

    Examples
    --------
    >>> relative_material_ratio(heights=np.linspace(0.0, 1.0, 1001), depth=0.25).__round__(2)
    0.3
    """
    reference = np.quantile(heights, 1.0 - REFERENCE_RATIO, method="hazen")
    return float(np.mean(heights >= reference - depth))


def _sections(topography: Topography, cut_off: float) -> int:
    """Sections that fit between run-in and run-out of half a cut-off, five at most; not positive if none does."""
    return min(CUT_OFFS_EVALUATED, math.floor(topography.size[0] / cut_off - 1.0 + 1e-6))


def _check_cut_off(topography: Topography, cut_off: float) -> None:
    shortest, longest = FEWEST_POINTS * topography.spacing, 0.5 * topography.size[0]
    if not shortest <= cut_off <= longest * (1.0 + 1e-6):
        raise InputError(
            f"{topography.source or 'the profile'}: the cut-off is {format_quantity(cut_off, 'mm')}; it must lie "
            f"between {FEWEST_POINTS} spacings ({format_quantity(shortest, 'mm')}) and half of the profile "
            f"({format_quantity(longest, 'mm')}), because half a cut-off at either end is not evaluated",
            options=["cut-off"],
        )


def _behind(topography: Topography, cut_off: float, short_cut_off: float | None, choice: str) -> Roughness:
    """The parameters behind the filters of one cut-off."""
    z, spacing = topography.heights, topography.spacing
    if short_cut_off is None:
        standard = standard_short_cut_off(cut_off=cut_off)
        short_cut_off = standard if standard >= 0.99 * POINTS_IN_SHORT_CUT_OFF * spacing else None
    elif not 2.0 * spacing <= short_cut_off < cut_off:
        raise InputError(
            f"{topography.source or 'the profile'}: lambda_s is {format_quantity(short_cut_off, 'um')}; it must lie "
            f"between two spacings ({format_quantity(2.0 * spacing, 'um')}) and the cut-off "
            f"({format_quantity(cut_off, 'mm')})",
            options=["short-cut-off"],
        )
    if short_cut_off is not None:
        z = gaussian_lowpass(heights=z, spacing=spacing, cutoff=short_cut_off)
    z = z - gaussian_lowpass(heights=z, spacing=spacing, cutoff=cut_off)
    sections = _sections(topography, cut_off)
    edges = np.round(np.arange(sections + 1) * cut_off / spacing).astype(int)
    edges += (z.size - int(edges[-1])) // 2
    pieces = [z[start:stop] for start, stop in itertools.pairwise(edges)]
    z = z[edges[0] : edges[-1]]
    peak, valley = (float(np.mean([sign * (sign * piece).max() for piece in pieces])) for sign in (1.0, -1.0))
    square = z * z
    rms = float(np.sqrt(square.mean()))
    Rk, Rpk, Rvk, Rmrk1, Rmrk2 = material_ratio_parameters(heights=z)
    lengths = {
        "Ra": float(np.abs(z).mean()),
        "Rq": rms,
        "Rz": peak - valley,
        "Rp": peak,
        "Rv": -valley,
        "Rt": float(np.ptp(z)),
        "Rk": Rk,
        "Rpk": Rpk,
        "Rvk": Rvk,
    }
    width = element_width(heights=z, spacing=spacing)
    ratio = relative_material_ratio(heights=z, depth=0.25 * (peak - valley))
    return Roughness(
        cut_off,
        choice,
        short_cut_off,
        sections,
        lengths if width is None else lengths | {"RSm": width},
        {
            "Rsk": float(np.mean(square * z)) / rms**3 if rms > 0.0 else math.nan,
            "Rku": float(np.mean(square * square)) / rms**4 if rms > 0.0 else math.nan,
            "Rmrk1": Rmrk1,
            "Rmrk2": Rmrk2,
            f"Rmr({100 * REFERENCE_RATIO:g} %, Rz/4)": ratio,
        },
    )
