"""The posterior sampler against a linear model whose posterior is known."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.study.posterior import sample


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_linear_model():
    pytest.importorskip("numpyro")
    rng = np.random.default_rng(0)
    design = np.stack([np.ones(60), np.linspace(-1.0, 1.0, 60)], axis=1)
    true, spread = np.array([0.5, 0.4]), 0.05
    data = design @ true + spread * rng.standard_normal(60)
    fit, *_ = np.linalg.lstsq(design, data, rcond=None)
    deviation = np.sqrt(np.sum((data - design @ fit) ** 2) / 58)
    found = sample(
        predict=lambda places: jnp.asarray(design) @ places,
        data=data,
        first=fit,
        first_deviation=float(deviation),
        draws=600,
        warmup=300,
        chains=2,
        seed=0,
    )
    expected = deviation * np.sqrt(
        np.diag(np.linalg.inv(design.T @ design))
    )  # t with 58 degrees of freedom, nearly
    assert found.places.shape == (1200, 2)
    assert found.places.mean(axis=0) == pytest.approx(fit, abs=0.15 * expected.max())
    assert found.places.std(axis=0) == pytest.approx(expected, rel=0.15)
    assert np.all(found.r_hat < 1.05)
    assert found.divergences == 0
