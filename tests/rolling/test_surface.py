"""Flash temperature and oil film of the contacts of a drive: by hand, and absent without their numbers."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.contact.life_factor import life_modification_factor
from asperity.contact.rolling_fatigue import BEARING_STEEL, line_contact_life
from asperity.drive.state.state import RollingSpeeds
from asperity.joint.description import joint_contacts
from asperity.materials import Material
from asperity.rolling.conditions import PLAIN_ROLLING
from asperity.rolling.life import film_factors
from asperity.rolling.surface import flash_temperatures, mean_half_width, oil_film, rolling_strips

STEEL = Material(206e9, 0.3, 7800.0, 450e6, 1260e6, thermal_conductivity=46.0, specific_heat_capacity=460.0)
CERAMIC = Material(307e9, 0.26, 3200.0, 4e9, 14.7e9, thermal_conductivity=30.0, specific_heat_capacity=750.0)
UNKNOWN = Material(206e9, 0.3, 7800.0, 450e6, 1260e6)
EACH = np.ones(5)
#: Sun and planet, planet and loading rollers, loading rollers and ring.
CONTACT_BODIES = ((0, 1), (1, 2), (1, 2), (2, 3), (2, 3))


def rises(bodies, *, power=EACH * 20.0, speed=2.0, stuck=EACH * 0.5):
    speeds = RollingSpeeds(EACH * speed * 1.001, EACH * speed, EACH, np.asarray(1.0))
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


NORMAL = np.array([1000.0, 600.0, 500.0, 600.0, 500.0])
RADIUS = np.array([4.0 * 13.5 / 17.5, *[13.5 * 5.0 / 18.5] * 2, *[5.0 * 40.0 / 35.0] * 2]) * 1e-3
LENGTH, MODULUS, YIELD = 5e-3, 206e9 / (2.0 * 0.91), 450e6


@pytest.fixture(scope="module")
def strips(paper_joint):
    return lambda traction: rolling_strips(
        contacts=joint_contacts(paper_joint()),
        normal_force=np.asarray(NORMAL),
        traction=np.asarray(traction),
    )


def test_even_loads_have_one_width(strips):
    found = strips(np.zeros(5))
    width = np.sqrt(4.0 * NORMAL * RADIUS / (math.pi * LENGTH * MODULUS))
    np.testing.assert_allclose(found.largest_half_width, width, rtol=1e-12)
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


@pytest.fixture(scope="module")
def crowned_contacts(paper_joint):
    """Planets with a crown of 0.3 m; the contacts of the ring stay even."""
    return joint_contacts(paper_joint(drive__planet_crown_radius=0.3))


@pytest.fixture(scope="module")
def crowned_pairs(crowned_contacts):
    return crowned_contacts.pairs


@pytest.fixture(scope="module")
def crowned(crowned_contacts):
    return lambda traction: rolling_strips(
        contacts=crowned_contacts, normal_force=np.asarray(NORMAL), traction=np.asarray(traction)
    )


@pytest.mark.slow
def test_even_contacts_beside_crowned_ones_are_even(strips, crowned):
    traction = np.array([0.03, 0.02, -0.02, 0.05, 0.0])
    even, found = strips(traction), crowned(traction)
    for name in (
        "largest_half_width",
        "largest_load",
        "middle_traction",
        "shakedown_ratio",
    ):
        np.testing.assert_allclose(getattr(found, name)[3:], getattr(even, name)[3:], rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(found.tracks[:, 3:], even.tracks[:, 3:], rtol=1e-9)
    np.testing.assert_allclose(found.middle_power_ratio[3:], 1.0, rtol=1e-9)


def test_slices_of_a_crowned_contact_creep_alike(strips, crowned, crowned_pairs):
    """By Carter a little creepage xi makes the traction 2 xi R/a of a slice: the wide middle has the least."""
    little = 1e-6
    found, even = crowned(np.full(5, little)), strips(np.full(5, little))
    lines = found.lines
    load = np.asarray(lines.line_load * lines.length_share) * LENGTH
    width = np.asarray(lines.half_width)
    middle = little * NORMAL / width[0] / np.sum(load / width, axis=0)
    np.testing.assert_allclose(found.middle_traction, middle, rtol=1e-4)
    peak = np.asarray(lines.line_load[0]) * LENGTH / NORMAL
    assert np.all(peak[:3] > 1.1)
    np.testing.assert_allclose(found.middle_power_ratio, middle / little * peak, rtol=1e-4)
    np.testing.assert_allclose(crowned(np.zeros(5)).middle_power_ratio, peak, rtol=1e-9)
    mean = mean_half_width(pairs=crowned_pairs, lines=lines, normal_force=np.asarray(NORMAL))
    np.testing.assert_allclose(mean, np.sum(load * width, axis=0) / NORMAL, rtol=1e-12)
    # pressure grows as the width; without traction p_0 may reach the same limit everywhere
    np.testing.assert_allclose(found.shakedown_ratio / even.shakedown_ratio, np.sqrt(peak), rtol=1e-4)


def test_life_of_a_crowned_track_is_that_of_its_slices(crowned):
    """Each slice alone by Lundberg and Palmgren, on its own length; all survive with the product of their chances."""
    found = crowned(np.zeros(5))
    lines, slope = found.lines, 10.0 / 9.0
    radius = np.array([4.0, 13.5, 13.5, 5.0, 5.0]) * 1e-3
    width = np.asarray(lines.half_width)
    alone = line_contact_life(
        peak_pressure=2.0 * np.asarray(lines.line_load) / (math.pi * width),
        half_width=width,
        contact_length=np.maximum(np.asarray(lines.length_share), 1e-30) * LENGTH,  # the middle has no length
        track_radius=radius,
        material_constant=BEARING_STEEL,
    )
    expected = 1e6 * np.sum(np.asarray(alone) ** -slope, axis=0) ** (-1.0 / slope)
    np.testing.assert_allclose(found.tracks[0], expected, rtol=1e-9)


def test_the_film_factor_of_a_crowned_contact_is_that_of_its_slices(crowned, crowned_pairs):
    """Each slice lives its own factor longer; kappa 1 of the contact, e_C C_u/P by the pressure of each slice."""
    found = crowned(np.zeros(5))
    lines, slope = found.lines, 10.0 / 9.0
    width = np.asarray(lines.half_width)
    pressure = 2.0 * np.asarray(lines.line_load) / (math.pi * width)
    alone = line_contact_life(
        peak_pressure=pressure,
        half_width=width,
        contact_length=np.maximum(np.asarray(lines.length_share), 1e-30) * LENGTH,
        track_radius=4e-3,
        material_constant=BEARING_STEEL,
    )
    ratio = 0.5 * (1.5e9 / np.where(pressure > 0.0, pressure, np.inf)) ** 2
    bracket = 1.0 - (1.5859 - 1.2348) * np.where(pressure > 0.0, ratio, 0.0) ** 0.4
    factor = np.where(bracket > 0.50837, 0.1 * np.maximum(bracket, 0.5) ** -9.185, 50.0)
    together, without = (
        np.sum(np.asarray(lives) ** -slope, axis=0) ** (-1.0 / slope) for lives in (alone * factor, alone)
    )
    shown = film_factors(
        pairs=crowned_pairs,
        lines=lines,
        peak_pressure=found.peak_pressure,
        film_ratio=np.ones(5),
        cleanliness=0.5,
    )
    np.testing.assert_allclose(shown, together / without, rtol=1e-4)
    assert np.all(np.ptp(factor[:, :3], axis=0) > 0.01)  # the slices differ


def test_the_film_factor_of_an_even_contact_is_that_of_its_pressure(strips, paper_joint):
    found = strips(np.zeros(5))
    pairs = joint_contacts(paper_joint()).pairs
    films = np.array([0.1, 0.17, 0.6, 2.0, 5.0])
    shown = film_factors(
        pairs=pairs, lines=None, peak_pressure=found.peak_pressure, film_ratio=films, cleanliness=0.3
    )
    expected = life_modification_factor(
        viscosity_ratio=films**1.3,
        cleanliness=0.3,
        fatigue_load_ratio=(1.5e9 / np.asarray(found.peak_pressure)) ** 2,
    )
    np.testing.assert_allclose(shown, expected, rtol=1e-12)
    assert np.isnan(shown).tolist() == [True, True, False, False, False]
