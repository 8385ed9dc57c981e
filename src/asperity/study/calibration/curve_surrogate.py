"""A polynomial in place of the joint of a curve model: cheap, traceable by JAX, always checked with the model.

The logarithm of the compliance at every torque of the model is a polynomial of the joint's unknowns, fitted to the
model itself around one set of scaled values. The unknowns of the curve (play, offset, drift) enter as in the model.
What is drawn with its help must be checked with the model, as :mod:`asperity.study.calibration.posterior` does.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations_with_replacement
from math import comb

import jax.numpy as jnp
import numpy as np

from asperity.errors import NoSolutionError
from asperity.study.calibration.curve_model import CurveModel
from asperity.types import Array

#: Terms of the polynomial, and its total degree, at most.
MOST_TERMS = 250
MOST_DEGREE = 10

#: Half the width of the fitted box along each axis of the covariance, in standard deviations.
REACH = 6.0

#: Penalty of a term of degree d, times d²: it shifts the coefficient of a well-fitted one by about (1e-3 d²)² of it.
STIFFENING = 1e-3

#: How often that box is made smaller by a half if most joints in it have no solution.
_HALVINGS = 8

#: Numbers of a surrogate, an argument of its prediction, so that another fit needs no other program.
Coefficients = dict[str, Array]


def exponents(unknowns: int) -> np.ndarray:
    """Exponents of all terms up to the highest total degree that :data:`MOST_TERMS` allows, shape (terms, unknowns).

    The constant comes first, then the linear terms.

    Examples
    --------
    >>> exponents(2).shape, int(exponents(2).sum(axis=1).max())
    ((66, 2), 10)
    >>> int(exponents(6).sum(axis=1).max())
    4
    """
    degree = max(d for d in range(1, MOST_DEGREE + 1) if d == 1 or comb(unknowns + d, d) <= MOST_TERMS)
    powers = []
    for total in range(degree + 1):
        for chosen in combinations_with_replacement(range(unknowns), total):
            powers.append([chosen.count(index) for index in range(unknowns)])
    return np.array(powers, int).reshape(len(powers), unknowns)


def fit_surrogate(
    model: CurveModel, centre: np.ndarray, covariance: np.ndarray, *, seed: int
) -> Coefficients:
    """Fit the polynomial around one set of scaled values."""
    joint, rng = model.in_joint, np.random.default_rng(seed)
    powers = exponents(len(joint))
    middle = centre[joint]
    squares, axes = np.linalg.eigh(covariance[np.ix_(joint, joint)])
    reach = REACH * np.sqrt(np.maximum(squares, 1e-30))
    for _ in range(_HALVINGS):
        low, high = _box(middle, axes, reach)
        scaled = _scaled_inside(rng, middle, axes, low, high, 3 * len(powers) + 20)
        scaled_values = np.tile(centre, (len(scaled), 1))
        scaled_values[:, joint] = middle + (0.5 * (low + high) + 0.5 * (high - low) * scaled) @ axes.T
        compliance = model.compliances(scaled_values)
        exists = np.all(np.isfinite(compliance), axis=1)
        if exists.sum() >= 2 * len(powers):
            basis = np.asarray(_basis(scaled[exists], powers))
            terms = _smooth_fit(basis, np.log(compliance[exists]), powers)
            surrogate = {"middle": middle, "axes": axes, "low": low, "high": high, "terms": terms}
            return {name: jnp.asarray(value) for name, value in surrogate.items()}
        reach = 0.5 * reach
    raise NoSolutionError(
        "most joints next to the best fit have no solution (a contact slips or lifts off within the measured torques), "
        "so no posterior can be drawn; leave out the rows of the largest torques, or fix an unknown"
    )


def _smooth_fit(basis: np.ndarray, values: np.ndarray, powers: np.ndarray) -> np.ndarray:
    """Least squares with a slight penalty of high degrees, so that the polynomial stays tame where the joint slips."""
    degree = powers.sum(axis=1)
    penalty = np.where(degree > 1, STIFFENING * np.sqrt(len(basis)) * degree**2, 0.0)
    left = np.concatenate([basis, np.diag(penalty)])
    right = np.concatenate([values, np.zeros((degree.size, values.shape[1]))])
    return np.linalg.lstsq(left, right, rcond=None)[0]


def _box(middle: np.ndarray, axes: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The smaller of the reach and the distance to the bounds, along each axis."""
    to_zero, to_one = -middle[:, None] * axes, (1.0 - middle)[:, None] * axes
    low = np.maximum(-reach, np.minimum(to_zero, to_one).sum(axis=0))
    return low, np.minimum(reach, np.maximum(to_zero, to_one).sum(axis=0))


def _scaled_inside(
    rng: np.random.Generator,
    middle: np.ndarray,
    axes: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    count: int,
) -> np.ndarray:
    """Random scaled values in the box (−1 to 1 along each axis, denser at its ends) that lie between the bounds."""
    points: list[np.ndarray] = []
    for _ in range(200):
        scaled = np.cos(np.pi * rng.random((4 * count, middle.size)))
        scaled_values = middle + (0.5 * (low + high) + 0.5 * (high - low) * scaled) @ axes.T
        points.extend(scaled[np.all((scaled_values >= 0.0) & (scaled_values <= 1.0), axis=1)])
        if len(points) >= count:
            break
    return np.array(points[:count]).reshape(len(points[:count]), middle.size)


def _basis(scaled: np.ndarray | Array, powers: np.ndarray) -> Array:
    """Products of Chebyshev polynomials, shape (..., terms)."""
    scaled = jnp.asarray(scaled)
    ladder = [jnp.ones_like(scaled), scaled]
    for _ in range(2, int(powers.max(initial=1)) + 1):
        ladder.append(2.0 * scaled * ladder[-1] - ladder[-2])
    chebyshev = jnp.stack(ladder)  # (degree, ..., unknowns)
    products = jnp.ones((*scaled.shape[:-1], len(powers)))
    for index in range(powers.shape[1]):
        products = products * jnp.moveaxis(chebyshev[powers[:, index], ..., index], 0, -1)
    return products


def surrogate_prediction(model: CurveModel) -> Callable[[Coefficients, Array], Array]:
    """The prediction of a curve model with the polynomial in place of the joint, shape (unknowns,)."""
    joint = np.array(model.in_joint, int)
    powers = exponents(len(joint))
    weights = None if model.weights is None else jnp.asarray(model.weights)

    def predict(fitted: Coefficients, scaled_values: Array) -> Array:
        along = (scaled_values[joint] - fitted["middle"]) @ fitted["axes"]
        half = 0.5 * (fitted["high"] - fitted["low"])
        scaled = (along - 0.5 * (fitted["low"] + fitted["high"])) / half
        inside = jnp.clip(scaled, -1.0, 1.0)
        linear = fitted["terms"][1 : 1 + joint.size]
        compliance = jnp.exp(_basis(inside, powers) @ fitted["terms"] + (scaled - inside) @ linear)
        if weights is None:
            return 1.0 / compliance
        point = {
            model.unknowns[i].path: model.unknowns[i].from_unit(scaled_values[i]) for i in model.in_curve
        }
        return weights @ compliance + model.curve_part(point, tanh=jnp.tanh)

    return predict
