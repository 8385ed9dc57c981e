"""Modules of numbers as trees, against those of JAX."""

from typing import NamedTuple

import jax
import numpy as np
import pytest

from asperity.engine import trees
from asperity.engine.module import Module, same_numbers, static


class Pair(NamedTuple):
    one: object
    other: object


class Numbers(Module):
    first: object
    kind: str = static(default="a")
    second: object = None


TREES = [
    1.0,
    None,
    (),
    [],
    {},
    (1.0, [2.0, None, (3.0,)], {"b": 4.0, "a": 5.0, "c": {}}),
    Pair(1.0, Pair((2.0,), None)),
    Numbers(1.0, "b", Numbers({"z": 1.0, "y": [2.0]}, second=3.0)),
    [Numbers(Pair(1.0, 2.0), "c", (3.0, np.float64(4.0))), 5],
]


@pytest.mark.parametrize("tree", TREES)
def test_leaves_in_the_order_of_jax(tree):
    assert trees.leaves(tree) == jax.tree.leaves(tree)


@pytest.mark.parametrize("tree", TREES)
def test_a_function_of_every_leaf_as_by_jax(tree):
    found, expected = trees.map(lambda leaf: 2.0 * leaf, tree), jax.tree.map(lambda leaf: 2.0 * leaf, tree)
    assert found == expected
    assert type(found) is type(expected)
    assert jax.tree.structure(found) == jax.tree.structure(tree)


@pytest.mark.parametrize("tree", TREES)
def test_a_function_of_the_leaves_of_several_trees_as_by_jax(tree):
    others = [jax.tree.map(lambda leaf, k=k: leaf + k, tree) for k in (10.0, 100.0)]
    seen, of_jax = [], []
    found = trees.map(lambda *leaves: seen.append(leaves) or sum(leaves), tree, *others)
    assert found == jax.tree.map(lambda *leaves: of_jax.append(leaves) or sum(leaves), tree, *others)
    assert sorted(seen) == sorted(of_jax)


def test_leaves_of_a_dictionary_belong_together_by_their_keys():
    one, other = {"b": 1.0, "a": 2.0}, {"a": 20.0, "b": 10.0}
    assert trees.map(lambda x, y: x + y, one, other) == {"a": 22.0, "b": 11.0}
    assert trees.leaves(one) == trees.leaves({"a": 2.0, "b": 1.0}) == [2.0, 1.0]


def test_every_leaf_is_visited_in_the_order_in_which_leaves_are_listed():
    """Who takes the leaves one after the other while a tree is made of them relies on it."""
    tree = (Numbers({"b": 1.0, "a": 2.0}, second=3.0), {"d": 4.0, "c": (5.0,)})
    seen = []
    trees.map(seen.append, tree)
    assert seen == trees.leaves(tree)


def test_what_is_selected_stays_and_the_kind_too():
    found = trees.map(str, Pair(Numbers(1, "chosen"), [2]))
    assert isinstance(found, Pair)
    assert isinstance(found.one, Numbers)
    assert (found.one.first, found.one.kind, found.one.second, found.other) == ("1", "chosen", None, ["2"])


def test_leaves_may_be_joined_to_others_that_hold_more():
    """As by JAX, the other trees may have trees where the first has leaves."""
    tree, other = {"a": 1.0, "b": (2.0,)}, {"a": (3.0, 4.0), "b": ([5.0],)}
    assert trees.map(lambda x, y: (x, y), tree, other) == {"a": (1.0, (3.0, 4.0)), "b": ((2.0, [5.0]),)}


@pytest.mark.parametrize(
    ("one", "other"),
    [((1.0, 2.0), (1.0,)), ([1.0], [1.0, 2.0]), ({"a": 1.0}, {"b": 1.0}), (Numbers(1.0), (1.0,))],
)
def test_trees_of_two_structures_are_not_joined(one, other):
    with pytest.raises((ValueError, KeyError, AttributeError)):
        trees.map(lambda x, y: x, one, other)


ALIKE = [
    (1.0, 1.0),
    (1.0, np.float64(1.0)),
    (1, 1.0),
    (None, None),
    ((1.0, [2.0]), (1.0, [2.0])),
    ({"a": 1.0, "b": 2.0}, {"b": 2.0, "a": 1.0}),
    (Numbers((1.0, None)), Numbers((np.float64(1.0), None))),
    ("text", "text"),
]
UNLIKE = [
    (1.0, 2.0),
    (1.0, np.float64(2.0)),
    (None, 1.0),
    (0.0, None),
    ((1.0,), [1.0]),
    ((1.0,), (1.0, 2.0)),
    ((1.0,), 1.0),
    ([], None),
    ({"a": 1.0}, {"b": 1.0}),
    ({"a": 1.0}, {"a": 1.0, "b": 1.0}),
    ({"a": 1.0}, {"a": 2.0}),
    (Numbers(1.0), Numbers(2.0)),
    (Numbers(1.0), Numbers(1.0, "b")),
    (Numbers((1.0,)), Numbers([1.0])),
    (Numbers(1.0), Numbers(1.0, "a", 2.0)),
    (Numbers(1.0), (1.0, None)),
    (Pair(1.0, 2.0), (1.0, 2.0)),
    (np.array([1.0]), (1.0,)),
]


@pytest.mark.parametrize(("one", "other"), ALIKE)
def test_trees_with_the_same_numbers(one, other):
    assert same_numbers(one, other) is True
    assert same_numbers(other, one) is True


@pytest.mark.parametrize(("one", "other"), UNLIKE)
def test_trees_with_other_numbers(one, other):
    assert same_numbers(one, other) is False
    assert same_numbers(other, one) is False
