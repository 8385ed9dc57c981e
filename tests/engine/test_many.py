"""Many numbers at once: what NumPy says of each of them alone."""

import itertools
import operator
import threading
from functools import partial

import numpy as np
import pytest
from libraries import OF_NUMPY, OURS

from asperity.engine import many as module
from asperity.engine import trees
from asperity.engine.arrays import complex_number, entry_of, xp
from asperity.engine.control import map_over, vectorised
from asperity.engine.many import Many, chosen, many, one_by_one, together

# as many numbers at once as the axes are long: an axis taken for another changes numbers, not only shapes
COUNT = 3
SHAPES = {"s": (), "v": (3,), "c": (3, 1), "m": (3, 3), "t": (3, 3, 3), "w": (4,), "r": (4, 3)}
MATRIX = np.array([[0.3, -1.2, 2.0], [0.7, 0.1, -0.4], [-0.9, 1.1, 0.6]])
ROW = MATRIX[1]
PLACES = np.array([[2, 0, 1], [0, 0, 2], [1, 1, 0]])


def of(name, **options):
    """A function of a library by its name."""
    return lambda m, *numbers: getattr(m, name)(*numbers, **options)


def along(name, **options):
    """A function along each axis of an array of two, and of all of it."""
    return [
        ("m", of(name, **options)),
        *(("m", of(name, axis=axis, **options)) for axis in (0, 1, -1, -2)),
        ("t", of(name, axis=-2, **options)),
        ("v", of(name, **options)),
    ]


def operators(*names):
    """Operators of two numbers, with constants of Python and of NumPy on both sides."""
    return {
        name: [
            *((spec, lambda m, x, y, name=name: getattr(operator, name)(x, y)) for spec in PAIRS),
            *(
                ("m", lambda m, x, name=name, k=constant: getattr(operator, name)(x, k))
                for constant in CONSTANTS
            ),
            *(
                ("m", lambda m, x, name=name, k=constant: getattr(operator, name)(k, x))
                for constant in CONSTANTS
            ),
            ("s", lambda m, x, name=name: getattr(operator, name)(x, ROW)),
            ("s", lambda m, x, name=name: getattr(operator, name)(ROW, x)),
        ]
        for name in names
    }


PAIRS = ("m m", "m v", "v m", "s v", "v s", "c v", "v t", "t m", "s s", "c m", "t s")
CONSTANTS = (2, 2.5, np.float64(1.5), np.float32(0.5), np.array(3.0), np.array([1.0, 2.0, 3.0]))

