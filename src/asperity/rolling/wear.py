r"""Wear of a joint over its life: depths of its tracks, interference, preload, capacity and drift, and where it ends.

All results are in proportion to the wear coefficient: they are stated over the product k t of coefficient and time, and
the coefficient that a required life allows is that product over the life.
"""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, speeds
from asperity.drive.state.creep import drift_per_turn
from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint.capacity import limits_of
from asperity.joint.description import Joint, without_duty
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.torque_limits import kind_words
from asperity.rolling.wear_capacity import capacities
from asperity.rolling.wear_course import WearEnd, WearStage, WornCourse, states_at, worn_course
from asperity.rolling.wear_rates import Wearing, WearLoad, WearState, Worn, side_tracks, unworn
from asperity.types import Document
from asperity.units import format_quantity

#: Points of the course of wear, evenly over the time, and those of them at which the torque capacity is looked for.
POINTS, CAPACITY_POINTS = 33, 9
#: Further points, where creep rises steeply: time from the end of each stage over that of the stage.
_NEAR_THE_END = np.array([0.015, 0.008, 0.003, 1e-3, 2e-4])


class WearNow(NamedTuple):
    """A joint before it wears. Of tracks, shape (tracks,), per wear coefficient; the mean of its loads.

    ``depth_rate`` of the tracks and ``interference_rate`` of the drive [m Pa/s]; ``load_power`` of each contact of one
    sector, shape (contacts,) [W]; ``interference`` of the drive [m], ``preload`` [N].
    """

    depth_rate: np.ndarray
    interference_rate: float
    load_power: np.ndarray
    interference: float
    preload: float


class WearOverTime(NamedTuple):
    """A joint over wear coefficient times time, ``coefficient_time``, shape (points,) [s/Pa].

    ``interference`` of the drive [m], ``preload`` [N], ``depth`` of the tracks, shape (tracks, points) [m]; ``drift``
    by creep, the mean of the loads, and ``size_drift`` by the worn radii, both per turn of the output [rad];
    ``capacity``, torque in rolling at which the first contact slides [N·m], at some of the points and nan at the
    others.
    """

    coefficient_time: np.ndarray
    interference: np.ndarray
    preload: np.ndarray
    depth: np.ndarray
    drift: np.ndarray
    size_drift: np.ndarray
    capacity: np.ndarray


class JointWear(NamedTuple):
    """Wear of one joint.

    ``tracks``: names of the bodies, with their tracks where they have several; ``coefficients`` of them over the
    largest one [-]. ``loads``: torque at the output [N·m], speed of the input [rad/s] and share of the time of each.
    ``first_slide`` and ``nothing_left``, None where wear does not lead there or it is not known; ``course``, None where
    a cam or a spring keeps the force, so that nothing ends. ``ends`` of all stages; ``carries_on``: whether the joint
    may do more than the last one says. ``unlike_lengths``: tracks with contacts of unlike lengths.
    """

    contact_names: tuple[str, ...]
    tracks: tuple[str, ...]
    coefficients: np.ndarray
    loads: tuple[tuple[float, float, float], ...]
    now: WearNow
    first_slide: WearEnd | None
    nothing_left: WearEnd | None
    course: WearOverTime | None
    ends: tuple[WearEnd, ...]
    carries_on: bool
    unlike_lengths: tuple[str, ...]
    crowned: bool


def joint_wear(
    joint: Joint,
    coefficients: np.ndarray,
    *,
    keeps_force: bool,
    also: float | None = None,
    with_capacity: bool = True,
) -> JointWear:
    """Wear of a joint that carries its loads at the start; equations (W1)–(W5) of :doc:`/equations`.

    ``coefficients`` of its bodies over the largest one, shape (bodies,) [-]; ``keeps_force``: whether a cam or a force
    follows the wear; ``also``: a further point of the course [s/Pa]; ``with_capacity``: whether torque capacities are
    looked for. An ``InputError`` if nothing slips, or a contact
    does at once.
    """
    numbers: Joint = as_numbers(joint)
    _refuse_profiles(numbers)
    loads = wear_loads(numbers)
    machine: JointMachine = at_once(joint_machine, without_duty(numbers))
    wearing = Wearing(machine, np.asarray(coefficients, dtype=float))
    state = states_at(wearing, unworn(wearing), loads)
    _refuse_start(numbers, state, loads)
    tracks = track_names(machine.drive)
    shared: Document = {
        "contact_names": numbers.contact_names,
        "tracks": tracks,
        "coefficients": _of_tracks(machine.drive, wearing.coefficients),
        "loads": tuple(zip(*(each.tolist() for each in loads[:3]), strict=True)),
        "now": _now(machine.drive, state, loads),
        "unlike_lengths": _unlike_lengths(machine, tracks),
        "crowned": machine.contacts.crown_curvature is not None,
    }
    if keeps_force:
        return JointWear(**shared, first_slide=None, nothing_left=None, course=None, ends=(), carries_on=True)
    course = worn_course(wearing, loads)
    slides = [end for end in course.ends if end.kind == "gross_slip"]
    return JointWear(
        **shared,
        first_slide=slides[0] if slides else None,
        nothing_left=None if course.carries_on else course.ends[-1],
        course=_over_time(wearing, loads, course, also, with_capacity),
        ends=course.ends,
        carries_on=course.carries_on,
    )


