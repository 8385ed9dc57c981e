"""Deviations of the sizes of a drive that keep nearly all drives above stated results: tolerances backwards."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from asperity.errors import InputError, NoSolutionError, listed
from asperity.joint.solve import refuse_impossible_joint
from asperity.joint.status import STATUS_MEANINGS
from asperity.joint_file.any_joint import results_of, with_nominal_sizes
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.model import Case
from asperity.joint_file.open_radius import radii_of
from asperity.joint_file.part_names import paths_of_track
from asperity.joint_file.quantity_key import Distribution
from asperity.joint_file.si_tables import NumericKey, Values, numeric_keys, si_values
from asperity.library.tolerance_grades import grade_within, standard_tolerances
from asperity.precision import require_double_precision
from asperity.results import Result
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
    """A size, its diameter, the deviation of its radius allowed [m], the share of a limit's margin that 1 um uses."""

    path: str
    diameter: float
    deviation: float
    grade: str
    influence: float


@dataclass(frozen=True)
class AllowedDeviations:
    """What is allowed of the sizes that move a result; ``kept`` of ``samples`` drives meet all limits [-]."""

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
                f"'{text}': expected RESULT>=VALUE or RESULT<=VALUE, e.g. torque_capacity>=12 N*m",
                options=["keep"],
            )
        side = "at_least" if match[2] == ">=" else "at_most"
        limit, results = {side: match[3]}, results_of(values)
        try:
            limits.extend(constraint_of(match[1], limit, "assembly", values, results, said=f"'{text}'"))
        except InputError as error:
            raise InputError(str(error), options=["keep"]) from None
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
        Of :func:`limits_from_text`.
    share : float
        Share of the drives that meet all limits [-].
    sharing : {"equal", "grade", "cost"}
        Whether all radii have the same deviation t, the same grade of ISO 286-1, with its unit i, or those that cost
        least: if a tolerance costs in proportion to 1/t, and the deviations add up in squares, with the influence
        :math:`s_j` of a radius, the part of a limit's margin that it uses.
    distribution : Distribution
        Of each size within its deviation.
    samples, seed : int
        Drives of each try; of the random numbers, the same in all.
    report : callable, optional
        Called with the number of finished tries and the most that there may be.

    Raises
    ------
    InputError
        If the file states a preload force, the drive of nominal sizes misses a limit, or the
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
    if samples < (needed := int(np.ceil(_FEWEST_MISSES / (1.0 - share) - 1e-6))):
        raise InputError(
            f"{samples} drives are too few for a share of {share:g}; at least {needed} are needed"
        )
    drives = _Drives.of_nominal_sizes(case, limits)
    influence = drives.influence()
    weight = _weights(drives.diameters, influence, sharing)
    steps = weight * drives.spread(distribution, samples, seed)
    deviation, missed = _widest(drives, steps, share, report)
    sizes = tuple(
        AllowedSize(path, float(diameter), float(t), grade_within(diameter, 4.0 * t), 1e-6 * float(used))
        for path, diameter, t, used in zip(
            drives.sizes, drives.diameters, deviation * weight, influence, strict=True
        )
        if t > 0.0
    )
    without_influence = tuple(path for path, part in zip(drives.sizes, weight, strict=True) if not part)
    return AllowedDeviations(sizes, without_influence, samples - missed, samples, share)


def _weights(diameters: np.ndarray, influence: np.ndarray, sharing: Sharing) -> np.ndarray:
    """Deviation of each size over the largest one; 0 of a size without influence."""
    moving = influence > _NO_INFLUENCE * influence.max()
    if not moving.any():
        raise NoSolutionError(
            "no size of the drive moves a result that is limited; nothing follows for deviations"
        )
    shares = {
        "equal": np.ones(diameters.size),
        "grade": np.array([standard_tolerances(diameter)["IT6"] for diameter in diameters]),
        "cost": np.where(moving, influence, np.inf) ** (-2 / 3),
    }[sharing]
    return np.where(moving, shares / shares[moving].max(), 0.0)


def _widest(
    drives: _Drives, steps: np.ndarray, share: float, report: Callable[[int, int], Any] | None
) -> tuple[float, int]:
    """The largest deviation [m] that keeps a share of the drives, and how many miss a limit; steps per metre of it."""
    misses, tries, most = len(steps) - int(np.ceil(share * len(steps))), itertools.count(1), 2 + _HALVINGS

    def missing(deviation: float, which: np.ndarray) -> int:
        missed = drives.missing(deviation * steps[which])
        if report is not None:
            report(min(next(tries), most), most)
        return missed

    order, estimate = drives.linearised(steps, share)
    worst = order[: _LOOKED_AT * (misses + 1)]
    deviation = _largest(lambda deviation: missing(deviation, worst) <= misses, estimate)
    while (missed := missing(deviation, order)) > misses:  # drives that the linearised ones do not tell
        deviation *= 0.97
    return deviation, missed


