"""Decay length over the heights of every contact on a measured surface: by Persson's theory, by boundary elements."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from asperity.contact.persson_2007 import (
    PERSSON_OVER_BOUNDARY_ELEMENTS,
    WaveSpectrum,
    contact_fraction,
    persson_decay_length,
    sorted_waves,
    waves_along_line,
)
from asperity.engine import trees
from asperity.engine.control import at_once, vectorised
from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.drawn_surface import Ends, exponential_ratios
from asperity.joint_file.felt_heights import FeltContacts
from asperity.joint_file.material_entries import ContactLaw
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.measured_roughness import MeasuredRoughness
from asperity.types import Array
from asperity.units import format_quantity


def refuse_without_elements(measured: MeasuredRoughness) -> None:
    """Refuse surfaces that were not pressed by boundary elements."""
    for spectrum in measured.spectra:
        if not spectrum.is_map:
            raise InputError(
                f'{spectrum.source}: a profile; model.contact_law = "measured" needs a map of the surface. Leave '
                "contact_law out: the exponential law takes the spectrum of the profile"
            )
    if not measured.spectra or any(spectrum.pressed is None for spectrum in measured.spectra):
        raise InputError(
            f'{measured.source}: a measurement without boundary elements, which model.contact_law = "measured" takes: '
            'measure the map again with a hardness, such as "7 GPa", that of the softer body'
        )


def _by_persson(measured: MeasuredRoughness, contacts: FeltContacts) -> tuple[Ends, list[str]]:
    low, high = PERSSON_OVER_BOUNDARY_ELEMENTS
    lengths, fractions = _by_theory(measured, contacts, form=False)
    ends, told = {}, []
    for (name, one), pressure, length, share in zip(
        contacts.felt.items(), contacts.pressures, lengths, 100.0 * fractions, strict=True
    ):
        state = f"{share:.4g} % of the contact {name} touches by Persson's theory"
        _refuse_complete(measured, float(length), state)
        ratio = float(length) / one.rms_height
        ends[f"surface.{name}"] = (low * ratio, ratio, high * ratio)
        told.append(
            f"{name} {format_quantity(float(length), 'um', 3)} ({ratio:.3f} of the heights, at "
            f"{format_quantity(pressure, 'MPa', 3)}, where {share:.2g} % of the area touch)"
        )
    taken = (
        "contact law persson_2007: the decay length by Persson's theory of the waves above, elastic, under the mean "
        f"pressure of each contact, at the torque of the file; it stays at other torques: {'; '.join(told)}"
    )
    return ends, [taken]


def _refuse_complete(measured: MeasuredRoughness, length: float, state: str) -> None:
    """Refuse contacts without gaps, whose decay length [m] no joint file may have."""
    if not length > 1e-6 * limits.DECAY_LENGTH.lower:
        raise InputError(
            f"{measured.source}: {state}: in complete contact an interface has no stiffness that counts; leave "
            "contact_law out, the exponential law is its soft bound"
        )


def form_lengths(measured: MeasuredRoughness, contacts: FeltContacts) -> dict[str, float]:
    """Decay length of waves along the axis that the heights leave out, as far as no line load closes them [m]."""
    lengths, _ = _by_theory(measured, contacts, form=True)
    return dict(zip(contacts.felt, map(float, lengths), strict=True))


def _by_theory(measured: MeasuredRoughness, contacts: FeltContacts, *, form: bool) -> tuple[Any, Any]:
    """Decay length and share in contact by Persson's theory, of the waves that a contact feels or of its form."""
    spectra, loads = [], np.asarray(contacts.pressures)
    for one in contacts.felt.values():
        parts = [
            (body.form if form else body.waves)(rolling=1.0 / one.width, axial=1.0 / limit)
            for body, limit in zip(measured.spectra, one.axial, strict=True)
        ]
        waves = np.concatenate(parts, axis=1)
        spectra.append(waves_along_line(*waves, half_width=0.5 * one.width) if form else sorted_waves(*waves))
    loads = loads * [one.width if form else 1.0 for one in contacts.felt.values()]
    moduli = np.array([float(moduli.contact_modulus) for moduli in contacts.moduli])
    return at_once(_theory, trees.map(lambda *leaves: np.stack(leaves), *spectra), loads, moduli)


def _theory(waves: WaveSpectrum, pressure: Array, modulus: Array) -> tuple[Array, Array]:
    """Decay length [m] and share of the area in contact [-]; the contacts are the first axis."""

    def one(spectrum: WaveSpectrum, p: Array, contact_modulus: Array) -> tuple[Array, Array]:
        state = {"mean_pressure": p, "contact_modulus": contact_modulus}
        return (
            persson_decay_length(spectrum=spectrum, **state),
            contact_fraction(rms_slope=spectrum.rms_slope, **state),
        )

    return vectorised(one)(waves, pressure, modulus)


