"""The start of rolling against an independent table of the creepage and against boundary elements."""

import jax
import numpy as np
import pytest
from rolling_strip import rolling_strip

from asperity.contact.rolling_in import (
    STROKES,
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


# Missing creep over half of the rolling-in length, in steps of an eighth of that length, by boundary elements
# (``examples/rolling_contact.py``): mean over q = 0.1, 0.2, … 0.8, 200 and 300 cells extrapolated to infinitely many.
BY_ELEMENTS = np.array([
    0.1233, 0.2430, 0.3589, 0.4709, 0.5783, 0.6810, 0.7783, 0.8697, 0.9546, 1.0317, 1.0996, 1.1507, 1.1781, 1.1754,
    1.1388, 1.0747, 1.0289, 1.0009, 0.9839, 0.9747, 0.9709, 0.9710, 0.9739, 0.9786, 0.9846, 0.9911, 0.9978,
])  # fmt: skip


def missing(distance, q=0.0):
    """Missing creep over half of the rolling-in length, at a distance over that length."""
    length = (1.0 - q) ** (2.0 / 3.0)
    shift = rolling_in_shift(rolled_distance=distance * length, half_width=1.0, slip_ratio=q, creepage=1.0)
    return (distance * length - np.asarray(shift)) / (0.5 * length)


@pytest.mark.parametrize("q", [0.0, 0.4])
def test_every_entry_of_the_table_is_that_of_boundary_elements(q):
    """To 2e-3 at the entries, in the middle between them to 4e-3, behind the peak to 9e-3."""
    distance = 0.125 * np.arange(1, 28)
    close = np.where(np.arange(1, 28) % 2 == 0, 2e-3, np.where(distance == 1.875, 9e-3, 4e-3))
    assert np.all(np.abs(missing(distance, q) - BY_ELEMENTS) < close)
    np.testing.assert_allclose(missing(np.array([3.5, 4.0, 10.0]), q), 1.0, rtol=1e-12)


@pytest.mark.long
def test_the_table_of_boundary_elements_recomputed(load_example):
    example, distance, found = load_example("rolling_contact"), 0.125 * np.arange(1, 28), []
    for cells in (200, 300):
        contact, each = example.LineContact(cells), []
        for q in np.arange(1, 9) / 10.0:
            rolled, shift = contact.rolled(np.ones(round(3.6 / contact.pixel), dtype=int), q)
            length = (1.0 - q) ** (2.0 / 3.0)
            lag = rolled - (shift - shift[0]) / example.carter(q)
            each.append(np.interp(distance * length, rolled, lag) / (0.5 * length))
        found.append(np.mean(each, axis=0))
    np.testing.assert_allclose(3.0 * found[1] - 2.0 * found[0], BY_ELEMENTS, atol=2e-4)


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


@pytest.mark.programs("derivatives by JAX, one operation after the other")
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
    return rolling_strip(CELLS, STEPS)


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
    found = share_of_last(rolled(q, swings(stroke)), stroke, q)
    model = float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q))
    assert model == pytest.approx(found, abs=0.03)


#: Drift of strokes over that of steady rolling by boundary elements of 300 cells (``examples/rolling_swing.py``, whose
# CELLS and STEPS were 300 and 3000): a row for each slip ratio, a column for each stroke over a (1 - q).
SWINGING = {
    0.02: [0.0, 0.0001, 0.0002, 0.0034, 0.0245, 0.3561, 0.5451, 0.6246, 0.6766, 0.7090, 0.7440],
    0.1: [0.0, 0.0001, 0.0005, 0.0174, 0.2075, 0.3656, 0.5254, 0.6149, 0.6729, 0.7051, 0.7373],
    0.2: [0.0, 0.0, 0.0006, 0.1062, 0.2346, 0.3456, 0.4965, 0.5997, 0.6674, 0.7007, 0.7297],
    0.3: [0.0, 0.0, 0.0263, 0.1309, 0.2311, 0.3213, 0.4627, 0.5787, 0.6600, 0.6965, 0.7234],
    0.4: [0.0, 0.0, 0.0487, 0.1363, 0.2199, 0.2963, 0.4244, 0.5522, 0.6492, 0.6919, 0.7185],
    0.5: [0.0, 0.0, 0.0586, 0.1333, 0.2047, 0.2713, 0.3866, 0.5158, 0.6327, 0.6853, 0.7146],
    0.6: [0.0, 0.0006, 0.0614, 0.1260, 0.1881, 0.2464, 0.3499, 0.4735, 0.6068, 0.6737, 0.7097],
    0.7: [0.0, 0.0060, 0.0599, 0.1160, 0.1701, 0.2215, 0.3140, 0.4281, 0.5658, 0.6503, 0.6992],
    0.8: [0.0, 0.0087, 0.0554, 0.1039, 0.1511, 0.1959, 0.2777, 0.3817, 0.5135, 0.6064, 0.6710],
    0.9: [0.0023, 0.0090, 0.0486, 0.0896, 0.1293, 0.1680, 0.2386, 0.3287, 0.4501, 0.5396, 0.6092],
    0.95: [0.0021, 0.0084, 0.0442, 0.0806, 0.1165, 0.1514, 0.2143, 0.2983, 0.4082, 0.4946, 0.5620],
}
STROKE = np.array([1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.2, 2.5, 3.0, 3.5, 4.0])


