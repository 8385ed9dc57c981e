"""Displacements of pins and contacts are the slopes of one energy; pins change sides smoothly."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from pins_in_bores import pins, random_bores

from asperity.body.conforming_pin import SHARED, pressure_shares
from asperity.drive.state.bores import TURNOVER, Bores, by_amplitude

FORCE = np.array([70.0, -40.0])


@pytest.mark.slow
@pytest.mark.parametrize("clearance", [0.0, 2e-6])
def test_displacements_are_slopes_of_the_energy(clearance):
    """The energy by the shares of the modes: even ones press outward whatever the sign of the force."""
    random = np.random.default_rng(1)
    along_n, along_t = (np.asarray(random.uniform(-1.0, 1.0, (3, 2))) for _ in range(2))
    rim_n, rim_t = (np.asarray(random.uniform(-1.0, 1.0, (3, 2, SHARED.size))) for _ in range(2))
    contact = pins(2, clearance)
    bores = Bores(along_n, along_t, by_amplitude(rim_n), by_amplitude(rim_t), contact)
    normal, rest, tangential = (np.asarray(random.uniform(-1.0, 1.0, 3)) for _ in range(3))
    odd = SHARED % 2 == 1

    def energy(force, normal, tangential):
        shares = pressure_shares(arc=jnp.sin(0.5 * contact.angle(jnp.abs(force))) ** 2)
        modes = jnp.where(odd, force[:, None], -jnp.abs(force)[:, None]) * shares
        moved = jnp.einsum("cpn,c->pn", rim_n, normal - rest) + jnp.einsum("cpn,c->pn", rim_t, tangential)
        return force @ (along_n.T @ normal + along_t.T @ tangential) + jnp.sum(modes * moved)

    pressed = bores.beyond_turnover(FORCE)
    by_force, by_normal, by_tangential = jax.grad(energy, argnums=(0, 1, 2))(FORCE, normal, tangential)
    for found, expected in zip(bores.moved(FORCE, pressed), (by_normal, by_tangential), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-9)
    moved = bores.pin_moved(pressed, normal, normal - rest, tangential)
    np.testing.assert_allclose(moved - pressed.approach, by_force, rtol=1e-8)
    # and small changes follow the second slopes
    of_pin = jax.jacfwd(jax.grad(energy, argnums=1))(FORCE, normal, tangential)
    np.testing.assert_allclose(bores.by_pin(pressed)[0], of_pin, rtol=1e-8)


@pytest.mark.parametrize("clearance", [0.0, 2e-6])
@pytest.mark.parametrize("force", [70.0, -40.0, 0.1, 0.0])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_slopes_by_finite_differences(clearance, force):
    """Also where a pin changes sides, a ten-thousandth of the largest force."""
    largest, step = 1000.0, 2e-4 * max(abs(force), 0.1)
    bores = random_bores(np.random.default_rng(2), contacts=3, count=1, clearance=clearance, size=1e-9)
    less, at, more = (bores.under(np.array([force + side * step]), largest) for side in (-1.0, 0.0, 1.0))
    for found, low, high in (
        (at.slope, less.amplitude, more.amplitude),
        (at.curvature, less.slope, more.slope),
        (at.compliance, less.approach, more.approach),
    ):
        expected = (np.asarray(high) - np.asarray(low)) / (2.0 * step)
        np.testing.assert_allclose(found, expected, rtol=1e-5, atol=1e-5 * abs(expected).max())
    change, tangential = np.array([1.0, -2.0, 0.5]), np.array([0.3, 2.0, 1.0])
    ends = [bores.pin_moved(each, change, change, tangential) for each in (less, more)]
    slope = bores.pin_slope(at, change, tangential)
    np.testing.assert_allclose(slope, (ends[1] - ends[0]) / (2.0 * step), rtol=1e-4)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_pin_changes_sides_smoothly():
    """Without a force it presses neither side; three forces of its scale away it presses one, by the hypotenuse."""
    bores, small = (
        random_bores(np.random.default_rng(3), contacts=1, count=1, clearance=0.0, size=1e-9),
        TURNOVER,
    )
    uniform = float(pressure_shares(arc=jnp.sin(0.5 * bores.contact.angle(np.ones(1))) ** 2)[0, 0])
    for force, size, side in (
        (0.0, 0.0, 0.0),
        (3.0 * small, (10.0**0.5 - 1.0) * small, 3.0 / 10.0**0.5),
        (-4.0 * small, (17.0**0.5 - 1.0) * small, -4.0 / 17.0**0.5),
        (2.0, 2.0 - small, 1.0),
    ):
        pressed = bores.under(np.array([force]), 1.0)
        assert float(pressed.amplitude[0, 0]) == pytest.approx(-uniform * size, rel=1e-6, abs=1e-15)
        assert float(pressed.slope[0, 0]) == pytest.approx(-uniform * side, rel=1e-6, abs=1e-12)
