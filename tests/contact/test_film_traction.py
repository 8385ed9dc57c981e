"""Traction of rigid bodies on film and asperities: by quadrature, its slope and heat, friction over the slip speed."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.integrate import quad
from traction_contacts import (
    EFFUSIVITY,
    HALF_WIDTH,
    LENGTH,
    MODULUS,
    PEAK,
    RADIUS,
    dry_contact,
    oiled_contact,
)

from asperity.contact.creep_bounds import SHAPE, width_mean
from asperity.contact.film_traction import (
    MOST_WARMING,
    BoundaryFriction,
    even_slip,
    local_stress,
    slip_at_warming,
)

#: Places over the half-width at which the pressure over its peak is SHAPE.
PLACES = np.sqrt(1.0 - SHAPE**2)


def test_friction_over_the_slip_speed():
    """0.12 up to 1 mm/s, 0.08 from 0.1 m/s on, with the logarithm between."""
    law = BoundaryFriction(0.12, (1e-3, 1e-2, 1e-1), (0.12, 0.11, 0.08))
    speeds = np.array([1e-5, 1e-3, 10**-2.5, 10**-1.5, 1.0])
    found, slope = law.at(speeds)
    assert found == pytest.approx([0.12, 0.12, 0.115, 0.095, 0.08], rel=1e-12)
    decade = math.log(10.0)
    assert slope == pytest.approx([0.0, -0.01 / decade, -0.01 / decade, -0.03 / decade, 0.0], rel=1e-12)


def test_warming_of_the_film():
    """M100 at 60 °C, creepage 0.01: 0.15, 0.82 and 4.68 K at 1, 5 and 20 m/s; by an independent computation."""
    oiled = oiled_contact("M100", 60.0, [1.0, 5.0, 20.0], 1e-7)
    slides = even_slip(contact=oiled.contact, creepage=np.full(3, 1e-2))
    assert slides.heated == pytest.approx([0.15, 0.82, 4.68], abs=6e-3)


def test_mean_over_the_width():
    """Of sqrt(1 - x²), 1 and x²: pi/4, 1 and 1/3."""
    for stress, expected in ((SHAPE, 0.25 * math.pi), (np.ones(16), 1.0), (PLACES**2, 1.0 / 3.0)):
        assert width_mean(stress[:, None]) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("speed", [0.05, 1.0])
def test_traction_of_rigid_bodies_by_quadrature(speed):
    """Friction on the share of the asperities, and Eyring's film of its own pressure, over the whole width."""
    contact = oiled_contact("M100", 60.0, speed, 1e-7).contact
    share, film, thickness = (
        float(each[0]) for each in (contact.asperity_share, contact.film_share, contact.film_thickness)
    )
    slip, kelvin = 2e-3 * speed, 333.15 + 0.7
    base = 86.86e-6 * math.exp(890.0 / (kelvin - 182.0))

    def rise(pressure):
        stiffness = -2.28e7 + 2.26e5 * kelvin
        return pressure / (stiffness + (-68.20e-3 + 27.68e-5 * kelvin) * pressure)

    eyring = 2.0 * 0.047 * film * PEAK / rise(film * PEAK)

    def stress(x):
        pressure = PEAK * math.sqrt(1.0 - x**2)
        viscous = base * math.exp(rise(film * pressure)) * slip / thickness
        viscous = eyring * math.asinh(viscous / eyring)
        limit = 0.047 * film * pressure
        return 0.12 * share * pressure + (viscous**-8.0 + limit**-8.0) ** -0.125

    expected = LENGTH * HALF_WIDTH * 2.0 * quad(stress, 0.0, 1.0, epsabs=0.0, epsrel=1e-10)[0]
    found = slip_at_warming(contact=contact, creepage=np.array([2e-3]), warming=np.array([0.7]))
    assert found.force == pytest.approx(expected, rel=2e-5)
    assert found.stress[:, 0] == pytest.approx([stress(x) for x in PLACES], rel=1e-10)


def test_slope_of_the_traction_of_rigid_bodies():
    """At one temperature, by differences; friction that falls with the speed counts, too."""
    oiled = oiled_contact("M100", 60.0, 0.1, 1e-7)
    falling = BoundaryFriction(0.12, (1e-5, 1e-3), (0.12, 0.08))
    contact = dataclasses.replace(oiled.contact, friction=falling)
    creepage, warming = np.array([1e-3]), np.array([0.3])
    found = slip_at_warming(contact=contact, creepage=creepage, warming=warming)
    more, less = (
        slip_at_warming(contact=contact, creepage=creepage * math.exp(step), warming=warming).force
        for step in (1e-5, -1e-5)
    )
    assert found.exponent == pytest.approx(np.log(more / less) / 2e-5, rel=1e-7)
    constant = slip_at_warming(contact=oiled.contact, creepage=creepage, warming=warming).exponent
    assert constant > found.exponent


