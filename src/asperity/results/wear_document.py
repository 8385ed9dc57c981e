"""Wear of a joint as one JSON document."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.rolling.wear import JointWear, WearOverTime
from asperity.rolling.wear_course import WearEnd
from asperity.types import Document

_HOUR = 3600.0
#: Key of the document → field of the course.
_COURSE = {
    "interference_m": "interference",
    "preload_N": "preload",
    "drift_rad_per_output_turn": "drift",
    "size_drift_rad_per_output_turn": "size_drift",
    "torque_capacity_Nm": "capacity",
}


class WearOverLife(NamedTuple):
    """Wear of a joint with its largest wear coefficient [1/Pa] and the life that is asked for [s], None for neither.

    ``follows``: whether a cam or a force follows the wear; it keeps its force where it makes all of the preload.
    """

    wear: JointWear
    coefficient: float | None
    life: float | None
    follows: bool

    def hours(self, coefficient_time: float | None) -> float | None:
        """Hours that a product of coefficient and time [s/Pa] stands for; None without a coefficient."""
        if coefficient_time is None or self.coefficient is None:
            return None
        return coefficient_time / self.coefficient / _HOUR

    @property
    def life_time(self) -> float | None:
        """Wear coefficient times the life [s/Pa]."""
        return None if self.coefficient is None or self.life is None else self.coefficient * self.life

    @property
    def allowed_coefficient(self) -> float | None:
        """Largest wear coefficient with which the first contact slides after the life [1/Pa]; None for no end."""
        end = self.wear.first_slide
        return None if end is None or self.life is None else end.coefficient_time / self.life


def wear_document(found: WearOverLife) -> Document:
    """Wear of a joint in SI units, times in hours, ready for :func:`json.dumps`; null where something is not known."""
    wear, k = found.wear, found.coefficient
    return {
        "wear": {
            **_start(found),
            **_over_time(found),
            "first_slide_hours": found.hours(_time(wear.first_slide)),
            "nothing_left_hours": found.hours(_time(wear.nothing_left)),
            "first_slide_kt_s_per_Pa": _time(wear.first_slide),
            "nothing_left_kt_s_per_Pa": _time(wear.nothing_left),
            "first_slide": _end(wear, wear.first_slide),
            "nothing_left": _end(wear, wear.nothing_left),
            "computed_until": _end(wear, wear.ends[-1]) if wear.ends and wear.carries_on else None,
            "coefficient_per_Pa": None if k is None else _by_track(wear, k * wear.coefficients),
            "life_hours": None if found.life is None else found.life / _HOUR,
            "allowed_coefficient_per_Pa": found.allowed_coefficient,
            "after_life": after_life(found),
            "unlike_lengths": list(wear.unlike_lengths),
            "crowned": wear.crowned,
        }
    }


def _start(found: WearOverLife) -> Document:
    """How fast the joint wears before it does."""
    wear, k = found.wear, found.coefficient
    per_hour = None if k is None else k * _HOUR
    return {
        "loads": [
            {"output_torque_Nm": torque, "input_speed_rad_per_s": speed, "share": share}
            for torque, speed, share in wear.loads
        ],
        "depth_m_per_hour": None if per_hour is None else _by_track(wear, per_hour * wear.now.depth_rate),
        "interference_m_per_hour": None if per_hour is None else per_hour * wear.now.interference_rate,
        "depth_per_kt_m_Pa_per_s": _by_track(wear, wear.now.depth_rate),
        "interference_per_kt_m_Pa_per_s": wear.now.interference_rate,
        "load_power_W": dict(zip(wear.contact_names, wear.now.load_power.tolist(), strict=True)),
        "keeps_force": wear.course is None,
    }


def _over_time(found: WearOverLife) -> Document:
    """The joint over time; one point where its force stays."""
    wear, course = found.wear, found.wear.course
    if course is None:
        return {
            "hours": [0.0],
            "kt_s_per_Pa": [0.0],
            "interference_m": [wear.now.interference],
            "preload_N": [wear.now.preload],
        }
    return {
        "hours": None
        if found.coefficient is None
        else (course.coefficient_time / found.coefficient / _HOUR).tolist(),
        "kt_s_per_Pa": course.coefficient_time.tolist(),
        **{key: _plain(getattr(course, name)) for key, name in _COURSE.items()},
        "depth_m": {name: values.tolist() for name, values in zip(wear.tracks, course.depth, strict=True)},
    }


def after_life(found: WearOverLife) -> Document | None:
    """What the life leaves of a joint; None without a life or a coefficient, all null beyond the last end."""
    time, wear = found.life_time, found.wear
    if time is None:
        return None
    course = wear.course
    if course is None:
        return {
            "preload_N": wear.now.preload,
            "interference_m": None,
            "stroke_m": time * wear.now.interference_rate,
            "depth_m": _by_track(wear, time * wear.now.depth_rate),
        }
    reached = time <= course.coefficient_time[-1]
    preload, interference = at_life(course, time, course.preload), at_life(course, time, course.interference)
    depths = [at_life(course, time, depth) for depth in course.depth]
    return {
        "preload_N": preload,
        "interference_m": interference,
        "stroke_m": None,
        "depth_m": _by_track(wear, np.array(depths, dtype=float)) if reached else None,
    }


def at_life(course: WearOverTime, time: float, values: np.ndarray) -> float | None:
    """A number of the course at a product of coefficient and time, which is one of its points; None beyond the end."""
    if time > course.coefficient_time[-1]:
        return None
    return float(np.interp(time, course.coefficient_time, values))


def wear_columns(found: WearOverLife) -> Document:
    """The course as columns of one table, units in the names; of a joint that keeps its force one row."""
    wear, course = found.wear, found.wear.course
    if course is None:
        nothing = np.zeros(1)
        return {"kt_s_per_Pa": nothing, "preload_N": nothing + wear.now.preload}
    columns: Document = {"kt_s_per_Pa": course.coefficient_time}
    if found.coefficient is not None:
        columns["hours"] = course.coefficient_time / found.coefficient / _HOUR
    columns |= {key: getattr(course, name) for key, name in _COURSE.items()}
    return columns | {
        f"depth_m_{name}": values for name, values in zip(wear.tracks, course.depth, strict=True)
    }


def _by_track(wear: JointWear, values: np.ndarray) -> dict[str, float]:
    """Numbers by the names of the tracks."""
    return dict(zip(wear.tracks, values.tolist(), strict=True))


def _time(end: WearEnd | None) -> float | None:
    return None if end is None else end.coefficient_time


def _end(wear: JointWear, end: WearEnd | None) -> Document | None:
    """What happens at an end of wear, where, and under which load."""
    if end is None:
        return None
    return {
        "limit": end.kind,
        "contact": wear.contact_names[end.contact] if end.contact >= 0 else None,
        "load": end.load + 1 if end.load >= 0 else None,
        "interference_m": end.interference,
    }


def _plain(values: np.ndarray) -> list[float | None]:
    """Numbers for JSON; None for nan."""
    return [value if math.isfinite(value) else None for value in values.tolist()]
