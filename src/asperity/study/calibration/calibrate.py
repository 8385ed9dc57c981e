"""Calibration: unknowns of a joint from measured curves by least squares, with covariance and identifiability."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import qmc
from scipy.stats import t as student

from asperity.drive.layout.drive import speed_ratio
from asperity.drive.layout.existence import refuse_impossible
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.si_tables import AnyCase
from asperity.precision import require_double_precision
from asperity.standing.windup import StiffnessLevel
from asperity.study.calibration.curve_checks import refuse_curves
from asperity.study.calibration.directions import (
    NAMED_SHARE,
    UNINFORMED,
    Alternative,
    Direction,
    alternatives,
    candidates,
    direction_of,
)
from asperity.study.calibration.estimate import Estimate, estimated
from asperity.study.calibration.fitted_curve import FittedCurve, JoinedCurves, refuse_unexplained
from asperity.study.calibration.measurement import Measurement, read_measurement
from asperity.study.calibration.torque_history import History
from asperity.study.calibration.unknowns import of_joint_file, read_unknowns, unit_of
from asperity.study.design.design_problem import Variable
from asperity.units import format_quantity

#: Quantile of the normal distribution for both ends of 95 %.
NORMAL = 1.959964

#: Error of the model that the commands take: standard deviation of the joint's compliance, the same at every torque.
#: Plane strain and plane stress, between which real bodies lie, differ by 1/(1 - nu^2), a tenth: half of that.
MODEL_ERROR = 0.05

# rounds in which the sizes of the errors of two curves must settle, and their relative change when they have
_MOST_ROUNDS, _SETTLED = 50, 1e-4


@dataclass(frozen=True)
class Calibration:
    """The outcome of a calibration.

    ``estimates`` of all ``unknowns``; ``directions``, their combinations, the worst determined first;
    ``scaled_values``: estimates as scaled values (0 at the lower bound, 1 at the upper), and their ``covariance``,
    meaningless in directions that are not determined. ``starts``: root mean square residual at the end of each start,
    best first, over the root mean square of the data [-]; ``curves``: each measurement with what was fitted to it;
    ``model_error``: standard deviation of the relative error of the joint's compliance in each curve [-], which moves
    the scaled values by ``model_shifts``, shape (unknowns, curves);
    ``alternatives``: what explains the curves as well as an unknown does.
    """

    estimates: tuple[Estimate, ...]
    directions: tuple[Direction, ...]
    scaled_values: np.ndarray
    covariance: np.ndarray
    starts: tuple[float, ...]
    unknowns: tuple[Variable, ...]
    curves: tuple[FittedCurve, ...]
    model_error: float
    model_shifts: np.ndarray
    alternatives: tuple[Alternative, ...]


def calibrate(
    *,
    case: AnyCase,
    measurements: tuple[Measurement, ...],
    unknowns: tuple[Variable, ...],
    level: StiffnessLevel,
    history: History,
    starts: int,
    seed: int,
    model_error: float = 0.0,
    progress: Callable[[int, int], None] | None = None,
) -> Calibration:
    """Fit unknowns of a joint to a measured curve, or to two of them together.

    Parameters
    ----------
    case : Case
        The joint file.
    measurements : tuple of Measurement
        The data: one curve, or one of the joint at rest and one of the joint that turns.
    unknowns : tuple of Variable
        What is looked for, see :func:`asperity.study.calibration.unknowns.read_unknowns`.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness the joint is taken to have.
    history : {"virgin", "cycled"}
        State of the joint at rest before the first row.
    starts : int
        Starts of the search; the first is the joint file.
    seed : int
        Of the other starts.
    model_error : float, optional
        Standard deviation of the relative error of the joint's compliance, the same at every torque of a curve [-];
        by default 0, for data that the model itself has made.
    progress : callable, optional
        Called with the number of finished starts and of all starts.

    Returns
    -------
    Calibration
        Estimates, intervals, residuals and the combinations of unknowns that are not identifiable.

    Raises
    ------
    InputError
        If the bodies of the joint do not fit, there are no more data than unknowns, or the error of the model is not
        from 0 to 1.
    NoSolutionError
        If no start converged, the sizes of the errors of two curves did not settle, or the fitted joint slips within
        the measured torques.

    Notes
    -----
    Errors are taken as independent, normal and of one size for each curve, in the measured angle (or stiffness) and
    not in the torque. The sizes of two curves are estimated from their residuals in turn with the unknowns, until both
    stand still. Intervals are those of the linearised model, in the logarithm of unknowns that are positive. The error
    of the model, one normal number for each curve, changes the joint's part of the curve as a whole and does not
    average out over the rows; the estimates shift by the pseudo-inverse of the slopes times this change. What
    contacts feel of a measured surface stays that of the file.

    References
    ----------
    D. M. Bates and D. G. Watts, Nonlinear Regression Analysis, Wiley 1988; J. Durbin and G. S. Watson,
    Biometrika 37 (1950) 409.
    """
    require_double_precision()
    if not 0.0 <= model_error <= 1.0:
        raise InputError(
            f"the error of the model must be from 0 to 1, got {model_error:g}", options=["model-error"]
        )
    refuse_impossible(joint_from_case(case).drive)
    refuse_curves(measurements, unknown_count=len(unknowns), history=history)
    curves = JoinedCurves(
        case=case, measurements=measurements, unknowns=unknowns, level=level, history=history
    )
    begins = _begins(curves, starts, seed)
    ended = []
    for index, begin in enumerate(begins):
        ended.append(_fitted(curves, begin, curves.sizes))
        if progress is not None:
            progress(index + 1, len(begins))
    ended.sort(key=lambda fit: fit.cost)
    best = ended[0]
    if not best.converged:
        raise NoSolutionError(
            f"the best of {len(begins)} starts of the least-squares fit did not converge in 400 steps; "
            "narrow the bounds, or ask for fewer unknowns"
        )
    values = best.scaled_values if len(measurements) == 1 else _weighted_by_errors(curves, best.scaled_values)
    others = candidates(case, unknowns)
    wider = JoinedCurves(
        case=case, measurements=measurements, unknowns=(*unknowns, *others), level=level, history=history
    )
    rows = sum(measurement.torque.size for measurement in measurements)
    found = _conclude(
        curves, values, tuple(np.sqrt(2.0 * fit.cost / rows) for fit in ended), model_error, wider
    )
    refuse_unexplained(found.curves)
    return found


class _Fit(NamedTuple):
    """How one search ended: half the sum of squares, whether it converged, and where."""

    cost: float
    converged: bool
    scaled_values: np.ndarray


def _fitted(curves: JoinedCurves, begin: np.ndarray, scales: tuple[float, ...]) -> _Fit:
    """Least squares from a start, the errors of each curve over its scale."""
    size = len(curves.unknowns)
    solution = least_squares(
        lambda x: curves.residual(x, scales),
        np.clip(begin, 1e-6, 1.0 - 1e-6),
        jac=lambda x: curves.slopes(x, scales),
        bounds=(np.zeros(size), np.ones(size)),
        method="trf",
        xtol=1e-10,
        ftol=1e-10,
        gtol=1e-12,
        max_nfev=400,
    )
    return _Fit(float(solution.cost), bool(solution.status > 0), solution.x)


def _begins(curves: JoinedCurves, starts: int, seed: int) -> list[np.ndarray]:
    """Where searches begin: at the joint file, and at points where the joint exists at every torque."""
    if starts <= 1:
        return [curves.first]
    sampler = qmc.LatinHypercube(d=len(curves.unknowns), rng=np.random.default_rng(seed))
    # a search has no direction where the joint lacks a stiffness at a torque
    others = [point for point in sampler.random(8 * (starts - 1)) if curves.exists(point)]
    return [curves.first, *others[: starts - 1]]


def calibrate_files(
    case: AnyCase, data: Iterable[str | Path], unknowns: Sequence[str], **options: Any
) -> Calibration:
    """:func:`calibrate` with the curves of files and unknowns as texts; ``options`` are its other arguments."""
    ratio = float(speed_ratio(joint_from_case(case).drive))
    measurements = tuple(read_measurement(file, unloaded_ratio=ratio) for file in data)
    variables = read_unknowns(unknowns, case=case, measurements=measurements)
    return calibrate(case=case, measurements=measurements, unknowns=variables, **options)


def _weighted_by_errors(curves: JoinedCurves, scaled_values: np.ndarray) -> np.ndarray:
    """The fit in which each curve counts by the size of its own errors."""
    deviations = curves.deviations(scaled_values)
    for _ in range(_MOST_ROUNDS):
        _, converged, scaled_values = _fitted(curves, scaled_values, deviations)
        before, deviations = deviations, curves.deviations(scaled_values)
        if converged and np.allclose(deviations, before, rtol=_SETTLED, atol=0.0):
            return scaled_values
    raise NoSolutionError(
        f"the sizes of the errors of both curves did not settle in {_MOST_ROUNDS} rounds: one curve may be explained "
        "exactly by the unknowns; ask for fewer unknowns, or fit one curve alone"
    )


def _conclude(
    curves: JoinedCurves,
    scaled_values: np.ndarray,
    starts: tuple[float, ...],
    model_error: float,
    wider: JoinedCurves,
) -> Calibration:
    """The fit with its intervals; ``wider`` are the same curves with other numbers of the file as unknowns too."""
    curves.refuse_no_joint(scaled_values)
    fitted = curves.fitted(scaled_values)
    # an exact fit of exact data has no spread: then rounding of the data is what remains
    spreads = tuple(
        max(curve.standard_deviation, 1e-14 * float(np.max(np.abs(curve.measurement.measured))))
        for curve in fitted
    )
    left, singular, rows = np.linalg.svd(curves.slopes(scaled_values, spreads), full_matrices=False)
    with np.errstate(divide="ignore"):
        along = 1.0 / np.abs(singular)  # LAPACK may give −0
    covariance = (rows.T * np.minimum(along, 1e6) ** 2) @ rows
    # along what is not determined the bounds are what is known
    spread = np.sqrt(np.sum((rows.T * np.minimum(along, UNINFORMED)) ** 2, axis=1))
    # what the error of the model does in each curve
    model_shifts = (model_error * rows.T * np.minimum(along, UNINFORMED)) @ (
        left.T @ curves.of_joint(scaled_values, spreads)
    )
    model_spread = np.sqrt(np.sum(model_shifts**2, axis=1))
    points = sum(curve.residual.size for curve in fitted)
    unknowns = curves.unknowns
    quantile = float(student.ppf(0.975, points - len(unknowns)))
    directions = tuple(
        direction_of(unknowns, rows[k], float(along[k]), float(singular[k]) / np.sqrt(points), quantile)
        for k in reversed(range(len(along)))
    )
    estimates = tuple(
        estimated(
            unknown,
            float(scaled_values[index]),
            quantile * float(spread[index]),
            NORMAL * float(model_spread[index]),
            lost=any(not d.determined and abs(d.shares[unknown.path]) > NAMED_SHARE for d in directions)
            or math.hypot(spread[index], model_spread[index]) >= UNINFORMED,
        )
        for index, unknown in enumerate(unknowns)
    )
    everything = np.concatenate([scaled_values, np.full(len(wider.unknowns) - len(unknowns), 0.5)])
    return Calibration(
        estimates=estimates,
        directions=directions,
        scaled_values=scaled_values,
        covariance=covariance,
        starts=starts,
        unknowns=unknowns,
        curves=fitted,
        model_error=model_error,
        model_shifts=model_shifts,
        alternatives=alternatives(
            wider.unknowns,
            np.array([v.from_unit(p) for v, p in zip(wider.unknowns, everything, strict=True)]),
            wider.slopes(everything, spreads),
            len(unknowns),
        ),
    )


def calibrated_text(calibration: Calibration, case: AnyCase, *, comment: str) -> str:
    """The joint file with the estimates in place of its numbers; ``comment`` for its head, which also names bounds."""
    comment = " ".join([comment, *bound_words(calibration).values()]).strip()
    changes = {e.path: e.value for e in calibration.estimates if of_joint_file(e.path)}
    if "play.angle" in changes and case.play is None:  # a section [play] has both keys
        changes.setdefault("play.take_up_torque", 0.0)
    return joint_file_text(case, changes, comment=comment)


def estimate_note(estimate: Estimate) -> str:
    """What a table says beside an estimate: its bound where the search ended there, or that it is not determined."""
    if estimate.at_bound:
        bound = format_quantity(estimate.value, unit_of(estimate.path), 6)
        return f"at its {estimate.at_bound} bound, {bound}"
    return "" if estimate.determined else "NOT determined"


def bound_words(calibration: Calibration) -> dict[str, str]:
    """Unknown → a sentence, for each whose search ended at a bound."""
    return {
        each.path: f"{each.path} ended at its {each.at_bound} bound, "
        f"{format_quantity(each.value, unit_of(each.path), 6)}: this is no fitted value, the curve asks for "
        f"{'less' if each.at_bound == 'lower' else 'more'}, and the other estimates are those beside this bound; widen "
        "its bounds, or check the curve and what else the file states."
        for each in calibration.estimates
        if each.at_bound
    }


def count_words(calibration: Calibration) -> str:
    """How many unknowns were found from which data."""
    count = len(calibration.estimates)
    sources = [
        f"{curve.residual.size} rows of {'; '.join((curve.measurement.source, *curve.measurement.notes))}"
        for curve in calibration.curves
    ]
    return f"{count} unknown{'s'[: count - 1]} from {' and '.join(sources)}"


def identifiability_words(calibration: Calibration) -> dict[str, list[str]]:
    """Heading → sentences: combinations of unknowns, and, where there are some, their alternatives."""
    combinations = "Combinations of unknowns by the scatter of the data, the least well determined first:"
    words = {
        combinations: [direction.words for direction in calibration.directions],
        "What would explain the data as well:": [other.words for other in calibration.alternatives],
    }
    return {heading: sentences for heading, sentences in words.items() if sentences}


def model_error_words(model_error: float) -> str:
    """What the intervals hold besides the scatter of the data."""
    if model_error == 0.0:
        return "The intervals hold the scatter of the data alone: no error of the model (--model-error)."
    default = ", the default" if model_error == MODEL_ERROR else ""
    return (
        f"The intervals hold an error of the model: {100.0 * model_error:g} % of the joint's compliance at every "
        f"torque alike (standard deviation{default}; --model-error)."
    )
