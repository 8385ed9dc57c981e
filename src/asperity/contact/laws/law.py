"""What a contact law is: one surface of two bodies, what its asperities do under load, and what is said of the law.

A law is a class in a module of this folder that has its name. Its numbers are those of one contact. What it does not
state is found when the module is imported: no branch elsewhere asks which law it is.
"""

from __future__ import annotations

import dataclasses
import math
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple, Self

from asperity.contact.asperity import AsperityBase
from asperity.contact.exponential import lay_stiffness_ratio
from asperity.contact.interface import RoughContact
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.materials import ContactPair
from asperity.types import Real

if TYPE_CHECKING:
    from asperity.contact.felt_contacts import FeltContacts
    from asperity.surface.measured_roughness import MeasuredRoughness

#: What of a measured surface goes into a joint file for a law: D, G and gamma; the rms of the heights that each contact
#: feels; the decay length of each contact, which the law finds itself; or nothing.
FromMeasurement = Literal["fractal", "heights", "decay_length", "nothing"]

#: The keys of a joint file for each of them.
_OF_MEASUREMENT: dict[FromMeasurement, tuple[str, ...]] = {
    "fractal": ("fractal_dimension", "fractal_roughness", "frequency_ratio"),
    "heights": ("rms_height",),
    "decay_length": ("decay_length",),
    "nothing": (),
}
#: What every law states → what that is.
_STATED = {
    "name": "its name in model.contact_law",
    "rank": "its place among the laws side by side",
    "meaning": "what it is, in a few words",
    "assumes": "the sentences that stand under Assumed",
    "needs": "the keys of a surface that it takes",
    "needs_words": "what those are, in words",
    "default_for": "the keys for which it is the law of a file that states none",
    "from_measurement": "what of a measured surface it takes",
    "slip_exponent": "the exponent of its tangential stiffness",
    "has_spots": "whether it knows the sizes of the spots",
    "over_boundary_elements": "its stiffness over that of boundary elements",
    "error": "the same as a sentence that says on which surfaces",
    "of_surface": "how it is made from the numbers of a surface",
    "rough_contact": "stiffnesses and areas under load",
}
#: Which of them are tuples of texts.
_TUPLES = ("assumes", "needs", "default_for")
#: What else laws state that take the rms of the heights or a decay length, since their interval holds their error.
_SOFTER = {"softer": "the same surface with asperities that yield more"}
#: What else laws state that take the heights or the waves of a measured surface.
_RATIOS = {"decay_ratios": "decay lengths on a measured surface"}


#: Number in SI units, its unit and digits → text, of a room that knows units.
Quantity = Callable[[float, str, int], str]


class SurfaceKey(NamedTuple):
    """A number of [surface] that no other law takes: a key of joint files while the law is there.

    ``dimension``: its kind by the name in :class:`asperity.unit_table.Dimension`, "length"; ``lower`` and ``upper``,
    the range that catches errors of typing, in ``unit``; ``example``: text that messages quote. A key that is not among
    the ``needs`` of the law may be left out. ``choices``: the words of a key that is no number, whose ``dimension`` is
    "choice". ``absent``: what it is at a contact that does not state it where another one does. ``beside``: the key
    without which it says nothing. ``reason``: why nothing below the range is possible, and what to do.
    ``in_place_of``: keys beside which it cannot stand.
    """

    name: str
    meaning: str
    dimension: str
    unit: str = "1"
    lower: float = 0.0
    upper: float = 0.0
    example: str = ""
    choices: tuple[str, ...] = ()
    absent: float | str | None = None
    beside: str = ""
    reason: str = ""
    in_place_of: tuple[str, ...] = ()


class DecayRatios(NamedTuple):
    """Decay lengths on a measured surface.

    ``ratios``: contact → decay length over the rms of the heights that it feels, lower end, itself and upper end [-];
    ``told``: what was taken, one sentence each; ``states``: contact → how it touches, for one that has no gaps.
    """

    ratios: dict[str, tuple[float, float, float]]
    told: tuple[str, ...]
    states: dict[str, str]


class PressedRollers(Module):
    """Rollers under load, as a contact law is given them; numbers and arrays that broadcast. SI units.

    Parameters
    ----------
    normal_force, tangential_force : Real
        N, and T >= 0 [N].
    friction_coefficient : Real
        mu [-].
    moduli : ContactPair
        Moduli and hardness of the two materials.
    contact_length, effective_radius : Real
        Of the line contact [m].
    contact_factor : Real
        lambda of the population of spots [-], :func:`asperity.contact.population.contact_factor`.
    """

    normal_force: Real
    tangential_force: Real
    friction_coefficient: Real
    moduli: ContactPair
    contact_length: Real
    effective_radius: Real
    contact_factor: Real


