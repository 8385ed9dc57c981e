"""Numbers with slopes: those of JAX, function by function, also of slopes and of many numbers at once."""

import itertools
import operator

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from libraries import OF_JAX, OURS

from asperity.engine import dual, trees
from asperity.engine.arrays import complex_number, xp
from asperity.engine.control import vectorised
from asperity.engine.derivatives import value_and_slope, value_and_slopes
from asperity.engine.dual import Dual

# as many numbers at once as the axes are long: an axis taken for another changes numbers, not only shapes
COUNT = 3
SHAPES = {"s": (), "v": (3,), "c": (3, 1), "m": (3, 3), "t": (3, 3, 3), "r": (2, 3)}
PLACES = np.array([[2, 0, 1], [0, 0, 2], [1, 1, 0]])
MATRIX = np.array([[0.3, -1.2, 2.0], [0.7, 0.1, -0.4], [-0.9, 1.1, 0.6]])
ROW = MATRIX[1]

# name: the numbers (+: positive ones), and what is computed with a library and with them
CASES = {
    **{
        name: [("m", lambda m, x, name=name: getattr(m, name)(x))]
        for name in [
            "abs",
            "cbrt",
            "exp",
            "expm1",
            "log1p",
            "sin",
            "cos",
            "tan",
            "arcsin",
            "arccos",
            "arctan",
            "tanh",
            "arctanh",
            "square",
            "erf",
            "erfc",
            "arcsinh",
        ]
    },
    **{name: [("+m", lambda m, x, name=name: getattr(m, name)(x))] for name in ("sqrt", "log", "gamma")},
    "power": [
        ("+m v", lambda m, x, y: m.power(x, y)),
        ("+v m", lambda m, x, y: x**y),
        ("m", lambda m, x: x**2),
        ("m", lambda m, x: x**3),
        ("m", lambda m, x: m.power(x, -2)),
        ("+m", lambda m, x: x**-0.5),
        ("v", lambda m, x: 2.0**x),
        ("v", lambda m, x: m.power(np.array([0.5, 3.0, 7.0]), x)),
    ],
    "logaddexp": [("m v", lambda m, x, y: m.logaddexp(x, y)), ("v", lambda m, x: m.logaddexp(0.0, x))],
    "hypot": [("m v", lambda m, x, y: m.hypot(x, y)), ("v", lambda m, x: m.hypot(2.0, x))],
    "arctan2": [("m v", lambda m, x, y: m.arctan2(x, y)), ("v", lambda m, x: m.arctan2(x, -0.5))],
    "maximum": [("m v", lambda m, x, y: m.maximum(x, y)), ("m", lambda m, x: m.maximum(0.1, x))],
    "minimum": [("c v", lambda m, x, y: m.minimum(x, y)), ("m", lambda m, x: m.minimum(x, 0.1))],
    "mod": [("m +v", lambda m, x, y: m.mod(x, y)), ("m", lambda m, x: m.mod(x, 0.25))],
    # linear
    "sum": [
        ("m", lambda m, x: m.sum(x)),
        ("t", lambda m, x: m.sum(x, axis=1)),
        ("t", lambda m, x: m.sum(x, axis=(0, -1))),
        ("m", lambda m, x: m.sum(x, axis=-1, keepdims=True)),
        ("t", lambda m, x: x.sum()),
        ("t", lambda m, x: x.sum(axis=0)),
        ("s", lambda m, x: m.sum(x)),
    ],
    "mean": [
        ("m", lambda m, x: m.mean(x)),
        ("t", lambda m, x: m.mean(x, axis=-2)),
        ("m", lambda m, x: x.mean()),
        ("t", lambda m, x: x.mean(axis=1)),
    ],
    "stack": [
        ("m m", lambda m, x, y: m.stack([x, y])),
        ("m m", lambda m, x, y: m.stack([x, MATRIX, y], axis=1)),
        ("v", lambda m, x: m.stack([x[0], x[1]], axis=-1)),
        ("m", lambda m, x: m.stack([m.stack([x, x]), m.stack([2.0 * x, MATRIX])], axis=-1)),
    ],
    "concatenate": [
        ("m v", lambda m, x, y: m.concatenate([x, y[None], MATRIX])),
        ("m c", lambda m, x, y: m.concatenate([x, MATRIX, y], axis=-1)),
        ("t m", lambda m, x, y: m.concatenate((x, y[:, None, :]), axis=1)),
    ],
    "block": [
        ("m c", lambda m, x, y: m.block([[x, y], [y.T, np.ones((1, 1))]])),
        ("m m", lambda m, x, y: m.block([[x, MATRIX], [MATRIX, y]])),
    ],
    "column_stack": [("v m", lambda m, x, y: m.column_stack([x, y, ROW]))],
    "broadcast_to": [
        ("v", lambda m, x: m.broadcast_to(x, (3, 3))),
        ("c", lambda m, x: m.broadcast_to(x, (3, 3, 3))),
        ("s", lambda m, x: m.broadcast_to(x, (3,))),
    ],
    "reshape": [
        ("m", lambda m, x: m.reshape(x, (9,))),
        ("m", lambda m, x: m.reshape(x, (3, 1, 3))),
        ("m", lambda m, x: x.reshape(1, -1)),
        ("m", lambda m, x: x.reshape((9, 1))),
        ("v", lambda m, x: x[:1].reshape(())),
    ],
    "ravel": [("m", lambda m, x: m.ravel(x)), ("t", lambda m, x: x.ravel())],
    "moveaxis": [("t", lambda m, x: m.moveaxis(x, 0, -1)), ("t", lambda m, x: m.moveaxis(x, -1, 0))],
    "swapaxes": [("t", lambda m, x: m.swapaxes(x, 0, 1)), ("t", lambda m, x: m.swapaxes(x, -1, -2))],
    "transpose": [("t", lambda m, x: m.transpose(x)), ("m", lambda m, x: x.T), ("t", lambda m, x: x.T)],
    "tile": [("v", lambda m, x: m.tile(x, 2)), ("m", lambda m, x: m.tile(x, (2, 1)))],
    "repeat": [("m", lambda m, x: m.repeat(x, 2)), ("m", lambda m, x: m.repeat(x, 2, axis=1))],
    "pad": [
        ("v", lambda m, x: m.pad(x, (1, 2))),
        ("m", lambda m, x: m.pad(x, ((0, 1), (2, 0)))),
        ("m", lambda m, x: m.pad(x, 1, mode="edge")),
    ],
    "split": [
        ("m", lambda m, x: m.split(x, [1])),
        ("m", lambda m, x: m.split(x, [1, 2], axis=-1)),
        ("t", lambda m, x: m.split(x, 3, axis=1)),
    ],
    "diag": [("v", lambda m, x: m.diag(x)), ("m", lambda m, x: m.diag(x))],
    "diagonal": [("m", lambda m, x: m.diagonal(x))],
    "asarray": [
        ("m", lambda m, x: m.asarray(x)),
        ("v", lambda m, x: m.asarray([x[0], 2.0, x[2]])),
        ("s s", lambda m, x, y: m.asarray([x, y])),
    ],
    "array": [("v", lambda m, x: m.array(x)), ("s s", lambda m, x, y: m.array([x, y, x]))],
    "diff": [("m", lambda m, x: m.diff(x)), ("m", lambda m, x: m.diff(x, axis=0))],
    "atleast_1d": [("s", lambda m, x: m.atleast_1d(x)), ("m", lambda m, x: m.atleast_1d(x))],
    "real": [("m", lambda m, x: m.real(x)), ("m", lambda m, x: x.real), ("m", lambda m, x: x.imag)],
    "negative": [("m", lambda m, x: m.negative(x)), ("m", lambda m, x: -x), ("m", lambda m, x: +x)],
    "expand_dims": [("m", lambda m, x: m.expand_dims(x, 1)), ("m", lambda m, x: m.expand_dims(x, -1))],
    "squeeze": [("c", lambda m, x: m.squeeze(x, axis=1)), ("c", lambda m, x: m.squeeze(x))],
    "flip": [("m", lambda m, x: m.flip(x, axis=0)), ("m", lambda m, x: m.flip(x))],
    "cumsum": [
        ("v", lambda m, x: m.cumsum(x)),
        ("m", lambda m, x: m.cumsum(x)),
        ("m", lambda m, x: m.cumsum(x, axis=0)),
        ("t", lambda m, x: m.cumsum(x, axis=-1)),
    ],
    "take_along_axis": [
        ("m", lambda m, x: m.take_along_axis(x, PLACES, axis=1)),
        ("m", lambda m, x: m.take_along_axis(x, PLACES, axis=0)),
        ("m", lambda m, x: m.take_along_axis(x, m.argsort(x, axis=-1), axis=-1)),
    ],
    "trace": [("m", lambda m, x: m.trace(x))],
    # of two numbers, linear in each
    "multiply": [("m v", lambda m, x, y: m.multiply(x, y)), ("c v", lambda m, x, y: m.multiply(x, y))],
    "matmul": [
        ("m m", lambda m, x, y: m.matmul(x, y)),
        ("m v", lambda m, x, y: m.matmul(x, y)),
        ("v m", lambda m, x, y: x @ y),
        ("v v", lambda m, x, y: x @ y),
        ("t m", lambda m, x, y: x @ y),
        ("m t", lambda m, x, y: x @ y),
        ("t v", lambda m, x, y: x @ y),
        ("v t", lambda m, x, y: x @ y),
        ("m", lambda m, x: MATRIX @ x),
        ("m", lambda m, x: x @ ROW),
        ("v", lambda m, x: ROW @ x),
    ],
    "tensordot": [
        ("m v", lambda m, x, y: m.tensordot(x, y, axes=1)),
        ("t m", lambda m, x, y: m.tensordot(x, y, axes=((0, 2), (1, 0)))),
        ("t", lambda m, x: m.tensordot(ROW, x, axes=1)),
    ],
    "outer": [("v v", lambda m, x, y: m.outer(x, y)), ("v", lambda m, x: m.outer(x, ROW))],
    "dot": [("m v", lambda m, x, y: m.dot(x, y)), ("v v", lambda m, x, y: m.dot(x, y))],
    "cross": [("v v", lambda m, x, y: m.cross(x, y)), ("m", lambda m, x: m.cross(ROW, x))],
    # with functions of their own
    "where": [
        ("m v", lambda m, x, y: m.where(x > y, x, y)),
        ("m v", lambda m, x, y: m.where(MATRIX > 0.0, y, x)),
        ("v", lambda m, x: m.where(MATRIX > 0.0, 1.5, x)),
        ("c", lambda m, x: m.where(ROW > 0.0, x, MATRIX)),
        ("s", lambda m, x: m.where(x > 2.0, x, 0.0)),
    ],
    "clip": [
        ("m", lambda m, x: m.clip(x, -0.3, 0.4)),
        ("m", lambda m, x: m.clip(x, -0.3, None)),
        ("m", lambda m, x: m.clip(x, None, 0.4)),
        ("m +v", lambda m, x, y: m.clip(x, -y, y)),
        ("v", lambda m, x: m.clip(MATRIX, None, x)),
    ],
    "max": [
        ("m", lambda m, x: m.max(x)),
        ("t", lambda m, x: m.max(x, axis=1)),
        ("t", lambda m, x: m.max(x, axis=-1)),
        ("m", lambda m, x: x.max()),
        ("t", lambda m, x: x.max(axis=0)),
    ],
    "min": [
        ("m", lambda m, x: m.min(x)),
        ("t", lambda m, x: m.min(x, axis=1)),
        ("m", lambda m, x: x.min()),
        ("t", lambda m, x: x.min(axis=-1)),
    ],
    "broadcast_arrays": [
        ("m v", lambda m, x, y: list(m.broadcast_arrays(x, y))),
        ("s c", lambda m, x, y: list(m.broadcast_arrays(x, 2.0, ROW, y))),
    ],
    "full_like": [
        ("m s", lambda m, x, y: m.full_like(x, y)),
        ("m", lambda m, x: m.full_like(x, 2.0)),
        ("s", lambda m, x: m.full_like(MATRIX, x)),
    ],
    "full": [("s", lambda m, x: m.full((3, 3), x)), ("v", lambda m, x: m.full((3, 3), x))],
    "select": [
        ("m v", lambda m, x, y: m.select([x > 0.5, x > -0.2], [x * y, y + x], 0.5 * x)),
        ("m m", lambda m, x, y: m.select([MATRIX > 0.5, y > x], [x, y])),
    ],
    "norm": [
        ("v", lambda m, x: m.norm(x)),
        ("m", lambda m, x: m.norm(x)),
        ("m", lambda m, x: m.norm(x, axis=1)),
        ("m", lambda m, x: m.norm(x, axis=0)),
    ],
    "einsum": [
        ("m v", lambda m, x, y: m.einsum("ij,j->i", x, y)),
        ("m m", lambda m, x, y: m.einsum("ij,kj,ki->k", x, MATRIX, y)),
        ("m", lambda m, x: m.einsum("ij,jk->ik", x, x)),
    ],
    "fmax": [
        ("m v", lambda m, x, y: m.fmax(x, y)),
        ("m", lambda m, x: m.fmax(x, np.nan)),
        ("m", lambda m, x: m.fmax(np.nan, x)),
        ("v", lambda m, x: m.fmax(x, np.array([np.nan, 0.0, np.nan]))),
    ],
    "add": [("m v", lambda m, x, y: m.add(x, y)), ("v", lambda m, x: m.add(MATRIX, x))],
    "subtract": [("v m", lambda m, x, y: m.subtract(x, y)), ("v", lambda m, x: m.subtract(MATRIX, x))],
    "divide": [("c v", lambda m, x, y: m.divide(x, y)), ("v", lambda m, x: m.divide(MATRIX, x))],
    # operators and methods
    "sums": [
        ("m v", lambda m, x, y: x + y),
        ("c v", lambda m, x, y: x + y),
        ("v", lambda m, x: x + MATRIX),
        ("v", lambda m, x: MATRIX + x),
        ("v", lambda m, x: np.float64(2.0) + x + 1),
        ("c s", lambda m, x, y: 1 + x + y),
    ],
    "differences": [
        ("v m", lambda m, x, y: x - y),
        ("c v", lambda m, x, y: x - y),
        ("v", lambda m, x: x - MATRIX),
        ("v", lambda m, x: MATRIX - x),
        ("v", lambda m, x: np.float64(2.0) - x - 1),
        ("c", lambda m, x: 1 - (x - ROW)),
    ],
    "products": [
        ("v m", lambda m, x, y: x * y),
        ("c v", lambda m, x, y: x * y),
        ("v", lambda m, x: x * MATRIX),
        ("v", lambda m, x: MATRIX * x),
        ("v", lambda m, x: np.float64(2.0) * x * 3),
        ("m", lambda m, x: x * x * x),
    ],
    "quotients": [
        ("v m", lambda m, x, y: x / y),
        ("c v", lambda m, x, y: x / y),
        ("v", lambda m, x: x / MATRIX),
        ("v", lambda m, x: MATRIX / x),
        ("v", lambda m, x: np.float64(2.0) / (x / 3)),
        ("s v", lambda m, x, y: 1 / (x / y)),
    ],
    "absolute values": [("m", lambda m, x: abs(x))],
    "entries": [
        ("m", lambda m, x: x[1]),
        ("m", lambda m, x: x[:, 2]),
        ("m", lambda m, x: x[..., 1:]),
        ("m", lambda m, x: x[:, None, ::-1]),
        ("m", lambda m, x: x[np.array([2, 0]), 1]),
        ("m", lambda m, x: x[PLACES]),
        ("m", lambda m, x: x[MATRIX[0] > 0.0]),
        ("r", lambda m, x: [row * (1.0 + k) for k, row in enumerate(x)]),
        ("r", lambda m, x: [x[len(x) - 1], x * float(x.ndim), x / x.size, x + float(x.shape[1])]),
        ("m", lambda m, x: x.astype(float)),
    ],
    "several steps": [
        ("m v", lambda m, x, y: m.sum(m.sin(x @ y) * m.exp(-y / (1.0 + x * x)), axis=0) / m.norm(y)),
        (
            "+v s",
            lambda m, x, y: m.sqrt(x) * m.where(y > x, x**y, m.log(x)) + m.cumsum(x / (y + 2.0), axis=0),
        ),
    ],
}
NAMED = {f"{name} {k}": case for name, cases in CASES.items() for k, case in enumerate(cases)}


