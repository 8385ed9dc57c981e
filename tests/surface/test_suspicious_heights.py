"""Profiles of one surface that disagree beyond their scatter, and heights that mark missing points."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.suspicious_heights import disagreement, end_notes, refuse_missing_marks
from asperity.surface.topography import Topography


def profile(seed, scale=1.0, points=2000, name="p"):
    """A Brownian profile behind a short window, of about 0.1 um."""
    noise = np.random.default_rng(seed).standard_normal(points + 50)
    heights = np.convolve(noise, np.ones(50), "valid")[:points]
    return Topography(scale * 1.4e-8 * (heights - heights.mean()), 1e-6, source=f"{name}{seed}.txt")


def test_profiles_of_one_surface_agree():
    """Independent profiles of one statistics, short and long, never differ enough to be named."""
    for points in (64, 500, 4000):
        assert disagreement([profile(seed, points=points) for seed in range(8)]) == ""


def test_a_difference_beyond_the_scatter_is_said_and_a_large_one_refused():
    words = disagreement([profile(0), profile(1), profile(2, scale=2.0)])
    assert "p2.txt (Pq" in words
    assert 1.5 <= float(words.split(" differ ")[1].split(" times")[0]) <= 2.5  # Pq itself scatters
    with pytest.raises(
        InputError, match=r"are no profiles of one surface: their heights differ 1e\+03 times|9\d\d times"
    ):
        disagreement([profile(0), profile(1, scale=1e3)])


def test_a_profile_with_a_crown_and_noise_of_another_instrument_agrees():
    """Form raises Pq and not the waves, noise the short waves and not Pq: neither alone is another surface."""
    flat = profile(0)
    x = np.linspace(-1.0, 1.0, 2000)
    crowned = Topography(flat.heights + 5e-6 * (x**2 - 1.0 / 3.0), 1e-6, source="crown")
    assert disagreement([flat, crowned]) == ""
    noisy = Topography(
        flat.heights + 3e-8 * np.random.default_rng(9).standard_normal(2000), 1e-6, source="noise"
    )
    assert disagreement([profile(1), noisy]) == ""


@pytest.mark.parametrize("mark", [-9999.0, 32767.0, 0.0])
def test_a_number_that_repeats_far_from_all_others_is_asked_for(mark):
    heights = 1000.0 + np.random.default_rng(3).standard_normal(400)
    heights[[5, 6, 90]] = mark
    with pytest.raises(InputError, match=r"3 points have exactly the (lowest|highest) height"):
        refuse_missing_marks(Topography(1e-9 * heights, 1e-6))
    heights[[5, 6]] = 1000.0  # one alone is a spike
    refuse_missing_marks(Topography(1e-9 * heights, 1e-6))


def test_a_mark_or_a_spike_at_one_end_does_not_hide_a_mark_at_the_other():
    heights = np.random.default_rng(3).standard_normal(400)
    heights[[5, 6, 90]] = -9999.0
    for at, height in (([7], 15000.0), ([7, 8], 9999.0)):
        both = heights.copy()
        both[at] = height
        with pytest.raises(InputError, match="3 points have exactly the lowest height"):
            refuse_missing_marks(Topography(1e-9 * both, 1e-6))


def test_one_point_far_from_all_others_is_said():
    heights = np.random.default_rng(3).standard_normal(400)
    assert end_notes(Topography(1e-9 * heights, 1e-6)) == ()
    rest = np.sort(np.delete(heights, 90))[1:]  # without the other extreme, which may be a mark too
    heights[90] = rest.max() + 5.9 * np.ptp(rest)
    (note,) = end_notes(Topography(1e-9 * heights, 1e-6))
    assert note.startswith("one point has the highest height")
    assert "5.9 times the range of the rest away" in note


def test_steps_and_pits_are_surfaces():
    step = np.where(np.arange(400) < 200, 0.0, 1e-6)
    refuse_missing_marks(Topography(step, 1e-6))
    assert end_notes(Topography(step, 1e-6)) == ()
    worn = np.minimum(np.random.default_rng(4).standard_normal(4000), 0.5)
    (note,) = end_notes(Topography(1e-7 * worn, 1e-6))
    assert note.startswith(
        f"{100.0 * np.mean(worn == 0.5):.3g} % of the points stand at the highest height, 0.05 um"
    )


def test_heights_that_dwell_at_their_ends_were_not_cut_off():
    """A sine dwells at its ends: an outermost level holds about as many points as the next one, and many."""
    levels = np.round(25.0 * np.sin(np.linspace(0.0, 200.0, 20_000)))
    assert 0.3 < np.sum(levels == 25.0) / np.sum(levels == 24.0) < 4.0
    assert end_notes(Topography(1e-9 * levels, 1e-6)) == ()
    assert len(end_notes(Topography(1e-9 * np.clip(levels, -15.0, 20.0), 1e-6))) == 2
