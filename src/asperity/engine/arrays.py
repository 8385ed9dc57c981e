"""Functions of arrays that compute with what their arguments are: NumPy's arrays, JAX's, or numbers of our own.

``xp`` has the functions of :mod:`jax.numpy` by their names. One of them looks at the types of its arguments, which
takes a tenth of a microsecond each, and calls NumPy's function of this name where all are NumPy's or Python's.
Constants are therefore NumPy's; JAX takes them as constants of its programs. Numbers of our own bring their functions
along (:class:`OwnNumber`): numbers with slopes (:mod:`asperity.engine.dual`) and many at once
(:mod:`asperity.engine.many`).
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from asperity.engine import trees
from asperity.types import Number

#: What is NumPy's or Python's own, and therefore neither an array of JAX nor a number of ours.
_PLAIN = frozenset(
    {
        np.ndarray,
        *(np.float64, np.float32, np.int64, np.int32, np.int8, np.uint8, np.bool_, np.complex128),
        *(float, int, bool, complex, str, type(None), type(Ellipsis), type, slice, range),
        *(type(np.dtype(kind)) for kind in (float, int, bool)),
    }
)


class OwnNumber:
    """Base of the numbers that are neither NumPy's nor JAX's; of two kinds in one function the one of higher rank."""

    __slots__ = ()
    __array_ufunc__ = None  # NumPy's operators leave it to those of these classes
    rank: ClassVar[int] = 0

    @classmethod
    def function(cls, name: str) -> Callable[..., Number]:
        """The function of :mod:`numpy` of this name, for arguments of which some are of this kind."""
        raise NotImplementedError

    def __array__(self, *_: Number, **__: Number) -> np.ndarray:
        raise TypeError("this is no array of NumPy; compute with asperity.engine.arrays.xp")


class MeetsJaxError(TypeError):
    """A number of our own meets one of JAX's, which cannot compute with it."""


def is_of_jax(number: Number) -> bool:
    """Whether a number is an array of JAX, or stands for one in a program; False where nobody has imported JAX."""
    if type(number) in _PLAIN:
        return False
    jax = sys.modules.get("jax")
    return jax is not None and isinstance(number, getattr(jax, "Array", ()))


def uses_jax(*modules: Number) -> bool:
    """Whether an array of JAX is among the leaves of modules of numbers.

    Raises
    ------
    MeetsJaxError
        If a number of our own is among them as well.
    """
    if "jax" not in sys.modules:
        return False
    leaves = trees.leaves(modules)
    if not any(map(is_of_jax, leaves)):
        return False
    refuse_own(leaves)
    return True


def refuse_own(numbers: Iterable[Number]) -> None:
    """Raise :class:`MeetsJaxError` if a number of our own is among those that JAX is to compute with."""
    if any(isinstance(number, OwnNumber) for number in numbers):
        raise MeetsJaxError("numbers with slopes, or many at once, meet an array of JAX")


def as_numbers(tree: Number) -> Number:
    """A module of numbers with NumPy's floats as its leaves: what one joint is computed with."""
    return trees.map(lambda leaf: np.asarray(leaf, dtype=float), tree)


def _kind(arguments: Iterable[Number]) -> type[OwnNumber] | str | None:
    """What computes: ``jax``, a kind of our own numbers, or None for NumPy."""
    own: type[OwnNumber] | None = None
    for argument in arguments:
        kind: Number = type(argument)
        if kind in _PLAIN:
            continue
        if isinstance(argument, tuple | list):
            kind = _kind(argument)
            if kind is None:
                continue
            if kind == "jax":
                return kind
        elif not issubclass(kind, OwnNumber):
            if is_of_jax(argument):
                return "jax"
            continue
        if own is None or kind.rank > own.rank:
            own = kind
    return own


class _Arrays:
    """The functions of one module of NumPy and of the module of JAX with a name, by their names."""

    def __init__(self, of_numpy: Number, of_jax: str) -> None:
        self._of_numpy, self._of_jax = of_numpy, of_jax

    def __getattr__(self, name: str) -> Number:
        found = getattr(self._of_numpy, name)
        if name == "linalg":
            found = _Arrays(np.linalg, "jax.numpy.linalg")
        elif callable(found) and not isinstance(found, type):
            found = _choosing(found, self._of_jax, name)
        setattr(self, name, found)
        return found


def _choosing(of_numpy: Callable[..., Number], library: str, name: str) -> Callable[..., Number]:
    """One function of both libraries, and of our own numbers."""
    of_own: dict[type[OwnNumber], Callable[..., Number]] = {}

    def function(*arguments: Number, **options: Number) -> Number:
        own: Number = None
        for argument in arguments:
            kind: Number = type(argument)
            if kind in _PLAIN:
                continue
            if kind not in of_own:
                break
            if own is None or kind.rank > own.rank:
                own = kind
        else:
            if not options:
                return of_numpy(*arguments) if own is None else of_own[own](*arguments)
        own = _kind((*arguments, *options.values()) if options else arguments)
        if own is None:
            return of_numpy(*arguments, **options)
        if own == "jax":
            refuse_own(trees.leaves((arguments, options)))
            return getattr(importlib.import_module(library), name)(*arguments, **options)
        if own not in of_own:
            of_own[own] = own.function(name)
        return of_own[own](*arguments, **options)

    return function


class _Special:
    """Functions of :mod:`scipy.special` and of the same of JAX, which NumPy lacks; imported when they are called."""

    def __getattr__(self, name: str) -> Number:
        if name.startswith("_"):
            raise AttributeError(name)

        def of_scipy(*arguments: Number) -> Number:
            return getattr(importlib.import_module("scipy.special"), name)(*arguments)

        setattr(self, name, _choosing(of_scipy, "jax.scipy.special", name))
        return getattr(self, name)


#: The same functions without types, for what is no array.
any_xp: Number = _Arrays(np, "jax.numpy")
special: Number = _Special()
if TYPE_CHECKING:
    import jax.numpy as xp
else:
    xp = any_xp


def complex_number(real: Number, imaginary: Number) -> Number:
    """A complex number of its parts."""
    if is_of_jax(real) or is_of_jax(imaginary):
        import jax

        return jax.lax.complex(*jax.numpy.broadcast_arrays(real, imaginary))
    own = _kind((real, imaginary))
    if own is not None and not isinstance(own, str):
        return own.function("complex_number")(real, imaginary)
    number = np.empty(np.broadcast_shapes(np.shape(real), np.shape(imaginary)), dtype=complex)
    number.real, number.imag = real, imaginary  # a sum would make nan of an infinite part
    return number


def as_complex(real: Number) -> Number:
    """Real numbers as complex ones: JAX does not convert them by itself where it is strict."""
    return complex_number(real, any_xp.zeros_like(real))


def entry_of(table: Number, place: Number) -> Number:
    """Entries of a table of constants at places that are computed, from 0 on."""
    return any_xp.take(np.asarray(table), place, axis=0, mode="clip")
