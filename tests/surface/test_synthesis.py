"""Generators against the analytic structure function and spectrum."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface import conventions, synthesis
from asperity.surface.structure_function import structure_functions

COMMON = {"points": 4000, "spacing": 1e-7, "fractal_roughness": 1e-9}


@pytest.mark.parametrize("D", [1.1, 1.5, 1.9])
def test_self_affine_noise_has_the_exact_structure_function(D):
    random = np.random.default_rng(5)
    z = np.array(
        [synthesis.self_affine_profile(**COMMON, fractal_dimension=D, random=random) for _ in range(100)]
    )
    lags = np.array([1, 3, 10, 60])
    model = conventions.structure_function(lag=lags * 1e-7, fractal_dimension=D, fractal_roughness=1e-9)
    S = structure_functions(profiles=z, lags=lags)
    error = S.std(axis=0) / np.sqrt(len(S))
    assert np.all(np.abs(S.mean(axis=0) - model) < 4 * error)
    assert np.all(error < 0.07 * model)


def test_spectral_profile_variance_is_the_sum_of_its_spectrum():
    random = np.random.default_rng(6)
    z = np.array(
        [
            synthesis.spectral_profile(**COMMON, fractal_dimension=1.7, periodic=True, random=random)
            for _ in range(300)
        ]
    )
    f = np.arange(1, 2001) / (4000 * 1e-7)
    P = conventions.power_spectral_density(frequency=f, fractal_dimension=1.7, fractal_roughness=1e-9)
    P[-1] *= 0.5  # a real ordinate at the sampling limit
    assert z.var(axis=1).mean() == pytest.approx(P.sum() * f[0], rel=0.06, abs=0.0)


def test_row_of_a_map_has_the_profile_roughness():
    random = np.random.default_rng(7)
    D, G = 1.4, 1e-9
    maps = [
        synthesis.spectral_surface(
            rows=512,
            columns=512,
            spacing=1e-7,
            fractal_dimension=D,
            areal_fractal_roughness=G,
            periodic=False,
            random=random,
        )
        for _ in range(4)
    ]
    lags = np.array([8, 16])
    S = np.mean([structure_functions(profiles=m, lags=lags).mean(axis=0) for m in maps], axis=0)
    row_G = conventions.profile_roughness_from_areal(fractal_dimension=D, areal_fractal_roughness=G)
    model = conventions.structure_function(lag=lags * 1e-7, fractal_dimension=D, fractal_roughness=row_G)
    np.testing.assert_allclose(S, model, rtol=0.2)


def test_seed_fixes_the_surface_and_bad_input_is_refused():
    one, two = (
        synthesis.self_affine_profile(**COMMON, fractal_dimension=1.5, random=np.random.default_rng(1))
        for _ in range(2)
    )
    np.testing.assert_array_equal(one, two)
    with pytest.raises(InputError, match="between 1 and 2"):
        synthesis.self_affine_profile(**COMMON, fractal_dimension=2.5, random=np.random.default_rng(1))
