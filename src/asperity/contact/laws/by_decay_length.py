"""What the laws of randomly rough elastic surfaces share: one length decides, in which the pressure falls."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any, ClassVar, Self

from asperity.contact.asperity import AsperityBase
from asperity.contact.exponential import RandomRoughness, lay_stiffness_ratio, random_contact
from asperity.contact.interface import RoughContact
from asperity.contact.laws.law import ContactLaw, PressedRollers, SurfaceKey
from asperity.materials import ContactPair
from asperity.surface.lay import DIRECTIONS, ENDLESS, rolling_share
from asperity.types import Real

ELASTIC_ERROR = (
    "The law is {:g} to {:g} times as stiff as boundary elements on measured surfaces, elastic, in nine cases of ten; "
    "plastic spots make contacts stiffer, up to four times at a hardness of 1.26 GPa."
)
DECAY_LENGTH = (
    "contact law {}: K_n = f N/u with the decay_length u of each contact at every force, f from 1 to 2 because "
    "contacts widen under load, K_t proportional to 1 - T/(mu N)"
)
#: What is known of the grooves of a surface.
LAY_KEYS = (
    SurfaceKey(
        "lay_ratio",
        "Correlation length of the heights along the grooves over that across them, 1 without grooves, 1e6 for "
        "grooves without an end; for the contact laws with a decay length. With lay.",
        "dimensionless",
        "1",
        1.0,
        ENDLESS,
        "10",
        absent=1.0,
        beside="lay",
        reason="heights are correlated further along the grooves than across them: give the reciprocal with the other "
        "lay",
    ),
    SurfaceKey(
        "lay",
        "Direction of the grooves: rolling, that in which the contact rolls, or axis, that of the rollers' axis; with "
        "lay_ratio.",
        "choice",
        choices=DIRECTIONS,
        absent=DIRECTIONS[0],
        beside="lay_ratio",
    ),
    SurfaceKey(
        "rolling_share",
        "Share of the waves that run in the rolling direction, as a measured map gives it: 0 for endless grooves in "
        "that direction, 0.5 without grooves, 1 for endless ones along the axis; in place of lay_ratio and lay.",
        "dimensionless",
        "1",
        0.0,
        1.0,
        "0.2",
        absent=0.5,
        in_place_of=("lay_ratio", "lay"),
    ),
)


class ByDecayLength(ContactLaw, RandomRoughness, abstract=True):
    """A law of the decay length of each contact, wherever that is from; (A10) and (A13) of :doc:`/equations`."""

    keys: ClassVar[tuple[SurfaceKey, ...]] = LAY_KEYS
    slip_exponent: ClassVar[float] = 1.0
    has_spots: ClassVar[bool] = False

    @classmethod
    def of_surface(cls, numbers: Mapping[str, Any], *, asperity_base: AsperityBase) -> Self:
        """The law with a stated decay length, which contains the grooves; the base of an asperity is nothing to it."""
        return cls(numbers["decay_length"], share_of(numbers))

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

    def stiffness_ratio(self, moduli: ContactPair, *, along_axis: bool = False) -> Real:
        """By the lay of the surface, :func:`asperity.contact.exponential.lay_stiffness_ratio`."""
        share = self.rolling_share
        return lay_stiffness_ratio(
            contact_modulus=moduli.contact_modulus,
            tangential_contact_modulus=moduli.tangential_contact_modulus,
            share=1.0 - share if along_axis and share is not None else share,
        )

    def softer(self, factor: Real) -> Self:
        """With a decay length that is ``factor`` times as long."""
        return dataclasses.replace(self, decay_length=factor * self.decay_length)


def share_of(numbers: Mapping[str, Any]) -> Real | None:
    """Share of the waves that run in the rolling direction, of a surface with the keys of a lay; None without them.

    Parameters
    ----------
    numbers : mapping
        Numbers and words of the surface by the names of their keys.

    Returns
    -------
    Real or None
        :func:`asperity.surface.lay.rolling_share` [-].
    """
    if "lay_ratio" not in numbers:
        return numbers.get("rolling_share")
    return rolling_share(length_ratio=numbers["lay_ratio"], grooves=numbers["lay"])
