"""The minimisation against SciPy on small dense problems."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import minimize

from asperity.bem.bounded_problem import bounded_solution, shifted_within_bounds

SIZE = 12
RNG = np.random.default_rng(5)
ROOT = RNG.standard_normal((SIZE, SIZE))
MATRIX = ROOT @ ROOT.T / SIZE + 0.2 * np.eye(SIZE)
TARGET = RNG.standard_normal(SIZE)


def solve(lower, upper, total):
    matrix = jnp.array(MATRIX)
    start = jnp.zeros(SIZE) if total is None else jnp.full(SIZE, total / SIZE)
    return jax.jit(
        lambda: bounded_solution(
            response=lambda t: matrix @ t,
            estimate=lambda g: g,
            target=jnp.array(TARGET),
            lower=jnp.array(lower),
            upper=None if upper is None else jnp.array(upper),
            total=None if total is None else jnp.array(total),
            start=start,
            scale=lambda t, u: jnp.ones(()),
            tolerance=jnp.array(1e-11),
            max_iterations=jnp.array(2000),
        )
    )()


@pytest.mark.parametrize(
    ("lower", "upper", "total"),
    [(0.0, None, 4.0), (0.0, 0.6, 4.0), (-0.5, 0.5, None), (-0.5, 0.5, 1.3), (-0.5, 0.5, -2.0)],
)
def test_the_minimum_is_scipys(lower, upper, total):
    constraints = [] if total is None else [{"type": "eq", "fun": lambda t: t.sum() - total}]
    reference = minimize(
        lambda t: 0.5 * t @ MATRIX @ t - t @ TARGET,
        np.full(SIZE, 0.0 if total is None else total / SIZE),
        jac=lambda t: MATRIX @ t - TARGET,
        bounds=[(lower, upper)] * SIZE,
        constraints=constraints,
        method="SLSQP",
        options={"ftol": 1e-15, "maxiter": 500},
    )
    found = solve(lower, upper, total)
    assert float(found.residual) < 1e-11
    np.testing.assert_allclose(found.traction, reference.x, atol=2e-6)
    if total is not None:
        assert float(found.traction.sum()) == pytest.approx(total, abs=1e-12)


@pytest.mark.parametrize(("upper", "total"), [(0.5, -3.9), (0.5, 0.3), (0.5, 3.9), (np.inf, 100.0)])
def test_the_shifted_cut_is_the_nearest_point_that_meets_the_total(upper, total):
    wild = RNG.standard_normal(8) * 3.0
    cut = shifted_within_bounds(
        jnp.array(wild), jnp.ones(8, dtype=bool), jnp.array(-0.5), jnp.array(upper), jnp.array(total)
    )
    assert float(cut.sum()) == pytest.approx(total, abs=1e-11)
    nearest = minimize(
        lambda t: np.sum((t - wild) ** 2),
        np.full(8, total / 8.0),
        bounds=[(-0.5, upper)] * 8,
        constraints=[{"type": "eq", "fun": lambda t: t.sum() - total}],
        method="SLSQP",
        options={"ftol": 1e-14},
    )
    np.testing.assert_allclose(cut, nearest.x, atol=1e-5)


def test_points_that_may_not_change_keep_their_traction():
    chosen = jnp.array([True, False, True, False])
    cut = shifted_within_bounds(
        jnp.array([0.2, 0.0, 0.9, 0.7]), chosen, jnp.array(0.0), jnp.array(1.0), jnp.array(2.3)
    )
    np.testing.assert_allclose(cut, [0.6, 0.0, 1.0, 0.7])
