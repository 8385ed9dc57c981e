"""Exactness of the chains with a surrogate that is wrong on purpose."""

from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.stats import norm, truncnorm

from asperity.study.calibration.delayed_acceptance import Chains, _chosen, _in_log_odds

MEAN, SPREAD = np.array([0.45, 0.6]), np.array([0.05, 0.08])


@pytest.mark.long
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
    # no closer to a bound than it is wide, and no farther than the middle
    near, far = np.diag([0.1**2, 0.7**2]), np.array([0.0, 1.0])
    slope = np.array([1.0 / (0.1 * 0.9), 4.0])
    assert _in_log_odds(near, far) == pytest.approx(slope[:, None] * near * slope, rel=1e-12)


class State(NamedTuple):
    rng_key: Any
    i: Any
    z: Any


def test_chains_that_reject_keep_their_state_but_not_their_random_numbers():
    old = State(np.array([1, 2]), np.array([7, 7]), {"a": np.zeros((2, 3)), "b": np.zeros(2)})
    new = State(np.array([3, 4]), np.array([8, 8]), {"a": np.ones((2, 3)), "b": np.ones(2)})
    found = _chosen(np.array([True, False]), new, old)
    assert (found.rng_key.tolist(), found.i.tolist()) == ([3, 4], [8, 8])
    assert found.z["a"].tolist() == [[1.0] * 3, [0.0] * 3]
    assert found.z["b"].tolist() == [1.0, 0.0]


def wide(given, point):
    return -0.5 * jnp.sum(((point - given["mean"]) / given["spread"]) ** 2)


@pytest.fixture
def chains():
    pytest.importorskip("numpyro")
    exact = lambda points: norm.logpdf(points, MEAN, SPREAD).sum(axis=1)  # noqa: E731
    return Chains(surrogate=wide, exact=exact, size=2, warmup=10, seed=3)


def test_exact_draws_stay_exact(chains, monkeypatch):
    """Proposals of a wrong normal, without NUTS: 20 000 chains that begin with exact draws, after four steps."""
    count, rng = 20_000, np.random.default_rng(1)
    mean, spread = MEAN + 0.5 * SPREAD, 1.3 * SPREAD

    def moved():
        points = rng.normal(mean, spread, (count, 2))
        return None, points, norm.logpdf(points, mean, spread).sum(axis=1)

    monkeypatch.setattr(chains, "_moved", moved)
    chains._choose, chains._state = (lambda accept, new, old: old), None
    chains.position = rng.normal(MEAN, SPREAD, (count, 2))
    chains._log_surrogate = norm.logpdf(chains.position, mean, spread).sum(axis=1)
    chains.begin_exactly()
    for _ in range(4):
        chains.step()
    assert 0.4 < chains.accepted / chains.proposed < 0.9
    assert chains.proposed == 4 * count
    assert np.mean(chains.position, axis=0) == pytest.approx(MEAN, abs=4.0 * SPREAD.max() / count**0.5)
    assert np.std(chains.position, axis=0) == pytest.approx(SPREAD, rel=4.0 / (2.0 * count) ** 0.5)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_nuts_moves_in_log_odds_from_where_the_chains_begin(chains, monkeypatch):
    """The density of the free coordinates is the surrogate's of u times du/d(free), u (1 - u) for each odds."""
    import numpyro.infer
    from numpyro.infer.util import log_density

    begun = []

    class Kernel:
        def __init__(self, *_, **__):
            pass

        def init(self, keys, warmup, values, *_):
            begun.append(values["free"])

    monkeypatch.setattr(numpyro.infer, "NUTS", Kernel)
    given = {"mean": MEAN, "spread": SPREAD}
    begin = np.array([[0.45, 0.6], [0.5, 0.7], [0.0, 1.0]])
    chains.start(given, begin, np.diag(SPREAD**2))
    centre, axes = chains._frame["centre"], chains._frame["axes"]
    odds = centre + begun[0] @ axes.T
    unit = 1.0 / (1.0 + np.exp(-odds))
    np.testing.assert_allclose(unit, np.clip(begin, 1e-6, 1.0 - 1e-6), rtol=1e-9)
    np.testing.assert_allclose(centre, odds.mean(axis=0), rtol=1e-12)
    free = np.array([[0.0, 0.0], [0.4, -0.3], [-1.0, 0.5]])
    found = [float(log_density(chains._model, (chains._frame,), {}, {"free": at})[0]) for at in free]
    unit = 1.0 / (1.0 + np.exp(-(centre + free @ axes.T)))
    expected = np.sum(norm.logpdf(unit, MEAN, SPREAD) + np.log(unit * (1.0 - unit)), axis=1)
    np.testing.assert_allclose(np.diff(found), np.diff(expected), rtol=1e-9)
