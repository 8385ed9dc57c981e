"""Persson's theory against its own limits and an independent integration."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import beta, erf

from asperity.bem import (
    FreeHalfSpace,
    PeriodicHalfSpace,
    elastic_pair,
    normal_contact,
    normal_stiffness,
)
from asperity.contact.persson_2007 import (
    PERSSON_OVER_BOUNDARY_ELEMENTS,
    contact_fraction,
    persson_decay_length,
    sorted_waves,
    wave_spectrum,
    waves_along_line,
)
from asperity.surface.height_spectrum import spectrum_of_map, spectrum_of_profiles
from asperity.surface.topography import Topography


def interfacial_stiffness(*, mean_pressure, **state):
    return mean_pressure / persson_decay_length(mean_pressure=mean_pressure, **state)


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


def self_affine(H, *, low=1.0, high=1e6, count=4000):
    """Waves of C = C0 q^-(2+2H) from low to high, of the mean square height 1, in bins by their rms wavenumber."""
    edges = np.geomspace(low, high, count + 1)
    variance = -np.diff(edges ** (-2.0 * H)) / (low ** (-2.0 * H) - high ** (-2.0 * H))
    slope = H / (1.0 - H) * np.diff(edges ** (2.0 - 2.0 * H)) / (low ** (-2.0 * H) - high ** (-2.0 * H))
    return sorted_waves(np.sqrt(slope / variance), variance)


@pytest.mark.parametrize(("H", "ratio"), [(0.5, 0.5640), (0.8, 0.4787)])
def test_decay_length_of_a_self_affine_surface_at_small_pressure(H, ratio):
    """0.45/sqrt(2 pi) sqrt(H/(1 - H)) B(1/2, H/(2 - 2H)) of the rms height without a shortest wave: 0.48 for H = 0.8.

    The integral of the publication by hand, by s = (q/q0)^(2-2H).
    """
    closed = 0.45 / np.sqrt(2.0 * np.pi) * np.sqrt(H / (1.0 - H)) * beta(0.5, H / (2.0 - 2.0 * H))
    assert closed == pytest.approx(ratio, abs=5e-5)
    length = persson_decay_length(spectrum=self_affine(H), mean_pressure=1e-9, contact_modulus=1.0)
    assert float(length) == pytest.approx(closed, rel=2e-3)


@pytest.mark.parametrize("pressure", [0.01, 0.1, 0.4, 1.5])
def test_decay_length_is_the_published_integral_at_any_pressure(pressure):
    """sqrt(pi) int q^2 C w [gamma + 3 (1 - gamma) P^2] exp(-(w p/E)^2) dq by quadrature; p over E h' up to 1.5."""
    H, low, high = 0.7, 1.0, 100.0
    waves = self_affine(H, low=low, high=high, count=2000)
    level = H / np.pi / (low ** (-2.0 * H) - high ** (-2.0 * H))
    mean_pressure = pressure * float(waves.rms_slope)

    def integrand(q):
        slope = np.pi * level * (q ** (2.0 - 2.0 * H) - low ** (2.0 - 2.0 * H)) / (1.0 - H)
        w = np.sqrt(2.0 / slope)
        energy = 0.45 + 3.0 * 0.55 * erf(w * mean_pressure) ** 2
        return q ** (-2.0 * H) * level * w * energy * np.exp(-((w * mean_pressure) ** 2))

    expected = np.sqrt(np.pi) * quad(integrand, low, high, points=[1.01, 1.2, 3.0, 20.0], limit=400)[0]
    length = persson_decay_length(spectrum=waves, mean_pressure=mean_pressure, contact_modulus=1.0)
    assert float(length) == pytest.approx(expected, rel=2e-3)


def test_complete_contact_has_a_compliance_of_nothing():
    waves = self_affine(0.8, high=100.0, count=100)
    lengths = persson_decay_length(
        spectrum=waves, mean_pressure=jnp.array([1.0, 10.0, 1e4]) * waves.rms_slope, contact_modulus=1.0
    )
    assert lengths[0] > lengths[1] >= lengths[2] == 0.0
    assert np.isinf(interfacial_stiffness(spectrum=waves, mean_pressure=1e6, contact_modulus=1.0))

    def length(pressure):
        return persson_decay_length(spectrum=waves, mean_pressure=pressure, contact_modulus=1.0)

    middle = 0.3 * float(waves.rms_slope)
    step = 1e-5 * middle
    slope = (length(middle + step) - length(middle - step)) / (2.0 * step)
    assert float(jax.grad(length)(middle)) == pytest.approx(float(slope), rel=1e-6)
    assert float(jax.grad(length)(1e4 * middle)) == 0.0


def rolled_off(H):
    """A self-affine map, rolled off at 25 µm, h_rms 0.14 µm, 512 points of 1 µm, of all waves down to the pixel."""
    frequency = np.fft.fftfreq(512, 1e-6)
    size = np.maximum(np.hypot(frequency[:, None], frequency), 1.0 / 25e-6)
    size[np.hypot(frequency[:, None], frequency) < 1.0 / 100e-6] = np.inf
    noise = np.fft.fft2(np.random.default_rng(2).standard_normal((512, 512)))
    heights = np.fft.ifft2(noise * size ** (-1.0 - H)).real
    return heights * 0.14e-6 / heights.std()


