"""Structure functions add: closed form for equal D, a synthetic sum, and refusals."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.equivalent import equivalent_surface
from asperity.surface.measurement import SurfaceMeasurement


def body(D, G, gamma=1.5, band=(1e-7, 1e-4), sd=0.01):
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(D),
        fractal_roughness=jnp.asarray(G),
        frequency_ratio=jnp.asarray(gamma),
        covariance=sd**2 * jnp.eye(2),
        shortest_wavelength=jnp.asarray(band[0]),
        longest_wavelength=jnp.asarray(band[1]),
        estimator="likelihood",
        profiles=1,
        source="s",
    )


@pytest.mark.parametrize("D", [1.2, 1.5, 1.8])
def test_equal_dimensions_add_in_closed_form(D):
    both = equivalent_surface(first=body(D, 1e-9), second=body(D, 3e-9))
    p = 2 * (D - 1)
    assert float(both.fractal_dimension) == pytest.approx(D, abs=1e-10)
    assert float(both.fractal_roughness) == pytest.approx((1e-9**p + 3e-9**p) ** (1 / p), rel=1e-8)


def test_a_smooth_partner_changes_nothing_and_order_does_not_matter():
    one, two = body(1.5, 1e-8), body(1.45, 1e-20)
    both = equivalent_surface(first=one, second=two)
    assert float(both.fractal_dimension) == pytest.approx(1.5, abs=1e-3)
    np.testing.assert_allclose(both.covariance, one.covariance, atol=2e-6)
    swapped = equivalent_surface(first=two, second=one)
    assert float(swapped.fractal_roughness) == pytest.approx(float(both.fractal_roughness), rel=1e-9)


def test_two_equal_bodies_halve_the_variance_of_the_dimension():
    both = equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9))
    assert float(both.covariance[0, 0]) == pytest.approx(0.5e-4, rel=1e-4)


def test_refusals():
    with pytest.raises(InputError, match="gamma"):
        equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9, gamma=2.0))
    with pytest.raises(NoSolutionError, match="share only"):
        equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9, band=(5e-5, 1e-3)))
    with pytest.raises(NoSolutionError, match="differ too much"):
        equivalent_surface(first=body(1.1, 1e-16), second=body(1.9, 2.5e-7))
