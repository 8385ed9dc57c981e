"""The law of randomly rough elastic surfaces with the decay length by Persson's theory of a measured spectrum."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from asperity.contact.felt_contacts import FeltContacts, decay_lengths_by_theory
from asperity.contact.laws.by_decay_length import DECAY_LENGTH, ELASTIC_ERROR, ByDecayLength
from asperity.contact.laws.law import DecayRatios, FromMeasurement, Quantity
from asperity.contact.persson_2007 import PERSSON_OVER_BOUNDARY_ELEMENTS

if TYPE_CHECKING:
    from asperity.surface.measured_roughness import MeasuredRoughness


class Persson2007(ByDecayLength):
    """Randomly rough elastic surfaces by their measured spectrum; (A11) of :doc:`/equations`."""

    name: ClassVar[str] = "persson_2007"
    rank: ClassVar[int] = 30
    meaning: ClassVar[str] = "that of randomly rough elastic surfaces, from their spectrum"
    assumes: ClassVar[tuple[str, ...]] = (DECAY_LENGTH.format(name),)
    needs: ClassVar[tuple[str, ...]] = ("decay_length",)
    needs_words: ClassVar[str] = (
        "the spectrum of a measured surface (asperity surface measure), which neither Ra nor D and G fix,"
    )
    default_for: ClassVar[tuple[str, ...]] = ()
    from_measurement: ClassVar[FromMeasurement] = "decay_length"
    over_boundary_elements: ClassVar[tuple[float, float]] = PERSSON_OVER_BOUNDARY_ELEMENTS
    error: ClassVar[str] = ELASTIC_ERROR.format(*PERSSON_OVER_BOUNDARY_ELEMENTS)

    @classmethod
    def decay_ratios(
        cls, measured: MeasuredRoughness, contacts: FeltContacts, quantity: Quantity
    ) -> DecayRatios:
        """By the theory of the waves that each contact feels, at its mean pressure."""
        low, high = cls.over_boundary_elements
        lengths, fractions = decay_lengths_by_theory(measured, contacts, form=False)
        ratios, parts, states = {}, [], {}
        for (name, one), pressure, length, share in zip(
            contacts.felt.items(), contacts.pressures, lengths, 100.0 * fractions, strict=True
        ):
            states[name] = f"{share:.4g} % of the contact {name} touches by Persson's theory"
            ratio = float(length) / one.rms_height
            ratios[name] = (low * ratio, ratio, high * ratio)
            parts.append(
                f"{name} {quantity(float(length), 'um', 3)} ({ratio:.3f} of the heights, at "
                f"{quantity(pressure, 'MPa', 3)}, where {share:.2g} % of the area touch)"
            )
        told = (
            "contact law persson_2007: the decay length by Persson's theory of the waves above, elastic, under the "
            "mean pressure of each contact, at the torque of the file; it stays at other torques: "
            f"{'; '.join(parts)}"
        )
        return DecayRatios(ratios, (told,), states)
