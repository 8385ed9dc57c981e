"""What is stated of results is enough to hold their numbers again, and no more."""

import json
from typing import NamedTuple

import equinox
import jax
import pytest

from asperity.module_outline import of_outline, outline


class Pair(NamedTuple):
    first: object
    second: object


class Inner(equinox.Module):
    force: object
    name: str = equinox.field(static=True)


class Outer(equinox.Module):
    inner: Inner
    rows: dict
    absent: object
    names: tuple = equinox.field(static=True)


TREES = [
    Outer(Inner(1.0, "sp"), {"a": [3.0, (4.0,)], "b": 2.0}, None, ("x", ("y", 2, None, True))),
    Pair(1.0, Inner(None, "")),
    Outer(None, {}, (), Pair(("x",), Pair(1, None))),
    5.0,
    None,
    {},
    (),
    [{"x": ()}],
]


@pytest.mark.parametrize("tree", TREES)
def test_the_structure_survives_json(tree):
    found = of_outline(json.loads(json.dumps(outline(tree))))
    assert jax.tree.structure(found) == jax.tree.structure(tree)
    assert repr(found) == repr(jax.tree.map(lambda leaf: 0, tree))  # tuples of any name are equal
    assert all(leaf == 0 for leaf in jax.tree.leaves(found))


class NotKnown:
    """Neither a module nor a plain value."""


def test_what_cannot_be_stated_is_said():
    with pytest.raises(ValueError, match="NotKnown is no plain value"):
        outline(Inner(1.0, NotKnown()))


@pytest.mark.parametrize(
    "stated",
    [
        None,
        5,
        [],
        ["number", 1],
        ["class", "x"],
        ["module", "os", "system", []],
        ["module", "subprocess", "Popen", []],
        ["named", "builtins", "tuple.__new__", []],
        ["module", "not_loaded", "Module", []],
        ["module", "equinox", "Module", [["a", "static", ["list"]]]],
        ["dict", [[["list"], ["number"]]]],
    ],
)
def test_what_is_no_outline_is_refused(stated):
    with pytest.raises(ValueError, match=r"is no "):
        of_outline(stated)
