"""Transform against double loop, with and without gaps."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.structure_function import (
    height_step,
    logarithmic_lags,
    quantisation_noise_density,
    resolved_frequency,
    structure_functions,
)


@pytest.mark.parametrize("gaps", [False, True])
def test_equals_the_double_loop(gaps):
    random = np.random.default_rng(3)
    z = np.cumsum(random.standard_normal((3, 301)), axis=1) + 7.0
    if gaps:
        z[random.random(z.shape) < 0.1] = np.nan
    lags = np.array([1, 2, 16, 17, 40, 150, 300])
    got = structure_functions(profiles=z, lags=lags)
    expected = np.array([[np.nanmean((row[k:] - row[:-k]) ** 2) if k else 0 for k in lags[:-1]] for row in z])
    np.testing.assert_allclose(got[:, :-1], expected, rtol=1e-9)


def test_lags_are_distinct_and_bounded():
    lags = logarithmic_lags(points=1000, per_decade=10, longest_fraction=0.25)
    assert lags[0] == 1
    assert lags[-1] == 250
    assert (np.diff(lags) > 0).all()
    with pytest.raises(InputError, match="lags must lie between 1 and 9 points"):
        structure_functions(profiles=np.zeros((1, 10)), lags=np.array([10]))


def test_lags_are_ten_to_a_decade():
    """Long lags follow 10^(k/10); the longest is the requested share of the record."""
    lags = logarithmic_lags(points=40_000, per_decade=10, longest_fraction=0.25)
    np.testing.assert_array_equal(lags[-11:], np.round(10_000 * 10 ** (np.arange(-10, 1) / 10)))


@pytest.mark.parametrize("gaps", [False, True])
def test_an_offset_costs_no_digits(gaps):
    """Heights of order one on an offset of 1e7: squares of 1e14 leave two digits of the difference."""
    z = np.cumsum(np.random.default_rng(4).standard_normal((2, 500)), axis=1)
    if gaps:
        z[:, ::7] = np.nan
    lags = np.array([1, 16, 17, 100, 400])
    level = structure_functions(profiles=z, lags=lags)
    np.testing.assert_allclose(structure_functions(profiles=z + 1e7, lags=lags), level, rtol=1e-6)
    assert np.isnan(structure_functions(profiles=np.array([[1.0, np.nan, 2.0]]), lags=np.array([1]))).all()


def test_blocks_of_rows_change_nothing(monkeypatch):
    from asperity.surface import structure_function

    z = np.random.default_rng(5).standard_normal((7, 60))
    whole = structure_functions(profiles=z, lags=np.array([1, 20, 59]))
    monkeypatch.setattr(structure_function, "_CHUNK_POINTS", 130)
    np.testing.assert_array_equal(structure_functions(profiles=z, lags=np.array([1, 20, 59])), whole)


def test_step_is_found_under_a_tilt_and_absent_without_rounding():
    z = np.cumsum(np.random.default_rng(0).standard_normal((1, 3000)), axis=1)
    assert height_step(profiles=z) is None
    rounded = np.round(z / 0.7) * 0.7 + 0.01 * np.arange(3000)
    assert height_step(profiles=rounded) == pytest.approx(0.7, rel=0.02)


def test_many_small_moves_are_no_step():
    """Nine in ten moves are tiny and the others of any size: the tiny ones are multiples of nothing."""
    random = np.random.default_rng(3)
    tiny, large = 1e-4 * random.standard_normal(4000), random.uniform(0.5, 3.0, 4000)
    moves = np.where(random.random(4000) < 0.9, tiny, large * random.choice([-1.0, 1.0], 4000))
    assert height_step(profiles=np.cumsum(moves)[None]) is None


def test_staircase_with_rare_steps():
    z = np.cumsum(np.cumsum(np.random.default_rng(1).standard_normal((1, 20000)), axis=1), axis=1)
    step = 1e-2 * z.std()
    got = height_step(profiles=np.round(z / step) * step)
    assert got == pytest.approx(step, rel=1e-3)


def test_coarse_steps_are_found_and_limit_the_frequency():
    z = np.cumsum(np.random.default_rng(0).standard_normal((1, 20000)), axis=1)
    rounded = np.round(z / 5.0) * 5.0
    step = height_step(profiles=rounded)
    assert step == pytest.approx(5.0, rel=0.01)
    # a random walk moves by 5 rms in 25 points: waves of 100 points are resolved
    assert resolved_frequency(profiles=rounded, step=step, spacing=1.0) == pytest.approx(0.01, rel=0.5)
    assert resolved_frequency(profiles=z, step=0.1, spacing=1.0) == np.inf


def test_bearing_step(shared_data):
    """SOURCE.txt: heights in steps of about 0.076 um."""
    from asperity.surface.measure_files import read_surface

    t = read_surface(
        path=shared_data / "bearing_roller_profiles" / "NU206-RE-1.txt", position_unit="mm", height_unit="um"
    )
    assert height_step(profiles=t.heights[None]) == pytest.approx(0.076e-6, rel=0.03)


def test_noise_of_rounding_is_a_twelfth_of_the_square():
    assert quantisation_noise_density(step=3.0, spacing=2.0) == pytest.approx(2 * 2.0 * 9.0 / 12)