def numbers(case, seed):
    """Numbers of a case, and two directions, for each of many."""
    rng, spec = np.random.default_rng(seed), case[0].split()
    shapes = [(COUNT, *SHAPES[each.strip("+")]) for each in spec]
    at = tuple(
        rng.uniform(0.2 if each[0] == "+" else -0.9, 0.9, shape)
        for each, shape in zip(spec, shapes, strict=True)
    )
    return at, *(tuple(rng.normal(size=shape) for shape in shapes) for _ in range(2))


def only(place, directions):
    """Directions of one of the numbers alone."""
    return tuple(each if k == place else 0.0 * each for k, each in enumerate(directions))


def with_others_fixed(given):
    """Numbers of which all but the first are the same for all of many."""
    return tuple(
        tuple(each if k == 0 else np.repeat(each[:1], COUNT, axis=0) for k, each in enumerate(entry))
        for entry in given
    )


GIVEN = {name: numbers(case, seed) for seed, (name, case) in enumerate(NAMED.items())}
SETTINGS = {
    "all": lambda at, first, second: (at, first, second),
    "one and the other": lambda at, first, second: (at, only(0, first), only(1, second)),
    "the first": lambda at, first, second: (at, only(0, first), only(0, second)),
    "the second": lambda at, first, second: (at, only(1, first), only(1, second)),
    "the same for all": lambda *given: with_others_fixed(given),
}


