"""Film thickness: the theory of Ertel and Grubin, later fits, rigid rollers, dimensional scaling."""

import math

import pytest

from asperity.contact.film_thickness import (
    FilmInlet,
    central_film_by,
    central_film_thickness,
    film_ratio,
    inlet_heat_factor,
    minimum_film_thickness,
)

MODULUS, RADIUS = 206e9 / (2 * (1 - 0.3**2)), 20e-3 / 3
ROLLERS = {
    "viscosity": 0.0305,
    "pressure_coefficient": 2.918e-8,
    "entrainment_speed": 1.0,
    "line_load": 2e5,
    "effective_radius": RADIUS,
    "contact_modulus": MODULUS,
}


def film(**changes):
    return float(minimum_film_thickness(**(ROLLERS | changes)))


def test_between_later_fits():
    """Pan and Hamrock 1989: 0.2005 um; Masjedi and Khonsari 2012: 0.2178 um."""
    assert 0.2005e-6 < film() < 0.2178e-6


@pytest.mark.parametrize("speed", [0.3, 1.0, 4.0])
def test_three_quarters_of_the_central_film_of_ertel_and_grubin(speed):
    """h_c/R = 1.95 (G U)^(8/11) W^(-1/11), from the pressure in a Hertzian inlet; 3/4 of it at the outlet."""
    scale = 2 * MODULUS * RADIUS
    central = (
        1.95 * (2.918e-8 * 2 * MODULUS * 0.0305 * speed / scale) ** (8 / 11) * (2e5 / scale) ** (-1 / 11)
    )
    assert film(entrainment_speed=speed) == pytest.approx(0.75 * central * RADIUS, rel=0.08)


def test_exponents():
    assert film(entrainment_speed=2.0) / film() == pytest.approx(2**0.70, rel=1e-12)
    assert film(line_load=4e5) / film() == pytest.approx(2**-0.13, rel=1e-12)
    assert film(pressure_coefficient=2 * 2.918e-8) / film() == pytest.approx(2**0.54, rel=1e-12)
    # stiffness: U^0.70 G^0.54 W^-0.13 leave E'^(-0.70+0.54+0.13)
    assert film(contact_modulus=2 * MODULUS) / film() == pytest.approx(2**-0.03, rel=1e-12)
    assert film(effective_radius=2 * RADIUS) / film() == pytest.approx(2**0.43, rel=1e-12)


def test_film_over_roughness():
    rough = math.hypot(0.15e-6, 0.2e-6)
    assert float(film_ratio(film_thickness=0.5e-6, roughness=rough)) == pytest.approx(2.0, rel=1e-12)


def inlet(**changes):
    given = {"viscosity": 0.0305, "pressure_coefficient": 2.918e-8, "rolling_speed": 1.0, "line_load": 2e5}
    return FilmInlet(**(given | {"effective_radius": RADIUS, "contact_modulus": MODULUS} | changes))


@pytest.mark.parametrize(
    ("law", "thickness"), [("moes", 0.2954e-6), ("dowson_toyoda", 0.2867e-6), ("pan_hamrock", 0.2129e-6)]
)
def test_central_films_by_three_laws(law, thickness):
    """By computations of their own; Dowson and Toyoda as read in their source."""
    assert float(central_film_by(law=law, inlet=inlet())) == pytest.approx(thickness, rel=3e-4)


def test_a_film_without_load_is_that_of_rigid_rollers():
    """Reynolds's equation between rigid cylinders of an oil of constant viscosity: h = 6 eta V R/w."""
    light = inlet(line_load=1.0, pressure_coefficient=1e-12)
    assert float(central_film_thickness(inlet=light)) == pytest.approx(6.0 * 0.0305 * RADIUS, rel=1e-3)
    shared = inlet(pressure_coefficient=1e-12)
    assert float(central_film_thickness(inlet=shared, film_share=1e-9)) == pytest.approx(
        6.0 * 0.0305 * RADIUS / (1e-9 * 2e5), rel=1e-3
    )


@pytest.mark.parametrize(("speed", "factor"), [(2.0, 0.960), (16.0, 0.662)])
def test_heat_at_the_inlet(speed, factor):
    """M100 at 60 °C, R 20 mm, 1 GPa, a slide-roll ratio of 0.02; by a computation of its own."""
    found = inlet_heat_factor(
        peak_pressure=1e9,
        contact_modulus=MODULUS,
        viscosity=0.03133,
        viscosity_fall=890.0 / (333.15 - 182.0) ** 2,
        conductivity=0.14,
        rolling_speed=speed,
        slide_roll_ratio=0.02,
    )
    assert float(found) == pytest.approx(factor, abs=6e-4)
