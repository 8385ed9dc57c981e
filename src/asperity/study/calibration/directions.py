"""Combinations of unknowns, how well the data determine them, and what would explain the data as well."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from asperity.joint_file.si_tables import AnyCase, counterparts, varied_keys
from asperity.study.calibration.unknowns import added_to_curve, of_joint_file, si_unit_of
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

    ``shares``: unknown → component of the unit vector in scaled values (0 at the lower bound, 1 at the upper).
    ``standard_deviation`` of the scaled value along it [-]; ``determined``, whether that is below :data:`UNINFORMED`;
    ``words``, what a step along it does to the curve.
    """

    shares: dict[str, float]
    standard_deviation: float
    determined: bool
    words: str


def direction_of(
    unknowns: tuple[Variable, ...], row: np.ndarray, along: float, change_by_scatter: float, quantile: float
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


#: Correlation of the effects of two numbers on a curve from which on the data cannot tell one from the other.
ALIKE = 0.99
#: Relative change of a number per relative change of the unknown beyond which it is no alternative: a tenth of the
#: unknown would be half of it.
LARGEST_ELASTICITY = 5.0
#: Alternatives that are named for one unknown: those that need the smallest changes.
MOST_NAMED = 3
_STEP = 10.0
_KNOWN = ("_radius", "output_torque", "sun_speed", "output_speed")


@dataclass(frozen=True)
class Alternative:
    """A number whose change moves the curves as that of an unknown does, once the other unknowns have followed.

    ``correlation`` of both effects [-]; ``elasticity``, relative change of the number per relative change of the
    unknown [-]; ``calibrated``, whether it is an unknown itself.
    """

    unknown: str
    other: str
    correlation: float
    elasticity: float
    calibrated: bool

    @property
    def words(self) -> str:
        """The pair in words."""
        of_file = "" if self.calibrated else ", a number of the file"
        return (
            f"{self.unknown} {_STEP:+g} % or {self.other} {_STEP * self.elasticity:+.3g} %{of_file}: the same curve "
            f"(correlation {self.correlation:.4f})"
        )


def candidates(case: AnyCase, unknowns: tuple[Variable, ...]) -> tuple[Variable, ...]:
    """Numbers of a file that may be off by so much that a curve shows it: no radii, no loads, no whole numbers."""
    taken = {unknown.path for unknown in unknowns}
    taken |= {
        ".".join([*path.split(".")[:-1], other])
        for path in taken
        for other in counterparts(path.split(".")[-1])
    }
    return tuple(
        Variable(path, 0.5 * entry.value, 2.0 * entry.value, True)
        for path, entry in varied_keys(case).items()
        if entry.value > 0.0
        and not entry.key.integer
        and not path.endswith(_KNOWN)
        and not path.startswith("duty.")
        and not added_to_curve(path)
        and path not in taken
    )


def alternatives(
    variables: tuple[Variable, ...], points: np.ndarray, slopes: np.ndarray, count: int
) -> tuple[Alternative, ...]:
    """What the data cannot tell from the unknowns, which are the first ``count`` of the variables.

    ``points`` are values [SI], shape (variables,); ``slopes`` those of the curves by the scaled variables, each over
    its errors, shape (rows, variables).
    """
    steps = np.array(
        [point / variable.slope(point) for variable, point in zip(variables, points, strict=True)]
    )
    relative = slopes * steps  # by the logarithm of each number
    return tuple(
        pair
        for index in range(count)
        for pair in _of_unknown(variables, points, slopes, relative, index, count)
    )


def _of_unknown(
    variables: tuple[Variable, ...],
    points: np.ndarray,
    slopes: np.ndarray,
    relative: np.ndarray,
    index: int,
    count: int,
) -> Iterator[Alternative]:
    """The alternatives of one unknown, the smallest change first."""
    if not of_joint_file(variables[index].path) or points[index] == 0.0:
        return
    pairs = []
    for other in range(index + 1, len(variables)):
        if not of_joint_file(variables[other].path) or points[other] == 0.0:
            continue
        rest = np.delete(np.arange(count), [k for k in (index, other) if k < count])
        basis, _ = np.linalg.qr(slopes[:, rest])
        one, two = (column - basis @ (basis.T @ column) for column in relative[:, [index, other]].T)
        sizes = np.linalg.norm(one), np.linalg.norm(two)
        if min(sizes) <= 1e-9 * np.linalg.norm(relative[:, index]):
            continue  # the other unknowns, or nothing, explain it
        correlation = abs(float(one @ two)) / float(sizes[0] * sizes[1])
        elasticity = float(one @ two) / float(sizes[1] ** 2)
        if correlation > ALIKE and abs(elasticity) <= LARGEST_ELASTICITY:
            pairs.append((abs(elasticity), elasticity, other, correlation))
    for _, elasticity, other, correlation in sorted(pairs)[:MOST_NAMED]:
        yield Alternative(
            variables[index].path, variables[other].path, correlation, elasticity, other < count
        )
