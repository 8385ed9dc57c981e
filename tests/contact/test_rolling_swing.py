"""Rolling to and fro against boundary elements, off the nodes of the table."""

import jax
import numpy as np
import pytest

from asperity.contact.rolling_swing import STROKES, still_stroke, swing_drift_share

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