def wear_loads(joint: Joint) -> WearLoad:
    """The loads under which a joint wears: those of its duty that turn, or its own, no contact sliding.

    The shares of a duty are those of the whole time: a load that stands takes its part of it, and nothing wears.
    """
    duty = [(load.output_torque, load.input_speed, load.share) for load in joint.rolling.duty]
    points = duty or [(joint.output_torque, joint.input_speed, 1.0)]
    points = [point for point in points if float(point[1]) > 0.0] or points
    torque, speed, share = (np.array([float(point[i]) for point in points]) for i in range(3))
    return WearLoad(torque, speed, share, np.zeros((len(points), len(joint.drive.contacts))))


def track_names(drive: Drive) -> tuple[str, ...]:
    """Names of the tracks of all bodies: of the body, with that of the track where it has several."""
    names = []
    for body, tracks in zip(drive.bodies, drive.layout.tracks, strict=True):
        for number, _ in enumerate(tracks, start=1):
            names.append(body.name if len(tracks) == 1 else f"{body.name}_{number}")
    return tuple(names)


def _of_tracks(drive: Drive, of_bodies: np.ndarray) -> np.ndarray:
    """What tracks have of their bodies, shape (tracks,)."""
    return np.concatenate(
        [np.full(len(tracks), of_bodies[body]) for body, tracks in enumerate(drive.layout.tracks)]
    )


def by_track(drive: Drive, sides: np.ndarray) -> np.ndarray:
    """Numbers of both sides of all contacts, shape (..., 2, contacts), as those of the tracks, (tracks, ...)."""
    numbers = np.array(side_tracks(drive))
    places = [np.argwhere(numbers == track)[0] for track in range(numbers.max() + 1)]
    return np.stack([sides[..., side, contact] for side, contact in places])


def _now(drive: Drive, state: WearState, loads: WearLoad) -> WearNow:
    """The joint before it wears, the mean of its loads."""

    def mean(values: np.ndarray) -> np.ndarray:
        return np.tensordot(loads.share, values[0], axes=1)

    return WearNow(
        depth_rate=by_track(drive, mean(state.depth)),
        interference_rate=float(mean(state.drive_rate)),
        load_power=mean(state.load_power),
        interference=float(state.interference[0, 0]),
        preload=float(np.max(state.preload[0])),
    )


def _unlike_lengths(machine: JointMachine, tracks: tuple[str, ...]) -> tuple[str, ...]:
    """Tracks on which contacts of unlike lengths roll, so that they wear in steps."""
    numbers = np.array(side_tracks(machine.drive))
    lengths = np.broadcast_to(np.asarray(machine.contacts.pairs.contact_length), numbers.shape)
    return tuple(name for track, name in enumerate(tracks) if np.ptp(lengths[numbers == track]) > 0.0)


def _refuse_profiles(joint: Joint) -> None:
    """Refuse profiles of which it is not known what wear makes of them."""
    if joint.logarithmic_crowns is not None:
        raise InputError(
            "logarithmic and ISO/TS 16281 profiles (NAME_profile): how they wear is not computed; state crowns "
            "(NAME_crown_radius), or leave the profiles out"
        )


def _refuse_start(joint: Joint, state: WearState, loads: WearLoad) -> None:
    """Refuse a joint that does not wear, and one of which a contact slips before it does."""
    if not np.any(loads.input_speed > 0.0):
        raise InputError(
            "the input stands (load.sun_speed is 0 or missing), and nothing wears; give it a speed, or loads "
            "in [[duty]]"
        )
    if not np.any(loads.output_torque):
        raise InputError(
            "the output torque is 0 (load.output_torque): no contact slips, and nothing wears; give the torque of the "
            "work, or loads in [[duty]]"
        )
    entries = limits_of(joint)
    for number, excesses in enumerate(state.excesses[0]):
        known = np.where(np.isnan(excesses), -1.0, excesses)
        if known.max() >= 0.0:
            kind, contact = entries[int(np.argmax(known))]
            words = kind_words(kind, (*joint.contact_names, "none")[contact])
            torque = format_quantity(float(loads.output_torque[number]), "N*m")
            whose = f" of load {number + 1} of the [[duty]]" if len(loads.share) > 1 else ""
            raise InputError(
                f"under the output torque {torque}{whose} the joint does not roll at the start: {words}; lower the "
                "torque, or raise the interference (load.interference) or the friction coefficient"
            )


