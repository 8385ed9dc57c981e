"""The unknowns of a calibration: numbers of the joint file, and properties of the measured curve."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from asperity.drive.layout.drive import speed_ratio
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.si_tables import AnyCase, key_at, numeric_keys, replace_values, si_values
from asperity.study.calibration.measurement import Measurement
from asperity.study.design.design_problem import Variable
from asperity.study.parameters import refuse_twice
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

#: Properties of a measured curve that are not in a joint file, with their dimensions.
CURVE_UNKNOWNS = {"offset": Dimension.ANGLE, "drift": Dimension.ANGULAR_VELOCITY}

#: The offset of a drift curve that is fitted together with another curve.
OFFSET_OF_DRIFT = "offset of drift"

#: Without stated bounds, a number of the file may change by this factor in either direction.
DEFAULT_FACTOR = 5.0

#: Numbers of the joint file that add to the angles without a new solution of the joint.
PLAY_UNKNOWNS = ("play.angle", "play.take_up_torque")


_LINEAR_KINDS = ("fractal_dimension", "poisson_ratio", "push_angle")


def read_unknowns(
    texts: Iterable[str], *, case: AnyCase, measurements: tuple[Measurement, ...]
) -> tuple[Variable, ...]:
    """Read the unknowns of a calibration, with bounds and scale.

    Texts are ``KEY`` or ``KEY=LOWER:UPPER`` with units, for example ``load.preload=500 N:2000 N``; a key is a number of
    the joint file, or ``offset``, ``drift``. The value of the joint file is the first guess; without bounds, five times
    it and a fifth of it are the bounds (1.05 to 1.95 for a fractal dimension), and ``play.angle``, offset and drift may
    be as large as the whole range of angles, ``play.take_up_torque`` as the largest torque. The measurements are one
    curve, or one of the joint at rest and one of the joint that turns. With several repetitions each has its own
    offset, ``offset 1``, ``offset 2``, …. Of data of the drift per turn only the offset can be unknown; beside a curve
    at rest it is called ``offset of drift``. An ``InputError`` if a text cannot be read, or an unknown or the
    measurements together make no sense.
    """
    _refuse_alike(measurements)
    unknowns: list[Variable] = []
    for text in texts:
        name, _, bounds = text.partition("=")
        name = name.strip()
        sides = bounds.split(":") if bounds.strip() else []
        if sides and len(sides) != 2:
            raise InputError(f"unknown '{text}': expected KEY=LOWER:UPPER, e.g. load.preload=500 N:2000 N")
        if added_to_curve(name):
            unknowns.extend(_of_curve(name, sides, _curve_of(name, measurements)))
        else:
            unknowns.append(_of_joint(name, sides, case))
            if _sets_the_ratio(name, case) and any(m.unloaded_ratio is not None for m in measurements):
                raise InputError(
                    f"'{name}' sets the speed ratio without creep and cannot be an unknown of measured speed ratios; "
                    "use 'offset' for a ratio that is not known exactly, or a column 'speed loss' or 'drift'"
                )
    names = [unknown.path for unknown in unknowns]
    if not unknowns:
        raise InputError(
            "nothing to calibrate: name at least one unknown, such as load.preload", options=["unknown"]
        )
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"the unknown '{name}' is named twice")
    refuse_twice(case, [name for name in names if not added_to_curve(name)], named="unknowns")
    if "play.take_up_torque" in names and "play.angle" not in names and case.play is None:
        raise InputError(
            "play.take_up_torque is the torque that takes up the play; it needs the unknown 'play.angle' too, or a "
            "section [play] in the joint file"
        )
    return tuple(unknowns)


def _sets_the_ratio(path: str, case: AnyCase) -> bool:
    """Whether a radius moves the speed ratio without creep."""
    if not path.endswith("_radius") or "crown" in path:
        return False
    values, stated = si_values(case), numeric_keys(case)[path].value
    ratios = [
        float(speed_ratio(joint_from_values(replace_values(values, {path: factor * stated})).drive))
        for factor in (1.0, 1.001)
    ]
    return not math.isclose(*ratios, rel_tol=1e-9)


def of_measurement(path: str, measurement: Measurement, measurements: tuple[Measurement, ...]) -> bool:
    """Whether an unknown acts on a measurement."""
    return not added_to_curve(path) or _curve_of(path, measurements) is measurement


def _curve_of(name: str, measurements: tuple[Measurement, ...]) -> Measurement:
    """The measurement to which an unknown of a curve belongs."""
    standing = [curve for curve in measurements if curve.drift is None]
    rolling = [curve for curve in measurements if curve.drift is not None]
    if name != OFFSET_OF_DRIFT:
        return (standing or rolling)[0]
    if not (standing and rolling):
        raise InputError(f"'{OFFSET_OF_DRIFT}' belongs to a drift curve beside another one; say 'offset'")
    return rolling[0]


def _refuse_alike(measurements: tuple[Measurement, ...]) -> None:
    rolls = [curve.drift is not None for curve in measurements]
    if len(measurements) > 2 or len(set(rolls)) < len(rolls):
        kind = "turns" if all(rolls) else "is at rest"
        raise InputError(
            f"{', '.join(curve.source for curve in measurements)}: "
            + (f"both are curves of a joint that {kind}; " if len(measurements) == 2 else "")
            + "at most one torque-angle or stiffness curve and one drift curve can be fitted together; put repetitions "
            "into one file, with a column 'repetition'"
        )


def _bounds(name: str, sides: list[str], dimension: Dimension) -> tuple[float, float]:
    try:
        lower, upper = (parse_quantity(side.strip(), dimension) for side in sides)
    except InputError as error:
        raise InputError(f"unknown '{name}': {error}") from None
    if not lower < upper:
        raise InputError(f"unknown '{name}': the lower bound {sides[0]} must be below the upper {sides[1]}")
    return lower, upper


def _of_curve(name: str, sides: list[str], measurement: Measurement) -> list[Variable]:
    if measurement.angle is None and not (
        name in ("offset", OFFSET_OF_DRIFT) and measurement.drift is not None
    ):
        kind = measurement.quantity.name
        raise InputError(f"'{name}' can be fitted to measured angles only; the data are those of the {kind}")
    span = float(np.ptp(measurement.measured))
    if name == "drift" and (measurement.time is None or np.ptp(measurement.time) == 0.0):
        raise InputError("drift needs a column 'time', e.g. 'time [s]'")
    duration = float(np.ptp(measurement.time)) if measurement.time is not None else 1.0
    middle = float(np.mean(measurement.measured))
    default = {
        "play.angle": (0.0, span),
        "play.take_up_torque": (
            1e-3 * float(np.max(np.abs(measurement.torque))),
            float(np.max(np.abs(measurement.torque))),
        ),
        "offset": (middle - span, middle + span),
        OFFSET_OF_DRIFT: (middle - span, middle + span),
        "drift": (-span / duration, span / duration),
    }[name]
    lower, upper = _bounds(name, sides, dimension_of(name)) if sides else default
    if lower < 0.0 and name == "play.angle":
        raise InputError(f"unknown '{name}': the lower bound {sides[0].strip()} must not be negative")
    if lower <= 0.0 and name == "play.take_up_torque":
        raise InputError(f"unknown '{name}': the lower bound {sides[0].strip()} must be positive")
    if name == "offset":
        labels = np.unique(measurement.repetition)
        if labels.size > 1:
            return [Variable(f"offset {label:g}", lower, upper, False) for label in labels]
    return [Variable(name, lower, upper, name == "play.take_up_torque")]


def _of_joint(path: str, sides: list[str], case: AnyCase) -> Variable:
    key = key_at(path, case.type)
    if path == "load.output_torque":
        raise InputError("load.output_torque is measured here, it cannot be unknown")
    if key.integer:
        raise InputError(f"'{path}' is a whole number and cannot be calibrated")
    stated = numeric_keys(case).get(path)
    linear = path.rsplit(".", 1)[-1].endswith(_LINEAR_KINDS)
    if sides:
        lower, upper = _bounds(path, sides, key.dimension)
        for bound in (lower, upper):
            try:
                key.check(bound)
            except InputError as error:
                raise InputError(f"unknown '{path}': {error}") from None
    elif path.endswith("fractal_dimension"):
        lower, upper = 1.05, 1.95
    elif stated is None or stated.value <= 0.0 or linear:
        raise InputError(
            f"unknown '{path}': the joint file gives no value to start from; state bounds, {path}=LOWER:UPPER"
        )
    else:
        lower, upper = stated.value / DEFAULT_FACTOR, stated.value * DEFAULT_FACTOR
        if not (key.admits(lower) and key.admits(upper)):
            raise InputError(f"unknown '{path}': state bounds, {path}=LOWER:UPPER; allowed is {key.allowed}")
    return Variable(path, lower, upper, not linear and lower > 0.0)


def si_unit_of(path: str) -> str:
    """SI unit of an unknown, one of :mod:`asperity.units`."""
    return dimension_of(path).si_unit


def unit_of(path: str) -> str:
    """Unit in which an unknown is shown, one of :mod:`asperity.units`."""
    kind = path.partition(" ")[0]
    shown = {"offset": "arcmin", "drift": "arcmin/min"}
    return shown[kind] if kind in CURVE_UNKNOWNS else key_at(path).unit


def added_to_curve(path: str) -> bool:
    """Whether an unknown only adds to the angles, so that its effect needs no new solution of the joint."""
    return path.partition(" ")[0] in CURVE_UNKNOWNS or path in PLAY_UNKNOWNS


def of_joint_file(path: str) -> bool:
    """Whether an unknown is a number of the joint file; False for offset and drift, which are of the measurement."""
    return path.partition(" ")[0] not in CURVE_UNKNOWNS


def dimension_of(path: str) -> Dimension:
    """What an unknown measures."""
    kind = path.partition(" ")[0]
    return CURVE_UNKNOWNS[kind] if kind in CURVE_UNKNOWNS else key_at(path).dimension