@dataclass(frozen=True)
class _Drives:
    """Drives around that of nominal sizes: its limited results there, and their slopes by the sizes."""

    tables: Values
    limits: tuple[Constraint, ...]
    sizes: dict[str, NumericKey]
    diameters: np.ndarray
    nominal: Mapping[str, np.ndarray]
    slopes: Mapping[str, np.ndarray]

    @classmethod
    def of_nominal_sizes(cls, case: Case, limits: tuple[Constraint, ...]) -> _Drives:
        """An ``InputError`` is raised if the drive of nominal sizes misses a limit."""
        sizes, diameters = _sizes(case)
        refuse_impossible_joint(joint_from_case(case))
        tables, names = with_nominal_sizes(si_values(case)), dict.fromkeys(limit.name for limit in limits)
        points = {path: np.array([entry.value]) for path, entry in sizes.items()}
        status, nominal, slopes = derivatives_at(tables, points, tuple(names), tuple(sizes))
        if status[0] != 0:
            raise InputError(f"the drive of nominal sizes has no result: {STATUS_MEANINGS[status[0]]}")
        table = results_of(tables)
        said = [_shortfall(limit, table[limit.name], nominal[limit.name][:, 0]) for limit in limits]
        if any(said):
            raise InputError(listed(list(filter(None, said))))
        return cls(tables, limits, sizes, diameters, nominal, slopes)

    def spread(self, distribution: Distribution, samples: int, seed: int) -> np.ndarray:
        """Deviations of each drive over those allowed, shape (samples, sizes)."""
        cube = np.random.default_rng(seed).uniform(1e-12, 1.0 - 1e-12, size=(samples, len(self.sizes)))
        units = [NumericKey(path, 0.0, 1.0, entry.key, None) for path, entry in self.sizes.items()]
        return np.stack([quantiles(unit, distribution, cube[:, k]) for k, unit in enumerate(units)], axis=1)

    def missing(self, deviations: np.ndarray) -> int:
        """How many drives of these deviations miss a limit, shape (drives, sizes) [m]."""
        points = {path: entry.value + deviations[:, k] for k, (path, entry) in enumerate(self.sizes.items())}
        _, found = evaluate_points(self.tables, points, tuple(self.nominal))
        return int((~_met(self.limits, {name: np.atleast_2d(value) for name, value in found.items()})).sum())

    def _rows(self) -> Iterator[tuple[Constraint, float, np.ndarray]]:
        """Each limited number: its limit, its margin, and its slopes by the sizes, shape (sizes,)."""
        for limit in self.limits:
            for row in limit.rows:
                margin = abs(float(self.nominal[limit.name][row, 0]) - limit.limit)
                yield limit, margin, np.nan_to_num(self.slopes[limit.name][row, 0])

    def influence(self) -> np.ndarray:
        """Largest share of the margin of a limit that each size uses, shape (sizes,) [1/m]."""
        used = [np.abs(slope) / max(margin, 1e-9 * abs(limit.limit)) for limit, margin, slope in self._rows()]
        return np.stack(used).max(axis=0)

    def linearised(self, steps: np.ndarray, share: float) -> tuple[np.ndarray, float]:
        """Drives by the slopes, those that miss a limit first in front; the deviation that the share allows [m]."""
        furthest = np.full(len(steps), np.inf)
        for limit, margin, slope in self._rows():
            loss = (1.0 if limit.at_most else -1.0) * (steps @ slope)
            with np.errstate(divide="ignore", invalid="ignore"):
                furthest = np.fmin(furthest, np.where(loss > 0.0, margin / loss, np.inf))
        order = np.argsort(furthest)
        return order, float(furthest[order[len(steps) - int(np.ceil(share * len(steps)))]])


def _shortfall(limit: Constraint, result: Result, nominal: np.ndarray) -> str:
    """How the drive of nominal sizes falls short of a limit of a result, shape (rows,) [SI]; empty if it keeps it."""
    names = [result.row_names[row] for row in limit.rows]
    values = dict(zip(names, nominal[list(limit.rows)].tolist(), strict=True))
    if unknown := [name for name, value in values.items() if math.isnan(value)]:
        at = f" at {', '.join(unknown)}" if any(unknown) else ""
        why = f": there is none {result.has_none}; state what it needs, or" if result.has_none else ";"
        return f"{limit.name} has no value{at}{why} leave this limit out"
    sense, unit = "at most" if limit.at_most else "at least", f" [{result.si_unit}]" * (result.si_unit != "1")
    missed = [
        f"{limit.name}{name and f' at {name}'} is {value:.6g}"
        for name, value in values.items()
        if not (value <= limit.limit if limit.at_most else value >= limit.limit)
    ]
    if not missed:
        return ""
    asked = f"{sense} {limit.limit:.6g} is asked for{unit}"
    return f"the drive of nominal sizes misses a limit: {'; '.join(missed)}, {asked}"


def _sizes(case: Case) -> tuple[dict[str, NumericKey], np.ndarray]:
    """Radii of the tracks, or of the rollers and the interference of the rings, with their diameters [m]."""
    if case.load.interference is None:
        raise InputError(
            "load.preload is a force, which no size moves: give load.interference, the preload that the sizes make"
        )
    stated, radii = numeric_keys(case), radii_of(type(case))
    if not radii:  # the contacts are listed
        tables = si_values(case)
        listed = [path for path in stated if re.fullmatch(r"contact\.\d+\.(first|second)_radius", path)]
        sizes = {path: stated[path] for path in listed if paths_of_track(tables, path)[0] == path}
    else:
        sizes = {f"drive.{name}": stated[f"drive.{name}"] for name in radii}
    diameters = {path: 2.0 * entry.value for path, entry in sizes.items()}
    rings = case.drive_type.rings
    if rings and any(f"drive.{ring.size_key}_radius" not in sizes for ring in rings):
        # the bores of the rings follow from the rollers
        sizes["load.interference"] = stated["load.interference"]
        diameters["load.interference"] = 2.0 * float(np.max(joint_from_case(case).drive.second_radius))
    return sizes, np.array(list(diameters.values()))


def _met(limits: tuple[Constraint, ...], results: Mapping[str, np.ndarray]) -> np.ndarray:
    """Which drives meet all limits; what has no value meets none."""
    margins = [
        (-1.0 if limit.at_most else 1.0) * (results[limit.name][list(limit.rows)] - limit.limit)
        for limit in limits
    ]
    return np.asarray((np.concatenate(margins) >= 0.0).all(axis=0))


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
