"""A pin in a bore: the published figure of a hollow planet, and a force in the opposite direction."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.bore import bore_compliance
from asperity.body.shapes import Annulus

PLANET = Annulus(13e-3, 20e-3, 10e-3, 208e9, 0.3, 0.0, 0.0, "outer", "plane_strain")
CONTACTS = jnp.array([0.0, math.pi])


def test_a_hollow_planet_gives_way_as_plane_finite_elements_say():
    """Bore 26 mm in 40 mm, 10 mm long, dragged by T at both contacts: 5.35e-9 m/N more than with a force on its rim."""
    found = bore_compliance(body=PLANET, contact_angles=CONTACTS, push_angle=0.5 * math.pi)
    drag = np.array([0.0, 0.0, -1.0, 1.0])  # downwards, the pin with 2 upwards
    assert 4.0 * found.push_compliance + 4.0 * found.along @ drag == pytest.approx(5.35e-9, rel=2e-3)


def test_the_opposite_force_presses_the_other_half():
    """Turning the pin round is turning the force: its share that changes sign does so, the other stays."""
    angles = jnp.array([0.3, 2.0, 4.4])
    one, other = (
        bore_compliance(body=PLANET, contact_angles=angles, push_angle=0.7 + turn) for turn in (0.0, math.pi)
    )
    np.testing.assert_allclose(other.push_compliance, one.push_compliance, rtol=1e-12)
    np.testing.assert_allclose(other.along, -one.along, rtol=1e-9, atol=1e-24)
    np.testing.assert_allclose(other.around, one.around, rtol=1e-9, atol=1e-24)


def test_the_rim_grows_as_under_the_mean_pressure_of_the_pin():
    """Over all directions only the mean of the cosine pressure is left, 1/pi of its largest: Lamé's tube."""
    places = 101
    angles = jnp.asarray(2.0 * math.pi / places * np.arange(places))
    found = bore_compliance(body=PLANET, contact_angles=angles, push_angle=0.4)
    inner, outer, length = 13e-3, 20e-3, 10e-3
    pressure = 2.0 / (math.pi * inner * length) / math.pi  # of one newton
    expected = 2.0 * pressure * inner**2 * outer * (1.0 - 0.3**2) / (208e9 * (outer**2 - inner**2))
    assert float(jnp.mean(found.around[:places])) == pytest.approx(expected, rel=1e-9)
    assert float(jnp.mean(found.around[places:])) == pytest.approx(0.0, abs=1e-9 * expected)