@pytest.fixture(scope="module")
def known():
    """What JAX says of all cases: values and slopes in both directions, and the slopes of the slopes."""

    def of_all(given):
        return {
            name: jax.vmap(
                lambda at, first, second, case=case: jax.jvp(
                    lambda *x: jax.jvp(lambda *y: case[1](OF_JAX, *y), x, first), at, second
                )
            )(*given[name])
            for name, case in NAMED.items()
        }

    program = jax.jit(of_all)
    found = {}
    for setting, changed in SETTINGS.items():
        given = {name: changed(*each) for name, each in GIVEN.items()}
        found[setting] = jax.tree.map(np.asarray, program(given))
    return found


def twice(case, at, first, second):
    """Values and slopes in both directions, and the slopes of the slopes."""
    return value_and_slope(lambda *x: value_and_slope(lambda *y: case[1](OURS, *y), x, first), at, second)


def assert_alike(found, expected):
    found, expected = trees.leaves(found), trees.leaves(expected)
    for one, other in zip(found, expected, strict=True):
        assert np.shape(one) == np.shape(other)
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("name", NAMED)
def test_slopes_are_those_of_jax(name, known):
    case = NAMED[name]
    at, first, second = jax.tree.map(lambda leaf: leaf[0], GIVEN[name])
    nothing = tuple(np.zeros_like(each) for each in first)
    value, slopes = value_and_slopes(lambda *y: case[1](OURS, *y), at, [first, nothing, second])
    (expected, by_first), (by_second, _) = jax.tree.map(lambda leaf: leaf[0], known["all"][name])
    assert_alike([value, slopes[0], slopes[2]], [expected, by_first, by_second])
    assert_alike(slopes[1], jax.tree.map(np.zeros_like, expected))


