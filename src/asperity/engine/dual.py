r"""Numbers with slopes: exact derivatives of the formula code under NumPy, in forward mode.

.. math:: f(x + \dot x\,\varepsilon) = f(x) + f'(x)\,\dot x\,\varepsilon, \qquad \varepsilon^2 = 0

References: A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, chapter 3.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence

import numpy as np

from asperity.engine.arrays import OwnNumber, complex_number, special
from asperity.engine.arrays import any_xp as xp
from asperity.types import Number


class Dual(OwnNumber):
    """An array of floats with its slopes in some directions, each an array of its shape, or None for a slope of 0.

    Derivatives of derivatives have levels: a number of a lower level is a constant at a higher one, and the value of
    one may be a number with slopes of a lower level itself.
    """

    __slots__ = ("level", "slopes", "value")
    rank = 2

    def __init__(self, value: Number, slopes: Sequence[Number], level: int) -> None:
        self.value, self.slopes, self.level = value, slopes, level

    @classmethod
    def function(cls, name: str) -> Callable[..., Number]:
        """The function of this name with slopes."""
        return _with_slopes(name)

    @property
    def shape(self) -> tuple[int, ...]:
        return _shape(plain(self))

    @property
    def ndim(self) -> int:
        return len(self.shape)

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    @property
    def dtype(self) -> Number:
        return np.dtype(float)

    @property
    def T(self) -> Number:  # noqa: N802 - NumPy's name
        return _each(self, lambda part: part.T)

    def __len__(self) -> int:
        return self.shape[0]

    def __iter__(self) -> Number:
        return (self[i] for i in range(self.shape[0]))

    def __getitem__(self, place: Number) -> Number:
        return _each(self, lambda part: part[place])

    @property
    def real(self) -> Number:
        return _each(self, lambda part: part.real)

    @property
    def imag(self) -> Number:
        return _each(self, lambda part: part.imag)

    def astype(self, kind: Number) -> Number:
        return self if np.dtype(kind).kind in "fc" else plain(self).astype(kind)

    def reshape(self, *shape: Number) -> Number:
        return _each(self, lambda part: part.reshape(*shape))

    def ravel(self) -> Number:
        return _each(self, lambda part: part.ravel())

    def sum(self, axis: Number = None) -> Number:
        return _each(self, lambda part: part.sum(axis=axis))

    def mean(self, axis: Number = None) -> Number:
        return _each(self, lambda part: part.mean(axis=axis))

    def max(self, axis: Number = None) -> Number:
        return xp.max(self, axis=axis)

    def min(self, axis: Number = None) -> Number:
        return xp.min(self, axis=axis)

    def __neg__(self) -> Number:
        return _each(self, lambda part: -part)

    def __pos__(self) -> Number:
        return self

    def __abs__(self) -> Number:
        return xp.abs(self)

    def __add__(self, other: Number) -> Number:
        if type(other) is Dual:
            return _sum(self, other)
        value = self.value + other
        return Dual(value, _as_broad(self, value), self.level)

    __radd__ = __add__

    def __sub__(self, other: Number) -> Number:
        return self + -other

    def __rsub__(self, other: Number) -> Number:
        return -self + other

    def __mul__(self, other: Number) -> Number:
        if type(other) is Dual:
            return _product(self, other)
        slopes = [None if slope is None else slope * other for slope in self.slopes]
        return Dual(self.value * other, slopes, self.level)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Number:
        if type(other) is Dual:
            return _quotient(self, other)
        slopes = [None if slope is None else slope / other for slope in self.slopes]
        return Dual(self.value / other, slopes, self.level)

    def __rtruediv__(self, other: Number) -> Number:
        return _quotient(other, self)

    def __pow__(self, other: Number) -> Number:
        return xp.power(self, other)

    def __rpow__(self, other: Number) -> Number:
        return xp.power(other, self)

    def __matmul__(self, other: Number) -> Number:
        return xp.matmul(self, other)

    def __rmatmul__(self, other: Number) -> Number:
        return xp.matmul(other, self)

    def __lt__(self, other: Number) -> Number:
        return plain(self) < plain(other)

    def __le__(self, other: Number) -> Number:
        return plain(self) <= plain(other)

    def __gt__(self, other: Number) -> Number:
        return plain(self) > plain(other)

    def __ge__(self, other: Number) -> Number:
        return plain(self) >= plain(other)

    def __eq__(self, other: object) -> Number:
        return plain(self) == plain(other)

    def __ne__(self, other: object) -> Number:
        return plain(self) != plain(other)

    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        return bool(plain(self))


def plain(number: Number) -> Number:
    """A number without slopes of any level; what has none, as it is."""
    while isinstance(number, Dual):
        number = number.value
    return number


def highest_level(numbers: Iterable[Number]) -> int:
    """Highest level among numbers and lists of them; 0 where none has slopes."""
    level = 0
    for number in numbers:
        if type(number) is Dual:
            level = max(level, number.level)
        elif isinstance(number, list | tuple):
            level = max(level, highest_level(number))
    return level


def value_at(number: Number, level: int) -> Number:
    """A number without its slopes of this level, which is the highest that it has."""
    return number.value if type(number) is Dual and number.level == level else number


def constant_at(number: Number, level: int) -> Number:
    """A number without its slopes of this level, whatever others it has."""
    if type(number) is not Dual or number.level < level:
        return number
    if number.level == level:
        return number.value
    slopes = [None if slope is None else constant_at(slope, level) for slope in number.slopes]
    return Dual(constant_at(number.value, level), slopes, number.level)


def slopes_at(number: Number, level: int, count: int) -> Sequence[Number]:
    """Slopes of a number at a level in so many directions; None where it is a constant."""
    return number.slopes if type(number) is Dual and number.level == level else (None,) * count


def directions_at(numbers: Iterable[Number], level: int) -> int:
    """In how many directions numbers have slopes at a level."""
    for number in numbers:
        if type(number) is Dual and number.level == level:
            return len(number.slopes)
        if isinstance(number, list | tuple):
            count = directions_at(number, level)
            if count:
                return count
    return 0


def _each(number: Dual, function: Callable[[Number], Number]) -> Dual:
    """A linear function of one number."""
    slopes = [None if slope is None else function(slope) for slope in number.slopes]
    return Dual(function(number.value), slopes, number.level)


def _pair(one: Number, other: Number) -> tuple[Number, Number, int, Sequence[Number], Sequence[Number]]:
    """Values of two numbers, their highest level, and their slopes there."""
    of_one = one.level if type(one) is Dual else 0
    of_other = other.level if type(other) is Dual else 0
    if of_one == of_other:
        return one.value, other.value, of_one, one.slopes, other.slopes
    if of_one > of_other:
        return one.value, other, of_one, one.slopes, (None,) * len(one.slopes)
    return one, other.value, of_other, (None,) * len(other.slopes), other.slopes


def _added(one: Number, other: Number) -> Number:
    return other if one is None else one if other is None else one + other


def _shape(number: Number) -> tuple[int, ...]:
    """Shape of a number; of Python's own ()."""
    shape: tuple[int, ...] = getattr(number, "shape", ())
    return shape