# name: the numbers (+: positive ones, i: places from 0 to 2, b: truths), and what is computed with a library
CASES = {
    **{
        name: [(spec, of(name)) for spec in PAIRS]
        for name in [
            "add",
            "subtract",
            "multiply",
            "divide",
            "hypot",
            "arctan2",
            "maximum",
            "minimum",
            "fmax",
            "fmin",
            "mod",
        ]
    },
    **{
        name: [(spec, of(name)) for spec in ("m", "s")]
        for name in ["exp", "expm1", "sin", "cos", "tanh", "cbrt", "abs", "sign"]
    },
    **{name: [("+m", of(name))] for name in ["sqrt", "log", "log1p", "arcsin"]},
    **{
        name: [("m", of(name))]
        for name in ["isfinite", "isnan", "isinf", "floor", "negative", "square", "isreal", "real", "imag"]
    },
    **{name: [("m", of(name))] for name in ["erf", "gamma"]},
    "power": [("+m v", of("power")), ("m", lambda m, x: m.power(x, 2)), ("v", lambda m, x: m.power(2.0, x))],
    **{name: [("b b", of(name)), ("bv b", of(name))] for name in ("logical_and", "logical_or")},
    **{name: along(name) for name in ["sum", "mean", "max", "min", "prod", "cumsum"]},
    **{f"{name} kept": along(name, keepdims=True) for name in ["sum", "mean", "max", "min", "prod"]},
    **{f"{name} of truths": [(f"b{s[1:]}", f) for s, f in along(name)] for name in ("any", "all", "sum")},
    "sum of axes": [("t", of("sum", axis=(0, -1))), ("t", of("max", axis=(0, 1))), ("s", of("sum"))],
    "argmax": along("argmax"),
    "argmin": along("argmin"),
    "methods": [
        *(
            ("t", lambda m, x, name=name: getattr(x, name)())
            for name in ["sum", "mean", "max", "min", "ravel"]
        ),
        *(
            ("t", lambda m, x, name=name, axis=axis: getattr(x, name)(axis=axis))
            for name in ["sum", "mean", "max", "min"]
            for axis in (0, 1, -1, -3)
        ),
        *(
            ("t", lambda m, x, name=name, axis=axis: getattr(x > 0.0, name)(axis=axis))
            for name in ("all", "any")
            for axis in (None, 0, 2, -2)
        ),
        ("m", lambda m, x: x.reshape(9)),
        ("m", lambda m, x: x.reshape(1, -1)),
        ("m", lambda m, x: x.reshape((3, 1, 3))),
        ("s", lambda m, x: x.reshape(())),
        ("t", lambda m, x: x.T),
        ("m", lambda m, x: x.T),
        ("m", lambda m, x: [x.real, x.imag, -x, +x, abs(x)]),
        ("m", lambda m, x: [x.astype(int), (x > 0.0).astype(float)]),
        ("b", lambda m, x: [~x, x & True, False | x]),
        ("r", lambda m, x: [np.array(len(x)), x * x.ndim, x * x.size, x * x.shape[0], x.astype(x.dtype)]),
        ("r", lambda m, x: [row * k for k, row in enumerate(x)]),
    ],
    "where": [
        ("b m v", of("where")),
        ("bv m m", of("where")),
        ("bs v m", of("where")),
        ("m", lambda m, x: m.where(x > 0.0, x, 0.0)),
        ("bv", lambda m, x: m.where(x, MATRIX, 1.0)),
        ("v", lambda m, x: m.where(MATRIX > 0.0, x, -1)),
    ],
    "stack": [
        *(
            ("m m", lambda m, x, y, axis=axis: m.stack([x, MATRIX, y], axis=axis))
            for axis in (0, 1, 2, -1, -2, -3)
        ),
        ("s s", lambda m, x, y: m.stack([x, 2.0, y])),
        ("m", lambda m, x: m.stack(list(x), axis=1)),
        ("m", lambda m, x: m.stack(x)),
    ],
    "concatenate": [
        *(
            ("m m", lambda m, x, y, axis=axis: m.concatenate([x, MATRIX, y], axis=axis))
            for axis in (0, 1, -1, -2)
        ),
        ("v w", lambda m, x, y: m.concatenate((x, y, ROW))),
    ],
    "broadcast_to": [
        ("v", lambda m, x: m.broadcast_to(x, (3, 3))),
        ("c", lambda m, x: m.broadcast_to(x, (3, 3, 3))),
        ("s", lambda m, x: m.broadcast_to(x, 3)),
    ],
    "broadcast_arrays": [("c v", lambda m, *x: list(m.broadcast_arrays(*x, 2.0, MATRIX)))],
    "broadcast_shapes": [("c v", lambda m, x, y: x[:, 0] * m.broadcast_shapes(x.shape, y.shape)[0])],
    "matmul": [
        (spec, lambda m, x, y: x @ y)
        for spec in ("m m", "m v", "v m", "v v", "t m", "m t", "t t", "t v", "v t", "w r", "r v")
    ],
    "block": [
        ("m c", lambda m, x, y: m.block([[x, y], [y.T, np.ones((1, 1))]])),
        ("v w", lambda m, x, y: m.block([x, y])),
        ("m m", lambda m, x, y: m.block([[x, MATRIX], [MATRIX, y]])),
    ],
    "asarray": [
        ("m", of("asarray")),
        ("i", lambda m, x: m.asarray(x, dtype=float)),
        ("v", lambda m, x: m.asarray([x[0], 2.0, x[2]])),
        ("s s", lambda m, x, y: m.asarray([[x, y], [y, 1.0]])),
    ],
    "array": [("m", of("array")), ("s s", lambda m, x, y: m.array((x, y)))],
    "diag": [("v", of("diag")), ("m", of("diag")), ("r", of("diag"))],
    "diagonal": [("m", of("diagonal")), ("r", of("diagonal")), ("t", of("diagonal"))],
    "solve": [("m v", of("solve")), ("m m", of("solve")), ("m r", lambda m, x, y: m.solve(x, y.T))],
    "reshape": [("m", lambda m, x: m.reshape(x, 9)), ("m", lambda m, x: m.reshape(x, (3, 1, -1)))],
    "ravel": [("t", of("ravel")), ("s", of("ravel"))],
    "split": [
        ("m", lambda m, x: m.split(x, [1])),
        ("m", lambda m, x: m.split(x, [1, 2], axis=-1)),
        ("t", lambda m, x: m.split(x, 3, axis=1)),
    ],
    "take_along_axis": [
        ("m im", lambda m, x, p: m.take_along_axis(x, p, axis=1)),
        ("m im", lambda m, x, p: m.take_along_axis(x, p, axis=0)),
        ("t it", lambda m, x, p: m.take_along_axis(x, p, axis=-2)),
        ("v i", lambda m, x, p: m.take_along_axis(x, p, axis=-1)),
    ],
    "take": [
        ("v is", lambda m, x, p: m.take(x, p, axis=0, mode="clip")),
        ("m i", lambda m, x, p: m.take(x, p + 1, axis=0, mode="clip")),
        ("m im", lambda m, x, p: m.take(x, p, axis=1, mode="clip")),
    ],
    "clip": [
        ("m", lambda m, x: m.clip(x, -0.3, 0.4)),
        ("m", lambda m, x: m.clip(x, None, 0.4)),
        ("m", lambda m, x: m.clip(x, -0.3, None)),
        ("m +v", lambda m, x, y: m.clip(x, -y, y)),
    ],
    "shape": [("r", lambda m, x: np.array(m.shape(x)))],
    "ndim": [("t", lambda m, x: np.array(m.ndim(x)))],
    "size": [("r", lambda m, x: m.size(x))],
    "zeros_like": [("r", of("zeros_like")), ("r", of("zeros_like", dtype=int)), ("i", of("zeros_like"))],
    "ones_like": [("r", of("ones_like")), ("r", of("ones_like", dtype=bool)), ("b", of("ones_like"))],
    "full_like": [
        ("m s", of("full_like")),
        ("r", lambda m, x: m.full_like(x, 2.5)),
        ("i", lambda m, x: m.full_like(x, 2)),
        ("s", lambda m, x: m.full_like(MATRIX, x)),
        ("s", lambda m, x: m.full_like(MATRIX, x > 0.0, dtype=bool)),
    ],
    "full": [("s", lambda m, x: m.full((3, 3), x)), ("v", lambda m, x: m.full((2, 3), x))],
    "pad": [
        ("v", lambda m, x: m.pad(x, (1, 2))),
        ("m", lambda m, x: m.pad(x, ((0, 1), (2, 0)), constant_values=3.0)),
        ("m", lambda m, x: m.pad(x, 1, mode="edge")),
        ("t", lambda m, x: m.pad(x, ((0, 1),))),
    ],
    "repeat": [
        ("m", lambda m, x: m.repeat(x, 2)),
        ("m", lambda m, x: m.repeat(x, 2, axis=1)),
        ("m", lambda m, x: m.repeat(x, np.array([1, 0, 2]), axis=0)),
        ("s", lambda m, x: m.repeat(x, 3)),
    ],
    "expand_dims": [("m", of("expand_dims", axis=axis)) for axis in (0, 1, 2, -1, -2, -3)],
    "norm": [("v", of("norm")), ("m", of("norm")), *(("m", of("norm", axis=axis)) for axis in (0, 1, -1))],
    "transpose": [("t", of("transpose")), ("m", of("transpose")), ("v", of("transpose"))],
    # one call for each
    "others": [
        ("t", lambda m, x: m.moveaxis(x, 0, -1)),
        ("t", lambda m, x: m.swapaxes(x, 0, 1)),
        (
            "m",
            lambda m, x: [m.flip(x, axis=0), m.tile(x, (2, 1)), m.diff(x), m.argsort(x), m.sort(x, axis=0)],
        ),
        ("m v", lambda m, x, y: [m.tensordot(x, y, axes=1), m.dot(x, y), m.cross(x, y)]),
        ("m v", lambda m, x, y: [m.einsum("ij,j->i", x, y), m.outer(x, y), m.column_stack([x, y])]),
        ("v s", lambda m, x, y: m.searchsorted(m.sort(x), y)),
        ("m m", lambda m, x, y: m.select([x > 0.5, y > 0.0], [x, y], -1.0)),
        ("s", lambda m, x: [m.atleast_1d(x), m.linspace(0.0, x, 4), m.trace(x * MATRIX)]),
        ("m", lambda m, x: [m.det(x), m.inv(x), *m.eigh(x @ x.T + x.T @ x)][:3]),
    ],
    "lists": [
        *(
            (spec, lambda m, x: [m.add(x, [1.0, 2.0, 3.0]), m.hypot([[1.0], [2.0], [3.0]], x)])
            for spec in "scvm"
        ),
        *((spec, lambda m, x: m.where([True, False, True], x, [[1.0], [2.0], [3.0]])) for spec in "sv"),
    ],
    # operators
    **operators("add", "sub", "mul", "truediv", "lt", "le", "gt", "ge", "eq", "ne"),
    "pow": [
        ("+m v", lambda m, x, y: x**y),
        ("m", lambda m, x: x**2),
        ("m", lambda m, x: 2.0**x),
        ("m", lambda m, x: np.array([1.0, 2.0, 3.0]) ** x),
    ],
    "and": [
        ("b b", lambda m, x, y: x & y),
        ("bv b", lambda m, x, y: x & y),
        ("bv", lambda m, x: (MATRIX > 0) & x),
    ],
    "or": [
        ("b b", lambda m, x, y: x | y),
        ("bs b", lambda m, x, y: x | y),
        ("bv", lambda m, x: (MATRIX > 0) | x),
    ],
    "complex": [
        ("m v", lambda m, x, y: complex_number(x, y) ** 2),
        ("m", lambda m, x: m.abs(x * (2.0 + 1.0j))),
        ("m v", lambda m, x, y: [m.real(1.0j * (x + 1.0j * y)), (1.0j * x / 2j).real]),
    ],
    "entries": [
        *(("m", lambda m, x, k=k: x[k]) for k in (0, -1, np.int64(1), np.s_[1:], np.s_[::-1], None, ..., ())),
        *(("m", lambda m, x, k=k: x[k]) for k in (np.s_[:, 2], np.s_[..., 0], np.s_[:, None], np.s_[1, 2])),
        *(
            ("m", lambda m, x, k=k: x[k])
            for k in ([2, 0], np.array([2, 0, 1]), PLACES, PLACES[:2], ROW > 0.0)
        ),
        *(
            ("m", lambda m, x, k=k: x[k])
            for k in (MATRIX > 0.0, (PLACES, PLACES.T), ([0, 2], 1), (..., PLACES[0]))
        ),
        *(("t", lambda m, x, k=k: x[k]) for k in ((PLACES[0], 1), (0, PLACES[0]), np.s_[:, PLACES[0], 0])),
        *(("t", lambda m, x, k=k: x[k]) for k in ((PLACES[:, :1], PLACES[:1]), np.s_[..., None, 1])),
    ],
    "entries apart": [
        ("t", lambda m, x: x[0, :, PLACES[0]]),
        ("t", lambda m, x: x[PLACES[0], :, PLACES[1]]),
        ("t", lambda m, x: x[PLACES[0], :, 2]),
        ("t", lambda m, x: x[PLACES[0], None, PLACES[1]]),
        ("t", lambda m, x: x[0, ..., PLACES[:2]]),
    ],
    "computed entries": [
        ("v is", lambda m, x, p: x[p]),
        ("m is", lambda m, x, p: x[p]),
        ("v is", lambda m, x, p: x[p - 3]),
        ("v i", lambda m, x, p: x[p]),
        ("m i", lambda m, x, p: x[p]),
        ("w im", lambda m, x, p: x[p]),
        ("t im", lambda m, x, p: x[p]),
    ],
}
NAMED = {f"{name} {k}": case for name, cases in CASES.items() for k, case in enumerate(cases)}