@pytest.mark.parametrize("name", NAMED)
def test_slopes_of_slopes_are_those_of_jax(name, known):
    for setting, changed in SETTINGS.items():
        given, expected = jax.tree.map(lambda leaf: leaf[1], (changed(*GIVEN[name]), known[setting][name]))
        assert_alike(twice(NAMED[name], *given), expected)


@pytest.mark.parametrize("name", NAMED)
def test_slopes_of_slopes_of_many_numbers_at_once(name, known):
    for setting, changed in SETTINGS.items():
        found = vectorised(lambda *given: twice(NAMED[name], *given))(*changed(*GIVEN[name]))
        assert_alike(found, known[setting][name])


@pytest.mark.parametrize("name", [name for name, case in NAMED.items() if " " in case[0]])
def test_one_of_the_numbers_is_the_same_for_all_of_many(name, known):
    at, first, second = with_others_fixed(GIVEN[name])
    fixed = [tuple(each[0] for each in entry[1:]) for entry in (at, first, second)]

    def of_first(*given):
        return twice(NAMED[name], *((one, *others) for one, others in zip(given, fixed, strict=True)))

    found = vectorised(of_first)(at[0], first[0], second[0])
    assert_alike(found, known["the same for all"][name])


def test_every_function_with_slopes_is_compared_with_jax():
    tables = (dual._OF_ONE, dual._OF_TWO, dual._LINEAR, dual._BILINEAR, dual._OWN)
    # complex numbers are compared in test_arrays.py; the slope of gamma needs digamma
    assert set(itertools.chain(*tables)) - {"complex_number", "digamma"} <= CASES.keys()
    assert dual._OF_VALUES - VALUES.keys() == {"broadcast_shapes"}  # whose arguments are no numbers


