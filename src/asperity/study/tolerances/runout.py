r"""Runout and roundness of the parts of a drive that keep its output even: form errors backwards.

To first order a result is a sum over harmonics of unknown phases, :math:`\sum_j |H_j| A_j` at worst. Amplitudes in the
proportions w that keep it at a limit are therefore

.. math:: A_j = \frac{w_j\,y}{\sum_j |H_j| w_j} \quad\text{or}\quad \frac{w_j\,y}{\sqrt{\tfrac12 \sum_j (|H_j| w_j)^2}}

for the worst sum and for the root mean square. A drawing has twice an amplitude: full reading of an indicator.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.library.tolerance_grades import standard_tolerances
from asperity.rolling.accuracy import Accuracy, Component
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity

#: How the amplitudes share what is allowed: as the file states them, all alike, by the grade of the diameters of the
#: parts, or at the least cost, of 1/A each.
FormSharing = Literal["stated", "equal", "grade", "cost"]
#: Results that form errors move and a limit may keep: dimension, and unit to show.
FORM_RESULTS = {
    "transmission_error": (Dimension.ANGLE, "arcsec"),
    "transmission_error_rms": (Dimension.ANGLE, "arcsec"),
    "turn_slip_ratio": (Dimension.DIMENSIONLESS, "1"),
}
#: Share of the largest influence, and of an angle of one amplitude at the track, below which a harmonic is said to have
#: none: symmetry leaves rounding errors.
_NO_INFLUENCE = 1e-6


class FormLimit(NamedTuple):
    """A limit of a result that form errors move: its name, and the largest value [SI]."""

    name: str
    largest: float


@dataclass(frozen=True)
class AllowedForm:
    """What is allowed of one harmonic of a part, of each where ``sectors`` have one.

    ``amplitude`` [m], and the ``reading`` of an indicator, twice as much; ``influence``, share of the limit that
    1 um of amplitude of all of them uses.
    """

    part: str
    sectors: int
    harmonic: int
    amplitude: float
    reading: float
    influence: float


@dataclass(frozen=True)
class AllowedForms:
    """What is allowed of the harmonics that move the results; transmission error that is left [rad]."""

    forms: tuple[AllowedForm, ...]
    without_influence: tuple[str, ...]
    limits: tuple[str, ...]
    sharing: str
    transmission_error: float
    transmission_error_rms: float


def form_limits(texts: Sequence[str]) -> tuple[FormLimit, ...]:
    """Limits of results that form errors move, as in ``transmission_error <= 20 arcsec``; none of other results."""
    found, others = [], []
    for text in texts:
        match = re.fullmatch(r"\s*(\w+)\s*(>=|<=)\s*(.+)", text)
        if match is None or match[1] not in FORM_RESULTS:
            others.append(text)
            continue
        if match[2] == ">=":
            raise InputError(
                f"'{text}': {match[1]} has a largest value; write {match[1]}<=VALUE", options=["keep"]
            )
        dimension, unit = FORM_RESULTS[match[1]]
        try:
            value = parse_quantity(match[3], dimension)
        except InputError as error:
            raise InputError(f"'{text}': {error}", options=["keep"]) from None
        if value <= 0.0:
            raise InputError(
                f"'{text}': {format_quantity(value, unit)} is not allowed; it must be above 0",
                options=["keep"],
            )
        found.append(FormLimit(match[1], value))
    if found and others:
        raise InputError(
            f"'{others[0]}': limits of sizes and of form errors follow from different parts of the file; keep them in "
            "two calls",
            options=["keep"],
        )
    return tuple(found)


def allowed_amplitudes(*, influence: np.ndarray, weight: np.ndarray, limit: float, rms: bool) -> np.ndarray:
    r"""Amplitudes in given proportions that keep a sum of waves of unknown phases at a limit.

    .. math::
        A_j = \frac{w_j\,y}{\sum_j |H_j| w_j} \quad\text{or}\quad
        \frac{w_j\,y}{\sqrt{\tfrac12 \sum_j (|H_j| w_j)^2}}

    Parameters
    ----------
    influence : ndarray
        Amplitudes :math:`|H_j|` of the result over those of the waves, shape (waves,) [its unit/m].
    weight : ndarray
        Proportions w, shape (waves,) [-].
    limit : float
        Largest value y of the result [its unit].
    rms : bool
        Whether it is that of the root mean square, or of the worst sum.

    Returns
    -------
    ndarray
        Amplitudes, shape (waves,) [m].

    References
    ----------
    Equation (R4) of :doc:`/equations`, backwards.
    """
    swings = influence * weight
    total = np.sqrt(0.5 * np.sum(swings**2)) if rms else np.sum(swings)
    amplitudes: np.ndarray = weight * limit / total
    return amplitudes


class _Group(NamedTuple):
    """A harmonic of a part, of all sectors that the file states it of."""

    part: str
    harmonic: int
    components: tuple[Component, ...]
    diameter: float


def allowed_forms(
    accuracy: Accuracy, diameters: Sequence[float], limits: Sequence[FormLimit], *, sharing: FormSharing
) -> AllowedForms:
    """The largest amplitudes, in proportions, of the harmonics that a file states, with which all limits are kept.

    ``diameters`` of the tracks of the components [m]. Phases are unknown, whatever the file says: no drawing has them.
    An ``InputError`` is raised where a contact is beyond its limit without form errors, a ``NoSolutionError`` if no
    harmonic moves a limited result.
    """
    groups = _groups(accuracy, diameters)
    wanted = [each for limit in limits for each in _wanted(accuracy, groups, limit)]
    used = np.max([np.nansum(influence, axis=1) / room for influence, room, _ in wanted], axis=0)
    moving = used > _NO_INFLUENCE * used.max()
    if not used.max() > 0.0:
        raise NoSolutionError(
            "no harmonic that the file states moves a limited result; nothing follows for form errors"
        )
    parts = [len(group.components) for group in groups]
    kept = []
    for influence, room, rms in wanted:
        weight = np.where(moving, _weights(groups, influence, sharing, rms), 0.0)
        kept.append(
            allowed_amplitudes(
                influence=_flat(influence), weight=np.repeat(weight, parts), limit=room, rms=rms
            )
        )
    amplitudes = np.min(kept, axis=0)
    ends = np.cumsum([0, *parts])
    per_group = [float(amplitudes[start]) for start in ends[:-1]]
    forms = tuple(
        AllowedForm(
            part=group.part,
            sectors=len(group.components),
            harmonic=group.harmonic,
            amplitude=size,
            reading=2.0 * size,
            influence=1e-6 * float(part),
        )
        for group, size, part, moves in zip(groups, per_group, used, moving, strict=True)
        if moves
    )
    errors = np.concatenate([_error_of(group) for group in groups]) * amplitudes
    return AllowedForms(
        forms=forms,
        without_influence=tuple(
            f"{group.part} {group.harmonic}" for group, moves in zip(groups, moving, strict=True) if not moves
        ),
        limits=tuple(
            f"{limit.name}<={format_quantity(limit.largest, FORM_RESULTS[limit.name][1])}" for limit in limits
        ),
        sharing=sharing,
        transmission_error=float(errors.sum()),
        transmission_error_rms=float(np.sqrt(0.5 * np.sum(errors**2))),
    )


def _groups(accuracy: Accuracy, diameters: Sequence[float]) -> list[_Group]:
    """The harmonics of the parts, each with all of its sectors."""
    together: dict[tuple[str, int], list[tuple[Component, float]]] = {}
    for one, diameter in zip(accuracy.components, diameters, strict=True):
        together.setdefault((one.error.part, one.error.harmonic), []).append((one, diameter))
    return [
        _Group(part, harmonic, tuple(one for one, _ in each), each[0][1])
        for (part, harmonic), each in together.items()
    ]


_Wanted = tuple[np.ndarray, float, bool]


def _wanted(accuracy: Accuracy, groups: list[_Group], limit: FormLimit) -> list[_Wanted]:
    """What a limit wants: influences as a table (groups, components), its room, and whether the rms is meant."""
    if limit.name != "turn_slip_ratio":
        return [(_table([_error_of(group) for group in groups]), limit.largest, limit.name.endswith("_rms"))]
    found: list[_Wanted] = []
    for k, name in enumerate(accuracy.contact_names):
        room = limit.largest - float(accuracy.slip[k])
        if room <= 0.0:
            raise InputError(
                f"turn_slip_ratio<={limit.largest:g}: the contact {name} has {float(accuracy.slip[k]):.4g} without "
                "form errors; raise the limit or the preload, or lower the torque",
                options=["keep"],
            )
        influence = [
            np.array([abs(one.slip[k]) / one.error.amplitude for one in group.components]) for group in groups
        ]
        found.append((_table(influence), room, False))
    return found


def _error_of(group: _Group) -> np.ndarray:
    """Transmission errors of a group over its amplitudes, shape (components,) [rad/m]."""
    found = np.array([abs(one.transmission_error) / one.error.amplitude for one in group.components])
    return np.where(found * group.diameter > _NO_INFLUENCE, found, 0.0)


def _table(rows: list[np.ndarray]) -> np.ndarray:
    """Rows of unlike lengths as a table, nan behind the shorter ones."""
    table = np.full((len(rows), max(len(row) for row in rows)), np.nan)
    for k, row in enumerate(rows):
        table[k, : len(row)] = row
    return table


def _flat(table: np.ndarray) -> np.ndarray:
    flat: np.ndarray = table[np.isfinite(table)]
    return flat


def _weights(groups: list[_Group], influence: np.ndarray, sharing: FormSharing, rms: bool) -> np.ndarray:
    """Proportions of the amplitudes of the groups."""
    if sharing == "stated":
        return np.array([group.components[0].error.amplitude for group in groups])
    if sharing == "equal":
        return np.ones(len(groups))
    if sharing == "grade":
        return np.array([standard_tolerances(group.diameter)["IT6"] for group in groups])
    parts = np.array([len(group.components) for group in groups])
    # Lagrange: the least sum of 1/A over all parts with the sum, or the sum of squares, given
    total = np.nansum(influence**2, axis=1) if rms else np.nansum(influence, axis=1)
    safe = np.where(total > 0.0, total, np.inf)
    weights: np.ndarray = (parts / safe) ** (1 / 3 if rms else 1 / 2)
    return weights