def numbers(spec, rng):
    """Numbers of a kind, for each of many."""
    kind = spec[:-1] if spec[:-1] in ("+", "i", "b") else spec if spec in ("i", "b") else ""
    shape = (COUNT, *SHAPES[{"i": "v", "b": "m"}.get(spec, spec[-1])])
    if kind == "i":
        return rng.integers(0, 3, shape)
    if kind == "b":
        return rng.uniform(size=shape) > 0.4
    return rng.uniform(0.2 if kind == "+" else -0.9, 0.9, shape)


def assert_alike(found, expected):
    found, expected = trees.leaves(found), trees.leaves(expected)
    assert len(found) == len(expected)
    for one, other in zip(found, expected, strict=True):
        assert one.shape == other.shape
        assert one.dtype.kind == other.dtype.kind
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-14)


def compared(name, chosen_ones):
    """What is computed of many at once, of the numbers at these places; the others are the same for all."""
    spec, function = NAMED[name]
    rng = np.random.default_rng(list(name.encode()))
    given = [numbers(each, rng) for each in spec.split()]

    def with_others(several):
        places = iter(several)
        return [next(places) if k in chosen_ones else each[0] for k, each in enumerate(given)]

    several = [given[k] for k in chosen_ones]
    expected = [trees.leaves(function(OF_NUMPY, *with_others(one))) for one in zip(*several, strict=True)]
    found = vectorised(lambda *x: function(OURS, *with_others(x)))(*several)
    return found, [np.stack([np.asarray(one) for one in leaves]) for leaves in zip(*expected, strict=True)]


