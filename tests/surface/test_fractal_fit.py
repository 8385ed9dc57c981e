"""Recovery of known D and G, and refusals."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import binom

from asperity.errors import InputError, NoSolutionError
from asperity.surface import fractal_fit as module
from asperity.surface import synthesis
from asperity.surface.fractal_fit import fractal_fit
from asperity.surface.line_spectrum import LineFit
from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

G, SPACING, POINTS = 1e-10, 1e-7, 10_000


def fit(z, estimator="automatic", spacing=SPACING, **more):
    return fractal_fit(
        profiles=z,
        spacing=spacing,
        estimator=estimator,
        frequency_ratio=1.5,
        rows_of_a_map=False,
        **more,
    )


def noise(D, random, count=10, points=POINTS):
    return np.array(
        [
            synthesis.self_affine_profile(
                points=points, spacing=SPACING, fractal_dimension=D, fractal_roughness=G, random=random
            )
            for _ in range(count)
        ]
    )


def comb(D, random, record=POINTS * SPACING, length=POINTS * SPACING, lowest=0, terms=22, count=1):
    return np.array(
        [
            np.asarray(
                weierstrass_mandelbrot_profile(
                    position=np.arange(POINTS) * SPACING * record / (POINTS * SPACING),
                    profile_length=length,
                    fractal_dimension=D,
                    fractal_roughness=G,
                    frequency_ratio=1.5,
                    phases=random.uniform(0, 2 * np.pi, terms),
                    lowest_index=lowest,
                )
            )
            for _ in range(count)
        ]
    )


@pytest.mark.parametrize("D", [1.1, 1.5, 1.9])
def test_self_affine_noise(D):
    got = fit(noise(D, np.random.default_rng(int(10 * D))))
    assert got.estimator == "likelihood"
    assert abs(got.fractal_dimension - D) < 0.015
    assert abs(got.fractal_dimension - D) < 4 * np.sqrt(got.covariance[0, 0])
    assert abs(got.log_roughness - np.log(G)) < 4 * np.sqrt(got.covariance[1, 1])


def rolled_off(D, kind, random, points, wavelength=40e-6):
    """Gaussian profile with K-correlation or a flat spectrum above a wavelength, cut from a longer period."""
    n = 8 * points
    f = np.fft.rfftfreq(n, SPACING)[1:]
    long = f**2 + wavelength**-2 if kind == "K-correlation" else np.maximum(f, 1 / wavelength) ** 2
    P = np.concatenate([[0.0], 0.5 * G ** (2 * (D - 1)) * long ** (D - 2.5)])
    white = np.fft.rfft(random.standard_normal(n))
    return np.fft.irfft(white * np.sqrt(P / (2 * SPACING)), n=n)[:points]


def fewest_covered(count, share=0.9):
    """So few of ``count`` intervals of at least this coverage hold the truth once in a thousand runs."""
    return int(binom.ppf(1e-3, count, share))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "estimator", "repeats"),
    [
        pytest.param("K-correlation", "likelihood", 24, marks=pytest.mark.long),
        pytest.param("flat", "likelihood", 24, marks=pytest.mark.long),
        ("exact", "likelihood", 24),
        pytest.param("row quarters", "likelihood", 24, marks=pytest.mark.long),
        ("K-correlation", "structure_function", 12),
        ("exact", "structure_function", 12),
        ("K-correlation", "power_spectrum", 12),
        ("exact", "power_spectrum", 12),
    ],
)
def test_intervals_hold_the_truth_or_there_are_none(kind, estimator, repeats):
    """Gradual and sharp roll-offs at 40 um, with noise and averaged; unequal quarters of the record."""
    covered = []
    for seed in range(repeats):
        random, D, count = np.random.default_rng(seed), (1.3, 1.5, 1.7)[seed % 3], (1, 10)[seed % 2]
        if kind in ("exact", "row quarters"):
            z = noise(D, random, count, 4096)
        else:
            z = np.array([rolled_off(D, kind, random, 4096) for _ in range(count)])
        if kind == "row quarters":
            share = np.repeat([0.5, 1.0, 1.5, 2.0], 1024)[1:]
            z = np.concatenate([np.zeros((count, 1)), np.cumsum(share * np.diff(z), axis=1)], axis=1)
        z = z + (0.0, 0.02)[seed // 2 % 2] * z.std() * random.standard_normal(z.shape)
        try:
            low, high = fit(z, estimator).dimension_interval(confidence=0.95)
        except NoSolutionError:
            continue
        covered.append(low <= D <= high)
    assert sum(covered) >= fewest_covered(len(covered))
    if estimator == "likelihood":
        assert len(covered) >= 20


@pytest.mark.slow
def test_rows_of_a_map_without_cross_frequencies_above_the_sampling_limit():
    """Isotropic synthesis: D of the rows, without excluding their short waves."""
    covered = []
    for seed in range(20):
        random, D = np.random.default_rng(seed), (1.3, 1.6)[seed % 2]
        z = synthesis.spectral_surface(
            rows=256,
            columns=256,
            spacing=SPACING,
            fractal_dimension=D,
            areal_fractal_roughness=G,
            periodic=False,
            random=random,
        )
        got = fractal_fit(
            profiles=z, spacing=SPACING, estimator="likelihood", frequency_ratio=1.5, rows_of_a_map=True
        )
        low, high = got.dimension_interval(confidence=0.95)
        covered.append(low <= D <= high)
        assert got.reduced_chi_square < 2.5
    assert sum(covered) >= fewest_covered(20)


def test_roll_off_wavelength_is_reported():
    random = np.random.default_rng(0)
    z = np.array([rolled_off(1.5, "K-correlation", random, 4096) for _ in range(10)])
    assert fit(z).roll_off_wavelength == pytest.approx(40e-6, rel=0.25)
    plain = fit(noise(1.5, random))
    assert plain.roll_off_wavelength is None
    assert 0.5 < plain.reduced_chi_square < 2.0  # heights as the model has them scatter as it says


def test_all_estimators_refuse_the_same_band():
    """Fifths of a decade alternately at half and at twice the power law."""
    random = np.random.default_rng(3)
    n = 8 * 4096
    f = np.fft.rfftfreq(n, SPACING)[1:]
    P = 0.5 * G * f**-2.0 * np.where(np.floor(5 * np.log10(f)) % 2 == 0, 0.5, 2.0)
    white = np.fft.rfft(random.standard_normal((10, n)), axis=1)
    z = np.fft.irfft(white * np.sqrt(np.concatenate([[0.0], P]) / (2 * SPACING)), n=n, axis=1)[:, :4096]
    reasons = set()
    for estimator in ("likelihood", "structure_function", "power_spectrum"):
        with pytest.raises(NoSolutionError, match="departs from a power law by") as refusal:
            fit(z, estimator, shortest_wavelength=5e-7, longest_wavelength=1e-4)
        reasons.add(str(refusal.value))
    assert len(reasons) == 1


@pytest.mark.parametrize("estimator", ["likelihood", "structure_function", "power_spectrum"])
def test_tilt_changes_nothing(estimator):
    z = noise(1.4, np.random.default_rng(12), count=2, points=4096)
    level, tilted = fit(z, estimator), fit(z + 0.1 * SPACING * np.arange(4096), estimator)
    assert tilted.fractal_dimension == pytest.approx(level.fractal_dimension, abs=1e-6)
    assert tilted.covariance[0, 0] == pytest.approx(level.covariance[0, 0], rel=1e-3)


@pytest.mark.parametrize("D", [1.1, 1.5, 1.9])
def test_weierstrass_mandelbrot_is_recognised_and_solved_to_rounding(D):
    got = fit(comb(D, np.random.default_rng(int(10 * D))))
    assert got.estimator == "lines"
    assert abs(got.fractal_dimension - D) < 1e-5
    assert abs(got.log_roughness - np.log(G)) < 1e-3


def test_weierstrass_mandelbrot_with_noise_keeps_its_interval():
    random = np.random.default_rng(1)
    z = comb(1.5, random)
    z += 0.01 * z.std() * random.standard_normal(z.shape)
    got = fit(z)
    assert got.estimator == "lines"
    assert abs(got.fractal_dimension - 1.5) < 4 * np.sqrt(got.covariance[0, 0]) < 0.05


def test_structure_function_estimator():
    got = fit(noise(1.4, np.random.default_rng(2)), "structure_function")
    assert abs(got.fractal_dimension - 1.4) < 4 * np.sqrt(got.covariance[0, 0]) < 0.1


def test_power_spectrum_estimator_on_a_band_limited_surface():
    random = np.random.default_rng(3)
    z = np.array(
        [
            synthesis.spectral_profile(
                points=POINTS,
                spacing=SPACING,
                fractal_dimension=1.5,
                fractal_roughness=G,
                periodic=False,
                random=random,
            )
            for _ in range(10)
        ]
    )
    assert abs(fit(z, "power_spectrum").fractal_dimension - 1.5) < 0.02


def test_instrument_noise_becomes_a_floor():
    random = np.random.default_rng(4)
    z = noise(1.3, random)
    sigma = 0.01 * z.std()
    got = fit(z + sigma * random.standard_normal(z.shape))
    assert abs(got.fractal_dimension - 1.3) < 4 * np.sqrt(got.covariance[0, 0])
    assert got.noise_density == pytest.approx(2 * SPACING * sigma**2, rel=0.2, abs=0.0)


def test_roughness_scales_with_the_unit_of_length():
    z = noise(1.5, np.random.default_rng(5), count=3, points=2000)
    one = fit(z)
    two = fractal_fit(
        profiles=1e3 * z,
        spacing=1e3 * SPACING,
        estimator="automatic",
        frequency_ratio=1.5,
        rows_of_a_map=False,
    )
    assert two.fractal_dimension == pytest.approx(one.fractal_dimension, abs=1e-6)
    assert two.fractal_roughness == pytest.approx(1e3 * one.fractal_roughness, rel=1e-4)


@pytest.mark.parametrize("kind", ["white", "sine", "flat", "short"])
def test_no_power_law_is_refused(kind):
    random = np.random.default_rng(6)
    x = np.arange(1024)
    z = {
        "white": random.standard_normal(1024),
        "sine": np.sin(x / 50.0) + 1e-3 * random.standard_normal(1024),
        "flat": np.zeros(1024),
        "short": random.standard_normal(20),
    }[kind]
    with pytest.raises(NoSolutionError):
        fit(1e-6 * z[None])


@pytest.mark.parametrize("estimator", ["automatic", "structure_function", "power_spectrum"])
@pytest.mark.parametrize("kind", ["sine", "several sines", "chirp"])
def test_smooth_waves_without_noise_are_no_power_law(kind, estimator):
    """Their spectra span thirty decades, so that the misfit exceeds the sampling scatter beyond rounding."""
    x = np.arange(2000) * 1e-7
    z = {
        "sine": np.sin(2 * np.pi * x / 20e-6)[None],
        "several sines": np.sin(2 * np.pi * x / 20e-6 + np.arange(12)[:, None]),
        "chirp": np.sin(2 * np.pi * 40 * (x / 2e-4) ** 2)[None],
    }[kind]
    with pytest.raises(NoSolutionError, match="no power law over at least 1 decade"):
        fit(1e-6 * z, estimator=estimator, spacing=1e-7)


def test_a_straight_line_has_no_roughness():
    with pytest.raises(NoSolutionError, match="on a straight line"):
        fit(0.1 * np.arange(2000)[None] * 1e-7)


@pytest.mark.parametrize(
    ("limits", "says"),
    [
        ({"shortest_wavelength": 0.0}, "positive length"),
        ({"longest_wavelength": -1e-6}, "positive length"),
        ({"shortest_wavelength": np.inf}, "positive length"),
        ({"shortest_wavelength": 2e-6, "longest_wavelength": 1e-6}, "must be below the longest"),
    ],
)
def test_limits_of_the_band_are_checked(limits, says):
    with pytest.raises(InputError, match=says):
        fit(noise(1.5, np.random.default_rng(0), count=1, points=256), **limits)


def test_heights_beyond_measure_are_refused():
    with pytest.raises(InputError, match="too large"):
        fit(1e300 * np.random.default_rng(0).standard_normal((1, 256)))


def test_arguments_are_checked():
    with pytest.raises(InputError, match="estimator"):
        fit(np.zeros((1, 100)), "guess")
    with pytest.raises(InputError, match="gamma"):
        fractal_fit(
            profiles=np.zeros((1, 100)),
            spacing=1.0,
            estimator="lines",
            frequency_ratio=1.0,
            rows_of_a_map=False,
        )


def test_level_of_a_spectrum_is_a_roughness_with_its_covariance():
    """P = G^(2D-2) f^(2D-5)/2 at the reference frequency; derivatives of (D, ln G) by differences."""
    f, D, G = 2e4, 1.37, 3e-10
    fit = SimpleNamespace(reference_frequency=f, usable_band=(1e3, 1e6))
    names = (
        "frequency_ratio",
        "profiles",
        "points",
        "noise_density",
        "roll_off_wavelength",
        "height_step",
        "misfit",
    )
    common = dict.fromkeys((*names, "reduced_chi_square"))

    def result(dimension, level, covariance=None):
        return module._result(
            dimension, level, np.eye(2) if covariance is None else covariance, fit, "x", common
        )

    level = np.log(0.5 * G ** (2 * D - 2) * f ** (2 * D - 5))
    given = np.array([[4e-4, 3e-4], [3e-4, 9e-4]])
    found = result(D, level, given)
    assert found.fractal_roughness == pytest.approx(G, rel=1e-12, abs=0.0)
    # 95 % of a normal distribution lie within 1.959964 standard deviations, 0.02 of D
    assert found.dimension_interval(confidence=0.95) == pytest.approx(
        (D - 0.0391993, D + 0.0391993), rel=1e-6
    )
    low, high = found.roughness_interval(confidence=0.95)
    assert low * high == pytest.approx(G**2, rel=1e-9, abs=0.0)
    assert np.log(high / G) == pytest.approx(1.959964 * found.covariance[1, 1] ** 0.5, rel=1e-6)
    assert (found.shortest_wavelength, found.longest_wavelength) == pytest.approx((1e-6, 1e-3), rel=1e-12)
    steps = 1e-6 * np.eye(2)
    slopes = np.array(
        [
            (result(D + s[0], level + s[1]).log_roughness - result(D - s[0], level - s[1]).log_roughness)
            / 2e-6
            for s in steps
        ]
    )
    jacobian = np.array([[1.0, 0.0], slopes])
    np.testing.assert_allclose(found.covariance, jacobian @ given @ jacobian.T, rtol=1e-6)


def test_the_band_of_lines_is_in_wavelengths_and_a_refusal_tells_the_step_of_heights(monkeypatch):
    lines = LineFit(1.4, np.log(1e-10), np.eye(2), low=1e3, high=4e5, lines=9, misfit=0.1, explained=0.99)
    monkeypatch.setattr(module, "fit_lines", lambda **_: lines)
    found = module._from_lines(np.zeros((2, 100)), 1e-7, 1.5)
    assert (found.shortest_wavelength, found.longest_wavelength) == pytest.approx((2.5e-6, 1e-3), rel=1e-12)
    assert (found.profiles, found.points, found.misfit, found.frequency_ratio) == (2, 100, 0.1, 1.5)
    said = str(module._refusal("a reason", 2.5e-9))
    assert said.endswith("so no D and G: a reason; the heights are quantised in steps of 0.0025 um")
    assert str(module._refusal("a reason", None)).endswith("so no D and G: a reason")
