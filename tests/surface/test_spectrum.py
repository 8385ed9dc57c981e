"""Parseval, one sine, white noise."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.spectrum import binned_spectrum, power_spectral_densities


def test_parseval_for_a_boxcar_window():
    z = np.random.default_rng(0).standard_normal((1, 256))
    z -= np.polynomial.polynomial.polyval(
        np.arange(256), np.polynomial.polynomial.polyfit(np.arange(256), z[0], 1)
    )
    f, P = power_spectral_densities(profiles=z, spacing=0.1, window="boxcar")
    assert np.sum(P[0]) * (f[1] - f[0]) == pytest.approx(np.mean(z**2), rel=1e-12)


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
        power_spectral_densities(profiles=z, spacing=1.0, window="hann")