@pytest.mark.parametrize("name", NAMED)
def test_each_of_many_is_what_numpy_says_of_it(name):
    assert_alike(*compared(name, range(len(NAMED[name][0].split()))))


PARTLY = [
    (name, places)
    for name, (spec, _) in NAMED.items()
    for size in range(1, len(spec.split()))
    for places in itertools.combinations(range(len(spec.split())), size)
    if not (name.startswith("computed") and places == (1,))  # a table of constants is read by entry_of
]


@pytest.mark.parametrize(("name", "places"), PARTLY, ids=lambda part: str(part))
def test_some_of_the_numbers_are_the_same_for_all(name, places):
    assert_alike(*compared(name, places))


def test_every_function_of_many_numbers_is_compared_with_numpy():
    assert module._OWN.keys() - {"complex_number"} <= CASES.keys()  # compared in test_arrays.py


@pytest.mark.parametrize("places", [np.array([1, 0, 2]), PLACES, np.array([[[9]], [[-9]], [[0]]])])
def test_entries_of_a_table_of_constants_at_computed_places(places):
    for table in (ROW, MATRIX, MATRIX.tolist()):
        found = vectorised(lambda place, table=table: entry_of(table, place))(places)
        expected = [np.asarray(table)[np.clip(each, 0, 2)] for each in places]  # the last one beyond the end
        np.testing.assert_array_equal(found, expected)


