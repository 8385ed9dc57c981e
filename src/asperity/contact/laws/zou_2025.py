"""The published law: elastic and plastic spots of a fractal surface, from its D and G."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, Self

from asperity.contact.asperity import AsperityBase
from asperity.contact.fractal import Surface, fractal_contact
from asperity.contact.interface import RoughContact
from asperity.contact.laws.law import ContactLaw, FromMeasurement, PressedRollers
from asperity.types import Real


class Zou2025(ContactLaw, Surface):
    """The fractal law of Zou et al. 2025 on an equivalent surface with D and G."""

    name: ClassVar[str] = "zou_2025"
    rank: ClassVar[int] = 10
    meaning: ClassVar[str] = "the published law, from the D and G of the surfaces"
    assumes: ClassVar[tuple[str, ...]] = ()  # all of it is published
    in_rolling: ClassVar[str] = ": the local form of the contact law is not published"
    needs: ClassVar[tuple[str, ...]] = ("fractal_dimension", "fractal_roughness", "frequency_ratio")
    needs_words: ClassVar[str] = "D and G"
    default_for: ClassVar[tuple[str, ...]] = ("fractal_roughness",)
    from_measurement: ClassVar[FromMeasurement] = "fractal"
    slip_exponent: ClassVar[float] = 1.0 / 3.0
    has_spots: ClassVar[bool] = True
    over_boundary_elements: ClassVar[tuple[float, float]] = (0.045, 0.5)
    error: ClassVar[str] = (
        "The law is 0.045 to 0.5 times as stiff as boundary elements on measured maps that have D and G, elastic."
    )

    @classmethod
    def of_surface(cls, numbers: Mapping[str, Real], *, asperity_base: AsperityBase) -> Self:
        """The law on a surface with D, G and gamma."""
        return cls(
            fractal_dimension=numbers["fractal_dimension"],
            fractal_roughness=numbers["fractal_roughness"],
            frequency_ratio=numbers["frequency_ratio"],
            asperity_base=asperity_base,
        )

    def rough_contact(self, rollers: PressedRollers) -> RoughContact:
        """As :func:`asperity.contact.fractal.fractal_contact`."""
        return fractal_contact(
            surface=self,
            contact_factor=rollers.contact_factor,
            hardness=rollers.moduli.hardness,
            normal_force=rollers.normal_force,
            tangential_force=rollers.tangential_force,
            friction_coefficient=rollers.friction_coefficient,
            contact_modulus=rollers.moduli.contact_modulus,
            tangential_contact_modulus=rollers.moduli.tangential_contact_modulus,
        )
