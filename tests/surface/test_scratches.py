"""Scratches of known size on self-affine profiles: named where they bend D, and nothing where there are none."""

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.surface.fractal_fit import fractal_fit
from asperity.surface.scratches import scratches
from asperity.surface.synthesis import self_affine_profile, spectral_surface

SPACING = 1e-7


def profile(dimension, seed, points=4096):
    random = np.random.default_rng(seed)
    heights = self_affine_profile(
        points=points,
        spacing=SPACING,
        fractal_dimension=dimension,
        fractal_roughness=1e-10,
        random=random,
    )
    return heights, random


def scratched(heights, random, depth, count=12):
    """Valleys of 1 to 4 um width and V shape, so many rms heights deep, in random places."""
    x = np.arange(heights.size) * SPACING
    z = heights.copy()
    for _ in range(count):
        width, place = random.uniform(1e-6, 4e-6), random.uniform(0.0, x[-1])
        z -= depth * heights.std() * np.maximum(1.0 - 2.0 * np.abs(x - place) / width, 0.0)
    return z


def judged(profiles, rows_of_a_map=False):
    return scratches(
        profiles=profiles,
        spacing=SPACING,
        shortest_wavelength=4.0 * SPACING,
        longest_wavelength=profiles.shape[1] * SPACING / 6.0,
        rows_of_a_map=rows_of_a_map,
    )


@pytest.mark.parametrize(("dimension", "depth"), [(1.3, 0.3), (1.5, 1.0), (1.7, 3.0)])
def test_scratches_and_spikes_are_told_apart(dimension, depth):
    heights, random = profile(dimension, seed=1)
    z = scratched(heights, random, depth)[None]
    assert judged(z).startswith("scratches or other sharp valleys: around ")
    assert judged(-z).startswith("spikes or other sharp peaks: around ")


def test_normally_distributed_heights_have_none():
    """One in sixty: of 60 profiles, short ones and such of four levels of roughness, at most four."""
    found = 0
    for seed in range(20):
        smooth = profile(1.1, seed, points=1024)[0]
        rough = profile(1.7, seed)[0]
        quarters = np.cumsum(
            np.diff(profile(1.5, seed, points=4097)[0]) * np.repeat([0.5, 1.0, 1.5, 2.0], 1024)
        )
        found += sum(bool(judged(z[None])) for z in (smooth, rough, quarters))
    assert found <= 4


def test_rows_of_a_map_that_are_alike_count_once():
    """Grooves: the scatter of the skewness is that of one profile, not of 32."""
    found = 0
    for seed in range(8):
        groove, random = profile(1.5, seed, points=512)
        found += bool(
            judged(groove + 1e-3 * groove.std() * random.standard_normal((64, 512)), rows_of_a_map=True)
        )
    isotropic = spectral_surface(
        rows=256,
        columns=256,
        areal_fractal_roughness=1e-10,
        periodic=False,
        spacing=SPACING,
        fractal_dimension=1.5,
        random=np.random.default_rng(0),
    )
    assert found + bool(judged(isotropic, rows_of_a_map=True)) <= 1
    isotropic[:, 100:104] -= isotropic.std()
    assert judged(isotropic, rows_of_a_map=True).startswith("scratches")


def test_equal_heights_and_short_profiles_have_none():
    assert judged(np.zeros((1, 4096))) == ""
    assert judged(profile(1.5, 0, points=128)[0][None]) == ""


def fit(z):
    return fractal_fit(
        profiles=z[None], spacing=SPACING, estimator="likelihood", frequency_ratio=1.5, rows_of_a_map=False
    )


def test_the_refusal_has_their_name():
    heights, random = profile(1.5, seed=3)
    assert fit(heights).fractal_dimension == pytest.approx(1.5, abs=0.1)
    with pytest.raises(NoSolutionError, match=r"no D and G, because .*scratches"):
        fit(scratched(heights, random, 0.6))


@pytest.mark.long
def test_intervals_of_accepted_profiles_with_scratches_hold():
    """Twelve scratches of 0.1, 0.3 and 1 rms height: 85 % of what is accepted, which was 30 to 80 %."""
    accepted, covered = 0, 0
    for depth in (0.1, 0.3, 1.0):
        for dimension in (1.3, 1.5, 1.7):
            for seed in range(12):
                heights, random = profile(dimension, seed=1000 * seed + 77)
                try:
                    got = fit(scratched(heights, random, depth))
                except NoSolutionError:
                    continue
                low, high = got.dimension_interval(confidence=0.95)
                accepted += 1
                covered += low <= dimension <= high
    assert accepted > 30
    assert covered >= 0.85 * accepted
