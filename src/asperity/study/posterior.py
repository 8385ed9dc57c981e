"""Posterior of a calibration by Hamiltonian Monte Carlo (NumPyro), started from the least-squares fit."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.case.values import replace_values
from asperity.errors import InputError, MissingExtraError, NoSolutionError
from asperity.precision import require_double_precision
from asperity.study.calibrate import Calibration
from asperity.study.curve_model import CurveModel
from asperity.study.quantities import joint_quantities

#: Largest split-R-hat that counts as converged (A. Vehtari et al., Bayesian Anal. 16 (2021) 667, recommend 1.01;
#: this is the bound beyond which the numbers are refused).
LARGEST_R_HAT = 1.05


@dataclass(frozen=True)
class Posterior:
    """Draws from the posterior of a calibration.

    Parameters
    ----------
    places : ndarray
        Places of the unknowns between their bounds, shape (draws, unknowns).
    standard_deviation : ndarray
        Of the errors, shape (draws,) [rad] or [N·m/rad].
    r_hat, effective_draws : ndarray
        Split-R-hat and effective number of draws of each unknown, shape (unknowns,).
    divergences : int
        Number of divergent transitions.
    """

    places: np.ndarray
    standard_deviation: np.ndarray
    r_hat: np.ndarray
    effective_draws: np.ndarray
    divergences: int


def require_numpyro() -> None:
    """Raise unless NumPyro is installed.

    Raises
    ------
    MissingExtraError
        Saying what to install.
    """
    if importlib.util.find_spec("numpyro") is None:
        raise MissingExtraError("a posterior needs NumPyro; install it with: pip install 'asperity[bayes]'")


def sample(
    *,
    predict: Callable[[Array], Array],
    data: np.ndarray,
    first: np.ndarray,
    first_deviation: float,
    draws: int,
    warmup: int,
    chains: int,
    seed: int,
) -> Posterior:
    r"""Sample places of unknowns with uniform priors between their bounds, and the size of the errors.

    .. math::
        u_i \sim U(0, 1), \quad \ln(s/s_0) \sim U(-\ln 10, \ln 10), \quad y_k \sim N(f_k(u), s^2)

    Parameters
    ----------
    predict : callable
        f: places, shape (unknowns,), → predictions, shape (points,); traceable by JAX.
    data : ndarray
        y, shape (points,).
    first : ndarray
        Places to start from: the least-squares fit.
    first_deviation : float
        s_0, the standard deviation of its residuals.
    draws, warmup, chains, seed : int
        Of the sampler; draws and warm-up steps are per chain.

    Returns
    -------
    Posterior
        All draws of all chains.

    Raises
    ------
    MissingExtraError
        If NumPyro is not installed.
    NoSolutionError
        If the chains disagree (split-R-hat above :data:`LARGEST_R_HAT`).

    References
    ----------
    M. D. Hoffman and A. Gelman, J. Mach. Learn. Res. 15 (2014) 1593 (NUTS).
    """
    require_numpyro()
    require_double_precision()
    import numpyro
    import numpyro.distributions as dist
    from numpyro.diagnostics import effective_sample_size, split_gelman_rubin
    from numpyro.infer import MCMC, NUTS, init_to_value

    measured = jnp.asarray(data)
    size = first.size

    def model() -> None:
        places = numpyro.sample("places", dist.Uniform(jnp.zeros(size), jnp.ones(size)).to_event(1))
        log_ratio = numpyro.sample("log_ratio", dist.Uniform(-jnp.log(10.0), jnp.log(10.0)))
        deviation = first_deviation * jnp.exp(log_ratio)
        numpyro.sample("data", dist.Normal(predict(places), deviation).to_event(1), obs=measured)

    start = {"places": jnp.clip(jnp.asarray(first), 1e-3, 1.0 - 1e-3), "log_ratio": jnp.asarray(0.0)}
    kernel = NUTS(
        model,
        init_strategy=init_to_value(values=start),
        dense_mass=True,
        forward_mode_differentiation=True,
        target_accept_prob=0.9,
    )
    run = MCMC(
        kernel,
        num_warmup=warmup,
        num_samples=draws,
        num_chains=chains,
        chain_method="vectorized",
        progress_bar=False,
    )
    with jax.numpy_dtype_promotion("standard"):  # NumPyro counts its steps in integers
        run.run(jax.random.key(seed))
    by_chain = run.get_samples(group_by_chain=True)
    places = np.asarray(by_chain["places"])
    r_hat = np.atleast_1d(split_gelman_rubin(places))
    effective = np.atleast_1d(effective_sample_size(places))
    if not np.all(r_hat < LARGEST_R_HAT):
        raise NoSolutionError(
            f"the chains of the posterior disagree (largest split-R-hat {np.max(r_hat):.3g}, allowed {LARGEST_R_HAT}); "
            "take more warm-up steps, or fewer unknowns: the fit names the combinations that the data cannot tell"
        )
    return Posterior(
        places=places.reshape(-1, size),
        standard_deviation=first_deviation * np.exp(np.asarray(by_chain["log_ratio"]).reshape(-1)),
        r_hat=r_hat,
        effective_draws=effective,
        divergences=int(np.sum(np.asarray(run.get_extra_fields()["diverging"]))),
    )


def posterior(calibration: Calibration, *, draws: int, warmup: int, chains: int, seed: int) -> Posterior:
    """Posterior of the unknowns of a calibration.

    Parameters
    ----------
    calibration : Calibration
        The least-squares fit; the chains start there.
    draws, warmup, chains, seed : int
        Of the sampler; draws and warm-up steps are per chain.

    Returns
    -------
    Posterior
        All draws.

    Raises
    ------
    MissingExtraError, NoSolutionError
        As :func:`sample`.
    """
    return sample(
        predict=traceable_prediction(calibration.model),
        data=calibration.model.measurement.measured,
        first=calibration.places,
        first_deviation=calibration.standard_deviation,
        draws=draws,
        warmup=warmup,
        chains=chains,
        seed=seed,
    )


def traceable_prediction(model: CurveModel) -> Callable[[Array], Array]:
    """The prediction of a curve model as a function that JAX can trace.

    Parameters
    ----------
    model : CurveModel
        The model.

    Returns
    -------
    callable
        Places, shape (unknowns,) → predictions, shape (points,). A slope linear in play, offset and drift is taken
        from the model itself; a play torque is not supported here.

    Raises
    ------
    InputError
        If the unknowns contain a play torque.
    """
    if any(unknown.path == "play_torque" for unknown in model.unknowns):
        raise InputError("the posterior has no play torque; leave the unknown play_torque out, or draw no posterior")
    torque = jnp.asarray(model.torque)
    weights = None if model.weights is None else jnp.asarray(model.weights)
    base = np.full(len(model.unknowns), 0.5)
    _, slopes = model(base)
    linear = jnp.asarray(slopes[:, model.in_curve])
    middle = {model.unknowns[i].path: float(model.unknowns[i].from_unit(0.5)) for i in model.in_curve}
    constant = sum((model.curve_part(path, middle)[0] for path in middle), np.zeros(len(slopes)))

    def predict(places: Array) -> Array:
        changes: dict[str, Array] = {"load.output_torque": torque}
        for index in model.in_joint:
            unknown = model.unknowns[index]
            value = (
                unknown.lower * jnp.exp(places[index] * jnp.log(unknown.upper / unknown.lower))
                if unknown.logarithmic
                else unknown.lower + (unknown.upper - unknown.lower) * places[index]
            )
            changes[unknown.path] = jnp.broadcast_to(value, torque.shape)
        stiffness = joint_quantities(replace_values(model.values, changes))[f"stiffness.{model.level}"][0]
        held = stiffness > 0.0
        safe = jnp.where(held, stiffness, 1.0)
        if weights is None:
            return jnp.where(held, safe, jnp.nan)
        angle = weights @ jnp.where(held, 1.0 / safe, jnp.inf)
        return angle + constant + linear @ (places[jnp.array(model.in_curve, int)] - 0.5)

    return predict
