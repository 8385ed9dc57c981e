"""Joints on a measured surface at many points: what each of their contacts feels at the width that it has there."""

from __future__ import annotations

import functools
import itertools
import json
import math
from collections.abc import Callable, Mapping

import numpy as np

from asperity.contact.felt_contacts import FeltContacts
from asperity.contact.laws.registry import LAWS, law_for
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.decay_ratios import ratios_of
from asperity.joint_file.felt_heights import (
    HEIGHT,
    SHARE,
    Heights,
    Numbers,
    contact_lengths,
    felt_by,
    felt_numbers,
    moduli_of,
    settled_heights,
)
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.si_tables import MEASURED, Values, replace_values, with_numbers, without_measurement
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_from_document
from asperity.types import Document

#: Dotted path → its values at all points [SI], shape (points,).
Columns = Mapping[str, np.ndarray]
WIDTH, PRESSURE = "hertz_half_width", "hertz_pressure"
#: Results of the contacts on which depends what they feel.
STATE = (WIDTH, PRESSURE)


def with_felt_surfaces(
    values: Values, points: Columns, states: Callable[[Values, Columns], dict[str, np.ndarray]]
) -> tuple[Values, dict[str, np.ndarray], np.ndarray]:
    """Tables and points with what each contact of each joint feels of its measured surface, and where that settles.

    ``states`` are the :data:`STATE` of joints of tables at points. With sections ``[[branch]]`` the contacts feel what
    those of the drive with equal branches do. By a law with a decay length it is that at the pressure of each point.
    """
    replace_values(values, dict.fromkeys(points, 1.0))  # refuses what follows from the measurement
    measured, tables = _roughness(values[MEASURED]), without_measurement(values)
    surface, names = tables["surface"], contacts_of(tables)
    count = np.size(next(iter(points.values()))) if points else 1
    if names[0] not in surface:  # D and G, which every contact has, whatever its width
        return tables, dict(points), np.ones(count, dtype=bool)
    of_heights = HEIGHT in surface[names[0]]
    lay = {name: {SHARE: surface[name][SHARE]} if SHARE in surface[name] else {} for name in names}
    by_heights = tables | {
        "surface": {name: {HEIGHT: math.nan} | lay[name] for name in names},
        "model": tables["model"]
        if of_heights
        else tables["model"] | {"contact_law": law_for("measurement").name},
    }
    by_heights.pop("branch", None)
    alike = {path: column for path, column in points.items() if not path.startswith("branch.")}
    lengths = _lengths(by_heights, alike, count)
    last: dict[str, np.ndarray] = {}

    def widths_of(numbers: Numbers) -> Heights:
        last.update(states(by_heights, alike | _moving(measured, names, numbers)))
        return 2.0 * last[WIDTH]

    felt_here, settled = settled_heights(measured.spectra, lengths, widths_of)
    if of_heights:
        return tables, dict(points) | _moving(measured, names, felt_here), settled
    felt = np.array(felt_here[HEIGHT])
    for point in np.flatnonzero(np.isfinite(last[WIDTH]).all(axis=0)):
        numbers = {path: column[point] for path, column in alike.items()}
        contacts = FeltContacts(
            felt_by(measured.spectra, names, 2.0 * last[WIDTH][:, point], lengths[:, point]),
            0.25 * math.pi * last[PRESSURE][:, point],
            moduli_of(joint_from_values(replace_values(by_heights, numbers))),
        )
        try:
            ratios, _ = ratios_of(LAWS[tables["model"]["contact_law"]], measured, contacts)
        except InputError:  # the law has no decay length at this pressure
            settled[point] = False
        else:
            felt[:, point] = [ratios[f"surface.{name}"][1] * contacts.felt[name].rms_height for name in names]
    by_length = {"decay_length": felt} | {key: felt_here[key] for key in felt_here if key != HEIGHT}
    return tables, dict(points) | _moving(measured, names, by_length), settled