VALUES = {
    **{name: lambda m, x, name=name: getattr(m, name)(x) for name in ["isfinite", "isnan", "isinf", "sign"]},
    **{
        name: lambda m, x, name=name: getattr(m, name)(x)
        for name in ["floor", "shape", "ndim", "size", "argsort"]
    },
    **{name: lambda m, x, name=name: getattr(m, name)(x) for name in ["zeros_like", "ones_like"]},
    "argmax": lambda m, x: [m.argmax(x), m.argmax(x, axis=1), m.argmax(x, axis=0)],
    "argmin": lambda m, x: [m.argmin(x), m.argmin(x, axis=1), m.argmin(x, axis=0)],
    "any": lambda m, x: [m.any(x), m.any(m.maximum(x, 0.0), axis=1)],
    "all": lambda m, x: [m.all(x), m.all(m.maximum(x, 0.0), axis=1)],
    "searchsorted": lambda m, x: [
        m.searchsorted(ROW[[2, 1, 0]], x),
        m.searchsorted(m.sum(x * x, axis=1), 0.5),
    ],
}


@pytest.mark.parametrize("name", VALUES)
def test_what_follows_from_the_values_has_no_slopes(name):
    x = np.array([[0.0, 1.5, np.inf], [-2.5, np.nan, 0.25], [-np.inf, 3.0, 0.0]])
    if name == "searchsorted":
        x = np.array([[0.1, 0.2, 0.3], [0.5, 0.4, 0.1], [1.0, 2.0, 3.0]])
    found = trees.leaves(VALUES[name](xp, Dual(Dual(x, [np.ones((3, 3))], 1), [MATRIX], 2)))
    for one, other in zip(found, trees.leaves(VALUES[name](np, x)), strict=True):
        assert not isinstance(one, Dual)
        np.testing.assert_array_equal(one, other)


