"""Parseval, one sine, white noise."""

import itertools

import numpy as np
import pytest
import scipy.signal

from asperity.errors import InputError
from asperity.surface.spectrum import (
    _correlation,
    _independent_ordinates,
    bin_edges,
    binned_spectrum,
    power_spectral_densities,
    raised_cosine,
    without_line,
)


def test_parseval_with_the_power_of_the_window():
    z = np.random.default_rng(0).standard_normal((1, 256))
    z -= np.polynomial.polynomial.polyval(
        np.arange(256), np.polynomial.polynomial.polyfit(np.arange(256), z[0], 1)
    )
    f, P = power_spectral_densities(profiles=z, spacing=0.1)
    w = scipy.signal.get_window("hann", 256)
    power = (np.sum((w * z) ** 2) - np.sum(w * z) ** 2 / 256) / np.sum(w**2)  # without that of the mean
    assert np.sum(P[0]) * (f[1] - f[0]) == pytest.approx(power, rel=1e-12)


@pytest.mark.parametrize("points", [16, 255, 1000])
def test_raised_cosines_are_the_windows_of_hann_and_tukey(points):
    for share, name in ((1.0, "hann"), (0.1, ("tukey", 0.1))):
        np.testing.assert_allclose(
            raised_cosine(points, share), scipy.signal.get_window(name, points), atol=1e-14
        )


@pytest.mark.parametrize("differenced", [False, True])
def test_white_noise_has_density_two_variance_spacing(differenced):
    z = 3.0 * np.random.default_rng(1).standard_normal((40, 4096))
    b = binned_spectrum(
        profiles=z, spacing=0.5, differenced=differenced, bins_per_decade=5, rows_of_a_map=False
    )
    upper = b.frequency > 0.05
    np.testing.assert_allclose(b.density[upper], 2 * 9.0 * 0.5, rtol=0.05)


def test_identical_rows_of_a_map_count_as_few():
    row = np.random.default_rng(2).standard_normal(1024)
    same = np.tile(row, (64, 1))
    b = binned_spectrum(profiles=same, spacing=1.0, differenced=True, bins_per_decade=5, rows_of_a_map=True)
    independent = binned_spectrum(
        profiles=np.random.default_rng(2).standard_normal((64, 1024)),
        spacing=1.0,
        differenced=True,
        bins_per_decade=5,
        rows_of_a_map=True,
    )
    assert b.independent[-1] < 2 * b.ordinates[-1]
    assert independent.independent[-1] > 20 * independent.ordinates[-1]


def test_missing_points_are_refused():
    z = np.zeros((1, 64))
    z[0, 3] = np.nan
    with pytest.raises(InputError, match="missing"):
        power_spectral_densities(profiles=z, spacing=1.0)


def test_bins_cover_every_ordinate_once_and_average_it():
    """Densities of the bins, weighted with their ordinates, are the sum over the whole spectrum."""
    z = np.cumsum(np.random.default_rng(3).standard_normal((3, 1000)), axis=1)
    b = binned_spectrum(profiles=z, spacing=0.5, differenced=False, bins_per_decade=10, rows_of_a_map=False)
    f, P = power_spectral_densities(profiles=z, spacing=0.5)
    ordinates = P.mean(axis=0)[f < 1.0 - 1e-12]  # without the real one at the sampling limit
    assert b.ordinates.sum() == ordinates.size
    ends = np.cumsum(b.ordinates)
    for start, end, density, centre, spread in zip(
        ends - b.ordinates, ends, b.density, b.frequency, b.spread, strict=True
    ):
        assert density == pytest.approx(ordinates[start:end].mean(), rel=1e-9)
        logs = np.log(f[start:end])
        assert np.log(centre) == pytest.approx(logs.mean(), abs=1e-9)
        assert spread == pytest.approx(logs.var(), abs=1e-12)
    assert b.nyquist == 1.0
    assert b.frequency[-2] / b.frequency[-3] == pytest.approx(10**0.1, rel=0.02)


def test_differences_read_as_heights():
    """Increments of variance 4 every 0.5: P = 2 * 4 * 0.5 / (2 sin(pi f / 2))^2."""
    z = np.cumsum(2.0 * np.random.default_rng(4).standard_normal((60, 2049)), axis=1)
    b = binned_spectrum(profiles=z, spacing=0.5, differenced=True, bins_per_decade=5, rows_of_a_map=False)
    expected = 2 * 4.0 * 0.5 / (4 * np.sin(np.pi * b.frequency * 0.5) ** 2)
    z_score = (b.density / expected - 1.0) * np.sqrt(b.independent)
    wide = b.ordinates > 20
    assert np.abs(z_score[wide]).max() < 5.0
    assert np.abs(b.density / expected - 1.0)[wide].max() < 0.08


@pytest.mark.parametrize(("differenced", "loss"), [(False, 35 / 18), (True, 1.07)])
def test_a_taper_costs_independent_ordinates(differenced, loss):
    """Hann: <w^4> / <w^2>^2 = 35/18; the light taper of the differences costs little."""
    z = np.cumsum(np.random.default_rng(5).standard_normal((30, 4097)), axis=1)
    b = binned_spectrum(
        profiles=z, spacing=1.0, differenced=differenced, bins_per_decade=10, rows_of_a_map=False
    )
    share = 30 * b.ordinates[-5:] / b.independent[-5:]
    np.testing.assert_allclose(share, loss, rtol=0.25)
    assert share.min() > 0.999 * (loss if not differenced else 1.0)