class ContactLaw(Module):
    """The equivalent surface of both bodies of a contact, and the law of its asperities.

    A law that does not state everything below is a ``TypeError`` when its class is defined; ``abstract=True`` marks
    what several laws share.
    """

    #: Its name in ``model.contact_law``, and that of its module.
    name: ClassVar[str]
    #: Place among the laws side by side: the one that knows least of the surface has the smallest.
    rank: ClassVar[int]
    #: What it is in a few words, which follow its name.
    meaning: ClassVar[str]
    #: What stands under *Assumed* wherever it is the law, one sentence each.
    assumes: ClassVar[tuple[str, ...]]
    #: The same where the surface is stated by its Ra.
    assumes_of_average: ClassVar[str] = ""
    #: What is added about rolling, where the law has no local form.
    in_rolling: ClassVar[str] = ""
    #: Keys of [surface], or what follows from an Ra there, that :meth:`of_surface` takes.
    needs: ClassVar[tuple[str, ...]]
    #: The same in words.
    needs_words: ClassVar[str]
    #: Those of them that no joint file has without the law.
    keys: ClassVar[tuple[SurfaceKey, ...]] = ()
    #: Keys of [surface] for which it is the law of a file that states none; empty for a law that has to be asked for.
    default_for: ClassVar[tuple[str, ...]]
    from_measurement: ClassVar[FromMeasurement]
    #: n of the tangential stiffness before gross slip, in proportion to :math:`(1 - T/\mu N)^n` [-].
    slip_exponent: ClassVar[float]
    #: Whether it knows spots: their largest and critical area, and the real area of contact.
    has_spots: ClassVar[bool]
    #: Its stiffness over that of boundary elements on measured surfaces, from and to [-]; :doc:`/validity`.
    over_boundary_elements: ClassVar[tuple[float, float]]
    #: The same as a sentence, with the surfaces on which it was found.
    error: ClassVar[str]

    def __init_subclass__(cls, *, abstract: bool = False, **options: Any) -> None:
        super().__init_subclass__(**options)
        cls.abstract = abstract
        if abstract:
            return
        by_length = {"rms_height", "decay_length"}.intersection(getattr(cls, "needs", ()))
        measured = getattr(cls, "from_measurement", "") in ("heights", "decay_length")
        asked = _STATED | (_SOFTER if by_length else {}) | (_RATIOS if measured else {})
        missing = [f"{name} ({what})" for name, what in asked.items() if not _states(cls, name)]
        said = f"{file_of(cls)}: the contact law {cls.__name__}"
        if missing:
            raise TypeError(f"{said} does not state {', '.join(missing)}")
        texts = [name for name in _TUPLES if not isinstance(getattr(cls, name), tuple)]
        if texts:
            raise TypeError(f"{said} states {', '.join(texts)}, which is a tuple, in another way")
        given = _OF_MEASUREMENT[cls.from_measurement]
        if given and not set(cls.needs) <= set(given):
            raise TypeError(
                f"{said} needs {', '.join(cls.needs)}, while from_measurement = {cls.from_measurement!r} gives "
                f"{', '.join(given)}"
            )

    #: Whether it is no law, but what several laws share.
    abstract: ClassVar[bool] = True

    @classmethod
    def of_surface(cls, numbers: Mapping[str, Any], *, asperity_base: AsperityBase) -> Self:
        """The law on the surface of one contact.

        Parameters
        ----------
        numbers : mapping
            Key of :attr:`needs` → its number in SI units; those of :attr:`keys` that are stated, words among them.
        asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
            ``model.asperity_base`` of the joint file.
        """
        raise NotImplementedError

    def rough_contact(self, rollers: PressedRollers) -> RoughContact:
        """Stiffnesses, and spots and load shares where the law has them, of rollers under load."""
        raise NotImplementedError

    def stiffness_ratio(self, moduli: ContactPair, *, along_axis: bool = False) -> Real:
        """Tangential over normal stiffness of the asperities without slip, in the rolling direction or along the axis.

        Parameters
        ----------
        moduli : ContactPair
            Of the two materials.
        along_axis : bool, optional
            Whether the force acts along the rollers' axis.

        Returns
        -------
        Real
            :math:`4G^*/E^*` without grooves [-].
        """
        return lay_stiffness_ratio(
            contact_modulus=moduli.contact_modulus,
            tangential_contact_modulus=moduli.tangential_contact_modulus,
            share=None,
        )

    def softer(self, factor: Real) -> Self:
        """The same surface with asperities that yield ``factor`` times as much [-], for the ends of an interval."""
        raise NotImplementedError

    @classmethod
    def refuse(cls, measured: MeasuredRoughness) -> None:
        """Raise an ``InputError`` for a measured surface that lacks what this law takes, before anything is solved."""

    @classmethod
    def decay_ratios(
        cls, measured: MeasuredRoughness, contacts: FeltContacts, quantity: Quantity
    ) -> DecayRatios:
        """Decay lengths of contacts on a measured surface; an ``InputError`` where it does not serve the law."""
        raise InputError(
            f'model.contact_law = "{cls.name}" takes no measured surface: leave contact_law out, or state '
            f"{', '.join(cls.needs)} in [surface] in place of a measurement"
        )

    def with_numbers(self, **numbers: Real) -> Self:
        """The same law with other numbers of the surface."""
        return dataclasses.replace(self, **numbers)

    def number(self, name: str) -> Real:
        """A number of the surface by its name; nan where this law has no such number."""
        return getattr(self, name) if name in self.number_fields else math.nan


def _states(law: type[ContactLaw], member: str) -> bool:
    """Whether a law or what it shares with others states a member."""
    return any(member in vars(kind) for kind in law.__mro__ if kind is not ContactLaw)


def file_of(law: type[ContactLaw]) -> str:
    """The file in which a law stands."""
    return getattr(sys.modules.get(law.__module__), "__file__", None) or law.__module__