def test_a_function_whose_slope_is_not_known_is_refused():
    with pytest.raises(NotImplementedError, match="slope of sinc is not known"):
        xp.sinc(Dual(np.ones(2), [np.ones(2)], 1))


@pytest.mark.parametrize("name", ["lt", "le", "gt", "ge", "eq", "ne"])
def test_comparisons_are_those_of_the_values(name):
    compared = getattr(operator, name)
    a, b = np.array([1.0, 2.0, 3.0]), np.array([3.0, 2.0, 1.0])
    one, other = Dual(Dual(a, [-a], 1), [5.0 * a], 2), Dual(b, [b], 1)
    for left, right in ((one, other), (one, b), (a, other)):
        found = compared(left, right)
        assert type(found) is np.ndarray
        np.testing.assert_array_equal(found, compared(a, b))
    assert bool(compared(one[1], 2.0)) is compared(2.0, 2.0)
    assert bool(compared(3.0, one[1])) is compared(3.0, 2.0)


def test_truth_is_that_of_the_value():
    assert Dual(np.float64(2.0), [np.float64(0.0)], 1)
    assert not Dual(np.float64(0.0), [np.float64(1.0)], 1)
    with pytest.raises(TypeError, match="unhashable"):
        hash(Dual(1.0, [1.0], 1))


def test_a_number_with_slopes_never_becomes_an_array_of_numpy_unnoticed():
    number = Dual(np.ones(2), [np.ones(2)], 1)
    for refused in (np.asarray, np.sin, np.sum, lambda x: np.add(1.0, x), lambda x: np.stack([x, x])):
        with pytest.raises(TypeError):
            refused(number)
    with pytest.raises(TypeError):
        np.zeros(2)[:] = number


