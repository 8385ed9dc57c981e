"""A pin in a bore: the published figure of a hollow planet, and a force in the opposite direction."""

import math

import numpy as np
import pytest
from pressed_pin import disc

from asperity.body.bore import bore_modes
from asperity.body.conforming_pin import SHARED, conforming_compliance
from asperity.body.shapes import Annulus

PLANET = Annulus(13e-3, 20e-3, 10e-3, 208e9, 0.3, 0.0, 0.0, "outer", "plane_strain")
CONTACTS = np.array([0.0, math.pi])
#: Shares of the modes in the cosine pressure on half of a bore.
COSINE = np.array([4.0 / math.pi if n == 0 else 0.0 if n % 2 else 4.0 / math.pi * (-1) ** (n // 2 + 1) / (n * n - 1)
                   for n in SHARED])  # fmt: skip


def test_a_hollow_planet_gives_way_as_plane_finite_elements_say():
    """Bore 26 mm in 40 mm, 10 mm long, dragged by T at both contacts: 5.35e-9 m/N more than with a force on its rim.

    Under the cosine pressure of a rigid pin, whose own flattening is taken off.
    """
    found = bore_modes(body=PLANET, contact_angles=CONTACTS, push_angle=0.5 * math.pi)
    kolosov = 3.0 - 4.0 * 0.3
    plate = 4.0 / math.pi * SHARED[1:] / (SHARED[1:] ** 2 - 1.0)
    pin = 2.0 / (math.pi * (kolosov + 1.0)) * 2.0 * disc(SHARED[1:], kolosov)
    unit = 2.0 / (math.pi * (kolosov + 1.0))
    even = (1.0 / math.pi - unit * 0.5 * (kolosov - 1.0) + found.wall[0]) * COSINE[0] ** 2
    own = found.shift + found.scale * (even + np.sum((plate - pin + found.wall[1:]) * COSINE[1:] ** 2))
    own -= found.scale * unit * 0.5 * (kolosov - 1.0)  # the pin's first mode
    drag = np.array([0.0, 0.0, -1.0, 1.0])  # downwards, the pin with 2 upwards
    assert 4.0 * own + 4.0 * (found.along + found.rim @ COSINE) @ drag == pytest.approx(5.35e-9, rel=2e-3)


def test_the_opposite_force_presses_the_other_side():
    """Turning the pin round is turning the force: odd modes change their sign, even ones do not."""
    angles = np.array([0.3, 2.0, 4.4])
    one, other = (
        bore_modes(body=PLANET, contact_angles=angles, push_angle=0.7 + turn) for turn in (0.0, math.pi)
    )
    odd = np.where(SHARED % 2 == 1, -1.0, 1.0)
    for name in ("shift", "scale", "wall"):
        np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=1e-12)
    np.testing.assert_allclose(other.along, -one.along, rtol=1e-9, atol=1e-24)
    np.testing.assert_allclose(other.rim, odd * one.rim, rtol=1e-9, atol=1e-20)


def test_the_rim_grows_as_under_the_mean_pressure_of_the_pin():
    """Over all directions only the mean of the pressure is left, w_0/2 pi of F/RL: Lamé's tube."""
    places = 101
    angles = np.asarray(2.0 * math.pi / places * np.arange(places))
    found = bore_modes(body=PLANET, contact_angles=angles, push_angle=0.4)
    inner, outer, length = 13e-3, 20e-3, 10e-3
    pressure = 1.0 / (2.0 * math.pi * inner * length)  # of one newton and a share of one
    expected = 2.0 * pressure * inner**2 * outer * (1.0 - 0.3**2) / (208e9 * (outer**2 - inner**2))
    mean = np.asarray(found.rim).reshape(2, places, -1).mean(axis=1)
    assert mean[0, 0] == pytest.approx(expected, rel=1e-9)
    # modes that repeat at the places of 101 angles: none up to 80
    assert abs(mean[0, 1:]).max() < 1e-9 * expected
    assert abs(mean[1]).max() < 1e-9 * expected


def test_a_thick_wall_adds_nothing_to_a_large_plate():
    """A roller of a thousand radii: its modes are those of the plate."""
    plate = Annulus(13e-3, 13.0, 10e-3, 208e9, 0.3, 0.0, 0.0, "outer", "plane_strain")
    found = bore_modes(body=plate, contact_angles=CONTACTS, push_angle=0.0)
    assert abs(np.asarray(found.wall)).max() < 1e-5 * float(conforming_compliance(arc=np.asarray(0.4)))
