"""The free response: direct sums, far field, and the limit of the periodic one."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import dblquad, quad

from asperity.bem import ElasticPair, FreeHalfSpace, PeriodicHalfSpace
from asperity.bem.free_half_space import coupling_integral, patch_integrals, strip_integral
from asperity.errors import InputError

PAIR = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
DX, DY = 0.8, 1.3


def test_the_padded_convolution_has_no_images():
    free = FreeHalfSpace(PAIR, shape=(6, 5), pixel_size=(0.4, 0.3))
    columns = np.stack([np.ravel(free.normal_displacement(jnp.array(e.reshape(6, 5)))) for e in np.eye(30)])
    np.testing.assert_allclose(columns, columns.T, atol=1e-15)
    np.testing.assert_allclose(
        columns[0, 0], columns[-1, -1], rtol=1e-12
    )  # corners do not see each other's images
    assert columns[0, -1] == columns[0].min()


@pytest.mark.slow
def test_the_periodic_response_tends_to_the_free_one_near_a_balanced_load():
    """A curved load's field decays fast: a long period then changes little."""
    n = 64
    smooth = np.exp(-(((np.arange(n) - 32) / 3.0) ** 2))
    bump = np.outer(smooth, np.gradient(np.gradient(smooth)))
    free = FreeHalfSpace(PAIR, shape=(n, n), pixel_size=(1.0, 1.0)).normal_displacement(jnp.array(bump))
    periodic = PeriodicHalfSpace(PAIR, shape=(n, n), pixel_size=(1.0, 1.0)).normal_displacement(
        jnp.array(bump)
    )
    assert float(jnp.abs(free - periodic).max() / jnp.abs(free).max()) < 0.02


def test_a_strip_needs_its_reference_and_a_surface_has_infinity():
    with pytest.raises(InputError, match="needs reference_distance"):
        FreeHalfSpace(PAIR, shape=(8,), pixel_size=(1.0,))
    with pytest.raises(InputError, match="the reference is infinity"):
        FreeHalfSpace(PAIR, shape=(8, 8), pixel_size=(1.0, 1.0), reference_distance=1.0)


def test_the_reference_distance_of_a_strip_only_shifts_the_displacement():
    near = FreeHalfSpace(PAIR, shape=(8,), pixel_size=(0.1,), reference_distance=1.0)
    far = FreeHalfSpace(PAIR, shape=(8,), pixel_size=(0.1,), reference_distance=10.0)
    load = jnp.arange(8.0)
    shift = far.normal_displacement(load) - near.normal_displacement(load)
    expected = 2.0 / (np.pi * 2.0) * float(load.sum()) * 0.1 * np.log(10.0)
    np.testing.assert_allclose(shift, expected, rtol=1e-12)


def test_pressure_moves_the_surfaces_of_unlike_bodies_along_each_other():
    """Its gradient is -2 beta p/E (Johnson 1985, (2.25)); far away half the load to either side."""
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.3)
    strip = FreeHalfSpace(pair, shape=(64,), pixel_size=(0.1,), reference_distance=1.0)
    x = (np.arange(64) - 31.5) * 0.1
    pressure = np.exp(-(x**2))
    found = np.asarray(strip.coupled_displacement(jnp.array(pressure)))
    middle = 0.5 * (pressure[1:] + pressure[:-1])
    np.testing.assert_allclose(np.diff(found) / 0.1, -2.0 * 0.3 * middle / 2.0, atol=1e-14)
    np.testing.assert_allclose(found, -found[::-1], atol=1e-15)
    assert found[0] == pytest.approx(0.3 / 2.0 * np.sqrt(np.pi), rel=1e-3)


def test_the_rough_inverse_with_a_layer_is_exact_without_edges():
    """On a full period the free inverse symbol E q/2 in series with the layer."""
    strip = FreeHalfSpace(PAIR, shape=(64,), pixel_size=(0.1,), reference_distance=1.0)
    q = 2.0 * np.pi * 5.0 / 6.4
    wave = np.cos(q * 0.1 * np.arange(64))
    found = strip.layered_traction_estimate(jnp.array(wave), jnp.full(64, 0.7))
    np.testing.assert_allclose(found, wave / (2.0 / (2.0 * q) + 0.7), atol=1e-12)


@pytest.mark.parametrize(("column", "row"), [(1, 0), (0, 2), (2, -1), (-3, 4)])
def test_patch_integrals_match_quadrature_over_the_pixel(column, row):
    x, y = column * DX, row * DY
    found = patch_integrals(jnp.array(x), jnp.array(y), pixel_size=jnp.array([DX, DY]))
    for value, numerator in zip(
        found, (lambda a, b: a * a, lambda a, b: b * b, lambda a, b: a * b), strict=True
    ):
        expected, _ = dblquad(
            lambda b, a, f=numerator: f(a, b) / np.hypot(a, b) ** 3,
            x - DX / 2, x + DX / 2, y - DY / 2, y + DY / 2, epsabs=1e-12,
        )  # fmt: skip
        assert float(value) == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_own_pixel_of_a_square_is_loves_value():
    xx, yy, xy = patch_integrals(jnp.array(0.0), jnp.array(0.0), pixel_size=jnp.array([1.0, 1.0]))
    assert float(xx + yy) == pytest.approx(
        4.0 * np.log(1.0 + np.sqrt(2.0)), rel=1e-14
    )  # Johnson 1985, (3.26)
    assert float(xy) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("steps", [0, 1, -5])
def test_strip_integral_matches_quadrature(steps):
    width, far = 0.3, 7.0
    x = steps * width
    expected, _ = quad(
        lambda s: np.log(far / abs(s)) / np.pi,
        x - width / 2,
        x + width / 2,
        points=[0.0] if steps == 0 else None,
    )
    found = strip_integral(jnp.array(x), pixel_size=jnp.array(width), reference_distance=jnp.array(far))
    assert float(found) == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize(("steps", "expected"), [(0, 0.0), (1, -0.15), (4, -0.15), (-2, 0.15)])
def test_coupling_integral_is_half_the_pixel_on_either_side(steps, expected):
    found = coupling_integral(jnp.array(steps * 0.3), pixel_size=jnp.array(0.3))
    assert float(found) == pytest.approx(expected, abs=1e-15)
