"""The widest power law in a spectrum that is known exactly, and the reasons of a refusal."""

import re
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.surface.self_affine_band import _drift, _edges, widest_power_law


def test_band_stops_where_the_power_law_stops(exact):
    def bent(f):
        return 1e-8 * f**-1.8 / (1 + (f / 1e5) ** 4)

    search = widest_power_law(
        spectrum=exact(bent, independent=500.0),
        low=None,
        high=None,
        noise_density=0.0,
        resolved_frequency=np.inf,
    )
    assert search.reason == ""
    assert 3e4 < search.fit.high < 2.5e5
    assert search.fit.fractal_dimension == pytest.approx(1.6, abs=0.03)


@pytest.mark.parametrize(
    ("density", "says"),
    [
        (lambda f: 1e-8 * f**-3.6, "falls as frequency^-3.6"),
        (lambda f: 1e-8 * f**-2.0 * (1 + 0.7 * np.sin(5 * np.log(f))), "departs from a power law by"),
    ],
)
def test_refusals_say_why(exact, density, says):
    spectrum = exact(density, independent=500.0)
    search = widest_power_law(
        spectrum=spectrum, low=None, high=None, noise_density=0.0, resolved_frequency=np.inf
    )
    assert search.fit is None
    assert says in search.reason
    short, long = (float(each) for each in re.findall(r"wavelengths (\S+) m and (\S+) m", search.reason)[0])
    assert short * 1.01 >= 1e-6
    assert 10 * short <= 1.01 * long
    assert long <= 1.01 / 300  # the third ordinate of a record of 10 mm
    if percent := re.findall(r"by (\d+) % rms", search.reason):
        assert 15 <= int(percent[0]) <= 60  # of at most 0.7 sin, rms 49 %, of which departures take a part


def test_band_below_a_decade_is_refused(exact):
    spectrum = exact(lambda f: 1e-8 * f**-2.0)
    search = widest_power_law(
        spectrum=spectrum, low=None, high=None, noise_density=0.0, resolved_frequency=1e3
    )
    assert "decades of wavelength" in search.reason


@pytest.mark.parametrize(("bins", "accepted"), [(20, True), (19, False)])
def test_a_band_of_one_decade_is_the_narrowest(exact, bins, accepted):
    """Of 79 steps in four decades, 20 are 1.013 decades and 19 are 0.96."""
    spectrum = exact(lambda f: 1e-8 * f**-2.0)
    search = widest_power_law(
        spectrum=spectrum,
        low=spectrum.frequency[20],
        high=spectrum.frequency[20 + bins],
        noise_density=0.0,
        resolved_frequency=np.inf,
    )
    assert (search.fit is not None) is accepted


def test_folding_is_considered_where_the_band_reaches_the_sampling_limit(exact):
    """Power law of D = 1.6 with its images at k f_s +- f, the far ones as an integral: found again to the limit."""
    f_s, k = 2e6, np.arange(1, 2001)[:, None]

    def law(f):
        return 1e-8 * f**-1.8

    def folded(f):
        rest = 2 * 1e-8 * f_s**-1.8 * 2000.5**-0.8 / 0.8
        return law(f) + (law(k * f_s + f) + law(k * f_s - f)).sum(axis=0) + rest

    options = {"low": 1e3, "noise_density": 0.0, "resolved_frequency": np.inf}
    spectrum = exact(folded, independent=500.0)
    search = widest_power_law(spectrum=spectrum, high=1e6, **options)
    assert search.fit.tail == "folded"
    assert search.fit.fractal_dimension == pytest.approx(1.6, abs=2e-3)
    assert widest_power_law(spectrum=spectrum, high=5e4, **options).fit.tail == "band_limited"


def test_limits_that_are_tried_divide_a_decade_by_four():
    np.testing.assert_allclose(_edges(1e2, 1e4), 10.0 ** np.linspace(2.0, 4.0, 9), rtol=1e-12)
    assert _edges(1e3, 1e3) == []


def test_drift_of_the_local_dimension_is_that_of_a_parabola(exact):
    """P = P_fit (1 + c u^2): the slope of ln P changes by 2 c w over the width w, and D = (5 + slope)/2 by c w."""
    c, low, high = 0.02, 1e3, 1e5
    spectrum = exact(lambda f: f**-2.0 * (1 + c * np.log(f / 1e4) ** 2), independent=400.0)
    inside = (spectrum.frequency >= low) & (spectrum.frequency <= high)
    fit = SimpleNamespace(inside=lambda _: inside, expected=lambda f: f**-2.0, misfit=0.03)
    drift, error = _drift(fit, spectrum)
    u = np.log(spectrum.frequency[inside])
    assert drift == pytest.approx(c * (u[-1] - u[0]), rel=1e-9)
    # variance of each ln P is 1/400 + 0.03^2; standard error of the parabola as polyfit has it
    covariance = np.polyfit(u, u, 2, w=np.full(u.size, (1 / 400 + 0.03**2) ** -0.5), cov="unscaled")[1]
    assert error == pytest.approx(np.sqrt(covariance[0, 0]) * (u[-1] - u[0]), rel=1e-6)