def test_numbers_alike_share_the_slope_of_the_larger_and_of_the_smaller():
    """The mean of the slopes on both sides, as JAX has it."""
    one, other = np.array([1.0, 2.0]), np.array([1.0, 5.0])
    same, along = np.array([2.0, 2.0, 1.0]), np.array([1.0, 4.0, 9.0])
    rows, turned = np.stack([same, along]), np.stack([along, same])

    def of(slope, m):
        return [
            *(slope(getattr(m, name), (one, one), (one, other)) for name in ("maximum", "minimum")),
            *(slope(lambda x, y=y: m.fmax(x, y), (one,), (other,)) for y in (1.0, np.array([1.0, np.nan]))),
            slope(m.abs, (np.array([0.0, -0.0]),), (other,)),  # that of the numbers above 0
            slope(m.max, (same,), (along,)),
            slope(m.min, (-same,), (along,)),
            slope(lambda x: m.max(x, axis=1), (rows,), (turned,)),
        ]

    assert_alike(of(value_and_slope, xp), jax.jit(lambda: of(jax.jvp, jnp))())


def test_slopes_where_functions_have_an_edge():
    """What a formula does not choose by where may be infinite, and must then be so in both engines."""
    names = ["sqrt", "log", "arcsin", "arccos", "arctanh", "log1p", "cbrt"]
    x = np.array([-2.0, -1.0, 0.0, 1.0])

    def of(slope, m):
        return [slope(getattr(m, name), (x,), (np.ones(4),)) for name in names]

    expected = jax.jit(lambda: of(jax.jvp, jnp))()
    np.testing.assert_array_equal(np.isfinite(of(value_and_slope, xp)), np.isfinite(expected))


def test_powers_of_negative_numbers_and_of_zero():
    x, along = np.array([-2.0, 0.0, 3.0]), np.array([1.0, 2.0, 4.0])
    for power in (2, 3, 4):
        (value, slope), (again, second) = twice(("m", lambda m, x, n=power: x**n), (x,), (along,), (along,))
        np.testing.assert_allclose(value, x**power, rtol=1e-14)
        np.testing.assert_allclose(slope, power * x ** (power - 1) * along, rtol=1e-14)
        np.testing.assert_array_equal(again, slope)
        np.testing.assert_allclose(second, power * (power - 1) * x ** (power - 2) * along**2, rtol=1e-14)


def test_powers_of_zero_by_their_exponents():
    x, y = np.zeros(3), np.array([0.0, 0.5, 2.0])
    found = value_and_slope(lambda y: xp.power(x, y), (y,), (np.ones(3),))
    assert_alike(found, jax.jvp(lambda y: jnp.power(x, y), (y,), (np.ones(3),)))
    assert_alike(found, list(np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])))


@pytest.mark.parametrize(
    "function",
    [
        lambda m, x: m.pad(x, (1, 1), constant_values=3.0),
        lambda m, x: m.diff(x, prepend=2.0),
        lambda m, x: m.diff(x, append=2.0),
        lambda m, x: m.sum(x, initial=2.0),
    ],
    ids=["pad", "diff before", "diff behind", "sum"],
)
def test_a_constant_that_a_function_adds_has_no_slope(function):
    x, along = np.array([1.0, 4.0]), np.array([0.5, 7.0])
    found = value_and_slope(lambda x: function(xp, x), (x,), (along,))
    assert_alike(found, jax.jvp(lambda x: function(jnp, x), (x,), (along,)))


@pytest.mark.parametrize("kind", [float, np.float64, "float64", np.dtype(float)])
def test_a_number_as_one_of_its_own_kind_keeps_its_slopes(kind):
    assert value_and_slope(lambda x: 2.0 * x.astype(kind), (np.ones(2),), (ROW[:2],))[1].tolist() == [
        2.0 * ROW[0],
        2.0 * ROW[1],
    ]


def test_a_number_as_a_count_has_no_slopes():
    found = Dual(np.array([1.5, -0.5]), [np.ones(2)], 1).astype(int)
    assert type(found) is np.ndarray
    assert found.tolist() == [1, 0]


