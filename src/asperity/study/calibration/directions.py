"""Combinations of unknowns of a calibration, and how well the data determine them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from asperity.study.calibration.unknowns import si_unit_of
from asperity.study.design.design_problem import Variable

#: Standard deviation of a uniform distribution over the bounds: more than this means that the
#: data add nothing.
UNINFORMED = 1.0 / np.sqrt(12.0)

#: Share of an unknown in a direction from which on it is named as part of it.
NAMED_SHARE = 0.1

# factor by which an unknown may be off from which on it is only weakly known
_LARGE_FACTOR = 1.2


@dataclass(frozen=True)
class Direction:
    """A combination of unknowns, and how well the data determine it.

    Parameters
    ----------
    shares : dict
        Unknown → component of the unit vector in scaled values (0 at the lower bound, 1 at the upper).
    standard_deviation : float
        Of the scaled value along it [-].
    determined : bool
        Whether that is below :data:`UNINFORMED`.
    words : str
        The combination in words, with what a step along it does to the curve.
    """

    shares: dict[str, float]
    standard_deviation: float
    determined: bool
    words: str


def direction_of(
    unknowns: tuple[Variable, ...],
    row: np.ndarray,
    along: float,
    change_by_scatter: float,
    quantile: float,
) -> Direction:
    """A singular vector of the slopes in words, for a step that changes its strongest unknown by a tenth."""
    strongest = int(np.argmax(np.abs(row)))
    row = row * np.sign(row[strongest])
    lead = unknowns[strongest]
    factor = 1.1 if lead.logarithmic else None
    step = (np.log(factor) / np.log(lead.upper / lead.lower) if factor else 0.1) / row[strongest]
    parts = []
    for index in np.argsort(-np.abs(row)):
        if abs(row[index]) < NAMED_SHARE:
            continue
        unknown, change = unknowns[index], row[index] * step
        if unknown.logarithmic:
            percent = 100.0 * np.expm1(change * np.log(unknown.upper / unknown.lower))
            parts.append(f"{unknown.path} {percent:+.3g} %")
        else:
            parts.append(
                f"{unknown.path} {change * (unknown.upper - unknown.lower):+.3g}{_unit(unknown.path)}"
            )
    effect = abs(step) * change_by_scatter
    determined = bool(along < UNINFORMED)
    verdict = "NOT identifiable"
    if determined:
        verdict = f"{known_within(lead, quantile * along * abs(row[strongest]))} (95 %)"
    return Direction(
        shares={unknown.path: float(value) for unknown, value in zip(unknowns, row, strict=True)},
        standard_deviation=along,
        determined=determined,
        words=f"{' together with '.join(parts)} moves the curve by {effect:.3g} of its scatter (rms): {verdict}",
    )


def known_within(unknown: Variable, half_width: float) -> str:
    """How well an unknown is known, in words."""
    if not unknown.logarithmic:
        half = half_width * (unknown.upper - unknown.lower)
        return f"identifiable, {unknown.path} to ±{half:.2g}{_unit(unknown.path)}"
    factor = float((unknown.upper / unknown.lower) ** half_width)
    if factor < _LARGE_FACTOR:
        return f"identifiable, {unknown.path} to ±{100.0 * (factor - 1.0):.2g} %"
    return f"weakly identifiable, {unknown.path} to a factor of {factor:.3g}"


def _unit(path: str) -> str:
    unit = si_unit_of(path)
    return "" if unit == "1" else f" {unit.replace('*', '·')}"