def test_infinite_numbers_stay_where_they_are():
    """Nothing is multiplied by a zero that NumPy would not multiply by."""
    given = np.array([[1.0, np.inf, np.nan], [-np.inf, 2.0, 3.0]])
    np.testing.assert_array_equal(vectorised(xp.diag)(given), [np.diag(row) for row in given])
    taken = vectorised(lambda x: xp.where(xp.isfinite(x), x, 0.0))(given)
    np.testing.assert_array_equal(taken, np.where(np.isfinite(given), given, 0.0))


REFUSED = {
    "an array": np.asarray,
    "a function of NumPy": np.sin,
    "a sum of NumPy": np.sum,
    "a stack of NumPy": np.stack,
    "a truth": bool,
    "a float": float,
    "a hash": hash,
    "a branch": lambda x: 1.0 if x[0] > 0.5 else 2.0,
    "an addition of NumPy": lambda x: np.add(MATRIX, x),
    "an assignment": lambda x: np.zeros(3).__setitem__(slice(None), x),
    "a place in a table": lambda x: MATRIX[x.astype(int)],
    "a place among others": lambda x: x[x.astype(int), 0],
    "as many entries as something is true": lambda x: x[Many(MATRIX[[0, 1, 0]] > 0.2)],
    "sum 1": lambda x: xp.sum(x, axis=1),
    "sum -2": lambda x: xp.sum(x, axis=-2),
    "cumsum -2": lambda x: xp.cumsum(x, axis=-2),
    "max -2": lambda x: x.max(axis=-2),
    "any (0, -2)": lambda x: (x > 0.5).any(axis=(0, -2)),
    "argmax -2": lambda x: xp.argmax(x, axis=-2),
    "concatenate -2": lambda x: xp.concatenate([x, x], axis=-2),
    "concatenate scalars": lambda x: xp.concatenate([x[0], x[1]], axis=-1),
    "stack -3": lambda x: xp.stack([x, x], axis=-3),
    "take_along_axis -2": lambda x: xp.take_along_axis(x, x.astype(int), axis=-2),
    "split -2": lambda x: xp.split(x, 3, axis=-2),
    "repeat -2": lambda x: xp.repeat(x, 2, axis=-2),
    "expand_dims -3": lambda x: xp.expand_dims(x, -3),
    "norm -2": lambda x: xp.norm(x, axis=-2),
    "broadcast_to ()": lambda x: xp.broadcast_to(x, ()),
    "vector times scalar": lambda x: xp.matmul(x, x[0]),
    "scalar times vector": lambda x: x[1] @ x,
    "scalar times scalar": lambda x: x[1] @ x[0],
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_nothing_for_one_of_the_numbers_is_refused(name):
    """Never an array of all of them, nor one in which an axis of the numbers is that of the many."""
    with pytest.raises((TypeError, ValueError, IndexError, AttributeError)):
        REFUSED[name](Many(np.array([[0.2, 0.9, 0.7], [0.4, 0.1, 0.2], [0.8, 0.6, 0.7]])))


def test_many_modules_and_all_of_them_together():
    several = many({"a": np.arange(6.0).reshape(2, 3), "b": (np.array([1, 2]), None)})
    assert (several["a"].shape, several["b"][0].shape, several["a"].ndim) == ((3,), (), 1)
    assert len(several["a"]) == 3
    assert several["b"][0].dtype == int
    back = together({"x": several["a"], "y": 5.0, "z": [np.array([1, 2])]}, 2)
    assert back["x"].tolist() == [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]
    assert back["y"].tolist() == [5.0, 5.0]
    assert back["z"][0].tolist() == [[1, 2], [1, 2]]
    assert together(several["a"], 2, axis=-1).tolist() == [[0.0, 3.0], [1.0, 4.0], [2.0, 5.0]]


def test_one_of_two_modules_for_each_condition():
    conditions = Many(np.array([True, False, True]))
    yes = {"a": Many(MATRIX), "b": 1.0, "c": ROW}
    no = {"a": Many(-MATRIX), "b": Many(np.array([5.0, 6.0, 7.0])), "c": np.zeros(3)}
    found = together(chosen(conditions, yes, no), COUNT)
    assert found["a"].tolist() == [MATRIX[0].tolist(), (-MATRIX[1]).tolist(), MATRIX[2].tolist()]
    assert found["b"].tolist() == [1.0, 6.0, 1.0]
    assert found["c"].tolist() == [ROW.tolist(), [0.0] * 3, ROW.tolist()]


def test_a_function_of_lists_and_options_called_for_each():
    a, b = Many(np.array([1.0, 2.0])), Many(np.array([[3.0, 4.0], [5.0, 6.0]]))

    def function(given, *, factor):
        (one, both), other = given
        return one * both * factor, other + one

    first, second = one_by_one(function, (([a, b], 10.0),), {"factor": a})
    assert first.values.tolist() == [[3.0, 4.0], [20.0, 24.0]]
    assert second.values.tolist() == [11.0, 12.0]


def test_a_function_of_nothing_but_constants_is_the_same_for_all():
    found = vectorised(lambda x: {"a": MATRIX, "b": 2.0, "c": x})(np.arange(2.0))
    np.testing.assert_array_equal(found["a"], [MATRIX, MATRIX])
    assert found["b"].tolist() == [2.0, 2.0]


def test_a_map_within_a_map():
    """The inner one goes over what is the same for all, over what is another for each, and over both."""
    a, b = MATRIX, MATRIX[:2] + 1.0

    def outer(row):
        over_constants = vectorised(lambda other: row * other)(b)
        over_own = map_over(lambda entry: entry * row, row)
        over_both = vectorised(lambda one, other: one + other @ row)(row, MATRIX)
        return over_constants, over_own, over_both

    found = vectorised(outer)(a)
    np.testing.assert_allclose(found[0], a[:, None] * b[None], rtol=1e-15)
    np.testing.assert_allclose(found[1], a[:, :, None] * a[:, None, :], rtol=1e-15)
    np.testing.assert_allclose(found[2], a + a @ MATRIX.T, rtol=1e-15)


def test_the_new_axis_may_be_any():
    def products(x, *, axis):
        return vectorised(lambda y: xp.stack([x, y * x]), out_axis=axis)(ROW[:2])

    for axis in (0, 1, -1):
        found = vectorised(lambda x: xp.stack([x, -x]), out_axis=axis)(MATRIX[:2])
        np.testing.assert_array_equal(found, np.stack([[x, -x] for x in MATRIX[:2]], axis=axis))
        inner = vectorised(partial(products, axis=axis))(MATRIX)
        expected = [np.stack([[x, y * x] for y in ROW[:2]], axis=axis) for x in MATRIX]
        np.testing.assert_array_equal(inner, expected)


def test_all_are_computed_in_one_call_even_after_one_has_failed():
    seen = []

    def function(x):
        seen.append(type(x))
        return 2.0 * x

    def fails(x):
        raise ArithmeticError

    for _ in range(2):
        assert vectorised(function)(ROW).tolist() == (2.0 * ROW).tolist()
        with pytest.raises(ArithmeticError):
            vectorised(fails)(ROW)
    assert seen == [Many, Many]


def test_each_thread_has_many_numbers_of_its_own():
    seen, kinds = [], []

    def elsewhere():
        seen.append(vectorised(lambda x: kinds.append(type(x)) or x + 1.0)(ROW))

    def function(x):
        thread = threading.Thread(target=elsewhere)
        thread.start()
        thread.join()
        return x

    vectorised(function)(MATRIX)
    assert kinds == [Many]
    assert seen[0].tolist() == (ROW + 1.0).tolist()
