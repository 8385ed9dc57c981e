"""Archard's law of a rolling contact, against the integral of pressure and slip over Carter's contact."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.wear import (
    mixed_load_power,
    slipping_load_power,
    worn_depth_rate,
    worn_volume_rate,
)

FORCE, WIDTH, FRICTION, CREEPAGE, SPEED = 800.0, 60e-6, 0.12, 6e-4, 2.5


@pytest.mark.parametrize("ratio", [0.05, 0.4, 0.9])
def test_carters_contact_by_quadrature(ratio):
    """Slip only behind the stick zone at the leading edge; the slip rate there is that of Carter's stresses."""
    stick = WIDTH * math.sqrt(1.0 - ratio)
    middle = WIDTH - stick  # of the stick zone, which touches the leading edge
    peak = 2.0 * FORCE / (math.pi * WIDTH)

    # surface strains of the two ellipses: within its own half-width each makes a linear rate, beyond it a root too
    def slip(x):
        beyond = abs(x - middle) / stick
        return CREEPAGE * SPEED * math.sqrt(beyond**2 - 1.0) / _carter_scale(ratio)

    def pressure(x):
        return peak * math.sqrt(1.0 - (x / WIDTH) ** 2)

    worn, _ = quad(lambda x: pressure(x) * slip(x), -WIDTH, middle - stick)
    power, _ = quad(lambda x: FRICTION * pressure(x) * slip(x), -WIDTH, middle - stick)
    assert slipping_load_power(friction_power=power, friction_coefficient=FRICTION) == pytest.approx(worn)
    # what the friction does on the slip is what the force loses: its power on the creepage
    assert power == pytest.approx(ratio * FRICTION * FORCE * CREEPAGE * SPEED, rel=1e-6)


def _carter_scale(ratio):
    r"""Creepage over the slope of its slip rate, :math:`\mu c/R`: :math:`(1 - \sqrt{1-q})/\sqrt{1-q}`."""
    return (1.0 - math.sqrt(1.0 - ratio)) / math.sqrt(1.0 - ratio)


def test_creepage_times_normal_force_is_too_much():
    tangential = 0.25 * FRICTION * FORCE
    power = tangential * CREEPAGE * SPEED
    too_much = mixed_load_power(asperity_share=1.0, normal_force=FORCE, slip_speed=CREEPAGE * SPEED)
    right = slipping_load_power(friction_power=power, friction_coefficient=FRICTION)
    assert too_much / right == pytest.approx(FRICTION * FORCE / tangential)


def test_a_full_film_keeps_the_surfaces():
    assert mixed_load_power(asperity_share=0.0, normal_force=FORCE, slip_speed=1.0) == 0.0
    assert mixed_load_power(asperity_share=0.2, normal_force=FORCE, slip_speed=0.5) == pytest.approx(80.0)


def test_depth_of_a_track():
    """A pin of 1 mm^2 under 1 N that slides 1 m loses what the coefficient says, on a track as on a flat."""
    volume = worn_volume_rate(wear_coefficient=1e-15, load_power=1.0)
    assert volume * 1e9 == pytest.approx(1e-6)  # mm^3/(N m)
    radius, length = 4e-3, 5e-3
    depth = worn_depth_rate(volume_rate=volume, track_radius=radius, contact_length=length)
    assert float(depth) * 2.0 * np.pi * radius * length == pytest.approx(volume)
