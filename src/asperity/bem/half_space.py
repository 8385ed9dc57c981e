r"""Interface of the half-space models to the solvers, and the periodic half-space.

The elastic surface is a grid of one axis (a strip in plane strain: loads are per metre of length) or two. Displacements
are those of both bodies together; tractions act on the centre pixel areas. Each model maps traction to displacement by
fast Fourier transforms, and also provides an approximate inverse that costs much less than the transforms: the inverse
response of an unrestricted surface, :math:`E q/2`, or its nearest-neighbour part. It preconditions conjugate gradients;
on a patchy contact area the nearest neighbours alone need about 15 % more iterations than the whole.
"""

from __future__ import annotations

import abc
import functools
import itertools
import math
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.elastic_pair import ElasticPair, positive
from asperity.engine.module import Module, static
from asperity.errors import InputError
from asperity.precision import require_double_precision


def _scaled(waves: Array, symbol: Array) -> Array:
    """Complex waves times a real symbol, without promoting the symbol to complex numbers."""
    return jax.lax.complex(waves.real * symbol, waves.imag * symbol)


def filtered(field: Array, symbol: Array) -> Array:
    """A real field whose half-spectrum (last ``symbol.ndim`` axes) is multiplied by a real symbol."""
    axes = tuple(range(-symbol.ndim, 0))
    shape = field.shape[-symbol.ndim :]
    return jnp.fft.irfftn(_scaled(jnp.fft.rfftn(field, axes=axes), symbol), s=shape, axes=axes)


def mixed(field: Array, symbols: Array, shape: tuple[int, ...]) -> Array:
    r"""A vector field, shape (2, \*grid), filtered by a symmetric 2 x 2 symbol: xx, yy and, on grids with two axes, xy.

    ``shape`` is the grid on which the symbols, shape (3 or 2, \*half-spectrum), live; the field is padded with zeros to
    it.
    """
    axes = tuple(range(1, field.ndim))
    waves = jnp.fft.rfftn(field, s=shape, axes=axes)
    out = _scaled(waves, symbols[:2])
    if len(shape) == 2:
        out = out + _scaled(waves[::-1], symbols[2])
    back = jnp.fft.irfftn(out, s=shape, axes=axes)
    return back[(slice(None), *(slice(n) for n in field.shape[1:]))]


def wavenumbers(shape: tuple[int, ...], pixel_size: Array) -> list[Array]:
    """Angular wavenumber [rad/m] along each axis of the half-spectrum, broadcastable against each other."""
    last = len(shape) - 1
    q = []
    for axis, n in enumerate(shape):
        f = jnp.fft.rfftfreq(n) if axis == last else jnp.fft.fftfreq(n)
        q.append(
            (2.0 * math.pi * f / pixel_size[axis]).reshape([-1 if i == axis else 1 for i in range(last + 1)])
        )
    return q


class Operators(NamedTuple):
    """Symbols of the normal and the shear response [m/Pa], and what estimates a traction [Pa/m]."""

    normal: Array
    shear: Array
    estimate: Array


class HalfSpace(Module, abc.ABC):
    """Linear elastic surface: traction to displacement, and its approximate inverse."""

    pair: ElasticPair
    shape: tuple[int, ...] = static()
    pixel_size: Array
    _operators: Operators

    @property
    @abc.abstractmethod
    def periodic(self) -> bool:
        """Whether the surface repeats, so that displacements are relative to its mean plane."""

    @property
    def pixel_area(self) -> Array:
        """Area of one pixel [m^2]; its length [m] on a strip, where every force is per metre."""
        return jnp.prod(self.pixel_size)

    @property
    def nominal_area(self) -> Array:
        """Area of the whole grid [m^2]; length [m] on a strip."""
        return self.pixel_area * float(math.prod(self.shape))

    @property
    def force_unit(self) -> str:
        """Unit of every force: N, or N/m on a strip."""
        return "N" if len(self.shape) == 2 else "N/m"

    @abc.abstractmethod
    def normal_displacement(self, pressure: Array) -> Array:
        """Normal approach of the surfaces [m] under a pressure field [Pa]."""

    @abc.abstractmethod
    def shear_displacement(self, traction: Array) -> Array:
        """Relative tangential displacement [m], shape (2, *grid), under shear traction [Pa]."""

    @abc.abstractmethod
    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """Displacement along one axis [m] under shear traction along the same axis [Pa], both (*grid)."""

    @abc.abstractmethod
    def traction_estimate(self, displacement: Array) -> Array:
        """Traction [Pa] that gives approximately this displacement [m]; any leading axes."""

    def flattening_pressure(self, heights: Array) -> Array:
        """Pressure [Pa], up to a constant, that would press this periodic surface [m] flat."""
        q = wavenumber_magnitude(self.shape, self.pixel_size)
        return filtered(heights, self.pair.contact_modulus / 2.0 * q)


