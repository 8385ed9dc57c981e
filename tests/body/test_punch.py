"""Punch pressure: its Fourier coefficients and the moments of distances, against SciPy."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import digamma, j0

from asperity.body.punch import distance_moments, mean_logarithm, mean_power, punch_factor


def test_punch_factor_is_the_bessel_function():
    x = np.linspace(0.0, 8.0, 4001)
    assert np.max(np.abs(np.asarray(punch_factor(x)) - j0(x))) < 1e-14


def test_punch_factor_is_the_mean_of_the_cosine_over_the_pressure():
    mean, _ = quad(lambda u: math.cos(2.7 * math.cos(u)) / math.pi, 0.0, math.pi)
    assert float(punch_factor(2.7)) == pytest.approx(mean, rel=1e-12)


@pytest.mark.parametrize("k", [0, 1, 2, 5, 8])
def test_means_of_powers_of_the_sine(k):
    mean, _ = quad(lambda p: math.sin(p) ** k * 2.0 / math.pi, 0.0, 0.5 * math.pi)
    assert mean_power(k) == pytest.approx(mean, rel=1e-12)
    if k % 2 == 0:
        slope = 0.5 * mean_power(k) * (digamma(0.5 * (k + 1)) - digamma(0.5 * k + 1.0))
        assert mean_logarithm(k) == pytest.approx(slope, rel=1e-12)


def test_moments_of_the_distance_of_two_contacts():
    nodes = np.cos((np.arange(20) + 0.5) * np.pi / 20)
    distance = np.subtract.outer(0.3 * nodes, 0.2 * nodes)
    second, fourth = distance_moments(0.3, 0.2)
    assert float(second) == pytest.approx(np.mean(distance**2), rel=1e-12)
    assert float(fourth) == pytest.approx(np.mean(distance**4), rel=1e-12)
