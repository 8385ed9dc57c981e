"""What the laws of randomly rough elastic surfaces share: one length decides, in which the pressure falls."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import ClassVar, Self

from asperity.contact.asperity import AsperityBase
from asperity.contact.exponential import RandomRoughness, random_contact
from asperity.contact.interface import RoughContact
from asperity.contact.laws.law import ContactLaw, PressedRollers
from asperity.types import Real

ELASTIC_ERROR = (
    "The law is {:g} to {:g} times as stiff as boundary elements on measured surfaces, elastic, in nine cases of ten; "
    "plastic spots make contacts stiffer, up to four times at a hardness of 1.26 GPa."
)
DECAY_LENGTH = (
    "contact law {}: K_n = f N/u with the decay_length u of each contact at every force, f from 1 to 2 because "
    "contacts widen under load, K_t proportional to 1 - T/(mu N)"
)


class ByDecayLength(ContactLaw, RandomRoughness, abstract=True):
    """A law of the decay length of each contact, wherever that is from; (A10) of :doc:`/equations`."""

    slip_exponent: ClassVar[float] = 1.0
    has_spots: ClassVar[bool] = False

    @classmethod
    def of_surface(cls, numbers: Mapping[str, Real], *, asperity_base: AsperityBase) -> Self:
        """The law with a stated decay length; the base of an asperity is nothing to it."""
        return cls(numbers["decay_length"])

    def rough_contact(self, rollers: PressedRollers) -> RoughContact:
        """As :func:`asperity.contact.exponential.random_contact`."""
        return random_contact(
            roughness=self,
            normal_force=rollers.normal_force,
            tangential_force=rollers.tangential_force,
            friction_coefficient=rollers.friction_coefficient,
            contact_modulus=rollers.moduli.contact_modulus,
            tangential_contact_modulus=rollers.moduli.tangential_contact_modulus,
            contact_length=rollers.contact_length,
        )

    def softer(self, factor: Real) -> Self:
        """With a decay length that is ``factor`` times as long."""
        return dataclasses.replace(self, decay_length=factor * self.decay_length)
