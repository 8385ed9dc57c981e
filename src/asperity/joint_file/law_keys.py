"""Keys of [surface] that contact laws state themselves, as fields of that section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from pydantic import Field, create_model

from asperity.contact.laws.law import ContactLaw, SurfaceKey, file_of
from asperity.contact.laws.registry import LAWS
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.section import Section
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import unit_exponents

#: Key → law that states it.
LAW_OF_KEY: dict[str, type[ContactLaw]] = {key.name: law for law in LAWS.values() for key in law.keys}


def _key(law: type[ContactLaw], stated: SurfaceKey) -> Key:
    """The key of a joint file; a ``TypeError`` names the file of a law that states what is none."""
    said = f"{file_of(law)}: the contact law {law.name} states surface.{stated.name}"
    dimension = Dimension.__members__.get(stated.dimension.upper())
    if dimension is None:
        known = ", ".join(name.lower() for name in Dimension.__members__)
        raise TypeError(f"{said} of the dimension {stated.dimension!r}; known are {known}")
    if stated.unit != "1" and unit_exponents(stated.unit) != dimension.exponents:
        raise TypeError(f"{said}, {dimension.label}, in {stated.unit!r}, which is no unit of it")
    return Key(dimension, stated.lower, stated.upper, stated.unit, example=stated.example)


def _fields() -> Document:
    """Fields of all keys that laws state."""
    fields: Document = {}
    for law in LAWS.values():
        for stated in law.keys:
            if stated.name in fields:
                raise TypeError(
                    f"{file_of(law)}: surface.{stated.name} is a key of the contact law "
                    f"{LAW_OF_KEY[stated.name].name} already"
                )
            kind = Annotated[Quantity, _key(law, stated)] | None
            fields[stated.name] = (kind, Field(default=None, description=stated.meaning))
    return fields


if TYPE_CHECKING:
    LawKeys = Section
else:
    LawKeys = create_model("LawKeys", __base__=Section, __module__=__name__, **_fields())


def refuse_unknown_keys(known: set[str]) -> None:
    """Raise a ``TypeError`` with the file of a law that needs what [surface] does not have."""
    for law in LAWS.values():
        unknown = [key for key in (*law.needs, *law.default_for) if key not in known]
        if unknown:
            raise TypeError(
                f"{file_of(law)}: the contact law {law.name} takes {', '.join(unknown)}, which is no key of "
                "[surface]: state it in its keys"
            )
