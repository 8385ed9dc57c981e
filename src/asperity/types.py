"""Numbers of the formula code: their type, and which array library computes with them."""

from typing import Any, TypeAlias

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

#: A float or an array of floats of any broadcastable shape; formulas map `Real` to `Real` elementwise.
Real: TypeAlias = Array | float


def namespace(*numbers: Any) -> Any:
    """NumPy, which computes small sums at once, where no JAX array is among the numbers; else :mod:`jax.numpy`."""
    return jnp if any(isinstance(leaf, jax.Array) for leaf in jax.tree.leaves(numbers)) else np
