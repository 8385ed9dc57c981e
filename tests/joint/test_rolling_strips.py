"""Strips of contacts that roll, under even loads: widths by Hertz, shakedown by Johnson."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.contacts import joint_contacts
from asperity.joint.rolling_strips import rolling_strips

NORMAL = np.array([1000.0, 600.0, 500.0, 600.0, 500.0])
RADIUS = np.array([4.0 * 13.5 / 17.5, *[13.5 * 5.0 / 18.5] * 2, *[5.0 * 40.0 / 35.0] * 2]) * 1e-3
LENGTH, MODULUS, YIELD = 5e-3, 206e9 / (2.0 * 0.91), 450e6


@pytest.fixture(scope="module")
def strips(paper_joint):
    return lambda traction: rolling_strips(
        contacts=joint_contacts(paper_joint()),
        normal_force=jnp.asarray(NORMAL),
        traction=jnp.asarray(traction),
    )


def test_even_loads_have_one_width(strips):
    found = strips(np.zeros(5))
    width = np.sqrt(4.0 * NORMAL * RADIUS / (math.pi * LENGTH * MODULUS))
    for name in ("even_half_width", "mean_half_width", "largest_half_width"):
        np.testing.assert_allclose(getattr(found, name), width, rtol=1e-12)
    np.testing.assert_allclose(found.largest_load, NORMAL)
    assert found.middle_power_ratio is None
    assert found.lines is None


def test_shakedown_without_and_with_traction(strips):
    """Line contact: p_0 up to 4 k without traction, k = yield/sqrt(3); k/(T/N) above T/N = 0.367."""
    width = np.sqrt(4.0 * NORMAL * RADIUS / (math.pi * LENGTH * MODULUS))
    pressure, shear = 2.0 * NORMAL / (math.pi * width * LENGTH), YIELD / math.sqrt(3.0)
    np.testing.assert_allclose(strips(np.zeros(5)).shakedown_ratio, pressure / (4.0 * shear), rtol=2e-3)
    np.testing.assert_allclose(strips(np.full(5, -0.5)).shakedown_ratio, pressure * 0.5 / shear, rtol=1e-6)


def test_lives_fall_with_the_load(strips):
    """Every contact has two tracks; the third power of the load at least (ISO 281: 10/3 by load)."""
    found = np.asarray(strips(np.zeros(5)).tracks)
    assert found.shape == (2, 5)
    assert np.all(found[:, 1] < found[:, 2])
    assert np.all(found[:, 2] / found[:, 1] > 1.2**3)