def _over_time(
    wearing: Wearing, loads: WearLoad, course: WornCourse, also: float | None, with_capacity: bool
) -> WearOverTime:
    """The joint over wear coefficient times time, to the last end."""
    last = course.stages[-1].coefficient_time[-1]
    spans = [(stage.coefficient_time[0], stage.coefficient_time[-1]) for stage in course.stages]
    further = [end - (end - begin) * np.append(_NEAR_THE_END, 0.0) for begin, end in spans]
    times = np.unique(
        np.concatenate(
            [np.linspace(0.0, last, POINTS), *further, [] if also is None or also > last else [also]]
        )
    )
    parts: list[tuple[np.ndarray, ...]] = []
    worn: list[Worn] = []
    first = 0.0
    for stage in course.stages:
        end = stage.coefficient_time[-1]
        inside = times[(times >= first) & ((times < end) | (stage is course.stages[-1]))]
        first = end
        states = at_times(stage, inside)
        found = states_at(wearing, states, loads._replace(sliding=stage.sliding))
        worn.append(states)
        parts.append(
            (
                found.interference[:, 0],
                found.preload.max(axis=1),
                mean_drift(wearing.machine.drive, found, loads),
                _interpolated(stage, stage.depth, inside),
            )
        )
    interference, preload, drift, depth = (np.concatenate(each) for each in zip(*parts, strict=True))
    all_worn: Worn = trees.map(lambda *leaves: np.concatenate(leaves), *worn)
    return WearOverTime(
        coefficient_time=times,
        interference=interference,
        preload=preload,
        depth=by_track(wearing.machine.drive, depth),
        drift=drift,
        size_drift=np.array([size_drift(wearing.machine.drive, each) for each in depth]),
        capacity=_capacity(wearing, loads, all_worn, course, times)
        if with_capacity
        else np.full(len(times), np.nan),
    )


def at_times(stage: WearStage, times: np.ndarray) -> Worn:
    """States of wear of a stage at wear coefficients times time [s/Pa]."""
    curvature = stage.worn.curvature
    return Worn(
        _interpolated(stage, stage.worn.interference, times),
        None if curvature is None else _interpolated(stage, curvature, times),
    )


def _interpolated(stage: WearStage, values: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Numbers of a stage, shape (n, ...), at times."""
    flat = values.reshape(len(values), -1)
    columns = [np.interp(times, stage.coefficient_time, column) for column in flat.T]
    return np.stack(columns, axis=1).reshape(len(times), *values.shape[1:])


def mean_drift(drive: Drive, state: WearState, loads: WearLoad) -> np.ndarray:
    """Angle by which creep lets the output fall behind in one of its turns, the mean of its turns, shape (n,) [rad]."""
    turns = loads.share * loads.input_speed * (1.0 - state.speed_loss)
    return np.sum(turns * drift_per_turn(state.speed_loss), axis=1) / np.sum(turns, axis=1)


def size_drift(drive: Drive, depth: np.ndarray) -> float:
    r"""Angle by which the output falls behind in one turn, as worn radii change the speed ratio [rad].

    .. math:: \Delta\varphi = -2\pi\,\frac{\Delta\omega_{out}}{\omega_{out} + \Delta\omega_{out}}

    ``depth`` of the tracks of both bodies of each contact, shape (2, contacts) [m]; the radius of a ring grows.
    Equation (W5).
    """
    worn = dataclasses.replace(
        drive,
        first_radius=np.asarray(drive.first_radius) - depth[0],
        second_radius=np.asarray(drive.second_radius) - drive.layout.outward * depth[1],
        motion=None,
    )
    fresh = dataclasses.replace(drive, motion=None)
    out = drive.members.index(drive.output)
    before, after = (abs(float(at_once(speeds, each)[out])) for each in (fresh, worn))
    return -2.0 * math.pi * (after - before) / after


def _capacity(
    wearing: Wearing, loads: WearLoad, worn: Worn, course: WornCourse, times: np.ndarray
) -> np.ndarray:
    """Torques at which the first contact slides in rolling, at some states of wear and nan at the others [N·m]."""
    even = np.linspace(0.0, times[-1], CAPACITY_POINTS)
    chosen = np.unique([int(np.argmin(np.abs(times - time))) for time in even])
    found = np.full(times.size, np.nan)
    slides = next((end for end in course.ends if end.kind == "gross_slip"), None)
    if slides is None or wearing.machine.joint.cam is not None:
        return found
    hardest = int(np.argmax(np.abs(loads.output_torque)))
    left = states_at(
        wearing,
        trees.map(lambda leaf: leaf[chosen], worn),
        trees.map(lambda leaf: leaf[hardest : hardest + 1], loads._replace(sliding=0.0 * loads.sliding)),
    ).interference[:, 0]
    load = trees.map(lambda leaf: leaf[slides.load], loads)
    found[chosen] = capacities(
        wearing,
        trees.map(lambda leaf: leaf[chosen], worn),
        load,
        guess=abs(load.output_torque) * left / slides.interference,
    )
    return found
