"""Exactness of the chains with a surrogate that is wrong on purpose."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.stats import norm, truncnorm

from asperity.study.calibration.delayed_acceptance import Chains, _in_log_odds

MEAN, SPREAD = np.array([0.45, 0.6]), np.array([0.05, 0.08])


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_wrong_surrogate_and_a_cut_give_the_exact_density():
    # exact: independent normals, the first cut at 0.5; surrogate: shifted, wider, without the cut
    pytest.importorskip("numpyro")

    def exact(points):
        found = norm.logpdf(points, MEAN, SPREAD).sum(axis=1)
        return np.where(points[:, 0] < 0.5, found, -np.inf)

    def surrogate(given, point):
        return -0.5 * jnp.sum(((point - given["mean"]) / given["spread"]) ** 2)

    chains = Chains(surrogate=surrogate, exact=exact, size=2, warmup=150, seed=3)
    given = {"mean": MEAN + 0.5 * SPREAD, "spread": 1.3 * SPREAD}
    chains.start(given, np.tile(MEAN, (16, 1)), np.diag(SPREAD**2))
    for _ in range(150):
        chains.warm_up()
    chains.begin_exactly()
    for _ in range(50):  # a chain that warmed up beyond the cut comes back
        chains.step()
    chains.forget()
    drawn = []
    for _ in range(400):
        chains.step()
        drawn.append(chains.position)
    drawn = np.concatenate(drawn)
    assert 0.3 < chains.accepted / chains.proposed < 0.9
    assert drawn[:, 0].max() < 0.5
    cut = truncnorm(-np.inf, 1.0, MEAN[0], SPREAD[0])
    for found, law in ((drawn[:, 0], cut), (drawn[:, 1], norm(MEAN[1], SPREAD[1]))):
        for share in (0.05, 0.25, 0.5, 0.75, 0.95):
            # a draw in five is effective: four standard errors of a share
            error = 4.0 * np.sqrt(share * (1.0 - share) / (0.2 * len(drawn)))
            assert np.mean(found < law.ppf(share)) == pytest.approx(share, abs=error)


def test_covariance_of_log_odds():
    rng = np.random.default_rng(0)
    covariance = 1e-4 * np.array([[1.0, 0.6], [0.6, 2.0]])
    points = rng.multivariate_normal([0.3, 0.7], covariance, size=200_000)
    expected = np.cov(np.log(points / (1.0 - points)), rowvar=False)
    assert _in_log_odds(covariance, np.array([0.3, 0.7])) == pytest.approx(expected, rel=0.02)
    assert np.all(np.isfinite(_in_log_odds(covariance, np.array([0.0, 1.0]))))
