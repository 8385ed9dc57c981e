"""Regression of the amplitudes of lines: exact lines, differences by each amplitude, and the jackknife of a mean."""

import numpy as np
import pytest

from asperity.surface.line_spectrum import (
    _fit_comb,
    _regression,
    _run,
    _spread_covariance,
    _wider,
    fit_lines,
    line_concentration,
)
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
    """1.2 mm with lines at 1.5^n/mm up to 1.48/um, sampled up to 1.7/um: those below 1.7/mm are not resolved."""
    points, spacing = 4_000, 3e-7
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
    assert found.log_roughness == pytest.approx(np.log(G), abs=1e-3)
    assert found.low == pytest.approx(1e3 * GAMMA**2, rel=1e-3)
    assert found.high == pytest.approx(1e3 * GAMMA**18, rel=1e-6)
    assert found.lines == 17
    assert found.explained == pytest.approx(1.0, abs=1e-4)
    assert found.misfit < 1e-3


def test_noise_concentrates_in_no_line():
    """Of n powers of noise the 16 largest have on average the share (sum over j to 16 of sum over i >= j of 1/i)/n."""
    noise = np.random.default_rng(3).standard_normal(16384)
    top, shares = 8192, []
    while top / 3 >= 128:
        n = top - int(top / 1.5)
        tails = np.cumsum(1 / np.arange(n, 0, -1.0))[::-1]
        shares.append(tails[:16].sum() / n)
        top = int(top / 1.5)
    assert line_concentration(profile=noise, frequency_ratio=1.5) == pytest.approx(np.median(shares), rel=0.1)


def test_errors_of_amplitudes_are_those_of_noise():
    """White noise s on n points: the amplitude a of a resolved line has the error s sqrt(2/n), ln a this over a."""
    n, spacing, noise, lowest = 4000, 2.5e-7, 1e-9, 4.64e3
    x = (np.arange(n) - 0.5 * (n - 1)) * spacing
    f = lowest * 1.5 ** np.arange(15)  # the next one is 2 % above the sampling limit
    a = 1e-7 * 0.9 ** np.arange(15)
    phases = np.linspace(0.3, 9.0, 15)
    z = (a * np.cos(2 * np.pi * f * x[:, None] + phases)).sum(axis=1)
    z += noise * np.random.default_rng(1).standard_normal(n)
    comb = _fit_comb(z, spacing, 1.5, np.log(lowest))
    lines = comb.frequency > 0.99 * lowest
    np.testing.assert_allclose(comb.frequency[lines], f, rtol=1e-4)
    np.testing.assert_allclose(comb.amplitude[lines], a, rtol=5 * noise * np.sqrt(2 / n) / a.min())
    # what no line explains: differences of neighbouring white noise have twice its variance
    assert comb.rough_variance == pytest.approx(2.0 * noise**2, rel=0.1, abs=0.0)
    # the longest three are not told from a tilt and longer waves so well
    np.testing.assert_allclose(comb.error[lines][3:], noise * np.sqrt(2 / n) / a[3:], rtol=0.05)
    # all of them from the least squares written anew: ln a of each line as a linear function of the noise
    angle = 2 * np.pi * comb.frequency * x[:, None]
    design = np.hstack([np.ones((n, 1)), x[:, None] / (n * spacing), np.cos(angle), np.sin(angle)])
    told = 1e-13**0.5  # columns that differ by less are not told apart
    cosine, sine = np.split((np.linalg.pinv(design, rcond=told) @ z)[2:], 2)
    turned = x[:, None] * comb.frequency * (np.cos(angle) * sine - np.sin(angle) * cosine)
    shifted = turned[:, comb.frequency * n * spacing > 1.0].sum(axis=1, keepdims=True)
    shifted *= np.sqrt(n) / np.linalg.norm(shifted)
    inverse = np.linalg.pinv(np.hstack([design, shifted]), rcond=told)
    cosines, sines = np.split(inverse[2:-1], 2)
    slopes = (cosine[:, None] * cosines + sine[:, None] * sines) / (cosine**2 + sine**2)[:, None]
    expected = np.sqrt(comb.variance) * np.linalg.norm(slopes, axis=1)
    np.testing.assert_allclose(comb.error[lines], expected[lines], rtol=1e-2)