@pytest.mark.parametrize(
    "function",
    [
        lambda m, z: z * z,
        lambda m, z: 1.0 / z,
        lambda m, z: m.exp(z),
        lambda m, z: m.sqrt(z),
        lambda m, z: z.imag * z.real,
        lambda m, z: m.real((2.0 + 1.0j) * z),
        lambda m, z: m.abs(z),
    ],
    ids=["square", "inverse", "exp", "sqrt", "parts", "turned", "abs"],
)
def test_complex_numbers(function):
    """By both parts, and by each of them."""
    (x, y), (dx, dy) = (MATRIX, MATRIX.T), (MATRIX + 0.1, 1.0 - MATRIX)

    def of(slope, m):
        def number(real, imaginary):
            return function(m, complex_number(real, imaginary))

        return [
            slope(number, (x, y), (dx, dy)),
            slope(lambda real: number(real, y), (x,), (dx,)),
            slope(lambda imaginary: number(x, imaginary), (y,), (dy,)),
        ]

    assert_alike(of(value_and_slope, xp), jax.jit(lambda: of(jax.jvp, jnp))())


def test_a_slope_of_a_slope_is_not_taken_for_a_slope():
    """d/dx (x d/dy (x + y)) = 1, which mixed-up levels make 2."""

    def outer(x):
        return x * value_and_slope(lambda y: x + y, (2.0,), (1.0,))[1]

    assert value_and_slope(outer, (3.0,), (1.0,)) == (3.0, 1.0)
    cubed = value_and_slope(
        lambda x: x * value_and_slope(lambda y: x * y * y, (x,), (1.0,))[1], (3.0,), (1.0,)
    )
    assert cubed == (54.0, 54.0)  # x times 2 x², and its slope 6 x²


def test_three_levels():
    def slope_of(function):
        return lambda x: value_and_slope(function, (x,), (1.0,))[1]

    third = slope_of(slope_of(slope_of(lambda x: xp.sin(2.0 * x))))
    assert third(0.3) == pytest.approx(-8.0 * np.cos(0.6), rel=1e-14)
    assert slope_of(slope_of(slope_of(lambda x: 1.0 / x)))(2.0) == pytest.approx(-6.0 / 16.0, rel=1e-14)


def test_slopes_have_the_shapes_of_their_values():
    one = Dual(np.ones((3, 1)), [np.ones((3, 1)), None], 1)
    row = Dual(np.ones(3), [None, np.ones(3)], 1)
    for number in (
        *(one + row, one - row, one * row, one / row, one + ROW, ROW - one, one * ROW, one / ROW),
        *(xp.maximum(one, row), xp.hypot(one, row), xp.where(MATRIX > 0.0, one, row), xp.mod(one, row)),
        *(xp.where(MATRIX > 0.0, one, 0.0), xp.maximum(one, ROW), one**ROW, xp.full_like(MATRIX, row)),
    ):
        assert number.shape == (3, 3)
        assert all(slope is None or slope.shape == (3, 3) for slope in number.slopes)
        assert number.slopes[0] is not None or number.slopes[1] is not None
    assert (one * ROW).slopes[1] is None
    assert xp.exp(xp.sum(row * 2.0)).slopes[0] is None
    assert xp.where(MATRIX > 0.0, one, 0.0).slopes[1] is None


def test_parts_of_numbers_with_slopes_of_several_levels():
    inner = Dual(1.0, [2.0], 1)
    outer = Dual(inner, [Dual(3.0, [4.0], 1), None], 2)
    assert dual.plain(outer) == 1.0
    assert dual.plain(5.0) == 5.0
    assert dual.highest_level([1.0, inner]) == 1
    assert dual.highest_level([inner, [1.0, (outer,)]]) == 2
    assert dual.highest_level([1.0, [2.0]]) == 0
    assert dual.value_at(outer, 2) is inner
    assert dual.value_at(outer, 3) is outer
    assert dual.value_at(5.0, 1) == 5.0
    assert dual.slopes_at(outer, 2, 2)[0].value == 3.0
    assert dual.slopes_at(inner, 2, 2) == (None, None)
    assert dual.directions_at([1.0, inner, [outer]], 2) == 2
    assert dual.directions_at([inner], 1) == 1
    assert dual.directions_at([inner, 1.0], 2) == 0
    assert dual.constant_at(outer, 2) is inner
    assert dual.constant_at(inner, 2) is inner
    assert dual.constant_at(5.0, 1) == 5.0
    without = dual.constant_at(outer, 1)
    assert (without.level, without.value, without.slopes) == (2, 1.0, [3.0, None])