def normal_symbol(pair: ElasticPair, q: Array) -> Array:
    r""":math:`2/(E q)` [m/Pa], zero for the mean (the mean plane of the surface is the reference)."""
    return jnp.where(q > 0.0, 2.0 / (pair.contact_modulus * jnp.where(q > 0.0, q, 1.0)), 0.0)


def wavenumber_magnitude(shape: tuple[int, ...], pixel_size: Array) -> Array:
    """Magnitude of the wavenumber [rad/m] over the half-spectrum."""
    return jnp.sqrt(sum((k**2 for k in wavenumbers(shape, pixel_size)), jnp.zeros(())))


def shear_symbols(pair: ElasticPair, q_axes: list[Array], shape: tuple[int, ...]) -> Array:
    r"""Cerruti's kernel in Fourier space [m/Pa], components xx, yy and xy (one axis: xx and yy); zero for the mean.

    .. math:: \hat u_i = \frac1q\left[\frac1G(\delta_{ij} - n_i n_j) + \frac2E n_i n_j\right]\hat\tau_j,
              \qquad n = \mathbf q/q
    """
    q = jnp.sqrt(sum((k**2 for k in q_axes), jnp.zeros(())))
    safe = jnp.where(q > 0.0, q, 1.0)
    along_x = jnp.where(q > 0.0, (q_axes[0] / safe) ** 2, 0.0)
    cross: list[Array] = []
    if len(shape) == 2:
        # The wave at half the sampling rate stands for both signs of its wavenumber: no cross term there.
        inner = [
            jnp.where(jnp.abs(k) * (1.0 + 1e-9) < jnp.max(jnp.abs(k)), k, 0.0) if n % 2 == 0 else k
            for k, n in zip(q_axes, shape, strict=True)
        ]
        cross = [inner[0] * inner[1] / safe**2]
    in_plane, antiplane = 2.0 / pair.contact_modulus, 1.0 / pair.antiplane_modulus

    parts = [antiplane + (in_plane - antiplane) * p for p in (along_x, 1.0 - along_x)]
    parts += [(in_plane - antiplane) * c for c in cross]
    return jnp.where(q > 0.0, jnp.stack(parts) / safe, 0.0)


def nearest_neighbour_weights(shape: tuple[int, ...], pixel_size: Array) -> Array:
    """The part of the operator :math:`q` that reaches the nearest neighbours, diagonal ones included [1/m].

    Symmetric, and positive as an operator because the long-range part that it leaves out is negative.
    """
    kernel = jnp.fft.irfftn(wavenumber_magnitude(shape, pixel_size), s=shape)
    near = jnp.array([1, 0, 1])
    return kernel[near] if len(shape) == 1 else kernel[near[:, None], near[None, :]]


def weighted_neighbours(field: Array, weights: Array) -> Array:
    """Each value replaced by the weighted sum of its neighbourhood, zero beyond the edge."""
    axes = weights.ndim
    grid_shape = field.shape[-axes:]
    padded = jnp.pad(field, [(0, 0)] * (field.ndim - axes) + [(1, 1)] * axes)
    total = jnp.zeros_like(field)
    for offset in itertools.product(range(3), repeat=axes):
        shifted = padded[(..., *(slice(o, o + n) for o, n in zip(offset, grid_shape, strict=True)))]
        total = total + weights[offset] * shifted
    return total