@pytest.mark.parametrize("q", SWINGING)
def test_every_entry_of_the_table_of_swings_is_that_of_boundary_elements(q):
    """To a unit of the last digit; at both ends of the table, where a pixel more is another stroke, to 2.5e-3."""
    found = swing_drift_share(stroke=STROKE * (1.0 - q), half_width=1.0, slip_ratio=q)
    np.testing.assert_allclose(found, SWINGING[q], atol=1e-3 if 0.02 < q < 0.9 else 2.5e-3)


@pytest.mark.parametrize("low", [0.1, 0.3, 0.6])
def test_between_the_entries_the_table_of_swings_is_straight(low):
    high = low + 0.1
    middle = 0.5 * (low + high)
    near, far = (np.array(SWINGING[min(SWINGING, key=lambda q, at=at: abs(q - at))]) for at in (low, high))
    found = swing_drift_share(stroke=STROKE * (1.0 - middle), half_width=1.0, slip_ratio=middle)
    np.testing.assert_allclose(found, 0.5 * (near + far), atol=1e-3)
    halves = 0.5 * (STROKE[1:] + STROKE[:-1])
    found = swing_drift_share(stroke=halves * (1.0 - low), half_width=1.0, slip_ratio=low)
    np.testing.assert_allclose(found, 0.5 * (near[1:] + near[:-1]), atol=1e-3)


@pytest.mark.long
@pytest.mark.parametrize(("q", "column"), [(0.02, 6), (0.3, 7), (0.6, 10), (0.95, 8)])
def test_the_table_of_swings_recomputed(load_example, monkeypatch, q, column):
    example = load_example("rolling_swing")
    for name, value in (("CELLS", 300), ("STEPS", 3000), ("PIXEL", 2.0 / 300)):
        monkeypatch.setattr(example, name, value)
    exact = STROKE[column] * (1.0 - q) / example.PIXEL
    pixels = np.array([int(np.floor(exact)), int(np.ceil(exact + 1e-9))])
    shares = [example.drift_share(q, int(pixel)) for pixel in pixels]
    assert np.interp(exact, pixels, shares) == pytest.approx(SWINGING[q][column], abs=3e-3)


@pytest.mark.slow
@pytest.mark.parametrize("q", [0.05, 0.36, 0.7])
def test_short_swings_come_to_rest(rolled, q):
    stroke = int(float(still_stroke(half_width=1.0, slip_ratio=q)) / PIXEL)
    assert abs(share_of_last(rolled(q, swings(stroke)), stroke, q)) < 0.01
    assert float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q)) < 0.005


@pytest.mark.slow
@pytest.mark.parametrize(("q", "stroke"), [(0.3, 100), (0.5, 50), (0.7, 50)])
def test_an_elastic_layer_changes_little(rolled, q, stroke):
    one_way = rolled(q, np.ones(400, int), layer=0.2)
    factor = (one_way[-1] - one_way[-51]) / (50 * PIXEL) / (1.0 - np.sqrt(1.0 - q))
    found = share_of_last(rolled(q, swings(stroke), layer=0.2), stroke, q, factor)
    model = float(swing_drift_share(stroke=stroke * PIXEL, half_width=1.0, slip_ratio=q))
    assert model == pytest.approx(found, abs=0.04)


@pytest.mark.parametrize("q", [0.2, 0.5, 0.8])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_nothing_comes_back_on_reversal(rolled, q):
    """After steady rolling the drift pauses for about a half-width, and goes on in the same direction."""
    shift = rolled(q, np.r_[np.ones(175, int), -np.ones(175, int)])
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


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_gross_slip_drifts_as_in_steady_rolling():
    for q in (1.0, -1.5):
        assert float(swing_drift_share(stroke=1e-6, half_width=1e-4, slip_ratio=q)) == 1.0
        assert float(still_stroke(half_width=1e-4, slip_ratio=q)) == 0.0
        slope = jax.grad(lambda r: swing_drift_share(stroke=1e-4, half_width=1e-4, slip_ratio=r))(q)
        assert np.isfinite(slope)
    assert float(still_stroke(half_width=2e-4, slip_ratio=-0.5)) == pytest.approx(1.5e-4, rel=1e-12)
