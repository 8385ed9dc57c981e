"""The start of rolling against an independent table of the creepage and against boundary elements."""

import jax
import numpy as np
import pytest

from asperity.contact.rolling_in import rolling_in_lag, rolling_in_length, rolling_in_shift

#: Integral of 1 - (creepage over its steady value) over the distance rolled, over the half-width: by two independent
# two-dimensional solvers, to two digits.
MISSING = {0.25: 0.42, 0.5: 0.32, 0.657: 0.25, 0.8: 0.17}
#: Creepage over its steady value at these distances over the half-width, by the same.
DISTANCES = np.array([0.02, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0])
CREEPAGE = {
    0.25: [0.501, 0.537, 0.582, 0.638, 0.711, 0.817, 1.044, 1.030, 0.971, 0.983],
    0.5: [0.502, 0.546, 0.604, 0.687, 0.837, 1.222, 1.052, 0.970, 0.998, 1.002],
}


@pytest.mark.parametrize(("q", "missing"), MISSING.items())
def test_what_is_missing_in_the_end(q, missing):
    assert rolling_in_lag(half_width=1.0, slip_ratio=q) == pytest.approx(missing, abs=0.008)
    shift = rolling_in_shift(rolled_distance=5.0, half_width=1.0, slip_ratio=q, creepage=2e-4)
    assert float(shift) / 2e-4 == pytest.approx(5.0 - missing, abs=0.008)


@pytest.mark.parametrize("q", CREEPAGE)
def test_shift_is_the_integral_of_the_creepage(q):
    """Where the creepage has no peak yet: within 0.02 of the half-width."""
    s = np.concatenate([[0.0], DISTANCES])[:6]
    rate = np.concatenate([[0.5], CREEPAGE[q]])[:6]
    expected = np.concatenate([[0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * np.diff(s))])
    found = rolling_in_shift(rolled_distance=s, half_width=1.0, slip_ratio=q, creepage=1.0)
    np.testing.assert_allclose(found, expected, atol=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("q", [0.02, 0.3, 0.6, 0.9])
def test_shift_against_boundary_elements(q):
    shift, rolled = boundary_elements(q, layer_ratio=0.0)
    model = rolling_in_shift(
        rolled_distance=rolled, half_width=1.0, slip_ratio=q, creepage=1.0 - np.sqrt(1.0 - q)
    )
    np.testing.assert_allclose(model, shift, atol=0.03 * (1.0 - np.sqrt(1.0 - q)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("q", "layer_ratio", "close"), [(0.3, 0.2, 0.04), (0.7, 0.2, 0.04), (0.1, 0.2, 0.09), (0.1, 1.0, 0.16)]
)
def test_shift_with_an_elastic_layer(q, layer_ratio, close):
    shift, rolled = boundary_elements(q, layer_ratio=layer_ratio)
    steady = steady_creepage(q, layer_ratio=layer_ratio)
    model = rolling_in_shift(rolled_distance=rolled, half_width=1.0, slip_ratio=q, creepage=steady)
    np.testing.assert_allclose(model, shift, atol=close * float(steady))


def hertz_strip():
    """Strip of unit modulus of one body, and Hertz's pressure on it; half-width 1."""
    from asperity.bem import ElasticPair, FreeHalfSpace

    cells, pixel = 200, 0.01
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(cells + 2,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    return strip, np.pad(np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) / pixel, 1)


def steady_creepage(q, *, layer_ratio):
    """Creepage in steady rolling over that at gross slip without a layer."""
    from asperity.bem import steady_rolling

    strip, pressure = hertz_strip()
    found = steady_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        layer_compliance=layer_ratio,
        longitudinal_force=q * 0.5 * np.pi,
        lateral_creepage=0.0,
    )
    return float(found.creepage[0])


def boundary_elements(q, *, layer_ratio):
    """Shift since rolling began, over the creepage at gross slip, and the distance rolled; half-width 1."""
    from asperity.bem import transient_rolling

    strip, pressure = hertz_strip()
    found = transient_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        axis=0,
        rolled_pixels=[0] + [1] * 300,
        layer_compliance=layer_ratio,  # E c/(2a) with E = 2, a = 1
        tangential_force=[q * 0.5 * np.pi] * 301,
    )
    shift = np.asarray(found.shear.displacement)
    return shift - shift[0], np.asarray(found.rolled_distance)


@pytest.mark.slow
def test_rolling_starts_at_half_the_creepage_and_ends_at_the_whole():
    def shift(s):
        return rolling_in_shift(rolled_distance=s, half_width=1e-4, slip_ratio=0.4, creepage=3e-4)

    assert float(jax.grad(shift)(0.0)) == pytest.approx(1.5e-4, rel=1e-6)
    assert float(jax.grad(shift)(5e-4)) == pytest.approx(3e-4, rel=1e-6)
    steps = np.linspace(0.0, 4e-4, 2001)
    slopes = np.asarray(jax.vmap(jax.grad(shift))(steps))
    assert np.abs(np.diff(slopes)).max() < 3e-6, "the slope is continuous"
    assert np.all(slopes > 0.0)


def test_units_signs_and_gross_slip():
    one = rolling_in_shift(rolled_distance=0.7, half_width=1.0, slip_ratio=0.3, creepage=1.0)
    other = rolling_in_shift(rolled_distance=0.7e-4, half_width=1e-4, slip_ratio=-0.3, creepage=-1.0)
    assert float(other) == pytest.approx(-1e-4 * float(one), rel=1e-12)
    for q in (1.0, 1.5):
        assert float(rolling_in_length(half_width=1.0, slip_ratio=q)) == 0.0
        slope = jax.grad(
            lambda r: rolling_in_shift(rolled_distance=0.2, half_width=1.0, slip_ratio=r, creepage=1.0)
        )(q)
        assert np.isfinite(slope)
    assert float(rolling_in_length(half_width=2.0, slip_ratio=0.875)) == pytest.approx(0.5, rel=1e-12)
