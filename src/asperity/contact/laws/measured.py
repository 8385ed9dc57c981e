"""The law of randomly rough elastic surfaces with the decay length by boundary elements on a measured map."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, ClassVar

from asperity.contact.felt_contacts import FeltContacts
from asperity.contact.laws.by_decay_length import DECAY_LENGTH, ByDecayLength
from asperity.contact.laws.law import DecayRatios, FromMeasurement, Quantity
from asperity.errors import InputError

if TYPE_CHECKING:
    from asperity.surface.height_spectrum import HeightSpectrum
    from asperity.surface.measured_roughness import MeasuredRoughness


class Measured(ByDecayLength):
    """Randomly rough elastic surfaces by boundary elements on patches of a measured map."""

    name: ClassVar[str] = "measured"
    rank: ClassVar[int] = 40
    meaning: ClassVar[str] = "that of randomly rough elastic surfaces, from their decay_length"
    assumes: ClassVar[tuple[str, ...]] = (DECAY_LENGTH.format(name),)
    needs: ClassVar[tuple[str, ...]] = ("decay_length",)
    needs_words: ClassVar[str] = (
        'a measured map that was pressed with a hardness, such as "7 GPa" (asperity surface measure)'
    )
    default_for: ClassVar[tuple[str, ...]] = ("decay_length",)
    from_measurement: ClassVar[FromMeasurement] = "decay_length"
    over_boundary_elements: ClassVar[tuple[float, float]] = (0.49, 2.31)  # of 15 rollers in 17
    error: ClassVar[str] = (
        "The law is that of boundary elements on the map: its soft end elastic, its stiff end capped at the hardness, "
        "each with the scatter between patches of the map."
    )

    @classmethod
    def refuse(cls, measured: MeasuredRoughness) -> None:
        """Refuse surfaces that were not pressed by boundary elements."""
        for spectrum in measured.spectra:
            if not spectrum.is_map:
                raise InputError(
                    f'{spectrum.source}: a profile; model.contact_law = "measured" needs a map of the surface. Leave '
                    "contact_law out: the exponential law takes the spectrum of the profile"
                )
        if not measured.spectra or any(spectrum.pressed is None for spectrum in measured.spectra):
            raise InputError(
                f'{measured.source}: a measurement without boundary elements, which model.contact_law = "measured" '
                'takes: measure the map again with a hardness, such as "7 GPa", that of the softer body'
            )

    @classmethod
    def decay_ratios(
        cls, measured: MeasuredRoughness, contacts: FeltContacts, quantity: Quantity
    ) -> DecayRatios:
        """By boundary elements at the mean pressure of each contact; the stiff end is capped at the hardness."""
        cls.refuse(measured)
        tables = [spectrum.pressed for spectrum in measured.spectra if spectrum.pressed]
        ratios, states = {}, {}
        parts, outside, other = [], [], []
        for (name, one), pressure, moduli in zip(
            contacts.felt.items(), contacts.pressures, contacts.moduli, strict=True
        ):
            for spectrum in measured.spectra:
                if one.width > spectrum.rolling_length:
                    raise InputError(
                        f"{spectrum.source}: {quantity(spectrum.rolling_length, 'mm', 3)} in the rolling "
                        f"direction, less than the contact {name} is wide, {quantity(one.width, 'mm', 3)}: "
                        'measure a larger map, or leave model.contact_law = "measured" out'
                    )
            modulus, hardness = float(moduli.contact_modulus), float(moduli.hardness)
            smoother = shares_of_bodies(measured.spectra, one.squares)
            (elastic, wide), (capped, deep) = (
                decay_ratio(measured.spectra, one.squares, pressure / modulus, capped=limited)
                for limited in (False, True)
            )
            states[name] = f"the contact {name} is pressed flat by boundary elements"
            ratios[name] = (capped * math.exp(-deep), elastic, elastic * math.exp(wide))
            parts.append(
                f"{name} {quantity(elastic * one.rms_height, 'um', 3)} ({elastic:.3f} of the heights, at "
                f"{quantity(pressure, 'MPa', 3)})"
            )
            ends = [
                (share * pressure / modulus, *table.range(capped=limited))
                for table, share in zip(tables, smoother, strict=True)
                for limited in (False, True)
            ]
            if not all(low <= at <= high for at, low, high in ends):
                outside.append(name)
            least = modulus * min(
                table.hardness / share for table, share in zip(tables, smoother, strict=True)
            )
            if abs(least - hardness) > 0.1 * hardness:
                other.append(f"{name} {quantity(least, 'GPa', 3)} in place of {quantity(hardness, 'GPa', 3)}")
        return DecayRatios(ratios, _told(parts, outside, other), states)


def _told(parts: list[str], outside: list[str], other: list[str]) -> tuple[str, ...]:
    """What was taken: of all contacts, of those at pressures without elements, and of those with another hardness."""
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
    return tuple(told)


def decay_ratio(
    spectra: tuple[HeightSpectrum, ...], squares: tuple[float, ...], pressure: float, *, capped: bool
) -> tuple[float, float]:
    r"""Decay length over the rms of the heights, and the half-width of its logarithm; squares of bodies add.

    .. math:: \frac{u_0}{h} = \sqrt{\frac{\sum_i r_i^2 h_i^2}{\sum_i h_i^2}}

    Parameters
    ----------
    spectra : tuple of HeightSpectrum
        Of the bodies, with the ratios r of their pressed maps.
    squares : tuple of float
        Mean square of the heights of each body [m^2].
    pressure : float
        Mean pressure over contact modulus [-].
    capped : bool
        Whether no pressure exceeds the hardness.

    Returns
    -------
    tuple of float
        Ratio and half-width [-].

    Notes
    -----
    Elastic heights and pressures scale together: the pair is rougher than a body, which tells of it at a pressure that
    is as much lower. Exact of two bodies alike, and of one beside a smooth one.

    References
    ----------
    Derived here; :class:`asperity.surface.pressed_map.PressedMap`.
    """
    parts, errors, shares = [], [], shares_of_bodies(spectra, squares)
    for spectrum, square, share in zip(spectra, squares, shares, strict=True):
        assert spectrum.pressed is not None
        ratio, error = spectrum.pressed.decay_ratio(pressure=share * pressure, capped=capped)
        parts.append(ratio**2 * square)
        errors.append(parts[-1] * error)
    return math.sqrt(sum(parts) / sum(squares)), math.hypot(*errors) / sum(parts)


def shares_of_bodies(spectra: tuple[HeightSpectrum, ...], squares: tuple[float, ...]) -> list[float]:
    """The rms of the heights of one body of each spectrum over that of both bodies together [-].

    Parameters
    ----------
    spectra : tuple of HeightSpectrum
        One, of one or of both bodies, or two.
    squares : tuple of float
        Mean square of the heights of each [m^2].

    Returns
    -------
    list of float
        Shares [-].

    References
    ----------
    Elementary: mean squares of independent heights add.
    """
    total = sum(squares)
    return [
        math.sqrt(square / spectrum.bodies / total) for spectrum, square in zip(spectra, squares, strict=True)
    ]
