"""Frozen modules of numbers, and what JAX makes of them."""

import dataclasses
import subprocess
import sys
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.module import Module, Partial, static


class Part(Module):
    length: Any
    name: str = static(default="part")


class Whole(Part):
    parts: tuple[Part, ...] = ()
    sizes: dict[str, Any] = dataclasses.field(default_factory=dict)
    kinds: tuple[str, ...] = static(default=("a",))

    def total(self):
        return self.length + sum(part.length for part in self.parts)


def whole(factor=1.0):
    return Whole(
        factor * np.array([1.0, 2.0]),
        parts=(Part(factor * 3.0), Part(factor * 4.0, "other")),
        sizes={"b": factor * 5.0, "a": factor * 6.0},
    )


def test_fields_and_defaults_also_of_the_base():
    made = Whole(1.0, "x")
    assert (made.length, made.name, made.parts, made.sizes, made.kinds) == (1.0, "x", (), {}, ("a",))
    assert Whole.number_fields == ("length", "parts", "sizes")
    assert Whole.static_fields == ("name", "kinds")
    assert (Part.number_fields, Part.static_fields) == (("length",), ("name",))
    assert repr(Part(1.0)) == "Part(length=1.0, name='part')"


def test_a_module_is_frozen():
    made = whole()
    with pytest.raises(dataclasses.FrozenInstanceError):
        made.length = 2.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        made.name = "y"
    with pytest.raises(dataclasses.FrozenInstanceError):
        del made.parts
    changed = dataclasses.replace(made, length=7.0)
    assert (changed.length, changed.parts) == (7.0, made.parts)
    assert made.length.tolist() == [1.0, 2.0]


def test_modules_are_compared_by_their_numbers():
    assert whole() == whole()
    assert whole() != whole(2.0)
    assert Part(1.0) == Part(np.float64(1.0)) == Part(np.array(1.0))
    assert Part(np.array([1.0, 2.0])) == Part(jnp.array([1.0, 2.0]))
    assert Part(np.array([1.0, 2.0])) != Part(np.array([1.0, 3.0]))
    assert Part(np.array([1.0, 2.0])) != Part(np.array([1.0, 2.0, 3.0]))
    assert Part(1.0) != Part(1.0, "other")
    assert Part(None) == Part(None)
    assert Part(None) != Part(np.ones(2))
    assert Part((1.0, None)) == Part((1.0, None))
    assert Part((1.0, None)) != Part((1.0, 0.0))
    assert Part({"a": Part(1.0)}) == Part({"a": Part(1.0)})
    assert Part({"a": Part(1.0)}) != Part({"a": Part(2.0)})
    assert Part(1.0) != Whole(1.0)
    assert Part(1.0) != (1.0, "part")


@pytest.mark.parametrize("held", [lambda x: (x, None), lambda x: {"a": x}, lambda x: [(x,), 1.0]])
def test_modules_that_hold_arrays_in_tuples_and_dictionaries_are_compared(held):
    assert Part(held(np.array([1.0, 2.0]))) == Part(held(np.array([1.0, 2.0])))
    assert Part(held(np.array([1.0, 2.0]))) != Part(held(np.array([1.0, 3.0])))
    assert Part(held(np.array([1.0, 2.0]))) != Part(held(np.array([1.0])))


def test_the_hash_is_that_of_what_is_selected():
    assert hash(whole()) == hash(whole(2.0))
    assert hash(Part(1.0)) != hash(Part(1.0, "other"))
    assert hash(Part(1.0)) != hash(Whole(1.0))
    assert len({Part(1.0), Part(1.0), Part(2.0)}) == 2


def test_jax_takes_the_numbers_apart_and_puts_them_together():
    leaves, structure = jax.tree.flatten(whole())
    assert [np.asarray(leaf).tolist() for leaf in leaves] == [[1.0, 2.0], 3.0, 4.0, 6.0, 5.0]
    assert jax.tree.unflatten(structure, leaves) == whole()
    assert structure == jax.tree.structure(whole(2.0))
    assert structure != jax.tree.structure(dataclasses.replace(whole(), kinds=("b",)))
    paths = [jax.tree_util.keystr(path) for path, _ in jax.tree_util.tree_leaves_with_path(whole())]
    assert paths == [".length", ".parts[0].length", ".parts[1].length", ".sizes['a']", ".sizes['b']"]


def test_modules_in_programs():
    traced = []

    @jax.jit
    def twice(module):
        traced.append((module.name, module.kinds))
        return jax.tree.map(lambda leaf: 2.0 * leaf, module)

    assert twice(whole()) == whole(2.0)
    assert twice(whole(3.0)) == whole(6.0)
    assert twice(dataclasses.replace(whole(), kinds=("b",))).kinds == ("b",)
    assert traced == [("part", ("a",)), ("part", ("b",))]


def test_many_modules_and_slopes_by_a_module():
    several = jax.tree.map(lambda *leaves: np.stack(leaves), whole(), whole(2.0))
    found = jax.jit(jax.vmap(Whole.total))(several)
    np.testing.assert_array_equal(found, [[8.0, 9.0], [16.0, 18.0]])
    slope = jax.jit(jax.grad(lambda module: jnp.sum(module.total() ** 2) + module.sizes["a"]))(whole())
    assert isinstance(slope, Whole)
    np.testing.assert_array_equal(slope.length, [16.0, 18.0])
    assert [float(part.length) for part in slope.parts] == [34.0, 34.0]
    assert (float(slope.sizes["a"]), float(slope.sizes["b"])) == (1.0, 0.0)
    assert (slope.parts[1].name, slope.kinds) == ("other", ("a",))


def test_a_function_with_known_numbers_is_a_module():
    def scaled(first, second, x):
        return first * x + second

    line = Partial(scaled, (2.0, np.array([1.0, 3.0])))
    assert line(5.0).tolist() == [11.0, 13.0]
    assert [np.asarray(leaf).tolist() for leaf in jax.tree.leaves(line)] == [2.0, [1.0, 3.0]]
    np.testing.assert_array_equal(jax.jit(lambda line, x: line(x))(line, 5.0), [11.0, 13.0])
    assert float(jax.grad(lambda line: jnp.sum(line(5.0)))(line).numbers[0]) == 10.0


SCRIPT = """
import sys
from asperity.engine.module import Module, static

class Early(Module):
    number: object
    inner: object = None
    kind: str = static(default="early")

assert "jax" not in sys.modules
import jax

class Late(Module):
    number: object
    kind: str = static(default="late")

def twice(tree):
    return jax.tree.map(lambda leaf: 2.0 * leaf, tree)

assert twice(Early(1.0, Late(2.0))) == Early(2.0, Late(4.0))
assert jax.tree.leaves((Late(1.0, "x"), Early(2.0, (3.0, None)))) == [1.0, 2.0, 3.0]
assert jax.jit(twice)(Late(4.0)).number == 8.0
assert jax.grad(lambda module: module.number * module.inner.number)(Early(3.0, Late(5.0))).number == 5.0
assert jax.vmap(lambda module: module.number)(Early(jax.numpy.ones(3))).shape == (3,)
"""


def test_classes_defined_before_and_after_jax_is_imported():
    done = subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
