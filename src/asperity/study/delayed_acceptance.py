"""Chains that NUTS (NumPyro) moves by a cheap likelihood, and that an exact one lets move or not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

#: A chain begins no closer to a bound than this: the logarithm of the odds, in which NUTS moves, is endless there.
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

        def model(coefficients: Any) -> None:
            unit = numpyro.sample("unit", dist.Uniform(jnp.zeros(size), jnp.ones(size)).to_event(1))
            numpyro.factor("likelihood", surrogate(coefficients, unit))

        self._model, self._surrogate, self._exact, self._warmup = model, surrogate, exact, warmup
        self._random, self._key = np.random.default_rng(seed), jax.random.key(seed)
        self._propose: Callable[[Any, Any], Any] | None = None
        self._choose = jax.jit(_chosen)
        self.forget()

    def start(self, coefficients: Any, begin: np.ndarray, covariance: np.ndarray) -> None:
        """Begin anew.

        Parameters
        ----------
        coefficients : pytree
            Of the surrogate; of the same shapes each time.
        begin : ndarray
            Where, shape (chains, size).
        covariance : ndarray
            First guess of the posterior's, shape (size, size).
        """
        from numpyro.infer import NUTS

        inside = np.clip(begin, _MARGIN, 1.0 - _MARGIN)
        kernel = NUTS(
            self._model,
            dense_mass=True,
            inverse_mass_matrix=jnp.asarray(_in_log_odds(covariance, inside.mean(axis=0))),
        )
        self._key, key = jax.random.split(self._key)
        with jax.numpy_dtype_promotion("standard"):  # NumPyro counts its steps in integers
            self._state = kernel.init(
                jax.random.split(key, len(begin)),
                self._warmup,
                {"unit": jnp.asarray(np.log(inside / (1.0 - inside)))},
                (coefficients,),
                {},
            )
        if self._propose is None:  # the kernel keeps nothing of one start that another would change
            self._propose = jax.jit(lambda state, fitted: self._proposal(kernel, state, fitted))
        self._coefficients, self.position = coefficients, inside
        self.forget()

    def _proposal(self, kernel: Any, state: Any, coefficients: Any) -> Any:
        new = kernel.sample(state, (coefficients,), {})
        unit = jax.nn.sigmoid(new.z["unit"])
        return new, unit, jax.vmap(lambda point: self._surrogate(coefficients, point))(unit)

    def forget(self) -> None:
        """Count from here."""
        self.accepted, self.proposed, self.divergences = 0, 0, 0

    def _moved(self) -> tuple[Any, np.ndarray, np.ndarray]:
        assert self._propose is not None, "start comes first"
        with jax.numpy_dtype_promotion("standard"):
            new, unit, log_surrogate = self._propose(self._state, self._coefficients)
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
        """One exact step.

        Returns
        -------
        proposed, log_exact : ndarray
            Points that were proposed, shape (chains, size), and the exact log-likelihood there, shape (chains,).
        """
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

    return jax.tree.map(chosen, new, old)._replace(rng_key=new.rng_key, i=new.i)


def _in_log_odds(covariance: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """Covariance of the logarithm of the odds u/(1−u), to first order, no closer to a bound than it is wide."""
    spread = np.sqrt(np.diag(covariance))
    place = np.clip(centre, np.minimum(spread, 0.5), np.maximum(1.0 - spread, 0.5))
    slope = 1.0 / (place * (1.0 - place))
    return slope[:, None] * covariance * slope
