"""Functions of arrays by their names: those of the package, of NumPy with SciPy, and of JAX."""

import jax
import jax.numpy as jnp
import numpy as np
import scipy.special

from asperity.engine.arrays import special, xp


class Library:
    """The functions of several modules by their names."""

    def __init__(self, *modules):
        self.modules = modules

    def __getattr__(self, name):
        return next(getattr(module, name) for module in self.modules if hasattr(module, name))


OURS = Library(xp, xp.linalg, special)
OF_NUMPY = Library(np, np.linalg, scipy.special)
OF_JAX = Library(jnp, jnp.linalg, jax.scipy.special)
