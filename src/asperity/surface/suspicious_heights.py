"""Heights that no surface has: numbers that mark missing points, a range that was exceeded, files that disagree."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np

from asperity.errors import InputError
from asperity.surface.spectrum import power_spectral_densities
from asperity.surface.topography import Topography

#: Different heights that a surface must have before one of them can stand out, and points that are looked at for them.
_FEWEST_LEVELS, _LOOKED_AT = 10, 20_000
#: A range was exceeded where at least such a share of the points, and so many times those of the next height, stand at
#: its end.
_SHARE_AT_END, _PILED = 2e-3, 5.0
_FEWEST_AT_END = 5
#: Distance of one extreme height from all others, over their range, from which it is said.
_FAR = 5.0
#: Ratios of the heights of profiles of one surface above which they are said to differ, and are refused.
_SAID, _REFUSED = 1.5, 4.0
#: Their difference over its standard deviation from which it is no chance.
_CERTAIN = 5.0
#: Standard deviation of the logarithm of an ordinate of a spectrum, and correlated ordinates under Hann's window.
_LOG_DEVIATION, _CORRELATED = math.pi / math.sqrt(6.0), 2.0
#: Longest waves that are left out of the comparison, [ordinates]: form.
_FORM = 3


def refuse_missing_marks(topography: Topography) -> None:
    """Raise if an extreme height occurs more than once, exactly, and lies farther from the rest than that reaches.

    The rest is without both extremes.
    """
    known = topography.heights[~np.isnan(topography.heights)]
    ends = (known.min(), known.max())
    inner = known[
        (known != ends[0]) & (known != ends[1])
    ]  # a mark at one end does not hide that at the other
    for extreme, name in zip(ends, ("lowest", "highest"), strict=True):
        rest, count = inner, int(np.count_nonzero(known == extreme))
        if count < 2 or np.unique(rest[:: max(1, rest.size // _LOOKED_AT)]).size < _FEWEST_LEVELS:
            continue
        low, high = float(rest.min()), float(rest.max())
        if max(low - extreme, extreme - high) > high - low:
            raise InputError(
                f"{topography.source}: {count} points have exactly the {name} height, {1e6 * extreme:.6g} um, far from "
                f"all others ({1e6 * low:.6g} um to {1e6 * high:.6g} um): probably a number that marks missing points. "
                "State it in the unit of the file, or that none does",
                options=["no-data"],
            )


def end_notes(topography: Topography) -> tuple[str, ...]:
    """Notes of heights at the ends of the range: where many points stand at one it was exceeded, one far off is odd."""
    known = topography.heights[~np.isnan(topography.heights)]
    inner = known[(known != known.min()) & (known != known.max())]
    if not inner.size or np.unique(inner[:: max(1, inner.size // _LOOKED_AT)]).size < _FEWEST_LEVELS:
        return ()
    reach = float(np.ptp(inner))
    notes = []
    for extreme, nearest, name in (
        (float(known.min()), float(inner.min()), "lowest"),
        (float(known.max()), float(inner.max()), "highest"),
    ):
        count = int(np.count_nonzero(known == extreme))
        what = f"the {name} height, {1e6 * extreme:.6g} um"
        apart = abs(extreme - nearest)
        if count == 1 and apart > _FAR * reach:
            notes.append(
                f"one point has {what}, {apart / reach:.3g} times the range of the rest away from it: does it mark a "
                "missing point?"
            )
        elif count >= max(_FEWEST_AT_END, _SHARE_AT_END * known.size) and count >= _PILED * np.count_nonzero(
            known == nearest
        ):
            notes.append(
                f"{100.0 * count / known.size:.3g} % of the points stand at {what}: the range of the instrument was "
                "probably exceeded, and the heights are cut off there"
            )
    return tuple(notes)


def disagreement(topographies: Sequence[Topography]) -> str:
    """How profiles of one surface differ beyond their scatter, in words; empty where they do not.

    Their heights differ by the smaller of the ratio of Pq and of the ratio by all waves of their spectra.

    An ``InputError`` if one is several times as high as another: one of the units is wrong, or the surfaces are not the
    same.
    """
    points = min(topography.heights.size for topography in topographies)
    profiles = np.stack([topography.heights[:points] for topography in topographies])
    _, density = power_spectral_densities(profiles=profiles, spacing=topographies[0].spacing)
    with np.errstate(divide="ignore"):
        log = np.log(density[:, _FORM:])
    log[~np.isfinite(log)] = np.nan
    counts = np.count_nonzero(np.isfinite(log), axis=1)
    if counts.min() < 1:
        return ""
    level = np.nanmean(log, axis=1)
    rms = [float(np.sqrt(np.mean(topography.heights**2))) for topography in topographies]
    worst, pair = 1.0, (0, 0)
    for low, high in itertools.permutations(range(len(rms)), 2):
        apart = level[high] - level[low]
        scatter = _LOG_DEVIATION * math.sqrt(_CORRELATED * (1.0 / counts[low] + 1.0 / counts[high]))
        ratio = min(math.exp(0.5 * apart), rms[high] / rms[low] if rms[low] else math.inf)
        if apart > _CERTAIN * scatter and ratio > worst:
            worst, pair = ratio, (low, high)
    if worst < _SAID:
        return ""
    words = " and ".join(f"{topographies[j].source} (Pq {1e6 * rms[j]:.4g} um)" for j in pair)
    if worst >= _REFUSED:
        raise InputError(
            f"{words} are no profiles of one surface: their heights differ {worst:.3g} times in all waves. A wrong "
            "unit in one file is the usual cause; correct it, or measure the files one by one"
        )
    return (
        f"heights of {words} differ {worst:.3g} times in all waves, more than profiles of one surface scatter"
    )
