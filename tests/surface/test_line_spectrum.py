"""Regression of the amplitudes of lines: exact lines, differences by each amplitude, and the jackknife of a mean."""

import numpy as np
import pytest

from asperity.surface.line_spectrum import _fit_comb, _regression, _run, _spread_covariance, _wider, fit_lines
from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

D, G, GAMMA = 1.4, 1e-10, 1.5
LOG_F = np.log(2e3) + np.log(GAMMA) * np.arange(12)
#: Of equation (6): a = G^(D-1) (ln gamma)^(1/2) f^(D-2).
LOG_A = (D - 1) * np.log(G) + 0.5 * np.log(np.log(GAMMA)) + (D - 2) * LOG_F
ERROR = np.full(12, 0.02)


def test_exact_amplitudes_give_their_dimension_and_roughness():
    result, _, misfit = _regression(
        [LOG_F[:7], LOG_F[7:]], [LOG_A[:7], LOG_A[7:]], [ERROR[:7], ERROR[7:]], GAMMA
    )
    np.testing.assert_allclose(result, [D, np.log(G)], rtol=1e-12)
    assert misfit == 0.0


def test_covariance_is_that_of_the_amplitudes():
    """Every amplitude has its own error and the median one beside it: twice the variance."""
    _, covariance, _ = _regression([LOG_F], [LOG_A], [ERROR], GAMMA)
    slopes = np.empty((12, 2))
    for k, step in enumerate(1e-6 * np.eye(12)):
        more, less = (_regression([LOG_F], [LOG_A + sign * step], [ERROR], GAMMA)[0] for sign in (1, -1))
        slopes[k] = (more - less) / 2e-6
    np.testing.assert_allclose(covariance, 2 * 0.02**2 * slopes.T @ slopes, rtol=1e-6)


def test_unequal_errors_weigh_the_amplitudes():
    """Variances of 0.02^2 + 0.01^2 and, for two lines, of 0.05^2 + 0.01^2; the median is 0.02."""
    error = np.where(np.arange(12) < 2, 0.05, 0.02)
    amplitude = LOG_A + 0.005 * np.cos(np.arange(12))
    variance = error**2 + 0.02**2
    slope, _ = np.polyfit(LOG_F, amplitude, 1, w=variance**-0.5)
    result, _, misfit = _regression([LOG_F], [amplitude], [error], GAMMA)
    assert misfit == 0.0
    assert result[0] == pytest.approx(2 + slope, rel=1e-10)


def test_scatter_beyond_the_errors_is_the_misfit():
    scattered = LOG_A + 0.3 * np.cos(2.0 * np.arange(12) ** 2)
    residual = scattered - np.polyval(np.polyfit(LOG_F, scattered, 1), LOG_F)
    variance = residual @ residual / 10
    _, covariance, misfit = _regression([LOG_F], [scattered], [ERROR], GAMMA)
    assert misfit == pytest.approx(np.sqrt(variance), rel=0.02)
    assert covariance[0, 0] == pytest.approx(variance / np.sum((LOG_F - LOG_F.mean()) ** 2), rel=0.02)


def test_spread_of_profiles_is_that_of_the_mean_of_their_slopes():
    """Six profiles alike in frequency and error: variance of the mean slope times (2.5706/1.9600)^2 of Student's t."""
    random = np.random.default_rng(4)
    amplitudes = LOG_A + 0.02 * random.standard_normal((6, 12))
    slopes = [np.polyfit(LOG_F, each, 1)[0] for each in amplitudes]
    found = _spread_covariance([LOG_F] * 6, list(amplitudes), [ERROR] * 6, GAMMA)
    assert found[0, 0] == pytest.approx(np.var(slopes, ddof=1) / 6 * (2.570582 / 1.959964) ** 2, rel=1e-6)
    assert _wider(found, 0.9 * found) is found
    assert _wider(found, larger := 1.1 * found) is larger


@pytest.mark.parametrize(
    ("flags", "run"), [("0110111", (4, 7)), ("1110011", (0, 3)), ("0000000", (0, 0)), ("0001000", (3, 4))]
)
def test_longest_run(flags, run):
    assert _run(np.array([flag == "1" for flag in flags])) == run


def test_lines_of_equation_6_are_counted_and_explain_the_profile():
    """1 mm with lines at 1.5^n/mm up to 1.48/um, sampled up to 2/um: those below 2/mm are not resolved."""
    points, spacing = 4_000, 2.5e-7
    profile = weierstrass_mandelbrot_profile(
        position=np.arange(points) * spacing,
        profile_length=1e-3,
        fractal_dimension=D,
        fractal_roughness=G,
        frequency_ratio=GAMMA,
        phases=np.random.default_rng(2).uniform(0, 2 * np.pi, 19),
        lowest_index=0,
    )
    found = fit_lines(profiles=np.asarray(profile)[None], spacing=spacing, frequency_ratio=GAMMA)
    assert found is not None
    assert found.fractal_dimension == pytest.approx(D, abs=1e-5)
    assert found.low == pytest.approx(1e3 * GAMMA**2, rel=1e-3)
    assert found.high == pytest.approx(1e3 * GAMMA**18, rel=1e-6)
    assert found.lines == 17
    assert found.explained == pytest.approx(1.0, abs=1e-4)
    assert found.misfit < 1e-3


def test_errors_of_amplitudes_are_those_of_noise():
    """White noise s on n points: the amplitude a of a resolved line has the error s sqrt(2/n), ln a this over a."""
    n, spacing, noise = 4000, 2.5e-7, 1e-9
    x = (np.arange(n) - 0.5 * (n - 1)) * spacing
    f = 5e3 * 1.5 ** np.arange(15)
    a = 1e-7 * 0.9 ** np.arange(15)
    phases = np.linspace(0.3, 9.0, 15)
    z = (a * np.cos(2 * np.pi * f * x[:, None] + phases)).sum(axis=1)
    z += noise * np.random.default_rng(1).standard_normal(n)
    comb = _fit_comb(z, spacing, 1.5, np.log(5e3))
    lines = comb.frequency > 4.9e3
    np.testing.assert_allclose(comb.frequency[lines][:15], f, rtol=1e-4)
    np.testing.assert_allclose(comb.amplitude[lines][:15], a, rtol=5 * noise * np.sqrt(2 / n) / a.min())
    # the longest two are not told from a tilt and longer waves so well
    np.testing.assert_allclose(comb.error[lines][2:15], noise * np.sqrt(2 / n) / a[2:], rtol=0.05)
