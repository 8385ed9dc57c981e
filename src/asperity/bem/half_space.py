r"""What every half-space model offers to the solvers, and the periodic one.

The elastic surface is a grid of one axis (a strip in plane strain: loads are per metre of length) or two.
Displacements are those of both bodies together; tractions act on the centre pixel areas. Each model maps traction to
displacement by fast Fourier transforms and also offers the *opposite* map for an unrestricted, periodic surface:
cheap, and close enough to the inverse on a patchy contact area to precondition conjugate gradients
(their iterations then hardly depend on the grid).
"""

from __future__ import annotations

import abc
import math

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.bem.checks import grid
from asperity.bem.elastic_pair import ElasticPair
from asperity.precision import require_double_precision


def _scaled(waves: Array, symbol: Array) -> Array:
    """Complex waves times a real symbol, without promoting the symbol to complex numbers."""
    return jax.lax.complex(waves.real * symbol, waves.imag * symbol)


def filtered(field: Array, symbol: Array) -> Array:
    """Multiply a real field's half-spectrum (last ``symbol.ndim`` axes) by a real symbol.

    Parameters
    ----------
    field : array, shape (..., *grid)
        Real field.
    symbol : array, shape of the half-spectrum
        Factor on each wave.

    Returns
    -------
    array, shape of ``field``
        The filtered field.
    """
    axes = tuple(range(-symbol.ndim, 0))
    shape = field.shape[-symbol.ndim :]
    return jnp.fft.irfftn(_scaled(jnp.fft.rfftn(field, axes=axes), symbol), s=shape, axes=axes)


def mixed(field: Array, symbols: Array, shape: tuple[int, ...]) -> Array:
    """Filter the two components of a vector field by a symmetric 2 x 2 symbol (xx, yy, xy).

    Parameters
    ----------
    field : array, shape (2, *grid)
        Vector field on the grid, zero-padded here if ``shape`` is larger.
    symbols : array, shape (3, *half-spectrum) or (2, *half-spectrum)
        xx, yy and, on grids with two axes, xy.
    shape : tuple of int
        Grid on which the symbols live.

    Returns
    -------
    array, shape of ``field``
        The filtered field.
    """
    axes = tuple(range(1, field.ndim))
    waves = jnp.fft.rfftn(field, s=shape, axes=axes)
    out = _scaled(waves, symbols[:2])
    if len(shape) == 2:
        out = out + _scaled(waves[::-1], symbols[2])
    back = jnp.fft.irfftn(out, s=shape, axes=axes)
    return back[(slice(None), *(slice(n) for n in field.shape[1:]))]


def wavenumbers(shape: tuple[int, ...], pixel_size: tuple[float, ...]) -> list[Array]:
    """Angular wavenumber [rad/m] along each axis of the half-spectrum, broadcastable against each other.

    Parameters
    ----------
    shape : tuple of int
        Points along each axis.
    pixel_size : tuple of float
        Spacing along each axis [m].

    Returns
    -------
    list of arrays
        One per axis.
    """
    last = len(shape) - 1
    q = []
    for axis, (n, d) in enumerate(zip(shape, pixel_size, strict=True)):
        f = jnp.fft.rfftfreq(n, d) if axis == last else jnp.fft.fftfreq(n, d)
        q.append((2.0 * math.pi * f).reshape([-1 if i == axis else 1 for i in range(last + 1)]))
    return q


class HalfSpace(eqx.Module):
    """Linear elastic surface: traction to displacement, and roughly back."""

    pair: eqx.AbstractVar[ElasticPair]
    shape: eqx.AbstractVar[tuple[int, ...]]
    pixel_size: eqx.AbstractVar[tuple[float, ...]]
    periodic: eqx.AbstractVar[bool]

    @property
    def pixel_area(self) -> float:
        """Area of one pixel [m^2]; its length [m] on a strip, where every force is per metre."""
        return math.prod(self.pixel_size)

    @property
    def nominal_area(self) -> float:
        """Area of the whole grid [m^2]; length [m] on a strip."""
        return self.pixel_area * math.prod(self.shape)

    @property
    def force_unit(self) -> str:
        """"N", or "N/m" on a strip."""
        return "N" if len(self.shape) == 2 else "N/m"

    @abc.abstractmethod
    def normal_displacement(self, pressure: Array) -> Array:
        """Normal approach of the surfaces [m] under a pressure field [Pa]."""

    @abc.abstractmethod
    def pressure_estimate(self, displacement: Array) -> Array:
        """Pressure field [Pa] that would give about this displacement [m] on an unrestricted surface."""

    @abc.abstractmethod
    def shear_displacement(self, traction: Array) -> Array:
        """Relative tangential displacement [m], shape (2, *grid), under shear traction [Pa]."""

    @abc.abstractmethod
    def shear_traction_estimate(self, displacement: Array) -> Array:
        """Shear traction [Pa], shape (2, *grid), that would give about this displacement [m]."""

    @abc.abstractmethod
    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """Displacement along one axis [m] under shear traction along the same axis [Pa]; both of grid shape."""

    @abc.abstractmethod
    def aligned_shear_traction_estimate(self, displacement: Array, axis: int) -> Array:
        """Rough inverse of :meth:`aligned_shear_displacement`."""


