"""Measured curves that are fitted together, and each of them with what was fitted to it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import f as f_law

from asperity.errors import NoSolutionError
from asperity.joint_file.si_tables import AnyCase
from asperity.standing.windup import StiffnessLevel
from asperity.study.calibration.curve_checks import Scatter, own_scatter
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.torque_history import History
from asperity.study.calibration.unknowns import of_measurement
from asperity.study.design.design_problem import Variable
from asperity.units import format_quantity

#: Durbin–Watson statistic below which neighbouring residuals are clearly alike.
CORRELATED = 1.5
#: Fewest rows of which that statistic says anything: tables of its bounds begin here (Savin and White 1977).
LEAST_ROWS = 6
#: Probability with which chance alone makes a misfit that counts as one.
CHANCE = 1e-3
#: Share of a curve below which a misfit is rounding, and from which on nothing of the joint is in the fit.
ROUNDING, UNEXPLAINED = 1e-6, 0.25


@dataclass(frozen=True)
class FittedCurve:
    """A measured curve with what was fitted to it; [rad] or [N·m/rad], shape (points,).

    ``residual`` is data minus prediction; ``standard_deviation``, that of the residuals with the degrees of ``freedom``
    that remain; ``durbin_watson``, about 2 for independent residuals, towards 0 where neighbours are alike and the
    intervals are too narrow; ``scatter`` of the curve itself, by :func:`own_scatter` of the residuals, in which a
    smooth misfit cancels.
    """

    model: CurveModel
    prediction: np.ndarray
    residual: np.ndarray
    standard_deviation: float
    freedom: float
    durbin_watson: float
    scatter: Scatter | None

    @property
    def measurement(self) -> Measurement:
        """The data."""
        return self.model.measurement

    @property
    def correlated(self) -> bool:
        """Whether neighbouring residuals are more alike than chance makes so few rows in one case of twenty."""
        rows = self.residual.size
        by_chance = 2.0 - 1.645 * 2.0 / math.sqrt(rows)
        return rows >= LEAST_ROWS and self.durbin_watson < min(CORRELATED, by_chance)

    @property
    def size(self) -> float:
        """How much the curve itself varies: rms about its mean, of a stiffness about zero [rad] or [N·m/rad]."""
        data = self.measurement.measured
        middle = 0.0 if self.measurement.stiffness is not None else float(np.mean(data))
        return float(np.sqrt(np.mean((data - middle) ** 2)))

    @property
    def misfit(self) -> float:
        """What the residuals hold beyond the scatter of the curve [rad] or [N·m/rad]; 0 where chance makes as much."""
        if self.scatter is None or self.standard_deviation <= ROUNDING * self.size:
            return 0.0
        ratio = (self.standard_deviation / max(self.scatter.deviation, ROUNDING * self.size)) ** 2
        if ratio <= f_law.isf(CHANCE, self.freedom, self.scatter.freedom):
            return 0.0
        return math.sqrt(max(self.standard_deviation**2 - self.scatter.deviation**2, 0.0))


def residual_sentences(curves: Sequence[FittedCurve]) -> list[str]:
    """How large the residuals of each curve are and whether neighbours are alike: one sentence for each curve.

    There is one more where the intervals of a curve are too narrow.
    """
    said = []
    for curve in curves:
        quantity = curve.measurement.quantity
        of_curve = f" of the {quantity.name}" if len(curves) > 1 else ""
        size = format_quantity(curve.standard_deviation, quantity.fine_unit)
        said.append(f"residual{of_curve}: {size} (standard deviation)")
        if curve.correlated:
            said.append(
                f"Neighbouring residuals{of_curve} are correlated (Durbin–Watson {curve.durbin_watson:.2f}, "
                "independent residuals give 2): the model does not explain the curve fully, and the intervals are too "
                "narrow."
            )
        if curve.misfit > 0.0 and curve.scatter is not None:
            own = max(curve.scatter.deviation, ROUNDING * curve.size)
            times = f"{curve.standard_deviation / own:.3g}"
            said.append(
                f"MISFIT{of_curve}: the residual is {times} times the curve's own scatter, "
                f"{format_quantity(own, quantity.fine_unit)} (by second differences of neighbouring rows, in which a "
                f"smooth misfit cancels): {_share(curve)} of the curve is not what the model does, and the intervals "
                "hold that only as far as the error of the model does."
            )
    return said


def _share(curve: FittedCurve) -> str:
    """The misfit over the size of its curve, in words."""
    return f"{100.0 * curve.misfit / curve.size:.2g} %"


def refuse_unexplained(curves: Sequence[FittedCurve]) -> None:
    """Raise ``NoSolutionError`` if a quarter of a curve or more is neither its scatter nor what was fitted to it."""
    for curve in curves:
        if curve.misfit >= UNEXPLAINED * curve.size > 0.0:
            unit = curve.measurement.quantity.fine_unit
            raise NoSolutionError(
                f"{curve.measurement.source}: the best fit misses the curve by "
                f"{format_quantity(curve.misfit, unit)} beyond its scatter, {_share(curve)} of its size of "
                f"{format_quantity(curve.size, unit)} (rms): no joint of the file within the bounds explains it; check "
                "columns and units, or widen the bounds"
            )


class JoinedCurves:
    """Residuals of all measurements as functions of one set of scaled values of the unknowns.

    Each curve sees the unknowns that act on it; ``level`` and ``history`` as of :class:`CurveModel`.
    """

    def __init__(
        self,
        *,
        case: AnyCase,
        measurements: tuple[Measurement, ...],
        unknowns: tuple[Variable, ...],
        level: StiffnessLevel,
        history: History,
    ) -> None:
        self.unknowns = unknowns
        self._columns = [
            [
                index
                for index, unknown in enumerate(unknowns)
                if of_measurement(unknown.path, measurement, measurements)
            ]
            for measurement in measurements
        ]
        self._models = [
            CurveModel(
                case=case,
                measurement=measurement,
                unknowns=tuple(unknowns[index] for index in columns),
                level=level,
                history=history,
            )
            for measurement, columns in zip(measurements, self._columns, strict=True)
        ]
        self._data = [measurement.measured for measurement in measurements]
        #: Root mean square of each curve [rad] or [N·m/rad]; 1 for one of zeros.
        self.sizes = tuple(float(np.sqrt(np.mean(data**2))) or 1.0 for data in self._data)
        self.first = np.empty(len(unknowns))
        for model, columns in zip(self._models, self._columns, strict=True):
            self.first[columns] = model.first

    def residual(self, scaled_values: np.ndarray, scales: tuple[float, ...]) -> np.ndarray:
        """Prediction minus data of all curves, each over its scale, shape (points,) [-]."""
        return np.concatenate(
            [
                (model(scaled_values[columns])[0] - data) / scale
                for model, columns, data, scale in zip(
                    self._models, self._columns, self._data, scales, strict=True
                )
            ]
        )

    def slopes(self, scaled_values: np.ndarray, scales: tuple[float, ...]) -> np.ndarray:
        """Derivatives of :meth:`residual` by the scaled values, shape (points, unknowns) [-]."""
        parts = []
        for model, columns, scale in zip(self._models, self._columns, scales, strict=True):
            part = np.zeros((model.measurement.torque.size, len(self.unknowns)))
            part[:, columns] = model(scaled_values[columns])[1] / scale
            parts.append(part)
        return np.concatenate(parts)

    def of_joint(self, scaled_values: np.ndarray, scales: tuple[float, ...]) -> np.ndarray:
        """What a relative error of the joint in one curve does to :meth:`residual`, shape (points, curves) [-]."""
        parts = [
            model.of_joint(scaled_values[columns]) / scale
            for model, columns, scale in zip(self._models, self._columns, scales, strict=True)
        ]
        in_curve = np.repeat(np.arange(len(parts)), [part.size for part in parts])
        shape = (in_curve.size, len(parts))
        return np.where(
            in_curve[:, None] == np.arange(len(parts)), np.concatenate(parts)[:, None], np.zeros(shape)
        )

    def deviations(self, scaled_values: np.ndarray) -> tuple[float, ...]:
        """Standard deviation of the residuals of each curve, at least a millionth of its size [rad] or [N·m/rad]."""
        fitted = self.fitted(scaled_values)
        return tuple(
            max(curve.standard_deviation, 1e-6 * size) for curve, size in zip(fitted, self.sizes, strict=True)
        )

    def fitted(self, scaled_values: np.ndarray) -> tuple[FittedCurve, ...]:
        """Each curve, in the order of the measurements, with its prediction and the statistics of its residuals.

        Each bears the unknowns in proportion to its rows.
        """
        points = sum(data.size for data in self._data)
        curves = []
        for model, columns, data in zip(self._models, self._columns, self._data, strict=True):
            prediction = model(scaled_values[columns])[0]
            residual = data - prediction
            squares = float(np.sum(residual**2))
            freedom = data.size * (1.0 - len(self.unknowns) / points)
            watson = float(np.sum(np.diff(residual) ** 2)) / squares if squares else 2.0
            curves.append(
                FittedCurve(
                    model=model,
                    prediction=prediction,
                    residual=residual,
                    standard_deviation=float(np.sqrt(squares / freedom)),
                    freedom=freedom,
                    durbin_watson=watson,
                    scatter=own_scatter(
                        values=residual,
                        torque=model.measurement.torque,
                        repetition=model.measurement.repetition,
                        in_order=model.measurement.angle is not None,
                    ),
                )
            )
        return tuple(curves)

    def exists(self, scaled_values: np.ndarray) -> bool:
        """Whether the joint has a stiffness at every torque of every curve."""
        return all(
            np.all(model.stiffness(scaled_values[columns])[0] > 0.0)
            for model, columns in zip(self._models, self._columns, strict=True)
        )

    def refuse_no_joint(self, scaled_values: np.ndarray) -> None:
        """Raise ``NoSolutionError`` if the joint slips within the measured torques or has no stiffness there."""
        for model, columns in zip(self._models, self._columns, strict=True):
            _refuse_no_joint(model, scaled_values[columns])


def _refuse_no_joint(model: CurveModel, scaled_values: np.ndarray) -> None:
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
                f"the best fit does not roll steadily at {lost:.6g} N·m, where a contact slips or lifts off, or has no "
                "drift in the sense of the torque, where the drag of the oil exceeds it: leave out rows past gross "
                "slip and near no torque, check units and preload, or widen the bounds"
            )
        raise NoSolutionError(
            f"the best fit has no stiffness at {lost:.3g} N·m, where all spots of a contact are plastic: the joint "
            "file cannot explain these data; check units and preload, or widen the bounds"
        )
