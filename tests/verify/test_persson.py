"""Persson's theory against its own limits and an independent integration."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.verify.persson import contact_fraction, interfacial_stiffness, wave_spectrum


def test_small_loads_give_persson_slope_and_large_ones_complete_contact():
    small = contact_fraction(mean_pressure=1e-6, contact_modulus=2.0, rms_slope=0.5)
    assert float(small) == pytest.approx(np.sqrt(8.0 / np.pi) * 1e-6 / (2.0 * 0.5), rel=1e-9)
    assert float(contact_fraction(mean_pressure=5.0, contact_modulus=2.0, rms_slope=0.5)) == pytest.approx(
        1.0
    )


def test_the_spectrum_of_one_wave():
    x = np.arange(32) / 32.0
    spectrum = wave_spectrum(np.tile(0.1 * np.cos(2 * np.pi * 3 * x), (32, 1)), sides=(1.0, 1.0))
    assert float(spectrum.rms_height) == pytest.approx(0.1 / np.sqrt(2.0))
    assert float(spectrum.rms_slope) == pytest.approx(0.1 * 6 * np.pi / np.sqrt(2.0))
    np.testing.assert_allclose(spectrum.wavenumber, 6 * np.pi)


def test_stiffness_is_the_integral_over_a_power_law_spectrum():
    """Sum over the waves of a map against quadrature of the published integral for C = C0 q^-(2+2H)."""
    n, H, level = 512, 0.7, 1e-6
    k = np.fft.fftfreq(n, 1.0 / n)
    q = 2.0 * np.pi * np.hypot(*np.meshgrid(k, k, indexing="ij"))
    low, high = 2.0 * np.pi * 8, 2.0 * np.pi * 128
    band = (q >= low) & (q <= high)
    density = np.where(band, level * np.where(band, q, 1.0) ** (-2.0 - 2.0 * H), 0.0)
    phases = np.angle(np.fft.fft2(np.random.default_rng(0).standard_normal((n, n))))
    heights = np.fft.ifft2(n**2 * 2.0 * np.pi * np.sqrt(density) * np.exp(1j * phases)).real
    spectrum = wave_spectrum(heights, sides=(1.0, 1.0))

    def slope_square(upper):
        return 2.0 * np.pi * level * (upper ** (2.0 - 2.0 * H) - low ** (2.0 - 2.0 * H)) / (2.0 - 2.0 * H)

    def integrand(wave):
        return wave**2 * level * wave ** (-2.0 - 2.0 * H) * np.sqrt(2.0 / slope_square(wave))

    length = 0.45 * np.sqrt(np.pi) * quad(integrand, low, high, points=[1.01 * low], limit=200)[0]
    pressure = 1e-7 * np.sqrt(slope_square(high))
    found = interfacial_stiffness(spectrum=spectrum, mean_pressure=pressure, contact_modulus=1.0)
    assert float(found) == pytest.approx(pressure / length, rel=0.03)


def test_stiffness_per_load_grows_towards_complete_contact():
    heights = np.random.default_rng(1).standard_normal((16, 16))
    spectrum = wave_spectrum(heights - heights.mean(), sides=(1.0, 1.0))
    pressure = jnp.array([0.001, 0.1, 1.0]) * float(spectrum.rms_slope)
    per_load = (
        interfacial_stiffness(spectrum=spectrum, mean_pressure=pressure, contact_modulus=1.0) / pressure
    )
    assert per_load[2] > per_load[0]
