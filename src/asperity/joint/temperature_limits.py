"""The temperatures at which a joint loses what holds it: the force of a contact, or the seat of a ring."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from asperity.joint.description import Joint
from asperity.joint.fit import HOTTEST, loose_temperature
from asperity.joint.housing import loosening_temperatures, seated
from asperity.types import Document
from asperity.units import format_quantity

_COLDEST = -273.15
_STEP = 20.0  # K, over which the forces are compared where no temperature takes all interference
_ALIKE = 1e-3  # ratios of forces that differ by less fall to zero together
_BEYOND = 2.0  # of the straight line to zero: forces fall a little slower than it
_CLOSE = 1e-3  # K


class AtTemperature(NamedTuple):
    """A joint at one temperature.

    ``normal``: forces of its contacts without torque, shape (contacts,) [N], nan or not positive where it cannot be
    assembled; ``seat``: smallest pressure of each ring on its housing, with the rollers, without and under the torque,
    shape (bodies,) [Pa].
    """

    normal: np.ndarray
    seat: np.ndarray


class TemperatureLimit(NamedTuple):
    """What is lost at a temperature [degC], ``above`` or below it.

    ``lost``: ``interference``, that of the drive with the forces of all contacts; ``contact``, the force of one;
    ``seat``, the pressure of a ring's fit in its housing; ``seat_between_rollers``, its pressure on a part of its
    circumference, with the forces of the rollers. ``part`` is the contact or the ring.
    """

    lost: str
    part: str
    temperature: float
    above: bool


def temperature_limits(joint: Joint, at: Callable[[float], AtTemperature]) -> tuple[TemperatureLimit, ...]:
    """What a joint loses as its temperature leaves that of the assembly, on each side the first one first.

    ``at`` gives the joint at a temperature [degC]. Empty where nothing depends on temperature, or nothing is lost
    between absolute zero and the melting of every roller. What the drive would lose after a seat is left out: the ring
    no longer follows its housing then.
    """
    fit, housing = joint.fit, joint.housing
    assembly = housing.assembly_temperature if fit is None and housing is not None else None
    assembly = fit.assembly_temperature if fit is not None else assembly
    if assembly is None:
        return ()
    start = float(assembly)
    lost = [*_seats_lost(joint, start, at), *([] if fit is None else _contacts_lost(joint, start, at))]
    lost.sort(key=lambda limit: abs(limit.temperature - start))
    kept: list[TemperatureLimit] = []
    for limit in lost:
        before = [other.lost for other in kept if other.above == limit.above]
        if limit.lost == "seat" or not any(name.startswith("seat") for name in before):
            kept.append(limit)
    return tuple(kept)


def _contacts_lost(
    joint: Joint, start: float, at: Callable[[float], AtTemperature]
) -> Iterator[TemperatureLimit]:
    """Where the contacts lose their forces, all together or the first one on each side."""
    assert joint.fit is not None
    loose = float(loose_temperature(joint.fit))
    probe = 0.5 * (loose - start) if math.isfinite(loose) else _STEP
    forces = at(start).normal
    ratio = at(start + probe).normal / forces
    if np.all(np.isfinite(ratio)) and np.ptp(ratio) < _ALIKE * np.max(ratio):
        if math.isfinite(loose):
            yield TemperatureLimit("interference", "", loose, loose > start)
        return
    for way in (1.0, -1.0):
        falling = np.where(np.isfinite(ratio), (1.0 - ratio) * way / probe, np.inf)
        if not np.any(falling > 0.0):
            continue
        end = start + way * _BEYOND / max(np.max(falling), 1.0 / HOTTEST)
        if math.isfinite(loose) and (loose - start) * way > 0.0:
            end = loose
        end = min(max(end, _COLDEST), HOTTEST)
        temperature = _first(lambda celsius: _pressed(at(celsius)), start, end)
        if temperature is not None:
            left = at(temperature).normal / forces
            yield TemperatureLimit(
                "contact", joint.contact_names[int(np.argmin(left))], temperature, way > 0.0
            )


def _pressed(found: AtTemperature) -> bool:
    return bool(np.all(found.normal > 0.0))


def _seats_lost(
    joint: Joint, start: float, at: Callable[[float], AtTemperature]
) -> Iterator[TemperatureLimit]:
    """Where each ring loses its fit in the housing, and where it leaves the housing between the rollers."""
    alone = loosening_temperatures(joint, start)
    for number, holds in enumerate(seated(joint)):
        end = alone[number]
        if not holds or not _COLDEST <= end <= HOTTEST:
            continue
        name = joint.drive.bodies[number].name
        yield TemperatureLimit("seat", name, end, end > start)

        def pressure(celsius: float, number: int = number) -> float:
            return float(at(celsius).seat[number])

        if not pressure(start) > 0.0:
            yield TemperatureLimit("seat_between_rollers", name, start, end > start)
            continue
        temperature = _vanishes(pressure, start, end)
        if temperature is not None:
            yield TemperatureLimit("seat_between_rollers", name, temperature, end > start)


def _vanishes(size: Callable[[float], float], start: float, end: float) -> float | None:
    """The temperature at which a size falls to zero on the way to an end; None where it is still positive there."""
    if size(end) > 0.0:
        return None
    if math.isfinite(size(end)):
        from scipy.optimize import brentq  # half a second, which most joints do not need

        return float(brentq(size, start, end, xtol=_CLOSE))
    return _first(lambda celsius: size(celsius) > 0.0, start, end)


def _first(holds: Callable[[float], bool], start: float, end: float) -> float | None:
    """The last temperature at which something holds on the way to an end, by bisection; None where it holds there."""
    if holds(end):
        return None
    while abs(end - start) > _CLOSE:
        middle = 0.5 * (start + end)
        start, end = (middle, end) if holds(middle) else (start, middle)
    return start


def limits_document(limits: tuple[TemperatureLimit, ...]) -> list[Document]:
    """The limits for a JSON document, on each side the first one first."""
    return [
        {
            "lost": limit.lost,
            "part": limit.part or None,
            "temperature_degC": limit.temperature,
            "side": "above" if limit.above else "below",
        }
        for limit in limits
    ]


_WORDS = {
    "interference": "loose",
    "contact": "no force at {part}",
    "seat": "no fit of {part} in its housing",
    "seat_between_rollers": "no pressure of {part} on its housing between the rollers",
}


def limit_words(entries: list[Document]) -> list[str]:
    """What a joint is beyond the first limit on each side, of :func:`limits_document`, in words.

    Examples
    --------
    >>> limit_words([{"lost": "contact", "part": "pr1", "temperature_degC": 80.0, "side": "above"}])
    ['no force at pr1 above 80 degC']
    """
    first = {entry["side"]: entry for entry in reversed(entries)}
    return [
        f"{lost_words(entry)} {side} {format_quantity(entry['temperature_degC'], 'degC')}"
        for side, entry in first.items()
    ]


def lost_words(entry: Document) -> str:
    """What is lost at a limit of :func:`limits_document`, in words."""
    return _WORDS[entry["lost"]].format(part=(entry["part"] or "").replace("_", " "))