def _by_elements(measured: MeasuredRoughness, contacts: FeltContacts) -> tuple[Ends, list[str]]:
    refuse_without_elements(measured)
    tables = [spectrum.pressed for spectrum in measured.spectra if spectrum.pressed]
    ratios: Ends = {}
    parts, outside, other = [], [], []
    for (name, one), pressure, moduli in zip(
        contacts.felt.items(), contacts.pressures, contacts.moduli, strict=True
    ):
        for spectrum in measured.spectra:
            if one.width > spectrum.rolling_length:
                raise InputError(
                    f"{spectrum.source}: {format_quantity(spectrum.rolling_length, 'mm', 3)} in the rolling "
                    f"direction, less than the contact {name} is wide, {format_quantity(one.width, 'mm', 3)}: "
                    'measure a larger map, or leave model.contact_law = "measured" out'
                )
        modulus, hardness = float(moduli.contact_modulus), float(moduli.hardness)
        smoother = _shares_of_bodies(measured.spectra, one.squares)
        (elastic, wide), (capped, deep) = (
            _decay_ratio(measured.spectra, one.squares, pressure / modulus, capped=limited)
            for limited in (False, True)
        )
        state = f"the contact {name} is pressed flat by boundary elements"
        _refuse_complete(measured, elastic * one.rms_height, state)
        ratios[f"surface.{name}"] = (capped * math.exp(-deep), elastic, elastic * math.exp(wide))
        parts.append(
            f"{name} {format_quantity(elastic * one.rms_height, 'um', 3)} ({elastic:.3f} of the heights, at "
            f"{format_quantity(pressure, 'MPa', 3)})"
        )
        ends = [
            (share * pressure / modulus, *table.range(capped=limited))
            for table, share in zip(tables, smoother, strict=True)
            for limited in (False, True)
        ]
        if not all(low <= at <= high for at, low, high in ends):
            outside.append(name)
        least = modulus * min(table.hardness / share for table, share in zip(tables, smoother, strict=True))
        if abs(least - hardness) > 0.1 * hardness:
            other.append(
                f"{name} {format_quantity(least, 'GPa', 3)} in place of {format_quantity(hardness, 'GPa', 3)}"
            )
    told = [
        "contact law measured: the decay length over the rms of the heights is that of elastic boundary elements on "
        "patches of the map under the mean pressure of each contact, at the torque of the file; it stays at other "
        f"torques: {'; '.join(parts)}"
    ]
    if outside:
        told.append(
            f"contact law measured: the pressure of {', '.join(outside)} is outside of what boundary elements have "
            "for this map; the decay length is that of the nearest pressure"
        )
    if other:
        told.append(
            "contact law measured: the stiff end of the interval has another hardness than the softer body, that of "
            "the measurement over the share of a body in the heights of both, 0.71 of two alike: "
            f"{'; '.join(other)}; for that of the body, measure the map with that hardness times the share"
        )
    return ratios, told


def _decay_ratio(
    spectra: tuple[HeightSpectrum, ...], squares: tuple[float, ...], pressure: float, *, capped: bool
) -> tuple[float, float]:
    """Decay length over the rms of the heights, and the half-width of its logarithm; squares of bodies add.

    Elastic heights and pressures scale together: the pair is rougher than a body, which tells of it at a pressure that
    is as much lower. Exact of two bodies alike, and of one beside a smooth one.
    """
    parts, errors, shares = [], [], _shares_of_bodies(spectra, squares)
    for spectrum, square, share in zip(spectra, squares, shares, strict=True):
        assert spectrum.pressed is not None
        ratio, error = spectrum.pressed.decay_ratio(pressure=share * pressure, capped=capped)
        parts.append(ratio**2 * square)
        errors.append(parts[-1] * error)
    return math.sqrt(sum(parts) / sum(squares)), math.hypot(*errors) / sum(parts)


def _shares_of_bodies(spectra: tuple[HeightSpectrum, ...], squares: tuple[float, ...]) -> list[float]:
    """The rms of the heights of one body of each spectrum over that of both bodies together [-]."""
    total = sum(squares)
    return [
        math.sqrt(square / spectrum.bodies / total) for spectrum, square in zip(spectra, squares, strict=True)
    ]


#: Law → function of a measurement and of what its contacts feel: path of a surface → decay length over the rms of the
#: heights, lower end, itself and upper end [-]; and what was taken. An ``InputError`` where it does not serve the law.
RATIOS_OF: dict[ContactLaw, Callable[[MeasuredRoughness, FeltContacts], tuple[Ends, list[str]]]] = {
    "exponential": lambda _, contacts: (exponential_ratios(f"surface.{name}" for name in contacts.felt), []),
    "persson_2007": _by_persson,
    "measured": _by_elements,
}
