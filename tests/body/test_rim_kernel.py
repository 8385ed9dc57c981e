"""Closed sums of the rim against sums of a million modes with SciPy's Bessel functions."""

import math

import jax
import numpy as np
import pytest
from scipy.special import j0

from asperity.body.punch import distance_moments
from asperity.body.rim_kernel import self_sums, separated_sums

MODES = np.arange(1.0, 1e6)


def direct(values, offset):
    """Sum of modes over n + offset, with a window that ends a wave smoothly."""
    window = np.clip(2.0 - 2.0 * MODES / MODES[-1], 0.0, 1.0)
    first = 0 if offset > 0 else 1
    return float(np.sum((window * values)[first:] / (MODES[first:] + offset)))


@pytest.mark.parametrize("alpha", [0.02, 0.1, 0.2])
def test_self_sums(alpha):
    weight = j0(MODES * alpha) ** 2
    tail = 1.0 / (math.pi * alpha * MODES[-1])  # of J0^2/n, whose mean is 1/(pi alpha n^2)
    wave = 0.3 / (alpha * MODES[-1]) ** 2  # of J0^2, which the tail leaves out
    plus, minus = self_sums(alpha)
    assert float(plus) == pytest.approx(np.sum(weight / (MODES + 1.0)) + tail, rel=0.0, abs=wave)
    assert float(minus) == pytest.approx(np.sum(weight[1:] / (MODES[1:] - 1.0)) + tail, rel=0.0, abs=wave)


def test_self_sums_tend_to_the_half_planes_logarithm():
    plus, minus = self_sums(1e-6)
    assert float(0.5 * (plus + minus)) == pytest.approx(math.log(2e6) - 0.5, rel=1e-9)


@pytest.mark.parametrize("angle", [0.6, 2.5, -0.6, 5.9 + 2.0 * math.pi])
@pytest.mark.parametrize(("alpha", "beta"), [(0.02, 0.02), (0.04, 0.01)])
def test_separated_sums(angle, alpha, beta):
    second, fourth = distance_moments(alpha, beta)
    ours = separated_sums(angle=angle, second_moment=second, fourth_moment=fourth)
    weight = j0(MODES * alpha) * j0(MODES * beta)
    cosine, sine = weight * np.cos(MODES * angle), weight * np.sin(MODES * angle)
    expected = (direct(cosine, 1), direct(sine, 1), direct(cosine, -1), direct(sine, -1))
    distance = abs(math.remainder(angle, 2.0 * math.pi))
    assert [float(x) for x in ours] == pytest.approx(expected, abs=1e-9 + (max(alpha, beta) / distance) ** 6)


def test_slope_over_the_half_width():
    slope = jax.grad(lambda a: self_sums(a)[0])(0.05)
    difference = (self_sums(0.05 + 1e-5)[0] - self_sums(0.05 - 1e-5)[0]) / 2e-5
    assert float(slope) == pytest.approx(float(difference), rel=1e-7)
