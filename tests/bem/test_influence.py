"""Influence coefficients against direct quadrature of the point-load solutions."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import dblquad, quad

from asperity.bem.influence import coupling_integral, patch_integrals, strip_integral

DX, DY = 0.8, 1.3


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
