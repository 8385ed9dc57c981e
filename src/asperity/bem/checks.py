"""Checks of user input: each message states the quantity, its value and the allowed range."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.errors import InputError


def positive(name: str, value: float, unit: str, *, infinite: bool = False) -> float:
    """The value as a float; an ``InputError`` unless it is positive, and finite too unless ``infinite``."""
    number = float(value)
    if not number > 0.0 or (math.isinf(number) and not infinite):
        kind = "positive" if infinite else "positive and finite"
        raise InputError(f"{name} = {number:g} {unit}: it must be {kind}")
    return number


def inside(name: str, value: float, low: float, high: float) -> float:
    """The value as a float; an ``InputError`` unless low < value <= high."""
    number = float(value)
    if not low < number <= high:
        raise InputError(f"{name} = {number:g}: it must lie above {low:g} and be at most {high:g}")
    return number


def field_on_grid(name: str, field: ArrayLike, shape: tuple[int, ...]) -> np.ndarray:
    """The field as a double-precision array; an ``InputError`` if it does not fit the grid or a value is not finite."""
    array = np.asarray(field, dtype=np.float64)
    if array.shape != shape:
        raise InputError(f"{name} has shape {array.shape}: the grid of the half-space has {shape}")
    bad = int(np.size(array) - np.count_nonzero(np.isfinite(array)))
    if bad:
        raise InputError(f"{name} has {bad} of {array.size} values that are not finite numbers")
    return array


def grid(shape: tuple[int, ...], pixel_size: tuple[float, ...]) -> tuple[tuple[int, ...], Array]:
    """Shape and pixel size of a grid with one axis (a strip, plane strain) or two, checked.

    Parameters
    ----------
    shape : tuple of int
        Points along each axis, at least 2.
    pixel_size : tuple of float
        Spacing along each axis [m].

    Returns
    -------
    tuple
        Shape, and the pixel size as an array.

    Raises
    ------
    InputError
        If they do not describe such a grid.
    """
    points = tuple(int(n) for n in shape)
    spacing = tuple(positive("pixel_size", d, "m") for d in pixel_size)
    if len(points) not in (1, 2) or len(points) != len(spacing) or min(points) < 2:
        raise InputError(
            f"shape {points} with pixel_size of {len(spacing)} values: a grid has one or two axes, at least "
            "2 points along each and one pixel size per axis"
        )
    return points, jnp.asarray(spacing, dtype=jnp.float64)
