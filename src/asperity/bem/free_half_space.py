"""Half-spaces loaded on a finite window: exact pixel coefficients, zero-padded convolution."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import jax
import jax.numpy as jnp
from jax import Array

from asperity.bem.elastic_pair import ElasticPair, positive
from asperity.bem.half_space import HalfSpace, Operators, filtered, grid, mixed, wavenumber_magnitude
from asperity.errors import InputError
from asperity.precision import require_double_precision


def _wrapped_distance(points: int, spacing: Array) -> Array:
    """0, 1, ... n-1, (n), 1-n, ... -1 pixels [m], the order of a circular convolution of twice the length."""
    steps = jnp.arange(2 * points)
    return jnp.where(steps <= points, steps, steps - 2 * points).astype(jnp.float64) * spacing


@functools.partial(jax.jit, static_argnames="shape")
def _strip_operators(
    pair: ElasticPair, shape: tuple[int, ...], pixel_size: Array, reference_distance: Array
) -> tuple[Array, Array]:
    base = strip_integral(
        _wrapped_distance(shape[0], pixel_size[0]),
        pixel_size=pixel_size[0],
        reference_distance=reference_distance,
    )
    symbol = jnp.fft.rfft(base).real
    normal = 2.0 / pair.contact_modulus * symbol
    return normal, jnp.stack([normal, symbol / pair.antiplane_modulus])


@functools.partial(jax.jit, static_argnames="shape")
def _surface_operators(pair: ElasticPair, shape: tuple[int, ...], pixel_size: Array) -> tuple[Array, Array]:
    x, y = (_wrapped_distance(n, pixel_size[axis]) for axis, n in enumerate(shape))
    xx, yy, xy = patch_integrals(x[:, None], y[None, :], pixel_size=pixel_size)
    # No pair of points uses entry n; an odd coefficient must vanish there for the symbol to be real.
    xy = xy.at[shape[0], :].set(0.0).at[:, shape[1]].set(0.0)
    coefficients = jnp.stack([normal_patch(pair, xx, yy), *shear_patch(pair, xx, yy, xy)])
    symbols = jnp.fft.rfftn(coefficients, axes=(1, 2)).real
    return symbols[0], symbols[1:]


@functools.partial(jax.jit, static_argnames="shape")
def _window_inverse(pair: ElasticPair, shape: tuple[int, ...], pixel_size: Array) -> Array:
    """Inverse response of the periodic surface on the bare window, its mean (zero) raised to be positive.

    Transforms of the window cost a quarter of those of the response, so using the whole inverse pays off here.
    """
    q = wavenumber_magnitude(shape, pixel_size)
    lowest = jnp.min(jnp.where(q > 0.0, q, jnp.inf))
    return pair.contact_modulus / 2.0 * jnp.maximum(q, 0.5 * lowest)


def _free_operators(
    pair: ElasticPair, shape: tuple[int, ...], pixel_size: Array, reference_distance: float | None
) -> Operators:
    if len(shape) == 2:
        if reference_distance is not None:
            raise InputError("reference_distance is for a strip; with two axes the reference is infinity")
        normal, shear = _surface_operators(pair, shape, pixel_size)
    else:
        if reference_distance is None:
            raise InputError(
                "a strip (one axis) needs reference_distance [m]; the displacement of a strip is unbounded"
            )
        far = jnp.asarray(positive("reference_distance", reference_distance, "m"))
        normal, shear = _strip_operators(pair, shape, pixel_size, far)
    return Operators(normal, shear, _window_inverse(pair, shape, pixel_size))


class FreeHalfSpace(HalfSpace):
    """Half-spaces of a pair that carry traction only inside the grid's window and are free elsewhere.

    ``shape``: points along each axis; ``pixel_size``: their spacing [m]. With two axes displacements are relative to
    infinity. With one axis the grid is a strip in plane strain, where displacement grows without bound: there, and only
    there, a ``reference_distance`` [m] from a load is required, at which the displacement is taken as zero. The
    convolution with the pixels' influence coefficients is exact (no periodic images) as the transforms run on twice the
    window along each axis.

    An ``InputError`` for what is no grid, or a reference distance that is missing or not applicable; a
    ``PrecisionError`` if JAX computes in single precision.

    References
    ----------
    S. Liu, Q. Wang and G. Liu, Wear 243 (2000) 101.
    """

    def __init__(
        self,
        pair: ElasticPair,
        *,
        shape: tuple[int, ...],
        pixel_size: tuple[float, ...] | Array,
        reference_distance: float | None = None,
        _operators: Operators | None = None,
    ) -> None:
        if _operators is None:  # JAX makes copies with all fields
            require_double_precision()
            pair = jax.tree.map(jnp.asarray, pair)
            shape, pixel_size = grid(shape, pixel_size)
            _operators = _free_operators(pair, shape, pixel_size, reference_distance)
        vars(self).update(pair=pair, shape=shape, pixel_size=pixel_size, _operators=_operators)

    @property
    def periodic(self) -> bool:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return False

    def _convolved(self, traction: Array, symbol: Array) -> Array:
        padded = jnp.pad(traction, [(0, n) for n in self.shape])
        return filtered(padded, symbol)[tuple(slice(n) for n in self.shape)]

    def normal_displacement(self, pressure: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return self._convolved(pressure, self._operators.normal)

    def shear_displacement(self, traction: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return mixed(traction, self._operators.shear, tuple(2 * n for n in self.shape))

    def aligned_shear_displacement(self, traction: Array, axis: int) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return self._convolved(traction, self._operators.shear[axis])

    def traction_estimate(self, displacement: Array) -> Array:
        """See :class:`~asperity.bem.half_space.HalfSpace`."""
        return filtered(displacement, self._operators.estimate)

    def layered_traction_estimate(self, displacement: Array, layer_compliance: Array) -> Array:
        """Traction [Pa] that gives roughly this displacement [m] with a layer [m/Pa] on the surface."""
        covered, softest = layer_compliance > 0.0, jnp.max(layer_compliance)
        typical = jnp.min(jnp.where(covered, layer_compliance, softest))
        weight = jnp.sqrt(jnp.where(covered, typical / jnp.where(covered, layer_compliance, 1.0), 1.0))
        inverse = self._operators.estimate
        return weight * filtered(weight * displacement, inverse / (1.0 + typical * inverse))

    def coupled_displacement(self, traction: Array) -> Array:
        r"""Displacement [m] across a strip under pressure [Pa]; minus the normal one under shear across it.

        .. math:: u(x) = -\frac{\beta}{E}\int \operatorname{sgn}(x - s)\, p(s)\, \mathrm ds
        """
        n = traction.shape[0]
        x = jnp.arange(1 - n, n).astype(jnp.float64) * self.pixel_size[0]
        kernel = coupling_integral(x, pixel_size=self.pixel_size[0])
        scale = 2.0 * self.pair.dundurs_constant / self.pair.contact_modulus
        return scale * jnp.convolve(traction, kernel)[n - 1 : 2 * n - 1]


def _over_pixel(
    primitive: Callable[[Array, Array], Array], x: Array, y: Array, dx: Array, dy: Array
) -> Array:
    right, left, top, bottom = x + dx / 2.0, x - dx / 2.0, y + dy / 2.0, y - dy / 2.0
    return primitive(right, top) - primitive(right, bottom) - primitive(left, top) + primitive(left, bottom)


def patch_integrals(x: Array, y: Array, *, pixel_size: Array) -> tuple[Array, Array, Array]:
    r"""Integrals [m] of :math:`x^2/r^3`, :math:`y^2/r^3`, :math:`xy/r^3` over the pixel centred at (x, y).

    No corner may have x = 0 or y = 0: x and y are multiples of the pixel size.
    """
    dx, dy = pixel_size[0], pixel_size[1]
    xx = _over_pixel(lambda a, b: b * jnp.arcsinh(a / jnp.abs(b)), x, y, dx, dy)
    yy = _over_pixel(lambda a, b: a * jnp.arcsinh(b / jnp.abs(a)), x, y, dx, dy)
    xy = _over_pixel(lambda a, b: -jnp.hypot(a, b), x, y, dx, dy)
    return xx, yy, xy


def normal_patch(pair: ElasticPair, xx: Array, yy: Array) -> Array:
    r"""Normal displacement per pressure [m/Pa], :math:`\frac{1}{\pi E} \int\!\!\int \frac1r`.

    References
    ----------
    A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377; K. L. Johnson, Contact Mechanics, 1985, equation
    (3.25).
    """
    return (xx + yy) / (math.pi * pair.contact_modulus)


def shear_patch(pair: ElasticPair, xx: Array, yy: Array, xy: Array) -> tuple[Array, Array, Array]:
    r"""Tangential displacements per shear traction on a pixel [m/Pa] (Cerruti), components xx, yy, xy.

    .. math::
        u_{xx} = \frac{1}{2\pi}\int\!\!\int\left[\frac{x^2}{G r^3} + \frac{2 y^2}{E r^3}\right], \quad
        u_{xy} = \frac{1}{2\pi}\left(\frac1G - \frac2E\right)\int\!\!\int\frac{xy}{r^3}

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (3.75), summed over both bodies.
    """
    in_plane, antiplane = 2.0 / pair.contact_modulus, 1.0 / pair.antiplane_modulus
    scale = 1.0 / (2.0 * math.pi)
    return (
        scale * (antiplane * xx + in_plane * yy),
        scale * (antiplane * yy + in_plane * xx),
        scale * (antiplane - in_plane) * xy,
    )


def strip_integral(x: Array, *, pixel_size: Array, reference_distance: Array) -> Array:
    r"""Integral [m] of :math:`\frac1\pi\ln(d/|x - s|)` over the pixel centred at s = 0, of width ``pixel_size`` [m].

    x: distances between pixel centres [m]; d: distance at which the displacement is taken as zero [m]. Times 2/E it is
    the displacement along the normal or across the strip, times 1/G the displacement along the strip, per traction.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 2.3 (an infinite strip has no displacement at infinity to refer to,
    so a distance has to be chosen).
    """

    def primitive(s: Array) -> Array:
        return s * (1.0 - jnp.log(jnp.abs(s) / reference_distance))

    return (primitive(x + pixel_size / 2.0) - primitive(x - pixel_size / 2.0)) / math.pi


def coupling_integral(x: Array, *, pixel_size: Array) -> Array:
    r"""Integral [m] of :math:`-\tfrac12\operatorname{sgn}(x - s)` over the pixel centred at s = 0.

    Times :math:`2\beta/E` it is the displacement across the strip per pressure, and with the opposite sign the normal
    displacement per traction across the strip.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (2.25), taken over both bodies.
    """

    def primitive(s: Array) -> Array:
        return -0.5 * jnp.abs(s)

    return primitive(x + pixel_size / 2.0) - primitive(x - pixel_size / 2.0)
