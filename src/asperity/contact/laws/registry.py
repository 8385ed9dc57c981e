"""All contact laws by their names: those of the modules in this folder."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator

from asperity.contact import laws
from asperity.contact.laws.law import ContactLaw, file_of


def _found() -> Iterator[type[ContactLaw]]:
    """The laws that the modules of this folder define."""
    for module in pkgutil.iter_modules(laws.__path__, f"{laws.__name__}."):
        for member in vars(importlib.import_module(module.name)).values():
            is_law = isinstance(member, type) and issubclass(member, ContactLaw) and not member.abstract
            if is_law and member.__module__ == module.name:
                yield member


def _by_name() -> dict[str, type[ContactLaw]]:
    """Name → law, from the one that knows least of the surface; a ``TypeError`` names the file of a mistake."""
    found = sorted(_found(), key=lambda law: (law.rank, law.name))
    default: dict[str, type[ContactLaw]] = {}
    for law in found:
        if law.name != law.__module__.rpartition(".")[2]:
            raise TypeError(
                f"{file_of(law)}: the contact law {law.name} stands in a file that is named after it"
            )
        for key in law.default_for:
            if key in default:
                raise TypeError(
                    f"{file_of(law)}: files with {key} have the contact law {default[key].name} already"
                )
            default[key] = law
    return {law.name: law for law in found}


#: Name in ``model.contact_law`` → law, from the one that knows least of the surface.
LAWS: dict[str, type[ContactLaw]] = _by_name()


def law_for(key: str) -> type[ContactLaw]:
    """The law of a surface with a key in a file that states no law."""
    return next(law for law in LAWS.values() if key in law.default_for)