def refuse_derivatives(values: Values) -> None:
    """Refuse a measured surface of which what the contacts feel has no derivatives."""
    by_length = any(
        "decay_length" in entry for entry in values["surface"].values() if isinstance(entry, dict)
    )
    remedies = {
        "leave [[branch]] out": "branch" in values,
        f'state model.contact_law = "{law_for("measurement").name}"': by_length,
    }
    if any(remedies.values()):
        raise InputError(
            "surface.measurement: what contacts feel has no derivatives beside [[branch]], or by a contact law with a "
            f"decay length: {' and '.join(words for words, needed in remedies.items() if needed)}"
        )


def heights_moved(
    values: Values, columns: Columns, half_widths: np.ndarray, slopes: np.ndarray, variables: tuple[str, ...]
) -> np.ndarray:
    r"""By how much what contacts feel moves with variables, shape (points, felt, variables) [SI].

    .. math::
        \frac{dh}{dx} = \Bigl(1 - \frac{\partial h}{\partial w}\frac{\partial w}{\partial h}\Bigr)^{-1}
        \Bigl(\frac{\partial h}{\partial w}\frac{\partial w}{\partial x}
        + \frac{\partial h}{\partial B}\frac{\partial B}{\partial x}\Bigr)

    with the heights h of all contacts, on maps their shares of the waves in the rolling direction behind them, the
    widths w of the contacts, their lengths B and the ``slopes`` of their half-widths by the variables and by what they
    feel, shape (contacts, points, variables + felt).
    """
    tables, spectra = without_measurement(values), _roughness(values[MEASURED]).spectra
    widths = 2.0 * np.where(half_widths > 0.0, half_widths, 0.5)  # any where there is no joint
    lengths = _lengths(tables, columns, widths.shape[1])
    nothing = with_numbers(tables, itertools.repeat(0.0))
    longer = [contact_lengths(replace_values(nothing, {path: 1.0}))[:, 0] for path in variables]

    def felt(widths: Heights, lengths: Heights) -> Heights:
        """Heights, and shares of maps, of all contacts below each other."""
        return np.concatenate(list(_that_move(spectra, felt_numbers(spectra, widths, lengths)).values()))

    many = len(felt(widths, lengths)) // len(widths)
    by_width = _slope(lambda factor: felt(factor * widths, lengths)) / np.tile(widths, (many, 1))
    by_length = _slope(lambda factor: felt(widths, factor * lengths)) / np.tile(lengths, (many, 1))
    gain = 2.0 * (by_width[..., None] * np.tile(slopes, (many, 1, 1))).transpose(1, 0, 2)
    count = len(variables)
    direct = by_length.T[:, :, None] * np.tile(np.array(longer).T, (many, 1))
    return np.linalg.solve(np.eye(len(by_width)) - gain[..., count:], gain[..., :count] + direct)


def _slope(function: Callable[[float], Heights], step: float = 1e-6) -> Heights:
    """Derivative by a factor around 1."""
    return (function(1.0 + step) - function(1.0 - step)) / (2.0 * step)


def _lengths(tables: Values, columns: Columns, count: int) -> Heights:
    lengths = contact_lengths(replace_values(tables, columns))
    return np.array(np.broadcast_to(lengths, (len(lengths), count)))


def _that_move(spectra: tuple[HeightSpectrum, ...], numbers: Numbers) -> Numbers:
    """Those of what contacts feel that move with their widths: the lay of profiles does not."""
    maps = any(spectrum.is_map for spectrum in spectra)
    return {key: felt for key, felt in numbers.items() if maps or key != SHARE}


def _moving(measured: MeasuredRoughness, names: tuple[str, ...], numbers: Numbers) -> Document:
    """Columns of points with what contacts feel."""
    moving = _that_move(measured.spectra, numbers)
    return {
        path: column for key, felt in moving.items() for path, column in _columns(names, key, felt).items()
    }


def _columns(names: tuple[str, ...], key: str, lengths: Heights) -> Document:
    return {f"surface.{name}.{key}": length for name, length in zip(names, lengths, strict=True)}


@functools.lru_cache(maxsize=8)
def _roughness(text: str) -> MeasuredRoughness:
    """The surface of both bodies together."""
    return roughness_from_document(json.loads(text)).pair
