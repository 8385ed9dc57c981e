"""Rounded heights are found out."""

import numpy as np
import pytest

from asperity.surface.quantisation import height_step, quantisation_noise_density, resolved_frequency


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
    from asperity.surface.read import read_surface

    t = read_surface(
        path=shared_data / "bearing_roller_profiles" / "NU206-RE-1.txt", position_unit="mm", height_unit="um"
    )
    assert height_step(profiles=t.heights[None]) == pytest.approx(0.076e-6, rel=0.03)


def test_noise_of_rounding_is_a_twelfth_of_the_square():
    assert quantisation_noise_density(step=3.0, spacing=2.0) == pytest.approx(2 * 2.0 * 9.0 / 12)
