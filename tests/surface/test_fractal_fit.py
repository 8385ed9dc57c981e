"""Recovery of known D and G, and refusals."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface import synthesis
from asperity.surface.fractal_fit import fractal_fit
from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

G, SPACING, POINTS = 1e-10, 1e-7, 10_000


def fit(z, estimator="automatic", **more):
    return fractal_fit(
        profiles=z, spacing=SPACING, estimator=estimator, frequency_ratio=1.5, rows_of_a_map=False, **more
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
    assert got.noise_density == pytest.approx(2 * SPACING * sigma**2, rel=0.2)


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
