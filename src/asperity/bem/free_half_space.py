"""Half-spaces loaded on a finite window: exact pixel coefficients, zero-padded convolution."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.bem.checks import grid, positive
from asperity.bem.elastic_pair import ElasticPair
from asperity.bem.half_space import HalfSpace, filtered, mixed, wavenumber_magnitude
from asperity.bem.influence import normal_patch, patch_integrals, shear_patch, strip_integral
from asperity.errors import InputError
from asperity.precision import require_double_precision


def _wrapped_distance(points: int, spacing: float) -> Array:
    """0, 1, ... n-1, (n), 1-n, ... -1 pixels, as the circular convolution of twice the length wants it [m]."""
    steps = jnp.arange(2 * points)
    return jnp.where(steps <= points, steps, steps - 2 * points).astype(jnp.float64) * spacing


class FreeHalfSpace(HalfSpace):
    r"""Half-spaces that carry traction only inside the grid's window and are free elsewhere.

    With two axes displacements are relative to infinity. With one axis the grid is a strip in plane strain, where
    displacement grows without bound; it is then relative to ``reference_distance``.

    Parameters
    ----------
    pair : ElasticPair
        The two bodies.
    shape : tuple of int
        Points along each axis.
    pixel_size : tuple of float
        Spacing along each axis [m].
    reference_distance : float, optional
        Only on a strip, and required there: distance from a load at which the surface is taken as unmoved [m].

    Raises
    ------
    InputError
        If shape and pixel size do not describe a grid, or the reference distance is missing or out of place.
    PrecisionError
        If JAX computes in single precision.

    Notes
    -----
    The convolution with the pixels' influence coefficients is exact (no periodic images) as the transforms run
    on twice the window along each axis.

    References
    ----------
    S. Liu, Q. Wang and G. Liu, Wear 243 (2000) 101.
    """

    pair: ElasticPair
    shape: tuple[int, ...] = eqx.field(static=True)
    pixel_size: tuple[float, ...] = eqx.field(static=True)
    _normal: Array
    _shear: Array
    _inverse: Array
    periodic: bool = eqx.field(static=True, default=False)

    def __init__(
        self,
        pair: ElasticPair,
        *,
        shape: tuple[int, ...],
        pixel_size: tuple[float, ...],
        reference_distance: float | None = None,
    ) -> None:
        require_double_precision()
        self.pair = pair
        self.shape, self.pixel_size = grid(shape, pixel_size)
        self.periodic = False
        q = wavenumber_magnitude(self.shape, self.pixel_size)
        lowest = jnp.min(jnp.where(q > 0.0, q, jnp.inf))
        # Transforms of the bare window cost a quarter of the response's: take the whole inverse of the periodic surface,
        # its mean (zero) replaced so that it stays positive.
        self._inverse = pair.contact_modulus / 2.0 * jnp.maximum(q, 0.5 * lowest)
        if len(self.shape) == 1:
            if reference_distance is None:
                raise InputError("a strip (one axis) needs reference_distance [m]; displacement has no limit there")
            distance = _wrapped_distance(self.shape[0], self.pixel_size[0])
            base = strip_integral(
                distance,
                pixel_size=self.pixel_size[0],
                reference_distance=positive("reference_distance", reference_distance, "m"),
            )
            symbol = jnp.fft.rfft(base).real
            self._normal = 2.0 / pair.contact_modulus * symbol
            self._shear = jnp.stack([self._normal, symbol / pair.antiplane_modulus])
        else:
            if reference_distance is not None:
                raise InputError("reference_distance is for a strip; with two axes the reference is infinity")
            x, y = (_wrapped_distance(n, d) for n, d in zip(self.shape, self.pixel_size, strict=True))
            xx, yy, xy = patch_integrals(x[:, None], y[None, :], pixel_size=self.pixel_size)
            # Entry n is reached by no pair of points; an odd coefficient has to vanish there to stay real.
            xy = xy.at[self.shape[0], :].set(0.0).at[:, self.shape[1]].set(0.0)
            coefficients = jnp.stack([normal_patch(pair, xx, yy), *shear_patch(pair, xx, yy, xy)])
            symbols = jnp.fft.rfftn(coefficients, axes=(1, 2)).real
            self._normal, self._shear = symbols[0], symbols[1:]

    def _convolved(self, traction: Array, symbol: Array) -> Array:
        padded = jnp.pad(traction, [(0, n) for n in self.shape])
        return filtered(padded, symbol)[tuple(slice(n) for n in self.shape)]

    def normal_displacement(self, pressure: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return self._convolved(pressure, self._normal)

    def shear_displacement(self, traction: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return mixed(traction, self._shear, tuple(2 * n for n in self.shape))

    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return self._convolved(traction, self._shear[axis])

    def traction_estimate(self, displacement: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return filtered(displacement, self._inverse)