@functools.partial(jax.jit, static_argnames="shape")
def _periodic_operators(pair: ElasticPair, shape: tuple[int, ...], pixel_size: Array) -> Operators:
    return Operators(
        normal_symbol(pair, wavenumber_magnitude(shape, pixel_size)),
        shear_symbols(pair, wavenumbers(shape, pixel_size), shape),
        pair.contact_modulus / 2.0 * nearest_neighbour_weights(shape, pixel_size),
    )


class PeriodicHalfSpace(HalfSpace):
    """Half-spaces of a pair whose surface repeats with the period of the grid.

    ``shape``: points along each axis; one axis is a strip in plane strain with x across it and y along it.
    ``pixel_size``: spacing along each axis [m]. Displacements are relative to the mean plane of the surface: a uniform
    traction causes no displacement. An ``InputError`` for what is no grid, a ``PrecisionError`` if JAX computes in
    single precision.

    References
    ----------
    H. M. Stanley and T. Kato, J. Tribol. 119 (1997) 481; K. L. Johnson, Contact Mechanics, 1985, section 13.2.
    """

    def __init__(
        self,
        pair: ElasticPair,
        *,
        shape: tuple[int, ...],
        pixel_size: tuple[float, ...] | Array,
        _operators: Operators | None = None,
    ) -> None:
        if _operators is None:  # JAX makes copies with all fields
            require_double_precision()
            pair = jax.tree.map(jnp.asarray, pair)
            shape, pixel_size = grid(shape, pixel_size)
            _operators = _periodic_operators(pair, shape, pixel_size)
        vars(self).update(pair=pair, shape=shape, pixel_size=pixel_size, _operators=_operators)

    @property
    def periodic(self) -> bool:
        """See :class:`HalfSpace`."""
        return True

    def normal_displacement(self, pressure: Array) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(pressure, self._operators.normal)

    def shear_displacement(self, traction: Array) -> Array:
        """See :class:`HalfSpace`."""
        return mixed(traction, self._operators.shear, self.shape)

    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(traction, self._operators.shear[axis])

    def traction_estimate(self, displacement: Array) -> Array:
        """See :class:`HalfSpace`."""
        return weighted_neighbours(displacement, self._operators.estimate)


def field_on_grid(name: str, field: ArrayLike, shape: tuple[int, ...]) -> np.ndarray:
    """The field as a double-precision array; an ``InputError`` if it does not fit the grid or a value is not finite."""
    array = np.asarray(field, dtype=np.float64)
    if array.shape != shape:
        raise InputError(f"{name} has shape {array.shape}: the grid of the half-space has {shape}")
    bad = int(np.size(array) - np.count_nonzero(np.isfinite(array)))
    if bad:
        raise InputError(f"{name} has {bad} of {array.size} values that are not finite numbers")
    return array


def pressure_on_grid(pressure: ArrayLike, shape: tuple[int, ...]) -> np.ndarray:
    """The field of a pressure [Pa]; an ``InputError`` as well if a value is negative, or none is positive."""
    p = field_on_grid("pressure", pressure, shape)
    if p.min() < 0.0 or p.max() <= 0.0:
        raise InputError(
            f"pressure lies between {p.min():g} and {p.max():g} Pa: it must not be negative, and must be positive "
            "in the contact"
        )
    return p


def grid(shape: tuple[int, ...], pixel_size: tuple[float, ...] | Array) -> tuple[tuple[int, ...], Array]:
    """Points and spacing [m] of a grid of one axis (a strip, plane strain) or two; an ``InputError`` for any other."""
    points = tuple(int(n) for n in shape)
    spacing = tuple(positive("pixel_size", d, "m") for d in pixel_size)
    if len(points) not in (1, 2) or len(points) != len(spacing) or min(points) < 2:
        raise InputError(
            f"shape {points} with pixel_size of {len(spacing)} values: a grid has one or two axes, at least "
            "2 points along each and one pixel size per axis"
        )
    return points, jnp.asarray(spacing, dtype=jnp.float64)
