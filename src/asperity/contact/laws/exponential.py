"""The law of randomly rough elastic surfaces with a decay length in proportion to the rms of their heights."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Self

from asperity.contact.asperity import AsperityBase
from asperity.contact.exponential import OVER_BOUNDARY_ELEMENTS, decay_length
from asperity.contact.laws.by_decay_length import ELASTIC_ERROR, ByDecayLength, share_of
from asperity.contact.laws.law import DecayRatios, FromMeasurement, Quantity

if TYPE_CHECKING:
    from asperity.contact.felt_contacts import FeltContacts
    from asperity.surface.measured_roughness import MeasuredRoughness


class Exponential(ByDecayLength):
    """Randomly rough elastic surfaces by the rms of their heights; (A10) and (A12) of :doc:`/equations`."""

    name: ClassVar[str] = "exponential"
    rank: ClassVar[int] = 20
    meaning: ClassVar[str] = "the law of randomly rough elastic surfaces, from the rms of their heights"
    assumes: ClassVar[tuple[str, ...]] = (
        "contact law exponential: randomly rough elastic surfaces, K_n = f N/(0.48 h), f from 1 to 2 because contacts "
        "widen under load, K_t proportional to 1 - T/(mu N), h the rms height of both bodies together; h counts waves "
        "shorter than the contact is wide, and along the axes up to the roll-off: longer ones make the joint look "
        "softer",
    )
    assumes_of_average: ClassVar[str] = (
        "contact law exponential with roughness_average: normally distributed heights, h = 1.2533 Ra of both bodies "
        "together; D has no influence, and waves longer than the cut-off of Ra are not included"
    )
    needs: ClassVar[tuple[str, ...]] = ("rms_height",)
    needs_words: ClassVar[str] = "the rms of the heights"
    default_for: ClassVar[tuple[str, ...]] = ("rms_height", "roughness_average", "measurement")
    from_measurement: ClassVar[FromMeasurement] = "heights"
    over_boundary_elements: ClassVar[tuple[float, float]] = OVER_BOUNDARY_ELEMENTS
    error: ClassVar[str] = ELASTIC_ERROR.format(*OVER_BOUNDARY_ELEMENTS)

    @classmethod
    def of_surface(cls, numbers: Mapping[str, Any], *, asperity_base: AsperityBase) -> Self:
        """The law on a surface of which the rms of the heights is known, and perhaps the lay."""
        share = share_of(numbers)
        return cls(decay_length(rms_height=numbers["rms_height"], rolling_share=share), share)

    @classmethod
    def decay_ratios(
        cls, measured: MeasuredRoughness, contacts: FeltContacts, quantity: Quantity
    ) -> DecayRatios:
        """0.48 of the heights at every contact, over the factor of its lay."""
        low, high = cls.over_boundary_elements
        ratios = {
            name: float(decay_length(rms_height=1.0, rolling_share=felt.rolling_share))
            for name, felt in contacts.felt.items()
        }
        return DecayRatios({name: (low * each, each, high * each) for name, each in ratios.items()}, (), {})
