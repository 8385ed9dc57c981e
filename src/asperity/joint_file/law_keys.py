"""Keys of [surface] that contact laws state themselves, as fields of that section."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, create_model

from asperity.contact.laws.law import ContactLaw, SurfaceKey, file_of
from asperity.contact.laws.registry import LAWS
from asperity.errors import InputError
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.section import Section
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import unit_exponents

_KEYS = {key.name: key for law in LAWS.values() for key in law.keys}
#: Key → laws that state it, from the one that knows least.
LAWS_OF_KEY: dict[str, list[type[ContactLaw]]] = {
    name: [law for law in LAWS.values() if key in law.keys] for name, key in _KEYS.items()
}
#: Those without which their law knows no surface.
LAW_OF_KEY: dict[str, type[ContactLaw]] = {
    name: laws[0] for name, laws in LAWS_OF_KEY.items() if name in laws[0].needs
}
#: Those that a file may leave out: key → what it is at a contact that does so beside another one that does not.
ABSENT: dict[str, float | str | None] = {
    name: key.absent for name, key in _KEYS.items() if name not in LAW_OF_KEY
}
#: Key → the key without which it says nothing.
BESIDE = {name: key.beside for name, key in _KEYS.items() if key.beside}
#: Key → keys beside which it cannot stand.
RIVALS: dict[str, set[str]] = {}
for _name, _stated in _KEYS.items():
    for _other in _stated.in_place_of:
        RIVALS.setdefault(_name, set()).add(_other)
        RIVALS.setdefault(_other, set()).add(_name)


def _kind(law: type[ContactLaw], stated: SurfaceKey) -> Any:
    """The type of the field of a key."""
    if stated.choices:
        return Literal[stated.choices]
    return Annotated[Quantity, _key(law, stated)]


def _key(law: type[ContactLaw], stated: SurfaceKey) -> Key:
    """The key of a joint file; a ``TypeError`` names the file of a law that states what is none."""
    said = f"{file_of(law)}: the contact law {law.name} states surface.{stated.name}"
    dimension = Dimension.__members__.get(stated.dimension.upper())
    if dimension is None:
        known = ", ".join(name.lower() for name in Dimension.__members__)
        raise TypeError(f"{said} of the dimension {stated.dimension!r}; known are {known}")
    if stated.unit != "1" and unit_exponents(stated.unit) != dimension.exponents:
        raise TypeError(f"{said}, {dimension.label}, in {stated.unit!r}, which is no unit of it")
    return Key(
        dimension, stated.lower, stated.upper, stated.unit, example=stated.example, reason=stated.reason
    )


def _fields() -> Document:
    """Fields of all keys that laws state."""
    fields: Document = {}
    known: dict[str, SurfaceKey] = {}
    for law in LAWS.values():
        for stated in law.keys:
            if known.setdefault(stated.name, stated) is not stated:  # laws may share one
                raise TypeError(
                    f"{file_of(law)}: surface.{stated.name} is a key of the contact law "
                    f"{LAWS_OF_KEY[stated.name][0].name} already"
                )
            fields[stated.name] = (_kind(law, stated) | None, Field(default=None, description=stated.meaning))
    return fields


if TYPE_CHECKING:

    class _Stated(Section):
        """Keys that contact laws state."""

    LawKeys = _Stated

else:
    LawKeys = create_model("LawKeys", __base__=Section, __module__=__name__, **_fields())


def refuse_halves(stated: Collection[str]) -> None:
    """Raise an ``InputError`` for a key that says nothing without one that is missing, or not beside another one."""
    for key, rivals in RIVALS.items():
        both = sorted(rivals.intersection(stated))
        if key in stated and both:
            raise InputError(
                f".{key}: it stands in place of {' and '.join(both)}: leave it out, or {' and '.join(both)}"
            )
    for key, beside in BESIDE.items():
        if key in stated and beside not in stated:
            choices = _KEYS[beside].choices
            example = " or ".join(f'"{word}"' for word in choices) or f"e.g. {_KEYS[beside].example}"
            raise InputError(
                f".{beside}: this key is missing, without which {key} says nothing: give {example}, or leave {key} out"
            )


def refuse_keys_of_others(surfaces: Collection[Collection[str]], law: str) -> None:
    """Raise an ``InputError`` for keys that other laws take than that of the joint."""
    lost = [
        key for key in ABSENT if any(key in keys for keys in surfaces) and LAWS[law] not in LAWS_OF_KEY[key]
    ]
    if lost:
        takers = ", ".join(taker.name for taker in LAWS_OF_KEY[lost[0]])
        raise InputError(
            f"surface.{lost[0]}: the contact law {law} takes no {' and no '.join(lost)}, only {takers} do: leave "
            f"{' and '.join(lost)} out, or state the surface and model.contact_law for one of those"
        )


def refuse_unknown_keys(known: set[str]) -> None:
    """Raise a ``TypeError`` with the file of a law that needs what [surface] does not have."""
    for law in LAWS.values():
        unknown = [key for key in (*law.needs, *law.default_for) if key not in known]
        if unknown:
            raise TypeError(
                f"{file_of(law)}: the contact law {law.name} takes {', '.join(unknown)}, which is no key of "
                "[surface]: state it in its keys"
            )
