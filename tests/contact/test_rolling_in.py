"""The start of rolling against an independent table of the creepage and against boundary elements."""

import jax
import numpy as np
import pytest

from asperity.contact.rolling_in import (
    STROKES,
    rolling_in_lag,
    rolling_in_length,
    rolling_in_shift,
    still_stroke,
    swing_drift_share,
)

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


CELLS, PIXEL, STEPS = 100, 0.02, 800


@pytest.fixture(scope="module")
def rolled():
    """Shift over the creepage at gross slip, by the steps rolled, from a contact at rest; half-width 1."""
    from asperity.bem import ElasticPair, FreeHalfSpace, transient_rolling

    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(CELLS + 2,), pixel_size=(PIXEL,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, CELLS + 1)
    pressure = np.pad(np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) / PIXEL, 1)

    def shift(steps, slip_ratio, layer=0.0):
        padded = np.zeros(STEPS, dtype=int)
        padded[: len(steps)] = steps
        found = transient_rolling(
            strip,
            pressure,
            friction_coefficient=1.0,
            axis=0,
            rolled_pixels=np.r_[0, padded],
            layer_compliance=layer,
            tangential_force=np.full(STEPS + 1, slip_ratio * pressure.sum() * PIXEL),
        )
        return np.asarray(found.shear.displacement)[: len(steps) + 1]

    return shift


def swings(stroke):
    """Whole swings of so many pixels to and fro."""
    return np.tile(np.r_[np.ones(stroke, int), -np.ones(stroke, int)], STEPS // (2 * stroke))


def share_of_last(shift, stroke, q, factor=1.0):
    steady = factor * (1.0 - np.sqrt(1.0 - q))
    return (shift[-1] - shift[-1 - 2 * stroke]) / (2 * stroke * PIXEL * steady)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("q", "stroke"), [(0.15, 82), (0.15, 130), (0.36, 62), (0.36, 100), (0.65, 34), (0.65, 75), (0.86, 30)]
)
def test_share_against_boundary_elements(rolled, q, stroke):
    found = share_of_last(rolled(swings(stroke), q), stroke, q)
    model = float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q))
    assert model == pytest.approx(found, abs=0.03)


@pytest.mark.slow
@pytest.mark.parametrize("q", [0.05, 0.36, 0.7])
def test_short_swings_come_to_rest(rolled, q):
    stroke = int(float(still_stroke(half_width=1.0, slip_ratio=q)) / PIXEL)
    assert abs(share_of_last(rolled(swings(stroke), q), stroke, q)) < 0.01
    assert float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q)) < 0.005


@pytest.mark.slow
@pytest.mark.parametrize(("q", "stroke"), [(0.3, 100), (0.5, 50), (0.7, 50)])
def test_an_elastic_layer_changes_little(rolled, q, stroke):
    one_way = rolled(np.ones(400, int), q, layer=0.2)
    factor = (one_way[-1] - one_way[-51]) / (50 * PIXEL) / (1.0 - np.sqrt(1.0 - q))
    found = share_of_last(rolled(swings(stroke), q, layer=0.2), stroke, q, factor)
    model = float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q))
    assert model == pytest.approx(found, abs=0.04)


@pytest.mark.parametrize("q", [0.2, 0.5, 0.8])
def test_nothing_comes_back_on_reversal(rolled, q):
    """After steady rolling the drift pauses for about a half-width, and goes on in the same direction."""
    shift = rolled(np.r_[np.ones(175, int), -np.ones(175, int)], q)
    steady = 1.0 - np.sqrt(1.0 - q)
    back = (shift[176:] - shift[175]) / steady
    assert np.all(back > -1e-3)
    assert back[4] < 0.01  # a tenth of a half-width
    assert (back[-1] - back[-26]) / (25 * PIXEL) == pytest.approx(1.0, abs=0.02)
    assert 0.2 < 3.5 - back[-1] < 1.0


def test_long_swings_lose_the_same_in_every_reversal():
    def lost(stroke):
        return stroke * (1.0 - float(swing_drift_share(stroke=stroke, half_width=1e-4, slip_ratio=0.45)))

    end = STROKES[-1] * 0.55e-4
    assert lost(20.0 * end) == pytest.approx(lost(end), rel=1e-9)
    assert lost(1.001 * end) == pytest.approx(lost(end), rel=1e-9)


@pytest.mark.slow
def test_share_is_continuous_and_between_nothing_and_all():
    q, x = np.meshgrid(np.linspace(-0.999, 0.999, 401), np.linspace(0.0, 12.0, 301), indexing="ij")
    share = np.asarray(swing_drift_share(stroke=x, half_width=1.0, slip_ratio=q))
    assert np.all((share >= 0.0) & (share <= 1.0))
    np.testing.assert_allclose(share, share[::-1], atol=1e-15)
    finer = np.linspace(0.0, 8.0, 100_001)
    for slip_ratio in (0.02, 0.33, 0.9):
        line = np.asarray(swing_drift_share(stroke=finer, half_width=1.0, slip_ratio=slip_ratio))
        assert np.abs(np.diff(line)).max() < 2e-3
        assert np.all(np.diff(line) >= -1e-12)
    across = np.asarray(
        swing_drift_share(stroke=1.0, half_width=1.0, slip_ratio=np.linspace(0.0, 0.999, 100_001))
    )
    assert np.abs(np.diff(across)).max() < 2e-3


def test_gross_slip_drifts_as_in_steady_rolling():
    for q in (1.0, -1.5):
        assert float(swing_drift_share(stroke=1e-6, half_width=1e-4, slip_ratio=q)) == 1.0
        assert float(still_stroke(half_width=1e-4, slip_ratio=q)) == 0.0
        slope = jax.grad(lambda r: swing_drift_share(stroke=1e-4, half_width=1e-4, slip_ratio=r))(q)
        assert np.isfinite(slope)
    assert float(still_stroke(half_width=2e-4, slip_ratio=-0.5)) == pytest.approx(1.5e-4, rel=1e-12)
