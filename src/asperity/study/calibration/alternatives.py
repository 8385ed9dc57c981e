"""What else would explain a measured curve as well as an unknown of its calibration does."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from asperity.joint_file.si_tables import AnyCase, counterparts, numeric_keys
from asperity.study.calibration.unknowns import added_to_curve, of_joint_file
from asperity.study.design.design_problem import Variable

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
        for path, entry in numeric_keys(case).items()
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
        if min(sizes) <= 1e-9 * np.linalg.norm(
            relative[:, index]
        ):  # the other unknowns, or nothing, explain it
            continue
        correlation = abs(float(one @ two)) / float(sizes[0] * sizes[1])
        elasticity = float(one @ two) / float(sizes[1] ** 2)
        if correlation > ALIKE and abs(elasticity) <= LARGEST_ELASTICITY:
            pairs.append((abs(elasticity), elasticity, other, correlation))
    for _, elasticity, other, correlation in sorted(pairs)[:MOST_NAMED]:
        yield Alternative(
            variables[index].path, variables[other].path, correlation, elasticity, other < count
        )
