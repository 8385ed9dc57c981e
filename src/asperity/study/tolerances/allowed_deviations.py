"""Deviations of the sizes of a drive that keep nearly all drives above stated results: tolerances backwards."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import refuse_impossible_joint
from asperity.joint_file.any_joint import results_of, with_nominal_sizes
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.model import Case
from asperity.joint_file.open_radius import radii_of
from asperity.joint_file.quantity_key import Distribution
from asperity.joint_file.si_tables import NumericKey, numeric_keys, si_values
from asperity.library.tolerance_grades import grade_within, standard_tolerances
from asperity.precision import require_double_precision
from asperity.study.batch import derivatives_at, evaluate_points
from asperity.study.design.design_file import constraint_of
from asperity.study.design.design_problem import Constraint
from asperity.study.tolerances.uncertainty import quantiles

#: How the deviations of the sizes share what is allowed.
Sharing = Literal["equal", "grade", "cost"]
#: Smallest and largest deviation [m].
_SMALLEST, _LARGEST = 1e-10, 1e-3
#: Step of the search for the largest deviation, and halvings of the last one: 25 % become 1.5 %.
_STEP, _HALVINGS = 1.25, 4
#: Drives that the search looks at over those that may miss a limit: the worst of the linearised drives.
_LOOKED_AT = 30
#: Samples that must miss in the mean where the share is met, for a share that is more than chance.
_FEWEST_MISSES = 5.0
#: Share of the largest influence below which a size is said to have none.
_NO_INFLUENCE = 1e-6


@dataclass(frozen=True)
class AllowedSize:
    """A size, its diameter, and the deviation of its radius either way that is allowed [m]; the grade of the diameter.

    ``influence``: share of the margin of a limit that one micrometre of the radius uses [1/um].
    """

    path: str
    diameter: float
    deviation: float
    grade: str
    influence: float


@dataclass(frozen=True)
class AllowedDeviations:
    """Sizes with what is allowed of them; ``kept`` of ``samples`` drives meet all limits, at least a ``share`` [-].

    ``without_influence`` are sizes that move no limited result.
    """

    sizes: tuple[AllowedSize, ...]
    without_influence: tuple[str, ...]
    kept: int
    samples: int
    share: float


def limits_from_text(texts: Sequence[str], case: Case) -> tuple[Constraint, ...]:
    """Limits of results, as in ``torque_capacity >= 12 N*m``."""
    values = si_values(case)
    limits: list[Constraint] = []
    for text in texts:
        match = re.fullmatch(r"\s*(\w+)\s*(>=|<=)\s*(.+)", text)
        if match is None:
            raise InputError(
                f"'{text}': expected RESULT>=VALUE or RESULT<=VALUE, e.g. torque_capacity>=12 N*m"
            )
        side = "at_least" if match[2] == ">=" else "at_most"
        limits.extend(constraint_of(match[1], {side: match[3]}, "assembly", values, results_of(values)))
    if not limits:
        raise InputError("nothing to keep: state a limit, e.g. torque_capacity>=12 N*m", options=["keep"])
    return tuple(limits)


def allowed_deviations(
    case: Case,
    limits: tuple[Constraint, ...],
    *,
    share: float,
    sharing: Sharing,
    distribution: Distribution,
    samples: int,
    seed: int,
    report: Callable[[int, int], Any] | None = None,
) -> AllowedDeviations:
    r"""The largest deviations of the sizes of a drive with which a share of all drives meets limits.

    .. math:: t_j = \kappa\, w_j, \qquad w_j = 1, \quad i(D_j) \quad\text{or}\quad s_j^{-2/3}

    Parameters
    ----------
    case : Case
        The joint file; its preload must be made by ``load.interference``.
    limits : tuple of Constraint
        What has to be kept, see :func:`limits_from_text`.
    share : float
        Share of the drives that meet all limits [-].
    sharing : {"equal", "grade", "cost"}
        Whether all radii have the same deviation t, the same grade of ISO 286-1, with its unit i, or those that cost
        least: if a tolerance costs in proportion to 1/t, and the deviations add up in squares, with the influence
        :math:`s_j` of a radius, the part of a limit's margin that it uses.
    distribution : Distribution
        Of each size within its deviation.
    samples : int
        Drives of each try; the same random numbers in all.
    seed : int
        Of the random numbers.
    report : callable, optional
        Called with the number of finished tries and the most that there may be.

    Returns
    -------
    AllowedDeviations
        Deviations and grades.

    Raises
    ------
    InputError
        If the file lists its contacts, states a preload force, or the drive of nominal sizes misses a limit; if the
        samples are too few.
    NoSolutionError
        If no size moves a limited result, or the limits are kept whatever the deviations.

    Notes
    -----
    The parts of one size, such as all planets, deviate alike; sizes deviate independently of each other. A drive
    without a value of a result misses its limit. The other numbers of the file are exact.

    References
    ----------
    ISO 286-1:2010; the least cost by Lagrange's multipliers, as in M. F. Spotts, J. Eng. Ind. 95 (1973) 762.
    """
    require_double_precision()
    if samples * (1.0 - share) < _FEWEST_MISSES:
        needed = int(np.ceil(_FEWEST_MISSES / (1.0 - share)))
        raise InputError(
            f"{samples} drives are too few for a share of {share:g}; at least {needed} are needed"
        )
    sizes = _sizes(case)
    refuse_impossible_joint(joint_from_case(case))
    tables, names = with_nominal_sizes(si_values(case)), tuple(dict.fromkeys(limit.name for limit in limits))
    nominal = {path: np.array([entry.value]) for path, (entry, _) in sizes.items()}
    status, at_nominal, slopes = derivatives_at(tables, nominal, names, tuple(sizes))
    if status[0] != 0 or not all(_met(limits, at_nominal)):
        found = "; ".join(
            f"{limit.name} is {float(value):.6g}, {'at most' if limit.at_most else 'at least'} {limit.limit:.6g} is "
            "asked for [SI]"
            for limit in limits
            for value in at_nominal[limit.name][list(limit.rows), 0]
        )
        raise InputError(f"the drive of nominal sizes misses a limit: {found}")
    influence = _influence(limits, at_nominal, slopes)
    moving = influence > _NO_INFLUENCE * influence.max()
    if not moving.any():
        raise NoSolutionError(
            "no size of the drive moves a result that is limited; nothing follows for deviations"
        )
    diameters = np.array([diameter for _, diameter in sizes.values()])
    units = np.array([standard_tolerances(diameter)["IT6"] for diameter in diameters])
    weights = {
        "equal": np.ones(len(sizes)),
        "grade": units,
        "cost": np.where(moving, influence, np.inf) ** (-2 / 3),
    }
    weight = np.where(moving, weights[sharing] / weights[sharing][moving].max(), 0.0)
    cube = np.random.default_rng(seed).uniform(1e-12, 1.0 - 1e-12, size=(samples, len(sizes)))
    unit = np.stack(
        [quantiles(NumericKey(path, 0.0, 1.0, entry.key, None), distribution, cube[:, k])
         for k, (path, (entry, _)) in enumerate(sizes.items())]
    )  # fmt: skip
    steps = weight * unit.T  # of each drive, per metre of the largest deviation
    order, estimate = _linearised(limits, at_nominal, slopes, steps, share)
    misses, tries = samples - int(np.ceil(share * samples)), 0
    worst, most = order[: _LOOKED_AT * (misses + 1)], 2 + _HALVINGS

    def missing(deviation: float, drives: np.ndarray) -> int:
        nonlocal tries
        points = {
            path: entry.value + deviation * steps[drives, k]
            for k, (path, (entry, _)) in enumerate(sizes.items())
        }
        _, found = evaluate_points(tables, points, names)
        tries += 1
        if report is not None:
            report(min(tries, most), most)
        return int((~_met(limits, {name: np.atleast_2d(value) for name, value in found.items()})).sum())

    deviation = _largest(lambda deviation: missing(deviation, worst) <= misses, estimate)
    while (missed := missing(deviation, order)) > misses:  # drives that the linearised ones do not tell
        deviation *= 0.97
    if report is not None:
        report(most, most)
    return AllowedDeviations(
        sizes=tuple(
            AllowedSize(path, diameter, t, grade_within(diameter, 4.0 * t), 1e-6 * float(influence[k]))
            for k, (path, (_, diameter)) in enumerate(sizes.items())
            if (t := deviation * float(weight[k])) > 0.0
        ),
        without_influence=tuple(path for path, moves in zip(sizes, moving, strict=True) if not moves),
        kept=samples - missed,
        samples=samples,
        share=share,
    )


def _sizes(case: Case) -> dict[str, tuple[NumericKey, float]]:
    """Radii of the rollers and the interference of the rings, with the diameters that they belong to [m]."""
    radii = radii_of(type(case))
    if not radii:
        raise InputError(
            "sizes of a file that lists its contacts have no tolerances of their own; state its radii by type"
        )
    if case.load.interference is None:
        raise InputError(
            "load.preload is a force, which no size moves: give load.interference, the preload that the sizes make"
        )
    stated = numeric_keys(case)
    sizes = {f"drive.{name}": stated[f"drive.{name}"] for name in radii}
    diameters = {path: 2.0 * entry.value for path, entry in sizes.items()}
    if "drive.ring_radius" not in sizes:  # then the bores of the rings follow from the rollers
        sizes["load.interference"] = stated["load.interference"]
        diameters["load.interference"] = 2.0 * float(np.max(joint_from_case(case).drive.second_radius))
    return {path: (entry, diameters[path]) for path, entry in sizes.items()}


def _met(limits: tuple[Constraint, ...], results: Mapping[str, np.ndarray]) -> np.ndarray:
    """Which drives meet all limits; what has no value meets none."""
    margins = [
        (-1.0 if limit.at_most else 1.0) * (results[limit.name][list(limit.rows)] - limit.limit)
        for limit in limits
    ]
    return np.asarray((np.concatenate(margins) >= 0.0).all(axis=0))


def _influence(
    limits: tuple[Constraint, ...], results: Mapping[str, np.ndarray], slopes: Mapping[str, np.ndarray]
) -> np.ndarray:
    """Largest share of the margin of a limit that each size uses, shape (sizes,) [1/m]."""
    parts = []
    for limit in limits:
        rows = list(limit.rows)
        margin = np.abs(results[limit.name][rows, 0] - limit.limit)[:, None]
        parts.append(np.abs(slopes[limit.name][rows, 0]) / np.maximum(margin, 1e-9 * abs(limit.limit)))
    largest: np.ndarray = np.nan_to_num(np.concatenate(parts)).max(axis=0)
    return largest


def _linearised(
    limits: tuple[Constraint, ...],
    results: Mapping[str, np.ndarray],
    slopes: Mapping[str, np.ndarray],
    steps: np.ndarray,
    share: float,
) -> tuple[np.ndarray, float]:
    """Drives by the slopes, those that miss a limit first in front, and the deviation that the share allows [m]."""
    furthest = np.full(len(steps), np.inf)
    for limit in limits:
        for row in limit.rows:
            margin = abs(results[limit.name][row, 0] - limit.limit)
            loss = (1.0 if limit.at_most else -1.0) * (steps @ np.nan_to_num(slopes[limit.name][row, 0]))
            with np.errstate(divide="ignore", invalid="ignore"):
                furthest = np.fmin(furthest, np.where(loss > 0.0, margin / loss, np.inf))
    order = np.argsort(furthest)
    return order, float(furthest[order[len(steps) - int(np.ceil(share * len(steps)))]])


def _largest(kept: Callable[[float], bool], estimate: float) -> float:
    """The largest deviation [m] that keeps enough drives, near an estimate."""
    low, high = 0.0, min(estimate, _LARGEST)
    while kept(high):
        low, high = high, _STEP * high
        if high > _LARGEST:
            raise NoSolutionError(
                f"all limits are kept with deviations of {1e3 * low:.3g} mm: they say nothing about tolerances"
            )
    while not low:
        if high < _SMALLEST:
            raise NoSolutionError(
                f"not even deviations of {1e9 * high:.2g} nm keep so many drives within the limits: the drive of "
                "nominal sizes has no margin"
            )
        low, high = (high / _STEP, high) if kept(high / _STEP) else (0.0, high / _STEP)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if kept(middle) else (low, middle)
    return low