def normal_symbol(pair: ElasticPair, q: Array) -> Array:
    r""":math:`2/(E q)`, zero for the mean (the mean plane of the surface is the reference).

    Parameters
    ----------
    pair : ElasticPair
        The two bodies.
    q : array
        Magnitude of the wavenumber [rad/m].

    Returns
    -------
    array
        Displacement per pressure [m/Pa].
    """
    return jnp.where(q > 0.0, 2.0 / (pair.contact_modulus * jnp.where(q > 0.0, q, 1.0)), 0.0)


def mean_wavenumber(q: Array) -> Array:
    """Wavenumber [rad/m] that the rough inverse gives to the mean: half the smallest, so that it stays invertible.

    Parameters
    ----------
    q : array
        Magnitude of the wavenumber [rad/m].

    Returns
    -------
    array, scalar
        The wavenumber.
    """
    return 0.5 * jnp.min(jnp.where(q > 0.0, q, jnp.inf))


def shear_symbols(pair: ElasticPair, q_axes: list[Array], shape: tuple[int, ...]) -> tuple[Array, Array]:
    r"""Cerruti's kernel and its inverse in Fourier space.

    .. math:: \hat u_i = \frac1q\left[\frac1G(\delta_{ij} - n_i n_j) + \frac2E n_i n_j\right]\hat\tau_j,
              \qquad n = \mathbf q/q

    Parameters
    ----------
    pair : ElasticPair
        The two bodies.
    q_axes : list of arrays
        Wavenumbers along the axes [rad/m].
    shape : tuple of int
        Points along each axis.

    Returns
    -------
    tuple of arrays
        Compliance (xx, yy and, with two axes, xy), zero for the mean, and its inverse.
    """
    q = jnp.sqrt(sum((k**2 for k in q_axes), jnp.zeros(())))
    safe = jnp.where(q > 0.0, q, 1.0)
    along_x = jnp.where(q > 0.0, (q_axes[0] / safe) ** 2, 0.0)
    if len(shape) == 1:
        projections = [along_x, 1.0 - along_x]
        cross: list[Array] = []
    else:
        # The wave at half the sampling rate stands for both signs of its wavenumber: no cross term there.
        inner = [
            jnp.where(jnp.abs(k) * (1.0 + 1e-9) < jnp.max(jnp.abs(k)), k, 0.0) if n % 2 == 0 else k
            for k, n in zip(q_axes, shape, strict=True)
        ]
        projections = [along_x, 1.0 - along_x]
        cross = [inner[0] * inner[1] / safe**2]
    in_plane, antiplane = 2.0 / pair.contact_modulus, 1.0 / pair.antiplane_modulus

    def combined(along: Array | float, across: Array | float, power: float) -> Array:
        parts = [across + (along - across) * p for p in projections] + [(along - across) * c for c in cross]
        return jnp.where(q > 0.0, jnp.stack(parts) * safe**power, 0.0)

    compliance = combined(in_plane, antiplane, -1.0)
    inverse = combined(1.0 / in_plane, 1.0 / antiplane, 1.0)
    mean = (slice(0, 2), *(0 for _ in shape))
    return compliance, inverse.at[mean].set(mean_wavenumber(q) / in_plane)


class PeriodicHalfSpace(HalfSpace):
    r"""Half-spaces whose surface repeats with the period of the grid.

    Displacements are relative to the mean plane of the surface: a uniform traction moves nothing.

    Parameters
    ----------
    pair : ElasticPair
        The two bodies.
    shape : tuple of int
        Points along each axis; one axis is a strip in plane strain with x across it and y along it.
    pixel_size : tuple of float
        Spacing along each axis [m].

    Raises
    ------
    InputError
        If shape and pixel size do not describe a grid.
    PrecisionError
        If JAX computes in single precision.

    References
    ----------
    H. M. Stanley and T. Kato, J. Tribol. 119 (1997) 481; K. L. Johnson, Contact Mechanics, 1985, section 13.2.
    """

    pair: ElasticPair
    shape: tuple[int, ...] = eqx.field(static=True)
    pixel_size: tuple[float, ...] = eqx.field(static=True)
    _normal: Array
    _normal_inverse: Array
    _shear: Array
    _shear_inverse: Array
    periodic: bool = eqx.field(static=True, default=True)

    def __init__(self, pair: ElasticPair, *, shape: tuple[int, ...], pixel_size: tuple[float, ...]) -> None:
        require_double_precision()
        self.pair = pair
        self.shape, self.pixel_size = grid(shape, pixel_size)
        self.periodic = True
        q_axes = wavenumbers(self.shape, self.pixel_size)
        q = jnp.sqrt(sum((k**2 for k in q_axes), jnp.zeros(())))
        self._normal = normal_symbol(pair, q)
        self._normal_inverse = pair.contact_modulus / 2.0 * jnp.where(q > 0.0, q, mean_wavenumber(q))
        self._shear, self._shear_inverse = shear_symbols(pair, q_axes, self.shape)

    def normal_displacement(self, pressure: Array) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(pressure, self._normal)

    def pressure_estimate(self, displacement: Array) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(displacement, self._normal_inverse)

    def shear_displacement(self, traction: Array) -> Array:
        """See :class:`HalfSpace`."""
        return mixed(traction, self._shear, self.shape)

    def shear_traction_estimate(self, displacement: Array) -> Array:
        """See :class:`HalfSpace`."""
        return mixed(displacement, self._shear_inverse, self.shape)

    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(traction, self._shear[axis])

    def aligned_shear_traction_estimate(self, displacement: Array, axis: int) -> Array:
        """See :class:`HalfSpace`."""
        return filtered(displacement, self._shear_inverse[axis])