def test_heat_of_the_slip():
    """Two thirds of the largest rise under a band of heat on steel, and h/(12 k) across the film; a balance."""
    contact = oiled_contact("N100", 40.0, 5.0, 1e-7).contact
    found = even_slip(contact=contact, creepage=np.array([1e-2]))
    heat = 5e-2 * found.force / (2.0 * HALF_WIDTH * LENGTH)
    surfaces = 2.0 / 3.0 * math.sqrt(2.0 * HALF_WIDTH / (math.pi * 5.0)) / EFFUSIVITY
    film = contact.film_thickness / (12.0 * 0.14)
    assert found.heated == pytest.approx(heat * (surfaces + film), rel=1e-12)
    assert found.force == pytest.approx(2.0 * HALF_WIDTH * LENGTH * found.mean, rel=1e-14)
    again = slip_at_warming(contact=contact, creepage=np.array([1e-2]), warming=found.heated)
    assert again.force == pytest.approx(found.force, rel=1e-9)
    assert 1.0 < found.heated[0] < MOST_WARMING


def test_places_that_slip_alike_are_even_slip():
    contact = oiled_contact("S50", 40.0, 0.05, 2e-7).contact
    even = slip_at_warming(contact=contact, creepage=np.array([1e-3]), warming=np.array([0.1]))
    stress, rise = local_stress(
        contact=contact,
        pressure_shape=SHAPE[:, None],
        slip_speed=np.full((16, 1), 1e-3 * 0.05),
        warming=np.array([0.1]),
    )
    assert stress == pytest.approx(even.stress, rel=1e-15)
    assert width_mean(rise) / even.mean == pytest.approx(even.exponent, rel=1e-14)


def test_dry_contacts_bear_friction_alone():
    """Whatever the film would bear; nothing of it remains in the slope."""
    contact = dry_contact(friction=0.1).contact
    found = even_slip(contact=contact, creepage=np.array([1e-3]))
    assert found.stress[:, 0] == pytest.approx(0.1 * PEAK * SHAPE, rel=1e-14)
    assert found.exponent == 0.0


@pytest.mark.parametrize("pressure", [0.4e9, 0.523e9, 0.7e9, 1.0e9, 1.5e9])
def test_the_dip_of_a_traction_fluid(pressure):
    """docs/theory/lubricated_contact.md: film and asperities together bear less than either, less so at more slip.

    A film that has the whole pressure on its share of the area bears no less: its viscosity is convex in the pressure.
    """
    load = math.pi * pressure**2 * LENGTH * RADIUS / MODULUS
    speed = np.geomspace(1e-3, 5.0, 40)
    contact = oiled_contact("S50", 40.0, speed, 0.2e-6, load=load).contact
    full = dataclasses.replace(contact, film_share=np.ones(40), asperity_share=np.zeros(40))
    mixed = (contact.asperity_share > 0.1) & (contact.asperity_share < 0.9)
    bottoms = []
    for creepage in (0.02, 0.1, 0.5):
        slip = np.full(40, creepage)
        law = even_slip(contact=contact, creepage=slip).force / load
        film = even_slip(contact=full, creepage=slip).force / load
        squeezed = 0.12 * contact.asperity_share + contact.film_share * film
        assert np.all(law[mixed] < squeezed[mixed] * 1.02)  # which is warmer
        bottom = int(np.argmin(np.where(mixed, law, 1.0)))
        assert law[bottom] < 0.95 * max(law[bottom:])
        bottoms.append(law[bottom])
    assert bottoms == sorted(bottoms)


def test_mineral_oils_have_no_dip():
    """Traction falls with the speed while asperities carry load, and heat lowers it afterwards."""
    for oil in ("N100", "M100"):
        for pressure in (0.7e9, 1.0e9, 1.5e9):
            load = math.pi * pressure**2 * LENGTH * RADIUS / MODULUS
            contact = oiled_contact(oil, 40.0, np.geomspace(1e-3, 5.0, 40), 0.2e-6, load=load).contact
            law = even_slip(contact=contact, creepage=np.full(40, 0.02)).force / load
            assert np.all(np.diff(law[contact.asperity_share > 0.05]) < 0.0), (oil, pressure)
