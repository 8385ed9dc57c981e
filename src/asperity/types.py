"""Types of the numbers of the formula code."""

from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from jax import Array
    from jax.typing import ArrayLike
else:
    Array = ArrayLike = Any

#: A number or an array of any engine: Python's, NumPy's, JAX's, with slopes, or many at once.
Number: TypeAlias = Any
#: Numbers in modules, tuples and dictionaries, nested as they may be; or one of them.
Tree: TypeAlias = Any
#: Plain data by name: a JSON document, the tables of a joint file, or a part of them.
Document: TypeAlias = dict[str, Any]
#: A float or an array of floats of any broadcastable shape; formulas map `Real` to `Real` elementwise.
Real: TypeAlias = Array | float

__all__ = ["Array", "ArrayLike", "Document", "Number", "Real", "Tree"]
