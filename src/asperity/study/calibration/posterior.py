"""Posterior of a calibration: NUTS (NumPyro) proposes with a surrogate, the model itself accepts or rejects."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import jax.numpy as jnp
import numpy as np
from scipy.special import ndtr, ndtri

from asperity.errors import InputError, NoSolutionError
from asperity.extras import optional_module
from asperity.precision import require_double_precision
from asperity.study.calibration.calibrate import Calibration
from asperity.study.calibration.curve_surrogate import fit_surrogate, surrogate_prediction
from asperity.study.calibration.delayed_acceptance import Chains
from asperity.study.calibration.directions import UNINFORMED
from asperity.types import Array

#: Largest split-R-hat that counts as converged (A. Vehtari et al., Bayesian Anal. 16 (2021) 667, recommend 1.01;
#: this is the bound beyond which the numbers are refused).
LARGEST_R_HAT = 1.05

#: Smallest number of effective draws of an unknown: with fewer, the ends of a 95 % interval are noise.
FEWEST_EFFECTIVE = 100

#: Number of chains; the agreement of two would prove less.
CHAINS = 4

#: Steps that adapt the sampler to the surrogate, and steps after them that show the share of accepted proposals.
WARMUP = 400
PILOT = 60

#: Below this share of accepted proposals the surrogate is fitted again where the chains are, at most this often.
LEAST_ACCEPTANCE = 0.8
REFITS = 3

#: Share of the prior's standard deviation beyond which an unknown fills its bounds, and share of the draws next to a
#: bound beyond which that cuts the posterior: then the bounds decide about the interval.
FILLS = 0.9
CUT_SHARE = 0.01

#: Standard errors by which a share of draws must differ from :data:`CUT_SHARE` before the answer counts as certain.
CERTAIN = 2.0

#: The errors' standard deviation is sought within this factor of the least-squares value, in either direction.
DEVIATION_FACTOR = 10.0


@dataclass(frozen=True)
class Posterior:
    """Draws from the posterior of a calibration.

    ``scaled_values`` of the unknowns (0 at the lower bound, 1 at the upper), shape (draws, unknowns), the draws chain
    by chain, ``chains`` of them; ``standard_deviation`` of the errors, shape (draws,) [rad] or [N·m/rad]. ``r_hat`` and
    ``effective_draws``: split-R-hat and effective number of draws of each unknown and, last, of the logarithm of the
    standard deviation, shape (unknowns + 1,); ``divergences``: divergent transitions of the proposals; ``acceptance``:
    share of the proposals that the model accepted [-].
    """

    scaled_values: np.ndarray
    standard_deviation: np.ndarray
    r_hat: np.ndarray
    effective_draws: np.ndarray
    divergences: int
    acceptance: float
    chains: int

    def share_error(self, inside: np.ndarray) -> float:
        """Standard error of the share of draws for which something holds, from the effective number of such draws [-].

        Where all draws agree, the error of one draw in the effective number of draws.
        """
        from numpyro.diagnostics import effective_sample_size

        share = float(np.mean(inside))
        if share in (0.0, 1.0):
            return 1.0 / float(np.min(self.effective_draws))
        count = float(effective_sample_size(np.reshape(inside, (self.chains, -1)).astype(float)))
        return float(np.sqrt(share * (1.0 - share) / count))

    def note(self, index: int) -> str:
        """How the bounds of an unknown limit its posterior, in words; empty if they do not.

        "cut" where the share of the draws next to a bound is certainly above :data:`CUT_SHARE`, "possibly cut" where
        the draws are too few to decide.
        """
        scaled_values = self.scaled_values[:, index]
        spread = float(np.std(scaled_values))
        if spread > FILLS * UNINFORMED:
            return "fills its bounds"
        # a tenth of a standard deviation next to a bound holds 1 % where that lies 1.7 standard deviations away
        certain, possible = [], []
        for side, near in (
            ("lower", scaled_values < 0.1 * spread),
            ("upper", scaled_values > 1.0 - 0.1 * spread),
        ):
            excess, error = float(np.mean(near)) - CUT_SHARE, self.share_error(near)
            if excess > CERTAIN * error:
                certain.append(side)
            elif excess > -CERTAIN * error and np.any(near):
                possible.append(side)
        notes = [f"cut by {' and '.join(certain)} bound"] if certain else []
        notes += [f"possibly cut by {' and '.join(possible)} bound: take more draws"] if possible else []
        return "; ".join(notes)


def require_numpyro() -> None:
    """Raise a ``MissingExtraError``, which says what to install, unless NumPyro is installed."""
    optional_module("numpyro", extra="bayes", needs="a posterior needs")


def sample(
    *,
    predict: Callable[[np.ndarray], np.ndarray],
    surrogate: Callable[[Any, Array], Array],
    fit: Callable[[np.ndarray, np.ndarray], Any],
    data: np.ndarray,
    first: np.ndarray,
    covariance: np.ndarray,
    first_deviation: float,
    draws: int,
    warmup: int,
    chains: int,
    seed: int,
    progress: Callable[[int, int], None] | None = None,
) -> Posterior:
    r"""Sample scaled values of unknowns with uniform priors, and the size of the errors.

    .. math::
        u_i \sim U(0, 1), \quad \ln(s/s_0) \sim U(-\ln 10, \ln 10), \quad y_k \sim N(f_k(u), s^2)

    Parameters
    ----------
    predict : callable
        f: scaled values, shape (sets, unknowns) → predictions, shape (sets, points); nan where the likelihood is zero.
    surrogate : callable
        Coefficients and scaled values, shape (unknowns,) → predictions like f's, shape (points,); traceable by JAX. It
        only proposes: the draws have the posterior of f, see
        :class:`asperity.study.calibration.delayed_acceptance.Chains`.
    fit : callable
        Centre, shape (unknowns,), and covariance of scaled values → coefficients of a surrogate that is good around
        there, of the same shapes each time.
    data : ndarray
        y, shape (points,).
    first, covariance : ndarray
        Least-squares fit in scaled values, and its covariance: chains begin around it.
    first_deviation : float
        s_0, the standard deviation of its residuals.
    draws, warmup, chains, seed : int
        Of the sampler; draws and warm-up steps are per chain.
    progress : callable, optional
        Called with the number of finished steps and of all steps.

    Returns
    -------
    Posterior
        All draws of all chains.

    Raises
    ------
    MissingExtraError
        If NumPyro is not installed.
    NoSolutionError
        If no beginning is possible, the chains disagree (split-R-hat above :data:`LARGEST_R_HAT`), or they hold fewer
        than :data:`FEWEST_EFFECTIVE` effective draws.
    """
    require_numpyro()
    require_double_precision()
    span, tell = float(np.log(DEVIATION_FACTOR)), progress or (lambda done, total: None)

    # data are an argument: one program for all of one form
    def log_surrogate(given: Any, point: Array) -> Array:
        log_deviation = given["log_deviation"] + span * (2.0 * point[-1] - 1.0)
        scaled = (surrogate(given["fitted"], point[:-1]) - given["data"]) * jnp.exp(-log_deviation)
        return -data.size * log_deviation - 0.5 * jnp.sum(scaled**2)

    def log_likelihood(points: np.ndarray) -> np.ndarray:
        log_deviation = np.log(first_deviation) + span * (2.0 * points[:, -1] - 1.0)
        scaled = (predict(points[:, :-1]) - data) * np.exp(-log_deviation)[:, None]
        logarithm = -data.size * log_deviation - 0.5 * np.sum(scaled**2, axis=1)
        return np.where(np.isfinite(logarithm), logarithm, -np.inf)

    # ln s has the standard deviation 1/sqrt(2 n) where the errors are normal
    centre, spread = np.append(first, 0.5), _capped(covariance, 1.0 / np.sqrt(2.0 * data.size) / (2.0 * span))
    begin = _begins(log_likelihood, centre, spread, chains, seed)
    moving = Chains(surrogate=log_surrogate, exact=log_likelihood, size=centre.size, warmup=warmup, seed=seed)
    total, done = warmup + PILOT + draws, 0
    for refit in range(REFITS + 1):
        given = {
            "fitted": fit(centre[:-1], spread[:-1, :-1]),
            "data": data,
            "log_deviation": np.log(first_deviation),
        }
        moving.start(given, begin, spread)
        for _ in range(warmup):
            moving.warm_up()
            done += 1
            tell(done, total)
        moving.begin_exactly()
        seen = []
        for _ in range(PILOT):
            seen.append(moving.step())
            done += 1
            tell(done, total)
        if moving.accepted >= LEAST_ACCEPTANCE * moving.proposed or refit == REFITS:
            break
        centre, spread, begin = _where_likely(seen, moving, centre, spread)
        total += warmup + PILOT
    if not np.all(np.isfinite(moving.log_exact)):
        raise NoSolutionError(
            f"{int(np.sum(~np.isfinite(moving.log_exact)))} of {chains} chains of the posterior never reached a joint "
            "that exists at all measured torques; narrow the bounds around the fit, or leave out the largest torques"
        )
    moving.forget()
    kept = []
    for _ in range(draws):
        moving.step()
        kept.append(moving.position)
        done += 1
        tell(done, total)
    return _concluded(np.stack(kept, axis=1), moving, first_deviation)


def _capped(covariance: np.ndarray, last: float) -> np.ndarray:
    """Covariance with no direction wider than the prior, and one more coordinate of given standard deviation."""
    squares, axes = np.linalg.eigh(covariance)
    size = len(covariance)
    capped = np.zeros((size + 1, size + 1))
    capped[:size, :size] = (axes * np.minimum(squares, UNINFORMED**2)) @ axes.T
    capped[size, size] = min(last, UNINFORMED) ** 2
    return capped


def _begins(
    log_likelihood: Callable[[np.ndarray], np.ndarray],
    centre: np.ndarray,
    spread: np.ndarray,
    chains: int,
    seed: int,
) -> np.ndarray:
    """Points around the fit at which the likelihood is not zero, shape (chains, size)."""
    rng, begins = np.random.default_rng(seed), []
    for attempt in range(20):  # 20 times, ever closer
        points = rng.multivariate_normal(centre, spread * 0.7**attempt, size=chains)
        points = np.clip(points, 0.01 * centre, 1.0 - 0.01 * (1.0 - centre))
        begins.extend(points[np.isfinite(log_likelihood(points))])
        if len(begins) >= chains:
            return np.array(begins[:chains])
    raise NoSolutionError(
        "the joint has no solution around the best fit (a contact slips or lifts off within the measured torques), so "
        "no posterior can be drawn; leave out the rows of the largest torques, or fix an unknown"
    )


def _where_likely(
    seen: list[tuple[np.ndarray, np.ndarray]], moving: Chains, centre: np.ndarray, spread: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Centre and covariance of the likelier half of what has been seen, and where to begin there."""
    points = np.concatenate([*(position for position, _ in seen), moving.position])
    logarithm = np.concatenate([*(logarithms for _, logarithms in seen), moving.log_exact])
    order = np.argsort(-logarithm)[: max(len(points) // 2, len(moving.position))]
    order = order[np.isfinite(logarithm[order])]
    begin = np.where(np.isfinite(moving.log_exact)[:, None], moving.position, centre)
    if order.size <= centre.size:
        return centre, 0.25 * spread, begin
    chosen = points[order]
    return chosen.mean(axis=0), np.cov(chosen, rowvar=False), begin


def _concluded(kept: np.ndarray, moving: Chains, first_deviation: float) -> Posterior:
    from numpyro.diagnostics import effective_sample_size, split_gelman_rubin

    with np.errstate(invalid="ignore", divide="ignore"):  # a chain that never moved
        r_hat = np.atleast_1d(split_gelman_rubin(kept))
        effective = np.atleast_1d(effective_sample_size(kept))
    acceptance = moving.accepted / moving.proposed
    if not (np.all(r_hat < LARGEST_R_HAT) and np.all(effective >= FEWEST_EFFECTIVE)):
        raise NoSolutionError(
            f"the chains of the posterior have not converged: largest split-R-hat {np.max(r_hat):.3g}, allowed "
            f"{LARGEST_R_HAT}; fewest effective draws {np.min(effective):.0f}, needed {FEWEST_EFFECTIVE}; "
            f"{100.0 * acceptance:.0f} % of the proposals accepted. Take more draws, narrower bounds, or fewer "
            "unknowns: the table of combinations names those that are not identifiable"
        )
    flat = kept.reshape(-1, kept.shape[-1])
    return Posterior(
        scaled_values=flat[:, :-1],
        standard_deviation=first_deviation * DEVIATION_FACTOR ** (2.0 * flat[:, -1] - 1.0),
        r_hat=r_hat,
        effective_draws=effective,
        divergences=moving.divergences,
        acceptance=acceptance,
        chains=kept.shape[0],
    )


def posterior(
    calibration: Calibration, *, draws: int, seed: int, progress: Callable[[int, int], None] | None = None
) -> Posterior:
    """Posterior of the unknowns of a calibration: all draws of all chains, which start at its least-squares fit.

    ``draws`` from each of :data:`CHAINS` chains; ``seed`` of the sampler; ``progress`` is called with the number of
    finished steps and of all steps. The likelihood is zero where the joint has no stiffness at one of the measured
    torques. The draws have the scatter of the data, and each is moved by an error of the model as the intervals of the
    fit are. Raised are an ``InputError`` if two curves were fitted together, or the data fit exactly, so that there are
    no errors whose size could be estimated; a ``MissingExtraError`` and a ``NoSolutionError`` as by :func:`sample`.
    """
    if len(calibration.curves) > 1:
        raise InputError(
            "a posterior is drawn from one curve; fit the curves one after the other, or without it"
        )
    (curve,) = calibration.curves
    model, data = curve.model, curve.measurement.measured
    if curve.standard_deviation <= 1e-12 * float(np.max(np.abs(data))):
        raise InputError(
            "the fit is exact to the last digit, so that the data contain no information about errors; a posterior "
            "needs measured data"
        )
    drawn = sample(
        predict=model.predictions,
        surrogate=surrogate_prediction(model),
        fit=lambda centre, spread: fit_surrogate(model, centre, spread, seed=seed),
        data=data,
        first=calibration.scaled_values,
        covariance=calibration.covariance,
        first_deviation=curve.standard_deviation,
        draws=draws,
        warmup=WARMUP,
        chains=CHAINS,
        seed=seed,
        progress=progress,
    )
    (shift,) = calibration.model_shifts.T
    return replace(drawn, scaled_values=shifted(drawn.scaled_values, shift, seed))


def shifted(scaled_values: np.ndarray, shift: np.ndarray, seed: int) -> np.ndarray:
    """Draws, shape (draws, unknowns), each moved by an error of the model that leaves it within the bounds.

    ``shift`` by an error of one standard deviation, shape (unknowns,).
    """
    moved = np.flatnonzero(shift)
    with np.errstate(over="ignore"):
        ends = (np.array([0.0, 1.0])[:, None, None] - scaled_values[:, moved]) / shift[moved]
    low = ndtr(ends.min(axis=0).max(axis=1, initial=-np.inf))
    high = ndtr(ends.max(axis=0).min(axis=1, initial=np.inf))
    error = ndtri(low + (high - low) * np.random.default_rng(seed).random(len(scaled_values)))
    return scaled_values + error[:, None] * shift
