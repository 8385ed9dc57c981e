"""Modules of numbers as trees: what :mod:`jax.tree` does, in the same order, without JAX.

A leaf is whatever is no :class:`Module`, tuple, list, dictionary or None.
"""

from __future__ import annotations

from collections.abc import Callable

from asperity.engine.module import Module
from asperity.types import Tree


def map(function: Callable[..., Tree], tree: Tree, *others: Tree) -> Tree:
    """A function of every leaf, and of those of other trees with the same structure; in a tree of this structure."""
    kind = type(tree)
    if tree is None:
        return None
    if isinstance(tree, Module):
        made: Tree = object.__new__(kind)
        fields = made.__dict__
        for name in kind.static_fields:
            fields[name] = getattr(tree, name)
        for name in kind.number_fields:
            fields[name] = map(function, getattr(tree, name), *[getattr(other, name) for other in others])
        return made
    if isinstance(tree, tuple):
        entries = [map(function, *each) for each in zip(tree, *others, strict=True)]
        return kind(*entries) if hasattr(kind, "_fields") else tuple(entries)
    if isinstance(tree, list):
        return [map(function, *each) for each in zip(tree, *others, strict=True)]
    if isinstance(tree, dict):
        made = {key: map(function, tree[key], *[other[key] for other in others]) for key in sorted(tree)}
        return {key: made[key] for key in tree}
    return function(tree, *others)


def leaves(tree: Tree) -> list[Tree]:
    """All leaves, those of a dictionary in the order of its sorted keys."""
    found: list[Tree] = []
    _collect(tree, found)
    return found


def _collect(tree: Tree, found: list[Tree]) -> None:
    if tree is None:
        return
    if isinstance(tree, Module):
        for name in type(tree).number_fields:
            _collect(getattr(tree, name), found)
    elif isinstance(tree, tuple | list):
        for entry in tree:
            _collect(entry, found)
    elif isinstance(tree, dict):
        for key in sorted(tree):
            _collect(tree[key], found)
    else:
        found.append(tree)
