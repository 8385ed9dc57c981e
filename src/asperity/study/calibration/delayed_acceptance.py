"""Markov chains proposed by NUTS (NumPyro) with a cheap likelihood and accepted or rejected with the exact one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from asperity.engine import trees
from asperity.types import Array

#: A chain begins no closer to a bound than this: the logarithm of the odds, in which NUTS moves, is infinite there.
_MARGIN = 1e-6


class Chains:
    r"""Chains in the unit cube, where the prior is uniform.

    A step proposes by one transition of NUTS, which is reversible for the posterior :math:`\tilde\pi` of a surrogate,
    and accepts with the probability

    .. math::
        \min\left\{1,\ \frac{\pi(u')\,\tilde\pi(u)}{\pi(u)\,\tilde\pi(u')}\right\}

    so that the chain leaves the exact posterior :math:`\pi` as it is whatever the surrogate is; a bad one costs
    effective draws.

    Parameters
    ----------
    surrogate : callable
        Coefficients and a point, shape (size,) → logarithm of a likelihood; traceable by JAX.
    exact : callable
        Points, shape (chains, size) → logarithm of the likelihood, −inf where it is zero, shape (chains,).
    size : int
        Dimension of the cube.
    warmup : int
        Steps that adapt.
    seed : int
        Of all random numbers.

    Attributes
    ----------
    position, log_exact : ndarray
        Where the chains are, shape (chains, size), and the logarithm of the exact likelihood there, shape (chains,).
    accepted, proposed, divergences : int
        Counts since the last :meth:`start` or :meth:`forget`.

    References
    ----------
    J. A. Christen and C. Fox, J. Comput. Graph. Stat. 14 (2005) 795 (delayed acceptance); M. D. Hoffman and
    A. Gelman, J. Mach. Learn. Res. 15 (2014) 1593 (NUTS); A. Durmus et al., arXiv:2307.03460 (its reversibility).
    """

    def __init__(
        self,
        *,
        surrogate: Callable[[Any, Array], Array],
        exact: Callable[[np.ndarray], np.ndarray],
        size: int,
        warmup: int,
        seed: int,
    ) -> None:
        import numpyro
        import numpyro.distributions as dist
        from numpyro.distributions import constraints

        def model(frame: Any) -> None:
            # coordinates of about unit covariance; a uniform prior of u is u (1 − u) in the logarithm of the odds
            free = numpyro.sample("free", dist.ImproperUniform(constraints.real_vector, (), (size,)))
            odds = frame["centre"] + frame["axes"] @ free
            log_prior = jnp.sum(jax.nn.log_sigmoid(odds) + jax.nn.log_sigmoid(-odds))
            numpyro.factor("density", log_prior + surrogate(frame["coefficients"], jax.nn.sigmoid(odds)))

        self._model, self._surrogate, self._exact, self._warmup = model, surrogate, exact, warmup
        self._random, self._key = np.random.default_rng(seed), jax.random.key(seed)
        self._propose: Callable[[Any, Any], Any] | None = None
        self._choose = jax.jit(_chosen)
        self.forget()

    def start(self, coefficients: Any, begin: np.ndarray, covariance: np.ndarray) -> None:
        """Start the chains at points of shape (chains, size), with a first guess of the posterior's covariance.

        The coefficients of the surrogate have the same shapes each time.
        """
        from numpyro.infer import NUTS, init_to_value

        inside = np.clip(begin, _MARGIN, 1.0 - _MARGIN)
        odds = np.log(inside / (1.0 - inside))
        centre = odds.mean(axis=0)
        axes = np.linalg.cholesky(_in_log_odds(covariance, inside.mean(axis=0)))
        self._frame = trees.map(jnp.asarray, {"coefficients": coefficients, "centre": centre, "axes": axes})
        kernel = NUTS(
            self._model,
            dense_mass=True,
            target_accept_prob=0.9,
            init_strategy=init_to_value(values={"free": jnp.zeros(centre.size)}),
        )
        self._key, key = jax.random.split(self._key)
        with jax.numpy_dtype_promotion("standard"):  # NumPyro counts its steps in integers
            self._state = kernel.init(
                jax.random.split(key, len(begin)),
                self._warmup,
                {"free": jnp.asarray(np.linalg.solve(axes, (odds - centre).T).T)},
                (self._frame,),
                {},
            )
        if self._propose is None:  # the kernel keeps nothing of one start that another would change
            self._propose = jax.jit(lambda state, frame: self._proposal(kernel, state, frame))
        self.position = inside
        self.forget()

    def _proposal(self, kernel: Any, state: Any, frame: Any) -> Any:
        new = kernel.sample(state, (frame,), {})
        unit = jax.nn.sigmoid(frame["centre"] + new.z["free"] @ frame["axes"].T)
        return new, unit, jax.vmap(lambda point: self._surrogate(frame["coefficients"], point))(unit)

    def forget(self) -> None:
        """Count from here."""
        self.accepted, self.proposed, self.divergences = 0, 0, 0

    def _moved(self) -> tuple[Any, np.ndarray, np.ndarray]:
        assert self._propose is not None, "start comes first"
        with jax.numpy_dtype_promotion("standard"):
            new, unit, log_surrogate = self._propose(self._state, self._frame)
        self.divergences += int(np.sum(np.asarray(new.diverging)))
        return new, np.asarray(unit), np.asarray(log_surrogate)

    def warm_up(self) -> None:
        """One step by the surrogate alone; the sampler adapts to it."""
        self._state, self.position, self._log_surrogate = self._moved()

    def begin_exactly(self) -> None:
        """End the warm-up; a chain where the exact likelihood is zero leaves as soon as it can."""
        self.log_exact = self._exact(self.position)
        self.forget()

    def step(self) -> tuple[np.ndarray, np.ndarray]:
        """Points that an exact step proposed, shape (chains, size), and the exact log-likelihood there."""
        new, proposed, log_surrogate = self._moved()
        log_exact = self._exact(proposed)
        with np.errstate(invalid="ignore"):
            log_ratio = (log_exact - log_surrogate) - (self.log_exact - self._log_surrogate)
        accept = np.log(self._random.random(len(proposed))) < log_ratio  # never where the ratio is nan
        self._state = self._choose(jnp.asarray(accept), new, self._state)
        self.position = np.where(accept[:, None], proposed, self.position)
        self.log_exact = np.where(accept, log_exact, self.log_exact)
        self._log_surrogate = np.where(accept, log_surrogate, self._log_surrogate)
        self.accepted += int(accept.sum())
        self.proposed += accept.size
        return proposed, log_exact


def _chosen(accept: Array, new: Any, old: Any) -> Any:
    """The new state of the chains that accept, the old one of the others; random numbers go on in all."""

    def chosen(after: Array, before: Array) -> Array:
        return jnp.where(accept.reshape((-1,) + (1,) * (after.ndim - 1)), after, before)

    return trees.map(chosen, new, old)._replace(rng_key=new.rng_key, i=new.i)


def _in_log_odds(covariance: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """Covariance of the logarithm of the odds u/(1−u), to first order, no closer to a bound than it is wide."""
    spread = np.sqrt(np.diag(covariance))
    place = np.clip(centre, np.minimum(spread, 0.5), np.maximum(1.0 - spread, 0.5))
    slope = 1.0 / (place * (1.0 - place))
    return slope[:, None] * covariance * slope
