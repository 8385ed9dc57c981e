"""Frozen modules of numbers: dataclasses that a formula takes and returns, and that JAX knows where it is there.

A field is a number, an array, or a module, tuple or dictionary of these, or None; :func:`static` fields select what to
compute and are no numbers.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, ClassVar, dataclass_transform

import numpy as np

from asperity.engine.jax_import import when_jax_is_imported


def static(**options: Any) -> Any:
    """A field that is no number: a text, a tuple of texts, or another value that can be compared and hashed."""
    return dataclasses.field(metadata={"static": True}, **options)


#: Modules of which JAX does not know yet.
_KINDS: list[type[Module]] = []
#: Not empty once JAX knows the others.
_JAX_KNOWS: list[bool] = []


@dataclass_transform(frozen_default=True, field_specifiers=(static, dataclasses.field))
class Module:
    """Base of the modules of numbers: every subclass is a frozen dataclass, compared by their numbers."""

    #: Names of the fields with numbers, and of the static ones.
    number_fields: ClassVar[tuple[str, ...]] = ()
    static_fields: ClassVar[tuple[str, ...]] = ()

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        dataclasses.dataclass(frozen=True, eq=False)(cls)
        fields = dataclasses.fields(cls)  # type: ignore[arg-type]
        cls.number_fields = tuple(field.name for field in fields if not field.metadata.get("static"))
        cls.static_fields = tuple(field.name for field in fields if field.metadata.get("static"))
        _KINDS.append(cls)
        if _JAX_KNOWS:
            _tell_jax()

    def __eq__(self, other: object) -> bool:
        """Whether the other module is of the same kind and has the same numbers."""
        return (
            type(self) is type(other)
            and all(getattr(self, name) == getattr(other, name) for name in self.static_fields)
            and all(same_numbers(getattr(self, name), getattr(other, name)) for name in self.number_fields)
        )

    def __hash__(self) -> int:
        return hash((type(self), *(getattr(self, name) for name in self.static_fields)))


def same_numbers(one: Any, other: Any) -> bool:
    """Whether two trees have the same structure and the same numbers."""
    if isinstance(one, _HOLDERS) or isinstance(other, _HOLDERS):
        if type(one) is not type(other):
            return False
        if isinstance(one, Module):
            return bool(one == other)
        if isinstance(one, dict):
            return one.keys() == other.keys() and all(same_numbers(one[key], other[key]) for key in one)
        return len(one) == len(other) and all(map(same_numbers, one, other))
    if one is None or other is None:
        return one is other
    return bool(np.array_equal(one, other))


#: What is no number but holds some.
_HOLDERS = (Module, tuple, list, dict)


class Partial(Module):
    """A function whose first arguments are known modules of numbers, as one module: :class:`jax.tree_util.Partial`."""

    function: Callable[..., Any] = static()
    numbers: tuple[Any, ...]

    def __call__(self, *others: Any) -> Any:
        """The function of the known and of other arguments."""
        return self.function(*self.numbers, *others)


def _tell_jax() -> None:
    """Let JAX know the modules that it does not know yet."""
    import jax

    if not _JAX_KNOWS:
        _JAX_KNOWS.append(True)
    while _KINDS:
        kind = _KINDS.pop()
        jax.tree_util.register_dataclass(
            kind, data_fields=list(kind.number_fields), meta_fields=list(kind.static_fields)
        )


when_jax_is_imported(_tell_jax)
