"""The one type alias of the formula code."""

from typing import TypeAlias

from jax import Array

#: A float or an array of floats of any broadcastable shape; formulas map `Real` to `Real` elementwise.
Real: TypeAlias = Array | float
