"""Many numbers at once under NumPy: what is written for one joint computes with the first axis of arrays in parallel.

As :func:`jax.vmap`, for a few torques of one joint: a loop over tens of small arrays costs as much as one array of all.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.lib.array_utils import normalize_axis_index

from asperity.engine import trees
from asperity.engine.arrays import OwnNumber, complex_number, uses_jax
from asperity.engine.arrays import any_xp as xp
from asperity.engine.dual import Dual
from asperity.types import Number


class Many(OwnNumber):
    """Arrays of one shape, stacked along the first axis of ``values``."""

    __slots__ = ("values",)
    rank = 1

    def __init__(self, values: Number) -> None:
        self.values = values

    @classmethod
    def function(cls, name: str) -> Callable[..., Number]:
        """The function of this name, of each of the arrays."""
        return _of_each(name)

    @property
    def shape(self) -> tuple[int, ...]:
        shape: tuple[int, ...] = self.values.shape[1:]
        return shape

    @property
    def ndim(self) -> int:
        return int(self.values.ndim) - 1

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    @property
    def dtype(self) -> Number:
        return self.values.dtype

    @property
    def T(self) -> Number:  # noqa: N802 - NumPy's name
        return Many(self.values.transpose(0, *range(self.values.ndim - 1, 0, -1)))

    @property
    def real(self) -> Number:
        return Many(self.values.real)

    @property
    def imag(self) -> Number:
        return Many(self.values.imag)

    def __len__(self) -> int:
        return self.shape[0]

    def __iter__(self) -> Number:
        return (self[i] for i in range(self.shape[0]))

    def __getitem__(self, place: Number) -> Number:
        parts = place if isinstance(place, tuple) else (place,)
        if any(isinstance(part, Many) and part.dtype == bool for part in parts):
            raise TypeError("conditions of many numbers choose different places of each; use xp.where")
        if any(isinstance(part, Many) for part in parts) or _is_apart(parts):
            return one_by_one(lambda array, *at: array[at], (self, *parts))
        return Many(self.values[(slice(None), *parts)])

    def astype(self, kind: Number) -> Number:
        return Many(self.values.astype(kind))

    def reshape(self, *shape: Number) -> Number:
        given = shape[0] if len(shape) == 1 and isinstance(shape[0], tuple) else shape
        return Many(self.values.reshape(len(self.values), *given))

    def ravel(self) -> Number:
        return self.reshape(-1)

    def sum(self, axis: Number = None) -> Number:
        return Many(self.values.sum(axis=_axis(self, axis)))

    def mean(self, axis: Number = None) -> Number:
        return Many(self.values.mean(axis=_axis(self, axis)))

    def max(self, axis: Number = None) -> Number:
        return Many(self.values.max(axis=_axis(self, axis)))

    def min(self, axis: Number = None) -> Number:
        return Many(self.values.min(axis=_axis(self, axis)))

    def all(self, axis: Number = None) -> Number:
        return Many(self.values.all(axis=_axis(self, axis)))

    def any(self, axis: Number = None) -> Number:
        return Many(self.values.any(axis=_axis(self, axis)))

    def __neg__(self) -> Number:
        return Many(-self.values)

    def __pos__(self) -> Number:
        return self

    def __abs__(self) -> Number:
        return Many(abs(self.values))

    def __invert__(self) -> Number:
        return Many(~self.values)

    def __bool__(self) -> bool:
        raise TypeError("many numbers at once have no truth value; branch with asperity.engine.control.cond")

    def __add__(self, other: Number) -> Number:
        return _operation(np.add, self, other)

    __radd__ = __add__

    def __sub__(self, other: Number) -> Number:
        return _operation(np.subtract, self, other)

    def __rsub__(self, other: Number) -> Number:
        return _operation(np.subtract, other, self)

    def __mul__(self, other: Number) -> Number:
        return _operation(np.multiply, self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Number:
        return _operation(np.divide, self, other)

    def __rtruediv__(self, other: Number) -> Number:
        return _operation(np.divide, other, self)

    def __pow__(self, other: Number) -> Number:
        return _operation(np.power, self, other)

    def __rpow__(self, other: Number) -> Number:
        return _operation(np.power, other, self)

    def __and__(self, other: Number) -> Number:
        return _operation(np.logical_and, self, other)

    __rand__ = __and__

    def __or__(self, other: Number) -> Number:
        return _operation(np.logical_or, self, other)

    __ror__ = __or__

    def __lt__(self, other: Number) -> Number:
        return _operation(np.less, self, other)

    def __le__(self, other: Number) -> Number:
        return _operation(np.less_equal, self, other)

    def __gt__(self, other: Number) -> Number:
        return _operation(np.greater, self, other)

    def __ge__(self, other: Number) -> Number:
        return _operation(np.greater_equal, self, other)

    def __eq__(self, other: object) -> Number:
        return _operation(np.equal, self, other)

    def __ne__(self, other: object) -> Number:
        return _operation(np.not_equal, self, other)

    __hash__ = None  # type: ignore[assignment]

    def __matmul__(self, other: Number) -> Number:
        return _matmul(self, other)

    def __rmatmul__(self, other: Number) -> Number:
        return _matmul(other, self)


def many(modules: Number) -> Number:
    """Modules of arrays as many modules at once, along the first axis of each array."""
    return trees.map(lambda leaf: Many(np.asarray(leaf)), modules)


def together(module: Number, count: int, axis: int = 0) -> Number:
    """The arrays of many modules, stacked along an axis; what is the same for all is repeated."""

    def stacked(leaf: Number) -> Number:
        if isinstance(leaf, Dual):
            slopes = [None if slope is None else stacked(slope) for slope in leaf.slopes]
            return Dual(stacked(leaf.value), slopes, leaf.level)
        return np.moveaxis(_values(leaf, count), 0, axis)

    return trees.map(stacked, module)


def chosen(conditions: Many, yes: Number, no: Number) -> Number:
    """One of two modules for each condition."""
    return trees.map(lambda one, other: xp.where(conditions, one, other), yes, no)


def _values(number: Number, count: int) -> Number:
    """Values of many numbers; of one as often as there are many."""
    if isinstance(number, Many):
        return number.values
    return np.broadcast_to(np.asarray(number), (count, *np.shape(number)))


def _ndim(number: Number) -> int:
    if type(number) is Many:
        return number.values.ndim - 1
    return (
        number.ndim if type(number) is np.ndarray else 0 if type(number) in _SCALARS else int(np.ndim(number))
    )


def aligned(number: Number, ndim: int) -> Number:
    """Values with axes of length 1 after the first, so that the others stand under those of arrays of more axes."""
    if not isinstance(number, Many):
        return number
    values = number.values
    missing = ndim - values.ndim + 1
    return values.reshape(values.shape[0], *(1,) * missing, *values.shape[1:]) if missing > 0 else values


#: Numbers without axes.
_SCALARS = frozenset({float, int, bool, np.float64, np.int64, np.bool_})


def _operation(function: Callable[..., Number], one: Number, other: Number) -> Number:
    """An elementwise function of two numbers, at least one of them many."""
    kind, other_kind = type(one), type(other)
    if kind is Many:
        if other_kind is Many:
            if one.values.ndim == other.values.ndim:
                return Many(function(one.values, other.values))
        elif other_kind in _SCALARS or (other_kind is np.ndarray and other.ndim < one.values.ndim):
            return Many(function(one.values, other))
    elif kind in _SCALARS or (kind is np.ndarray and one.ndim < other.values.ndim):
        return Many(function(one, other.values))
    if isinstance(one, OwnNumber) and isinstance(other, OwnNumber) and one.rank != other.rank:
        return NotImplemented  # the number of higher rank computes
    uses_jax((one, other))  # which refuses both together
    ndim = max(_ndim(one), _ndim(other))
    return Many(function(aligned(one, ndim), aligned(other, ndim)))


def _count(given: Number) -> int:
    """How many numbers there are in arguments."""
    for argument in given:
        if isinstance(argument, Many):
            return len(argument.values)
        if isinstance(argument, list | tuple):
            count = _count(argument)
            if count:
                return count
    return 0


def _axis(number: Number, axis: Number) -> Number:
    """An axis of the values for one of the numbers."""
    if axis is None:
        return tuple(range(1, number.values.ndim))
    if isinstance(axis, tuple):
        return tuple(_axis(number, each) for each in axis)
    return 1 + normalize_axis_index(axis, number.values.ndim - 1)


def _is_apart(parts: tuple[Number, ...]) -> bool:
    """Whether arrays of places, and numbers beside them, stand apart: NumPy puts their axes first then."""
    if not any(isinstance(part, np.ndarray | list) for part in parts):
        return False
    chosen_by = [i for i, part in enumerate(parts) if isinstance(part, np.ndarray | list | int | np.integer)]
    return chosen_by[-1] - chosen_by[0] >= len(chosen_by)


def _of_each(name: str) -> Callable[..., Number]:
    """A function of many numbers."""
    if name in _OWN:
        return _OWN[name]
    function: Number = getattr(np, name, None)
    if isinstance(function, np.ufunc) or name in ("where", "isreal"):
        return lambda *given: _elementwise(function, given)
    if name in ("sum", "mean", "max", "min", "any", "all", "prod"):
        return lambda x, axis=None, **options: Many(function(x.values, axis=_axis(x, axis), **options))
    return lambda *given, **options: one_by_one(_function(name), given, options)


def _function(name: str) -> Callable[..., Number]:
    """A function by its name, of NumPy, of its linear algebra, or of SciPy."""
    for place in (np, np.linalg):
        if hasattr(place, name):
            return getattr(place, name)
    from scipy import special

    return getattr(special, name)


def _elementwise(function: Number, given: tuple[Number, ...]) -> Number:
    if len(given) == 2:
        return _operation(function, *given)
    ndim = 0
    for one in given:
        ndim = max(ndim, _ndim(one))
    return Many(function(*[aligned(one, ndim) for one in given]))


def one_by_one(
    function: Callable[..., Number], given: tuple[Number, ...], options: dict[str, Number] | None = None
) -> Number:
    """A function of arguments of which some are many numbers: one call for each of them."""
    options = options or {}
    count = _count((*given, *options.values()))

    def entry(argument: Number, i: int) -> Number:
        if isinstance(argument, list | tuple):
            return type(argument)([entry(one, i) for one in argument])
        return argument.values[i] if isinstance(argument, Many) else argument

    results = [
        function(
            *(entry(one, i) for one in given), **{key: entry(value, i) for key, value in options.items()}
        )
        for i in range(count)
    ]
    if isinstance(results[0], list | tuple):
        return [Many(np.stack(parts)) for parts in zip(*results, strict=True)]
    return Many(np.stack(results))


def _joined(name: str) -> Callable[..., Number]:
    """``stack`` or ``concatenate`` along an axis."""

    def joined(given: Number, axis: int = 0) -> Many:
        count = _count(given)
        values = [_values(one, count) for one in given]
        axes = values[0].ndim - (name == "concatenate")
        return Many(getattr(np, name)(values, axis=1 + normalize_axis_index(axis, axes)))

    return joined


def _cumsum(x: Many, axis: int | None = None) -> Many:
    if axis is None:
        return Many(np.cumsum(x.values.reshape(len(x.values), -1), axis=1))
    return Many(np.cumsum(x.values, axis=_axis(x, axis)))


def _extreme_place(name: str) -> Callable[..., Number]:
    def place(x: Many, axis: int | None = None) -> Many:
        if axis is None:
            return Many(getattr(np, name)(x.values.reshape(len(x.values), -1), axis=1))
        return Many(getattr(np, name)(x.values, axis=_axis(x, axis)))

    return place


def _broadcast_to(x: Many, shape: Number) -> Many:
    given = (shape,) if isinstance(shape, int) else tuple(shape)
    return Many(np.broadcast_to(aligned(x, len(given)), (len(x.values), *given)))


def _broadcast_arrays(*given: Number) -> list[Number]:
    shape = np.broadcast_shapes(*(getattr(one, "shape", np.shape(one)) for one in given))
    return [xp.broadcast_to(one, shape) for one in given]


def _matmul(one: Number, other: Number) -> Number:
    row, column = _ndim(one) == 1, _ndim(other) == 1
    if not (_ndim(one) and _ndim(other)):
        raise ValueError("matmul: a number without axes is no matrix")
    a = one[None, :] if row else one
    b = other[:, None] if column else other
    ndim = max(_ndim(a), _ndim(b))
    product = np.matmul(aligned(a, ndim), aligned(b, ndim))
    if column:
        product = product[..., 0]
    if row:
        product = product[..., 0] if column else product[..., 0, :]
    return Many(product)


def _block(rows: Number) -> Number:
    nested = all(isinstance(row, list | tuple) for row in rows)
    if not nested or any(isinstance(each, list | tuple) or _ndim(each) != 2 for row in rows for each in row):
        return one_by_one(np.block, (rows,))
    whole = [xp.concatenate(list(row), axis=-1) for row in rows]
    return xp.concatenate(whole, axis=-2)


def _asarray(given: Number, dtype: Number = None) -> Number:
    if isinstance(given, list | tuple):
        return xp.stack([xp.asarray(one) for one in given])
    return given if dtype is None else given.astype(dtype)


def _diag(x: Many) -> Number:
    if x.ndim == 1:
        places = np.arange(x.shape[0])
        matrices = np.zeros((len(x.values), *x.shape * 2), dtype=x.dtype)
        matrices[:, places, places] = x.values
        return Many(matrices)
    return Many(np.diagonal(x.values, axis1=1, axis2=2))


def _solve(matrix: Number, right_side: Number) -> Number:
    if _ndim(matrix) != 2 or _ndim(right_side) != 1:
        return one_by_one(np.linalg.solve, (matrix, right_side))
    count = _count((matrix, right_side))
    return Many(np.linalg.solve(_values(matrix, count), _values(right_side, count)[..., None])[..., 0])


def _reshape(x: Many, shape: Number) -> Number:
    return x.reshape(*((shape,) if isinstance(shape, int) else shape))


def _split(x: Many, places: Number, axis: int = 0) -> list[Many]:
    return [Many(part) for part in np.split(x.values, places, axis=_axis(x, axis))]


def _take_along_axis(x: Number, place: Number, axis: int) -> Many:
    count = _count((x, place))
    return Many(
        np.take_along_axis(
            _values(x, count), _values(place, count), axis=1 + normalize_axis_index(axis, _ndim(x))
        )
    )


def _clip(x: Number, lower: Number = None, upper: Number = None) -> Number:
    above = x if lower is None else xp.maximum(x, lower)
    return above if upper is None else xp.minimum(above, upper)


def _like(fill: float) -> Callable[..., Number]:
    def like(x: Many, dtype: Number = None) -> np.ndarray:
        return np.full(x.shape, fill, dtype=x.dtype if dtype is None else dtype)

    return like


def _full_like(x: Number, value: Number, dtype: Number = None) -> Number:
    return xp.broadcast_to(xp.asarray(value, dtype=x.dtype if dtype is None else dtype), x.shape)


def _pad(x: Many, widths: Number, **options: Number) -> Many:
    each = np.broadcast_to(np.asarray(widths), (x.ndim, 2))
    return Many(np.pad(x.values, ((0, 0), *map(tuple, each)), **options))


def _repeat(x: Many, times: Number, axis: int | None = None) -> Many:
    if axis is None:
        return Many(np.repeat(x.values.reshape(len(x.values), -1), times, axis=1))
    return Many(np.repeat(x.values, times, axis=_axis(x, axis)))


def _expand_dims(x: Many, axis: int) -> Many:
    return Many(np.expand_dims(x.values, 1 + normalize_axis_index(axis, x.values.ndim)))


def _norm(x: Many, axis: int | None = None) -> Number:
    return xp.sqrt(xp.sum(x * x, axis=axis))


def _take(table: Number, place: Number, axis: int, mode: str) -> Number:
    if isinstance(table, Many) or axis != 0:
        return one_by_one(np.take, (table, place), {"axis": axis, "mode": mode})
    found: Number = np.take
    return Many(found(table, place.values, axis=0, mode=mode))


_OWN: dict[str, Callable[..., Number]] = {
    "stack": _joined("stack"),
    "concatenate": _joined("concatenate"),
    "argmax": _extreme_place("argmax"),
    "argmin": _extreme_place("argmin"),
    "cumsum": _cumsum,
    "complex_number": lambda real, imaginary: _operation(complex_number, real, imaginary),
    "broadcast_to": _broadcast_to,
    "broadcast_arrays": _broadcast_arrays,
    "broadcast_shapes": np.broadcast_shapes,
    "matmul": _matmul,
    "block": _block,
    "asarray": _asarray,
    "array": _asarray,
    "diag": _diag,
    "diagonal": lambda x: _diag(x),
    "solve": _solve,
    "reshape": _reshape,
    "ravel": lambda x: x.ravel(),
    "split": _split,
    "take_along_axis": _take_along_axis,
    "clip": _clip,
    "abs": lambda x: abs(x),
    "shape": lambda x: x.shape,
    "ndim": lambda x: x.ndim,
    "zeros_like": _like(0.0),
    "ones_like": _like(1.0),
    "full_like": _full_like,
    "full": lambda shape, value: _broadcast_to(value, shape),
    "pad": _pad,
    "repeat": _repeat,
    "expand_dims": _expand_dims,
    "norm": _norm,
    "transpose": lambda x: x.T,
    "take": _take,
}
