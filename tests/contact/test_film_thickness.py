"""Film thickness: the theory of Ertel and Grubin, two later fits, dimensional scaling."""

import math

import pytest

from asperity.contact.film_thickness import film_ratio, minimum_film_thickness

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