def _shaped(slope: Number, shape: tuple[int, ...]) -> Number:
    """A slope with the shape of its value, to which other numbers may have been broadcast."""
    if slope is None or _shape(slope) == shape:
        return slope
    return xp.broadcast_to(slope, shape)


def _as_broad(number: Dual, value: Number) -> Sequence[Number]:
    """Slopes of a number to which a constant was added, which may have broadcast it to a value."""
    shape = _shape(value)
    if _shape(number.value) == shape:
        return number.slopes
    return [_shaped(slope, shape) for slope in number.slopes]


def _sum(one: Number, other: Number) -> Number:
    a, b, level, first, second = _pair(one, other)
    value = a + b
    shape = _shape(value)
    slopes = [_shaped(_added(s, t), shape) for s, t in zip(first, second, strict=True)]
    return Dual(value, slopes, level)


def _product(one: Number, other: Number) -> Number:
    a, b, level, first, second = _pair(one, other)
    slopes = [
        (None if s is None else s * b) if t is None else a * t if s is None else s * b + a * t
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(a * b, slopes, level)


def _quotient(one: Number, other: Number) -> Number:
    a, b, level, first, second = _pair(one, other)
    value = a / b
    slopes = [
        (None if s is None else s / b) if t is None else value * t / -b if s is None else (s - value * t) / b
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(value, slopes, level)


def _nothing(value: Number) -> np.ndarray:
    return np.zeros(_shape(plain(value)))


#: Slopes of functions of one number, of the value and the argument.
_OF_ONE: dict[str, Callable[[Number, Number], Number]] = {
    "sqrt": lambda value, x: 0.5 / value,
    "cbrt": lambda value, x: value / (3.0 * x),
    "exp": lambda value, x: value,
    "expm1": lambda value, x: value + 1.0,
    "log": lambda value, x: 1.0 / x,
    "log1p": lambda value, x: 1.0 / (1.0 + x),
    "sin": lambda value, x: xp.cos(x),
    "cos": lambda value, x: -xp.sin(x),
    "tan": lambda value, x: 1.0 + value * value,
    "arcsin": lambda value, x: 1.0 / xp.sqrt(1.0 - x * x),
    "arccos": lambda value, x: -1.0 / xp.sqrt(1.0 - x * x),
    "arctan": lambda value, x: 1.0 / (1.0 + x * x),
    "tanh": lambda value, x: 1.0 - value * value,
    "arcsinh": lambda value, x: 1.0 / xp.sqrt(1.0 + x * x),
    "arctanh": lambda value, x: 1.0 / (1.0 - x * x),
    "square": lambda value, x: 2.0 * x,
    "erf": lambda value, x: 2.0 / math.sqrt(math.pi) * xp.exp(-x * x),
    "erfc": lambda value, x: -2.0 / math.sqrt(math.pi) * xp.exp(-x * x),
    "gamma": lambda value, x: value * special.digamma(x),
    "digamma": lambda value, x: special.polygamma(1, _constant(x)),
}
#: Slopes of functions of two numbers, of the value and both arguments.
_OF_TWO: dict[str, tuple[Callable[..., Number], Callable[..., Number]]] = {
    "power": (lambda v, x, y: y * x ** (y - 1.0), lambda v, x, y: v * xp.log(xp.where(x > 0.0, x, 1.0))),
    "hypot": (lambda v, x, y: x / v, lambda v, x, y: y / v),
    "arctan2": (lambda v, y, x: x / (x * x + y * y), lambda v, y, x: -y / (x * x + y * y)),
    "maximum": (lambda v, x, y: _share(x, y), lambda v, x, y: _share(y, x)),
    "minimum": (lambda v, x, y: _share(y, x), lambda v, x, y: _share(x, y)),
    "logaddexp": (lambda v, x, y: xp.exp(x - v), lambda v, x, y: xp.exp(y - v)),
    "mod": (lambda v, x, y: 1.0, lambda v, x, y: -xp.floor(plain(x) / plain(y))),
}
#: Functions that are linear in the arrays of their first argument, which may be a list of them.
_LINEAR = (
    {"mean", "cumsum", "trace", "negative", "real"}
    | {"array", "asarray", "atleast_1d", "stack", "concatenate", "block", "column_stack", "split"}
    | {"reshape", "ravel", "expand_dims", "squeeze", "moveaxis", "swapaxes", "transpose", "flip"}
    | {"broadcast_to", "tile", "repeat", "diag", "diagonal", "take_along_axis"}
)
_BILINEAR = {"multiply", "matmul", "tensordot", "outer", "dot", "cross"}
#: Functions of the values alone, without slopes.
_OF_VALUES = (
    {"isfinite", "isnan", "isinf", "any", "all", "sign", "floor"}
    | {"argmax", "argmin", "argsort", "searchsorted"}
    | {"shape", "ndim", "size", "broadcast_shapes", "zeros_like", "ones_like"}
)


def _constant(number: Number) -> Number:
    """A number without slopes; a slope of what comes of it is not known."""
    if isinstance(number, Dual):
        raise NotImplementedError("derivatives of the gamma function beyond the second are not known here")
    return number


def _share(larger: Number, smaller: Number) -> Number:
    """1 where the first number is larger, a half where both are alike."""
    one, other = plain(larger), plain(smaller)
    return xp.where(one > other, 1.0, xp.where(one == other, 0.5, 0.0))


def _with_slopes(name: str) -> Callable[..., Number]:
    """A function of numbers with slopes."""
    if name in _OWN:
        return _OWN[name]
    if name in _OF_VALUES:
        return lambda *given, **options: getattr(xp, name)(*(_plain_inside(one) for one in given), **options)
    if name in _OF_ONE:
        return lambda x, *rest: _of_one(name, x, *rest)
    if name in _OF_TWO:
        return lambda x, y: _of_two(name, x, y)
    if name in _LINEAR:
        return lambda x, *rest, **options: _linear(name, x, *rest, **options)
    if name in _BILINEAR:
        return lambda x, y, **options: _bilinear(name, x, y, **options)

    def unknown(*_: Number, **__: Number) -> Number:
        raise NotImplementedError(f"the slope of {name} is not known to asperity.engine.arrays")

    return unknown


def _plain_inside(argument: Number) -> Number:
    """An argument without slopes, and so the members of a list."""
    if isinstance(argument, list | tuple):
        return type(argument)(map(_plain_inside, argument))
    return plain(argument)


def _of_one(name: str, x: Dual) -> Dual:
    value = getattr(special if name in ("erf", "erfc", "gamma", "digamma") else xp, name)(x.value)
    slope = _OF_ONE[name](value, x.value)
    return Dual(value, [None if along is None else slope * along for along in x.slopes], x.level)


def _of_two(name: str, x: Number, y: Number) -> Dual:
    a, b, level, first, second = _pair(x, y)
    value = getattr(xp, name)(a, b)
    shape = _shape(value)
    by_first, by_second = _OF_TWO[name]
    first_slope = by_first(value, a, b) if any(s is not None for s in first) else None
    second_slope = by_second(value, a, b) if any(s is not None for s in second) else None
    slopes = [
        _shaped(
            _added(None if s is None else first_slope * s, None if t is None else second_slope * t), shape
        )
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(value, slopes, level)


def _taken(argument: Number, take: Callable[[Number], Number]) -> Number:
    """An argument, or each array in its lists, replaced."""
    if isinstance(argument, list | tuple):
        return [_taken(one, take) for one in argument]
    return take(argument)


def _linear(name: str, x: Number, *rest: Number, **options: Number) -> Number:
    function, level = getattr(xp, name), highest_level([x])
    value = function(_taken(x, lambda one: value_at(one, level)), *rest, **options)

    def along(k: int) -> Number:
        def slope(one: Number) -> Number:
            found = one.slopes[k] if type(one) is Dual and one.level == level else None
            return _nothing(one) if found is None else found

        if type(x) is Dual and x.slopes[k] is None:
            return None
        return function(_taken(x, slope), *rest, **options)

    slopes = [along(k) for k in range(directions_at([x], level))]
    if isinstance(value, list):  # the parts of a split
        return [
            Dual(part, [None if slope is None else slope[i] for slope in slopes], level)
            for i, part in enumerate(value)
        ]
    return Dual(value, slopes, level)


def _bilinear(name: str, x: Number, y: Number, **options: Number) -> Dual:
    function = getattr(xp, name)
    a, b, level, first, second = _pair(x, y)
    slopes = [
        _added(
            None if s is None else function(s, b, **options), None if t is None else function(a, t, **options)
        )
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(function(a, b, **options), slopes, level)


def _where(condition: Number, x: Number, y: Number) -> Number:
    condition = plain(condition)
    a, b, level, first, second = _pair(x, y)
    value = xp.where(condition, a, b)
    shape = _shape(value)
    slopes = [
        None
        if s is None and t is None
        else _shaped(xp.where(condition, 0.0 if s is None else s, 0.0 if t is None else t), shape)
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(value, slopes, level)


def _clip(x: Number, lower: Number = None, upper: Number = None) -> Number:
    above = x if lower is None else xp.maximum(x, lower)
    return above if upper is None else xp.minimum(above, upper)


def _extreme(name: str) -> Callable[..., Number]:
    """The largest or the smallest number along axes; numbers alike share its slope, as JAX has it."""

    def extreme(x: Number, axis: Number = None) -> Number:
        find = getattr(xp, name)
        alike = xp.where(plain(x) == find(plain(x), axis=axis, keepdims=True), 1.0, 0.0)
        share = alike / xp.sum(alike, axis=axis, keepdims=True)
        slopes = [None if slope is None else xp.sum(share * slope, axis=axis) for slope in x.slopes]
        return Dual(find(x.value, axis=axis), slopes, x.level)

    return extreme


def _broadcast_arrays(*given: Number) -> list[Number]:
    shape = np.broadcast_shapes(*(_shape(plain(one)) for one in given))
    return [xp.broadcast_to(one, shape) for one in given]


def _full_like(x: Number, value: Number, **options: Number) -> Number:
    return (
        xp.full_like(plain(x), value, **options)
        if type(value) is not Dual
        else xp.broadcast_to(value, x.shape)
    )


def _full(shape: Number, value: Number) -> Number:
    return xp.broadcast_to(value, shape)


def _select(conditions: Sequence[Number], choices: Sequence[Number], default: Number = 0.0) -> Number:
    for condition, choice in zip(reversed(conditions), reversed(choices), strict=True):
        default = xp.where(condition, choice, default)
    return default


def _norm(x: Number, axis: int | None = None) -> Number:
    return xp.sqrt(xp.sum(x * x, axis=axis))


def _einsum(rule: str, *given: Number) -> Number:
    level = highest_level(given)
    values = [value_at(one, level) for one in given]
    slopes = []
    for k in range(directions_at(given, level)):
        total = None
        for i, one in enumerate(given):
            slope = slopes_at(one, level, k + 1)[k]
            if slope is not None:
                total = _added(total, xp.einsum(rule, *values[:i], slope, *values[i + 1 :]))
        slopes.append(total)
    return Dual(xp.einsum(rule, *values), slopes, level)


def _nan_kept(x: Number, y: Number) -> Number:
    # of numbers alike the second one, as JAX has it
    return xp.where(xp.isnan(plain(y)) | (plain(x) > plain(y)), x, y)


def _complex(real: Number, imaginary: Number) -> Number:
    a, b, level, first, second = _pair(real, imaginary)
    slopes = [
        None if s is None and t is None else complex_number(0.0 if s is None else s, 0.0 if t is None else t)
        for s, t in zip(first, second, strict=True)
    ]
    return Dual(complex_number(a, b), slopes, level)


def _absolute(x: Dual) -> Dual:
    value = xp.abs(x.value)
    if getattr(plain(x), "dtype", np.dtype(float)).kind != "c":
        slope = xp.where(plain(x) >= 0.0, 1.0, -1.0)  # at 0 as JAX has it
        return Dual(value, [None if along is None else slope * along for along in x.slopes], x.level)
    real, imag = x.value.real, x.value.imag
    slopes = [
        None if along is None else (real * along.real + imag * along.imag) / value for along in x.slopes
    ]
    return Dual(value, slopes, x.level)


def _each_apart(
    x: Dual, name: str, rest: tuple[Number, ...], options: dict[str, Number], of_slopes: dict[str, float]
) -> Dual:
    """A linear function of a number, and of its slopes without the constants that options add."""
    function = getattr(xp, name)
    without = options | {key: value for key, value in of_slopes.items() if key in options}
    slopes = [None if slope is None else function(slope, *rest, **without) for slope in x.slopes]
    return Dual(function(x.value, *rest, **options), slopes, x.level)


_OWN: dict[str, Callable[..., Number]] = {
    "where": _where,
    "clip": _clip,
    "max": _extreme("max"),
    "min": _extreme("min"),
    "broadcast_arrays": _broadcast_arrays,
    "full_like": _full_like,
    "full": _full,
    "select": _select,
    "norm": _norm,
    "einsum": _einsum,
    "fmax": _nan_kept,
    "abs": _absolute,
    "complex_number": _complex,
    "pad": lambda x, widths, **options: _each_apart(x, "pad", (widths,), options, {"constant_values": 0.0}),
    "diff": lambda x, *rest, **options: _each_apart(
        x, "diff", rest, options, {"prepend": 0.0, "append": 0.0}
    ),
    "sum": lambda x, *rest, **options: _each_apart(x, "sum", rest, options, {"initial": 0.0}),
    "add": _sum,
    "subtract": lambda x, y: _sum(x, -y),
    "divide": _quotient,
}
