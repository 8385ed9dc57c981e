"""Types of the numbers of the formula code."""

from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from jax import Array
    from jax.typing import ArrayLike
else:
    Array = ArrayLike = Any

#: A float or an array of floats of any broadcastable shape; formulas map `Real` to `Real` elementwise.
Real: TypeAlias = Array | float

__all__ = ["Array", "ArrayLike", "Real"]
