"""The periodic Weierstrass–Mandelbrot map: its variance in closed form, period, isotropy, ranges."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.conventions import areal_roughness_from_profile
from asperity.verify.periodic_weierstrass import periodic_weierstrass_surface

ARGUMENTS = {
    "points": 64,
    "side": 1e-3,
    "longest_wavelength": 0.5e-3,
    "shortest_wavelength": 8e-3 / 64,
    "fractal_dimension": 1.4,
    "fractal_roughness": 1e-11,
    "frequency_ratio": 1.5,
}


def surface(seed=0, **change):
    return periodic_weierstrass_surface(**(ARGUMENTS | change), random=np.random.default_rng(seed))


def test_the_mean_square_is_the_sum_of_half_squared_amplitudes():
    """Equation (6) with the areal G: every wave adds half of its squared amplitude, whatever its phase."""
    z = surface()
    areal = areal_roughness_from_profile(fractal_dimension=1.4, fractal_roughness=1e-11)
    frequencies = (
        1.5 ** np.arange(4) / 0.5e-3
    )  # 2 to 6.75 waves per side; the next would be shorter than 8 pixels
    amplitudes = np.sqrt(np.log(1.5)) * areal**0.4 * frequencies**-0.6
    assert np.mean(z**2) == pytest.approx(np.sum(amplitudes**2) / 2.0, rel=1e-10, abs=0.0)
    assert abs(z.mean()) < 1e-15


def test_the_spectrum_lies_on_rings():
    power = np.abs(np.fft.fft2(surface())) ** 2
    k = np.fft.fftfreq(64, 1 / 64)
    distance = np.hypot(*np.meshgrid(k, k))[power > 1e-15 * power.max()]
    rings = 2.0 * 1.5 ** np.arange(4)
    assert np.abs(distance[:, None] - rings).min(axis=1).max() <= 0.5
    np.testing.assert_allclose(power, np.roll(power[::-1, ::-1], (1, 1), (0, 1)), atol=1e-9 * power.max())


def test_seeds_differ_and_repeat():
    assert np.array_equal(surface(3), surface(3))
    assert not np.allclose(surface(3), surface(4))


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"fractal_dimension": 2.4}, "between 1 and 2"),
        ({"shortest_wavelength": 1e-6}, "two pixels"),
        ({"longest_wavelength": 2e-3}, "must lie between"),
        ({"frequency_ratio": 1.0}, "frequency_ratio = 1"),
    ],
)
def test_bad_input_is_named(change, named):
    with pytest.raises(InputError, match=named):
        surface(**change)
