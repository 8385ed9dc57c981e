"""Which array library computes with given numbers."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np


def namespace(*numbers: Any) -> Any:
    """The module of array functions for numbers: NumPy where no JAX array is among them, else :mod:`jax.numpy`.

    Parameters
    ----------
    *numbers
        Numbers, arrays or modules of them.

    Returns
    -------
    module
        NumPy computes a single joint's small sums at once; JAX would compile a program for each function.
    """
    return jnp if any(isinstance(leaf, jax.Array) for leaf in jax.tree.leaves(numbers)) else np
