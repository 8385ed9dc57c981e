"""Flash temperature and oil film of the contacts of a drive: by hand, and absent without their numbers."""

import dataclasses
import math
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.state import RollingSpeeds
from asperity.materials import Material
from asperity.rolling.conditions import PLAIN_ROLLING
from asperity.rolling.surface import flash_temperatures, oil_film

STEEL = Material(206e9, 0.3, 7800.0, 450e6, 1260e6, thermal_conductivity=46.0, specific_heat_capacity=460.0)
CERAMIC = Material(307e9, 0.26, 3200.0, 4e9, 14.7e9, thermal_conductivity=30.0, specific_heat_capacity=750.0)
UNKNOWN = Material(206e9, 0.3, 7800.0, 450e6, 1260e6)
EACH = jnp.ones(5)
#: Sun and planet, planet and loading rollers, loading rollers and ring.
CONTACT_BODIES = ((0, 1), (1, 2), (1, 2), (2, 3), (2, 3))


def rises(bodies, *, power=EACH * 20.0, speed=2.0, stuck=EACH * 0.5):
    speeds = RollingSpeeds(EACH * speed * 1.001, EACH * speed, EACH, jnp.asarray(1.0))
    found = flash_temperatures(
        materials=[(bodies[one], bodies[two]) for one, two in CONTACT_BODIES],
        friction_power=power,
        speeds=speeds,
        half_width=EACH * 1e-4,
        stick_fraction=stuck,
    )
    return np.asarray(found)


def test_the_slip_zone_is_the_source_of_heat():
    """20 W/m, half of a width of 0.2 mm slips, 2 m/s: Blok's rise over sqrt(0.5), and 5 % for the uneven heat."""
    b = math.sqrt(46.0 * 7800.0 * 460.0)
    even = 1.11 * 20.0 / (math.sqrt(2e-4) * b * (math.sqrt(2.002) + math.sqrt(2.0)))
    np.testing.assert_allclose(rises((STEEL, STEEL, STEEL, STEEL)), even / math.sqrt(0.5) * 1.052, rtol=2e-3)


def test_unlike_bodies_and_those_without_thermal_properties():
    like = rises((STEEL, STEEL, STEEL, STEEL))
    found = rises((STEEL, CERAMIC, CERAMIC, UNKNOWN))
    steel, ceramic = math.sqrt(46.0 * 7800.0 * 460.0), math.sqrt(30.0 * 3200.0 * 750.0)
    assert found[0] / like[0] == pytest.approx(2.0 * steel / (steel + ceramic), rel=1e-3)
    assert found[1] / like[1] == pytest.approx(steel / ceramic, rel=1e-12)
    assert np.all(np.isnan(found[3:]))
    half = dataclasses.replace(STEEL, specific_heat_capacity=None)
    assert np.all(np.isnan(rises((half, STEEL, STEEL, STEEL))) == [True, False, False, False, False])


def test_without_slip_no_rise_and_without_rotation_no_number():
    steel = (STEEL, STEEL, STEEL, STEEL)
    np.testing.assert_array_equal(rises(steel, power=EACH * 0.0, stuck=EACH), np.zeros(5))
    assert np.all(np.isnan(rises(steel, speed=0.0)))


def test_oil_film_of_the_example_pair():
    """T1 with a traction fluid: 0.2128 um, over 0.2 um of roughness."""
    modulus = 206e9 / (2 * (1 - 0.3**2))
    pairs = SimpleNamespace(
        contact_length=10e-3, effective_radius=20e-3 / 3, moduli=SimpleNamespace(contact_modulus=modulus)
    )

    def film(speed=1.0, **changes):
        oil = {"viscosity": 0.0305, "pressure_viscosity_coefficient": 2.918e-8, "roughness": (0.2e-6,)}
        conditions = dataclasses.replace(PLAIN_ROLLING, **(oil | changes))
        return oil_film(
            conditions=conditions, pairs=pairs, normal_force=EACH * 2000.0, rolling_speed=EACH * speed
        )

    thickness, ratio = film()
    np.testing.assert_allclose(thickness, 0.2128e-6, rtol=5e-4)
    np.testing.assert_allclose(ratio, 1.064, rtol=5e-4)
    for absent in (film(viscosity=None), film(pressure_viscosity_coefficient=None), film(speed=0.0)):
        assert np.all(np.isnan(absent))
    apart = film(roughness=tuple(0.1e-6 * (1 + k) for k in range(EACH.size)))[1]
    np.testing.assert_allclose(
        apart, 2.128 / (1.0 + np.arange(EACH.size)), rtol=5e-4
    )  # each contact has its own
    thickness, ratio = film(roughness=None)
    assert np.all(np.isfinite(thickness))
    assert np.all(np.isnan(ratio))
