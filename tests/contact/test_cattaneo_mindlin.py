"""Partial slip of cylinders: the traction carries T, obeys Coulomb, and sticks where it should."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.cattaneo_mindlin import stick_half_width
from asperity.contact.hertz_line import peak_pressure

LOAD, LENGTH, WIDTH, MU = 1000.0, 5e-3, 8e-5, 0.12


def traction(x, force):
    stick = stick_half_width(
        half_width=WIDTH, normal_force=LOAD, tangential_force=force, friction_coefficient=MU
    )
    limit = MU * peak_pressure(normal_force=LOAD, contact_length=LENGTH, half_width=WIDTH)

    def ellipse(width):
        return jnp.where(jnp.abs(x) < width, jnp.sqrt(jnp.maximum(1.0 - (x / width) ** 2, 0.0)), 0.0)

    # Johnson 1985, equation (7.24)
    return limit * (ellipse(WIDTH) - jnp.where(stick > 0.0, stick / WIDTH * ellipse(stick), 0.0))


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.0])
def test_the_traction_integrates_to_the_tangential_force(share):
    force = share * MU * LOAD
    kinks = [WIDTH * np.sqrt(max(1.0 - share, 0.0))]
    total = quad(lambda x: float(traction(x, force)), 0.0, WIDTH, points=kinks, epsabs=0.0, epsrel=1e-9)[0]
    assert 2.0 * total * LENGTH == pytest.approx(force, rel=1e-7)


def test_the_traction_never_exceeds_friction():
    x = jnp.linspace(-WIDTH, WIDTH, 401)
    pressure = peak_pressure(normal_force=LOAD, contact_length=LENGTH, half_width=WIDTH) * jnp.sqrt(
        1.0 - (x / WIDTH) ** 2
    )
    assert bool(jnp.all(traction(x, 60.0) <= MU * pressure * (1.0 + 1e-12)))


def test_stick_zone_of_the_cattaneo_benchmark():
    """Johnson 1985, equation (7.28): 7/8 of mu N leaves sqrt(1/8) of the width of a line contact."""
    ours = stick_half_width(half_width=1.0, normal_force=1.0, tangential_force=0.35, friction_coefficient=0.4)
    assert float(ours) == pytest.approx(np.sqrt(1.0 / 8.0), rel=1e-14)
    gone = stick_half_width(half_width=1.0, normal_force=1.0, tangential_force=0.5, friction_coefficient=0.4)
    assert float(gone) == 0.0
