"""Displacements of pins and contacts are the slopes of one energy."""

import jax
import jax.numpy as jnp
import numpy as np

from asperity.drive.state.bores import Bores, sides


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


def test_a_pin_changes_sides_smoothly():
    """Without a force it presses neither half; three forces of its scale away it presses one, by the hypotenuse."""
    sign, size, slope = sides(jnp.array([0.0, 3e-4, -4e-4, 2.0]), 1.0)
    np.testing.assert_allclose(sign, [0.0, 3.0 / 10.0**0.5, -4.0 / 17.0**0.5, 1.0], atol=2e-9)
    np.testing.assert_allclose(
        size, [0.0, (10.0**0.5 - 1.0) * 1e-4, (17.0**0.5 - 1.0) * 1e-4, 1.9999], atol=1e-8
    )
    np.testing.assert_allclose(slope[:3], 1e4 / np.array([1.0, 10.0, 17.0]) ** 1.5, rtol=1e-12)
