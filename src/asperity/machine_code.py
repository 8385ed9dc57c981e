"""What the machine code of a program says of itself, without being loaded.

JAX keeps machine code as a pickle, which could name anything that runs. Here nothing of it is made.
"""

from __future__ import annotations

import io
import pickle
import sys
from typing import Any, NamedTuple

import numpy as np


class _Unmade:
    """What a pickle makes where only its names are looked at: the arguments of a class, and its state."""

    arguments: tuple[Any, ...]
    state: Any

    def __new__(cls, *arguments: Any, **named: Any) -> _Unmade:
        made = object.__new__(cls)
        made.arguments, made.state = arguments, None
        return made

    def __setstate__(self, state: Any) -> None:
        self.state = state


class _Names(pickle.Unpickler):
    """A pickle of which nothing is made but types of numbers.

    ValueError if it names more than classes of JAX and what JAX reads them by.
    """

    def find_class(self, module: str, name: str) -> Any:
        named = getattr(sys.modules.get(module), name, None)
        of_jax = getattr(named, "__module__", "").partition(".")[0] in ("jax", "jaxlib")
        if named is not np.dtype and not (
            of_jax and (isinstance(named, type) or name.startswith("_unpickle_"))
        ):
            raise ValueError(f"{module}.{name} is no part of machine code")
        return named if named is np.dtype else _Unmade

    def persistent_load(self, pid: Any) -> Any:
        return None


def check_names(machine_code: bytes) -> None:
    """ValueError if machine code names more than classes of JAX and what JAX reads them by."""
    _Names(io.BytesIO(machine_code)).load()


class Said(NamedTuple):
    """Name of a program, and shape and type of each of its results, as JSON states them."""

    name: str
    kinds: list[tuple[list[int], str]]


def said(machine_code: bytes) -> Said | None:
    """What machine code says; None for what is none, or is that of another release of JAX."""
    try:
        unloaded, *_ = _Names(io.BytesIO(machine_code)).load()
        _, parts = unloaded.state
        shapes = [result.arguments[:2] for result in parts["output_avals"]]
        return Said(parts["name"], [(list(shape), str(dtype)) for shape, dtype in shapes])
    except Exception:  # whatever damage leads to
        return None
