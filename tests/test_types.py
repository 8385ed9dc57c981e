"""Which array library computes with given numbers."""

import jax
import jax.numpy as jnp
import numpy as np

from asperity.types import namespace


def test_numpy_for_known_numbers_and_jax_for_its_own():
    assert namespace(1.0, np.ones(2), {"a": 2}) is np
    assert namespace(1.0, {"a": jnp.ones(2)}) is jnp
    seen = []
    jax.jit(lambda x: seen.append(namespace(x, 1.0)) or x)(1.0)
    assert seen == [jnp]
