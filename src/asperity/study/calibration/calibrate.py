"""Calibration: unknowns of a joint from a measured curve by least squares, with covariance and identifiability."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint.windup import StiffnessLevel
from asperity.joint_file.model import Case
from asperity.precision import require_double_precision
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.torque_history import History
from asperity.study.design.design_problem import Variable

#: Standard deviation of a uniform distribution over the bounds: more than this means that the
#: data add nothing.
UNINFORMED = 1.0 / np.sqrt(12.0)

#: Share of an unknown in a direction from which on it is named as part of it.
NAMED_SHARE = 0.1

#: Durbin–Watson statistic below which neighbouring residuals are clearly alike.
CORRELATED = 1.5


@dataclass(frozen=True)
class Estimate:
    """One calibrated unknown.

    Parameters
    ----------
    path : str
        Its name.
    value : float
        Least-squares estimate [SI].
    lower, upper : float
        95 % interval [SI]; nan where the data do not determine it.
    determined : bool
        Whether the data say more about it than its bounds do.
    at_bound : str
        "lower" or "upper" if the estimate lies on a bound, else empty.
    """

    path: str
    value: float
    lower: float
    upper: float
    determined: bool
    at_bound: str


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


@dataclass(frozen=True)
class Calibration:
    """The outcome of a calibration.

    Parameters
    ----------
    estimates : tuple of Estimate
        All unknowns.
    directions : tuple of Direction
        Combinations, the worst determined first.
    scaled_values : ndarray
        Estimates as scaled values (0 at the lower bound, 1 at the upper).
    covariance : ndarray
        Of the scaled values; meaningless in directions that are not determined.
    residual : ndarray
        Data minus prediction, shape (points,) [rad] or [N·m/rad].
    prediction : ndarray
        Shape (points,).
    standard_deviation : float
        Of the residuals, with the degrees of freedom that remain [rad] or [N·m/rad].
    durbin_watson : float
        About 2 for independent residuals; towards 0 where neighbours are alike and the intervals are too narrow.
    starts : tuple of float
        Root mean square residual at the end of each start, best first.
    model : CurveModel
        The model that was fitted.
    """

    estimates: tuple[Estimate, ...]
    directions: tuple[Direction, ...]
    scaled_values: np.ndarray
    covariance: np.ndarray
    residual: np.ndarray
    prediction: np.ndarray
    standard_deviation: float
    durbin_watson: float
    starts: tuple[float, ...]
    model: CurveModel


def calibrate(
    *,
    case: Case,
    measurement: Measurement,
    unknowns: tuple[Variable, ...],
    level: StiffnessLevel,
    history: History,
    starts: int,
    seed: int,
    progress: Callable[[int, int], None] | None = None,
) -> Calibration:
    """Fit unknowns of a joint to a measured curve.

    Parameters
    ----------
    case : Case
        The joint file.
    measurement : Measurement
        The data.
    unknowns : tuple of Variable
        What is looked for, see :func:`asperity.study.calibration.unknowns.read_unknowns`.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness the joint is taken to have.
    history : {"virgin", "cycled"}
        State of the joint before the first row.
    starts : int
        Starts of the search; the first is the joint file.
    seed : int
        Of the other starts.
    progress : callable, optional
        Called with the number of finished starts and of all starts.

    Returns
    -------
    Calibration
        Estimates, intervals, residuals and the combinations of unknowns that are not identifiable.

    Raises
    ------
    InputError
        If there are no more data than unknowns.
    NoSolutionError
        If no start converged, or the fitted joint slips within the measured torques.

    Notes
    -----
    Errors are taken as independent, normal and of one size, in the measured angle (or stiffness) and not in the
    torque. Intervals are those of the linearised model, in the logarithm of unknowns that are positive.

    References
    ----------
    D. M. Bates and D. G. Watts, Nonlinear Regression Analysis, Wiley 1988; J. Durbin and G. S. Watson,
    Biometrika 37 (1950) 409.
    """
    from scipy.optimize import least_squares
    from scipy.stats import qmc

    require_double_precision()
    data = measurement.measured
    if measurement.drift is not None and history != "virgin":
        raise InputError(
            "a drift curve has no history, because each torque is held while the joint turns; use 'virgin', the default"
        )
    if data.size <= len(unknowns):
        raise InputError(
            f"{data.size} rows cannot determine {len(unknowns)} unknowns; more rows than unknowns are needed"
        )
    model = CurveModel(case=case, measurement=measurement, unknowns=unknowns, level=level, history=history)
    scale = float(np.sqrt(np.mean(data**2))) or 1.0
    size = len(unknowns)
    begins = [model.first]
    if starts > 1:
        sampler = qmc.LatinHypercube(d=size, rng=np.random.default_rng(seed))
        begins += _usable(model, sampler.random(8 * (starts - 1)))[: starts - 1]
    ended = []
    for index, begin in enumerate(begins):
        found = least_squares(
            lambda x: (model(x)[0] - data) / scale,
            np.clip(begin, 1e-6, 1.0 - 1e-6),
            jac=lambda x: model(x)[1] / scale,
            bounds=(np.zeros(size), np.ones(size)),
            method="trf",
            xtol=1e-10,
            ftol=1e-10,
            gtol=1e-12,
            max_nfev=400,
        )
        ended.append((float(found.cost), bool(found.status > 0), found.x))
        if progress is not None:
            progress(index + 1, len(begins))
    ended.sort(key=lambda each: each[0])
    if not ended[0][1]:
        raise NoSolutionError(
            f"the best of {len(begins)} starts of the least-squares fit did not converge in 400 steps; "
            "narrow the bounds, or ask for fewer unknowns"
        )
    return _conclude(
        model, ended[0][2], tuple(scale * np.sqrt(2.0 * cost / data.size) for cost, _, _ in ended)
    )


def _usable(model: CurveModel, scaled_values: np.ndarray) -> list[np.ndarray]:
    """Scaled values at which the joint has a stiffness at every torque: a search from elsewhere has no direction."""
    return [scaled_value for scaled_value in scaled_values if np.all(model.stiffness(scaled_value)[0] > 0.0)]


def _conclude(model: CurveModel, scaled_values: np.ndarray, starts: tuple[float, ...]) -> Calibration:
    from scipy.stats import t as student

    data = model.measurement.measured
    stiffness, _, slip = model.stiffness(scaled_values)
    # the quadrature ends just below the largest torque; the slip ratio grows in proportion to it
    largest = float(np.max(np.abs(model.measurement.torque)))
    reached = float(slip.max()) * largest / float(np.max(np.abs(model.torque))) if largest else 0.0
    if reached >= 1.0:
        raise NoSolutionError(
            f"the best fit slips at the largest measured torque, {largest:.6g} N·m (slip ratio {reached:.3g}, below 1 "
            "is needed): a curve past gross slip cannot be fitted; leave those rows out, or widen the bounds"
        )
    if not np.all(stiffness > 0.0) or model.floored(stiffness).any():
        lost = np.abs(model.torque[~(stiffness > 0.0) | model.floored(stiffness)]).min()
        if model.rolls:
            raise NoSolutionError(
                f"the best fit does not roll steadily at {lost:.6g} N·m, where a contact slips or lifts off: leave out "
                "rows past gross slip, check units and preload, or widen the bounds"
            )
        raise NoSolutionError(
            f"the best fit has no stiffness at {lost:.3g} N·m, where all spots of a contact are plastic: the joint "
            "file cannot explain these data; check units and preload, or widen the bounds"
        )
    prediction, slopes = model(scaled_values)
    residual = data - prediction
    freedom = data.size - scaled_values.size
    deviation = float(np.sqrt(np.sum(residual**2) / freedom))
    steps = np.diff(residual)
    watson = float(np.sum(steps**2) / np.sum(residual**2)) if np.any(residual) else 2.0
    # an exact fit of exact data has no spread: then rounding of the data is what remains
    spread = max(deviation, 1e-14 * float(np.max(np.abs(data))))
    _, singular, rows = np.linalg.svd(slopes, full_matrices=False)
    with np.errstate(divide="ignore"):
        along = spread / np.abs(singular)  # LAPACK may give −0
    covariance = (rows.T * np.minimum(along, 1e6) ** 2) @ rows
    directions = tuple(
        _direction(model, scaled_values, rows[k], float(along[k]), spread, float(singular[k]))
        for k in reversed(range(len(along)))
    )
    quantile = float(student.ppf(0.975, freedom))
    estimates = []
    for index, unknown in enumerate(model.unknowns):
        lost = any(not d.determined and abs(d.shares[unknown.path]) > NAMED_SHARE for d in directions)
        half = quantile * float(np.sqrt(covariance[index, index]))
        scaled_value = float(scaled_values[index])
        bound = "lower" if scaled_value < 1e-6 else "upper" if scaled_value > 1.0 - 1e-6 else ""
        estimates.append(
            Estimate(
                path=unknown.path,
                value=float(unknown.from_unit(scaled_value)),
                lower=float("nan") if lost else float(unknown.from_unit(scaled_value - half)),
                upper=float("nan") if lost else float(unknown.from_unit(scaled_value + half)),
                determined=not lost,
                at_bound=bound,
            )
        )
    return Calibration(
        estimates=tuple(estimates),
        directions=directions,
        scaled_values=scaled_values,
        covariance=covariance,
        residual=residual,
        prediction=prediction,
        standard_deviation=deviation,
        durbin_watson=watson,
        starts=starts,
        model=model,
    )


def _direction(
    model: CurveModel,
    scaled_values: np.ndarray,
    row: np.ndarray,
    along: float,
    spread: float,
    singular: float,
) -> Direction:
    """A singular vector of the slopes in words, for a step that changes its strongest unknown by a tenth."""
    strongest = int(np.argmax(np.abs(row)))
    row = row * np.sign(row[strongest])
    lead = model.unknowns[strongest]
    factor = 1.1 if lead.logarithmic else None
    step = (np.log(factor) / np.log(lead.upper / lead.lower) if factor else 0.1) / row[strongest]
    parts = []
    for index in np.argsort(-np.abs(row)):
        if abs(row[index]) < NAMED_SHARE:
            continue
        unknown, change = model.unknowns[index], row[index] * step
        if unknown.logarithmic:
            percent = 100.0 * np.expm1(change * np.log(unknown.upper / unknown.lower))
            parts.append(f"{unknown.path} {percent:+.3g} %")
        else:
            parts.append(
                f"{unknown.path} {change * (unknown.upper - unknown.lower):+.3g}{_unit(unknown.path)}"
            )
    effect = abs(step) * singular / np.sqrt(model.measurement.torque.size) / spread
    determined = bool(along < UNINFORMED)
    verdict = "identifiable" if determined else "NOT identifiable"
    return Direction(
        shares={unknown.path: float(value) for unknown, value in zip(model.unknowns, row, strict=True)},
        standard_deviation=along,
        determined=determined,
        words=f"{' together with '.join(parts)} moves the curve by {effect:.3g} of its scatter (rms): {verdict}",
    )


def _unit(path: str) -> str:
    from asperity.study.calibration.unknowns import si_unit_of

    unit = si_unit_of(path)
    return "" if unit == "1" else f" {unit.replace('*', '·')}"
