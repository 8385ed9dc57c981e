"""Displacements of pins and contacts are the slopes of one energy."""

import jax
import jax.numpy as jnp
import numpy as np

from asperity.drive.state.bores import Bores


def test_displacements_are_slopes_of_the_energy():
    random = np.random.default_rng(1)
    along_n, along_t, around_n, around_t = (jnp.asarray(random.uniform(-1.0, 1.0, (3, 2))) for _ in range(4))
    bores = Bores(along_n, along_t, around_n, around_t, jnp.zeros(2))
    normal, rest, tangential = (jnp.asarray(random.uniform(-1.0, 1.0, 3)) for _ in range(3))
    force, largest = jnp.array([0.7, -0.4]), 1e-9

    def energy(force, normal, tangential):
        both = force @ (along_n.T @ normal + along_t.T @ tangential)
        return both - jnp.abs(force) @ (around_n.T @ (normal - rest) + around_t.T @ tangential)

    by_force, by_normal, by_tangential = jax.grad(energy, argnums=(0, 1, 2))(force, normal, tangential)
    for found, expected in zip(bores.moved(force, largest), (by_normal, by_tangential), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-8)
    pin = bores.pin_moved(force, largest, normal, normal - rest, tangential)
    np.testing.assert_allclose(pin, by_force, rtol=1e-12)
    # and small changes follow the second slopes
    of_pin = jax.jacfwd(jax.grad(energy, argnums=1))(force, normal, tangential)
    np.testing.assert_allclose(bores.by_pin(jnp.sign(force))[0], of_pin, rtol=1e-12)
