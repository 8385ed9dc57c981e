"""Quantiles of results that a part of the sampled joints does not have: those joints count as the worst."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from asperity.results import Result

_LOW_IS_WORSE = ("capacity", "life", "assembly", "bearings")
_HIGH_IS_WORSE = ("losses", "stresses")


def worse_end(row: Result) -> Literal["low", "high", ""]:
    """Which values of a result are the worse ones; empty where neither are."""
    if row.limit is not None and math.isfinite(row.limit.lowest) != math.isfinite(row.limit.highest):
        return "low" if math.isfinite(row.limit.lowest) else "high"
    if any(word in row.name for word in ("stiffness", "safety", "efficiency")) or row.group in _LOW_IS_WORSE:
        return "low"
    worse = "pressure" in row.name or "drift" in row.name or row.group in _HIGH_IS_WORSE
    return "high" if worse else ""


def quantiles_with_failed(
    values: np.ndarray, shares: np.ndarray, *, worse: Literal["low", "high", ""]
) -> np.ndarray:
    """Values below which given shares of all samples lie, where those without a value (nan) are the worst.

    Infinite, low or high, where so many samples have no value; nan where a quantile may lie anywhere.

    Examples
    --------
    >>> quantiles_with_failed(np.array([1.0, 2.0, 3.0, np.nan]), np.array([0.1, 0.5]), worse="low").tolist()
    [-inf, 1.0]
    """
    known = values[~np.isnan(values)]
    failed = values.size - known.size
    if not failed:
        return np.quantile(known, shares)

    def counted_as(worst: float, method: Literal["lower", "higher"]) -> np.ndarray:
        return np.quantile(np.append(known, np.full(failed, worst)), shares, method=method)

    lowest, highest = counted_as(-math.inf, "lower"), counted_as(math.inf, "higher")
    if worse:
        return lowest if worse == "low" else highest
    widest = np.where(shares < 0.5, lowest, np.where(shares > 0.5, highest, np.nan))
    return np.where(np.isfinite(widest), widest, np.nan)