@pytest.mark.parametrize("rows", [1, 20])
def test_roughness_that_changes_along_the_record_costs_independent_ordinates(rows):
    """Amplitudes 1, 2, 3, 4 in the quarters: mean of a^4 over the square of that of a^2, 1.573."""
    amplitude = np.repeat([1.0, 2.0, 3.0, 4.0], 4096)
    steps = amplitude * np.random.default_rng(6).standard_normal((rows, 16384))
    b = binned_spectrum(
        profiles=np.cumsum(steps, axis=1),
        spacing=1.0,
        differenced=True,
        bins_per_decade=10,
        rows_of_a_map=False,
    )
    expected = np.mean(amplitude**4) / np.mean(amplitude**2) ** 2
    assert rows * b.ordinates[-1] / b.independent[-1] == pytest.approx(expected, rel=0.15)


def test_unequal_profiles_count_as_fewer():
    """One of ten profiles with three times the amplitude: 10 <m^2> / <m>^2 with m = 9, 1, ..., 1: 2.78."""
    z = np.cumsum(np.random.default_rng(7).standard_normal((10, 4097)), axis=1)
    z[0] *= 3.0
    b = binned_spectrum(profiles=z, spacing=1.0, differenced=True, bins_per_decade=10, rows_of_a_map=False)
    share = 10 * b.ordinates[-1] / b.independent[-1]
    assert share == pytest.approx(10 * (81 + 9) / (9 + 9) ** 2, rel=0.15)


def test_wrong_arguments():
    for z, spacing, says in (
        (np.zeros(64), 1.0, "must have shape"),
        (np.zeros((1, 15)), 1.0, "16 points"),
        (np.zeros((1, 16)), 0.0, "must be positive"),
    ):
        with pytest.raises(InputError, match=says):
            power_spectral_densities(profiles=z, spacing=spacing)
    assert power_spectral_densities(profiles=np.zeros((1, 16)), spacing=1.0)[1].shape == (1, 8)


@pytest.mark.parametrize("differenced", [False, True])
def test_rows_that_resemble_each_other_count_as_fewer(differenced):
    """Rows that are sums of 8 successive white rows: sum of squared correlations (2 * 64 + 1) / 24 = 5.375."""
    white = np.random.default_rng(8).standard_normal((519, 1024))
    total = np.concatenate([np.zeros((1, 1024)), np.cumsum(white, axis=0)])
    rows = total[8:] - total[:-8]
    shares = [
        rows.shape[0]
        * b.ordinates[-1]
        / b.independent[-1]
        for b in (
            binned_spectrum(
                profiles=each, spacing=1.0, differenced=differenced, bins_per_decade=10, rows_of_a_map=True
            )
            for each in (rows, white[:512])
        )
    ]  # fmt: skip
    assert shares[0] / shares[1] == pytest.approx(5.375, rel=0.1)
    assert shares[1] == pytest.approx(1.07 if differenced else 35 / 18, rel=0.15)


def test_a_line_is_removed_by_least_squares():
    z = np.random.default_rng(9).standard_normal((3, 101)) + 0.4 * np.arange(101)
    expected = [row - np.polyval(np.polyfit(np.arange(101), row, 1), np.arange(101)) for row in z]
    np.testing.assert_allclose(without_line(z), expected, atol=1e-11)


def test_independent_ordinates_of_a_bin_count_its_own_powers():
    """2 (sum p)^2 / sum p^2 over the ordinates of the bin and the frequencies across the rows, at least one."""
    random = np.random.default_rng(10)
    spectra = random.standard_normal((6, 12)) + 1j * random.standard_normal((6, 12))
    power = np.abs(np.fft.fft(spectra, axis=0)) ** 2
    parts = [power[:, 0:2], power[:, 2:5], power[:, 5:12]]  # ordinates 1 and 2, 3 to 5, 6 to 12
    expected = [max(2 * part.sum() ** 2 / (part**2).sum(), 1.0) for part in parts]
    found = _independent_ordinates(spectra.astype(np.complex64), np.array([1, 3, 6, 13]))
    np.testing.assert_allclose(found, expected, rtol=1e-5)


def test_correlation_of_neighbouring_ordinates_by_octets_of_frequency():
    """Square waves of 40 ordinates in the highest octet and of 4 below: one plus twice the sum over ten lags."""
    edges = bin_edges(8193, 10)
    place, log = np.arange(8192), np.log(np.arange(1.0, 8193.0))
    wave = np.where(place >= 1024, np.where(place % 40 < 20, 1.0, -1.0), np.where(place % 4 < 2, 1.0, -1.0))
    centre = np.array([log[first - 1 : end - 1].mean() for first, end in itertools.pairwise(edges)])

    def factor(part):
        return 1.0 + 2.0 * sum(part[lag:] @ part[:-lag] for lag in range(1, 11)) / (part @ part)

    high, low = factor(wave[1024:]), factor(wave[128:1024])
    assert (high, low) == pytest.approx((10.0, -1.0), abs=0.1)
    falling = (place + 1.0) ** -1.8  # divided out
    found = _correlation(falling * (1.0 + 0.05 * wave), edges, log, centre)
    np.testing.assert_allclose(found, np.where(edges[:-1] > 1024, high, low), atol=0.15)
    few = bin_edges(60, 10)
    np.testing.assert_array_equal(_correlation(np.ones(59), few, log[:59], np.zeros(few.size - 1)), 1.0)