@pytest.mark.parametrize("H", [0.5, 0.8])
def test_bins_of_a_measured_spectrum_in_place_of_every_wave(H):
    """Those of a map to 3 %; those of its profiles, as of a surface without grooves, to 13 %."""
    heights = rolled_off(H)
    every = wave_spectrum(heights, sides=(512e-6, 512e-6))
    of_map = spectrum_of_map(topography=Topography(heights, 1e-6, 1e-6, source="map"), rolling="x")
    profiles = spectrum_of_profiles(profiles=heights, spacing=1e-6, lay="isotropic", source="profiles")
    for spectrum, error in ((of_map, 0.03), (profiles, 0.13)):
        waves = sorted_waves(*spectrum.waves(rolling=0.0, axial=0.0))
        assert float(waves.rms_slope) == pytest.approx(float(every.rms_slope), rel=0.02)
        for pressure in (10e6, 100e6, 1000e6):
            length, expected = (
                float(persson_decay_length(spectrum=one, mean_pressure=pressure, contact_modulus=113e9))
                for one in (waves, every)
            )
            assert length == pytest.approx(expected, rel=error)


@pytest.mark.slow
@pytest.mark.parametrize("pressure", [100e6, 1000e6])
def test_stiffness_of_boundary_elements(pressure):
    """Within the error that a joint takes of it, and above 0.8 on a self-affine map of Hurst exponent 0.8."""
    pair = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    heights = rolled_off(0.8)[:256, :256]  # no period: mirrored
    heights = np.block([[heights, heights[:, ::-1]], [heights[::-1], heights[::-1, ::-1]]])
    half_space = PeriodicHalfSpace(pair, shape=(512, 512), pixel_size=(1e-6, 1e-6))
    touches = normal_contact(half_space, heights, normal_force=pressure * 512e-6**2).pressure > 0.0
    stiffness = float(normal_stiffness(half_space, touches).stiffness) / 512e-6**2
    theory = interfacial_stiffness(
        spectrum=wave_spectrum(heights, sides=(512e-6, 512e-6)),
        mean_pressure=pressure,
        contact_modulus=pair.contact_modulus,
    )
    low, high = PERSSON_OVER_BOUNDARY_ELEMENTS
    assert low < 0.8 < float(theory) / stiffness < high


def test_waves_of_two_bodies_in_any_order_are_those_of_one():
    """The mean squares of like bodies add, to what three points of Gauss make of a first wave with half of it all."""
    wavenumber, variance = np.geomspace(1.0, 100.0, 40), np.geomspace(1.0, 1e-4, 40)
    half = np.concatenate([0.5 * variance[::-1], 0.5 * variance])
    waves = (
        sorted_waves(wavenumber, variance),
        sorted_waves(np.concatenate([wavenumber[::-1], wavenumber]), half),
    )
    for pressure in (0.01, 0.1, 1.0):
        one, both = (
            float(persson_decay_length(spectrum=spectrum, mean_pressure=pressure, contact_modulus=1.0))
            for spectrum in waves
        )
        assert both == pytest.approx(one, rel=0.03)


@pytest.mark.slow
def test_waves_along_a_roller_against_boundary_elements():
    """Waves along the axis alone: closed by the line load, or the roller rests on a part of its line.

    The line load that closes them varies by 0.5, 2 and 10 times its mean, rms. A roller of 10 mm on waves of 150 to
    640 um; its compliance less that of the smooth one.
    """
    pair = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    modulus, radius, half_width = float(pair.contact_modulus), 10e-3, 70e-6
    rows, columns, pixel = 384, 64, 5e-6
    line_load = np.pi * modulus * half_width**2 / (4.0 * radius)
    half_space = FreeHalfSpace(pair, shape=(rows, columns), pixel_size=(pixel, pixel))
    gap = ((np.arange(columns) - 0.5 * (columns - 1)) * pixel) ** 2 / (2.0 * radius) * np.ones((rows, 1))

    def decay_length(heights):
        load = line_load * rows * pixel
        contact = normal_contact(half_space, heights[:, None] - gap, normal_force=load)
        return load / float(normal_stiffness(half_space, contact.pressure > 0.0).stiffness)

    smooth = decay_length(np.zeros(rows))
    count = np.arange(3, 13)
    wavenumber = 2.0 * np.pi * count / (rows * pixel)
    ratios = []
    for seed in range(2):
        random = np.random.default_rng(seed)
        amplitude = random.rayleigh(size=count.size) / np.sqrt(count)
        phases = random.uniform(0.0, 2.0 * np.pi, count.size)
        shape = amplitude @ np.cos(np.outer(wavenumber, np.arange(rows) * pixel) + phases[:, None])
        unit = waves_along_line(wavenumber, 0.5 * amplitude**2, half_width=half_width)
        for deep in (0.5, 2.0, 10.0):
            factor = deep * line_load / (0.5 * modulus * float(unit.rms_slope))
            waves = waves_along_line(wavenumber, 0.5 * (factor * amplitude) ** 2, half_width=half_width)
            theory = persson_decay_length(spectrum=waves, mean_pressure=line_load, contact_modulus=modulus)
            elements = decay_length(factor * shape) - smooth
            if deep < 1.0:
                assert max(abs(elements), float(theory)) < 0.05 * float(waves.rms_height)
            else:
                ratios.append(elements / float(theory))
    assert 0.4 < min(ratios) < max(ratios) < 1.1
