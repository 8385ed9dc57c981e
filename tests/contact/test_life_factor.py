"""Life with a film over life without: a table by hand, its ends, and the exponent of the film by a second route."""

import itertools

import numpy as np
import pytest

from asperity.contact.film_thickness import minimum_film_thickness
from asperity.contact.hertz_line import half_width, peak_pressure
from asperity.contact.life_factor import (
    FATIGUE_LIMIT_PRESSURE,
    FILM_RATIO_EXPONENT,
    LEAST_FILM_RATIO,
    fatigue_load_ratio,
    life_modification_factor,
    viscosity_ratio,
)

KAPPA = np.array([0.1, 0.4, 1.0, 4.0])


def factor(kappa, load, cleanliness=1.0):
    return np.asarray(
        life_modification_factor(viscosity_ratio=kappa, cleanliness=cleanliness, fatigue_load_ratio=load)
    )


@pytest.mark.parametrize(
    ("load", "expected"),
    [(0.2, [0.1000, 0.1773, 0.6505, 1.3350]), (1.0, [0.0999, 0.3075, 5.311, 32.92])],
)
def test_an_independent_computation(load, expected):
    """To the half of the last digit of its table."""
    np.testing.assert_allclose(factor(KAPPA, load), expected, rtol=5e-4)
    np.testing.assert_allclose(factor(KAPPA, 2.0 * load, 0.5), expected, rtol=5e-4)  # e_C C_u/P alone counts


def test_its_pieces_meet():
    """b(0.4) is 1.4708 by both; 0.019087, as one program prints the exponent, would make it 1.2566."""
    at = 0.4
    assert 1.3993 * at**-0.054381 == pytest.approx(1.2348 * at**-0.19087, abs=5e-5) == 1.4708
    assert 1.2348 * at**-0.019087 == pytest.approx(1.2566, abs=5e-4)
    for border in (0.4, 1.0):
        below, above = factor(border * (1.0 - 1e-12), 0.7), factor(border, 0.7)
        assert above == pytest.approx(below, rel=1e-4)


def test_no_factor_below_a_tenth_and_no_more_above_four():
    assert np.isnan(factor(0.0999, 0.5))
    assert np.isnan(factor(np.nan, 0.5))
    assert factor(40.0, 0.5) == factor(4.0, 0.5)
    assert factor(4.0, 1.2) == 50.0
    assert factor(4.0, np.inf) == 50.0
    assert float(viscosity_ratio(film_ratio=LEAST_FILM_RATIO)) == pytest.approx(0.1)
    assert pytest.approx(0.1701, abs=5e-5) == LEAST_FILM_RATIO


def test_more_film_cleaner_oil_and_less_load_are_more_life():
    kappa, load = np.geomspace(0.101, 4.0, 200), np.geomspace(1e-3, 3.0, 60)
    grid = factor(kappa[:, None], load)
    assert np.all(np.diff(grid, axis=0) >= -1e-12)
    assert np.all(np.diff(grid, axis=1) >= -1e-12)
    assert np.all(np.diff(factor(1.0, 0.5, np.linspace(0.05, 1.0, 50))) > 0.0)
    assert np.all((grid >= 0.099) & (grid <= 50.0))
    assert factor(1.0, 1e-9) == pytest.approx(0.1, rel=1e-2)


def test_the_load_at_which_steel_just_does_not_tire():
    """Twice the load has sqrt(2) times the pressure: C_u/P by forces is that by pressures."""
    pair = {"contact_length": 10e-3, "effective_radius": 8e-3, "contact_modulus": 113e9}

    def pressure(force):
        width = half_width(normal_force=force, **pair)
        return peak_pressure(normal_force=force, contact_length=10e-3, half_width=width)

    limit = 2000.0 * (FATIGUE_LIMIT_PRESSURE / pressure(2000.0)) ** 2
    assert float(pressure(limit)) == pytest.approx(1.5e9, rel=1e-12)
    for force in (500.0, 2000.0, 20000.0):
        assert float(fatigue_load_ratio(peak_pressure=pressure(force))) == pytest.approx(limit / force)
    assert np.isinf(fatigue_load_ratio(peak_pressure=0.0))


def test_the_exponent_of_the_film_by_mineral_oils():
    """Oils of other viscosities at one contact, whose pressure coefficient goes with the viscosity to the 0.1348.

    kappa is the viscosity over that at which lambda is 1; by the films of Dowson its exponent is 1/(0.70 + 0.54 *
    0.1348) = 1.29.
    """
    contact = {"entrainment_speed": 1.0, "line_load": 2e5, "effective_radius": 8e-3, "contact_modulus": 113e9}
    viscosities = np.geomspace(2e-3, 0.2, 9)
    films = np.array(
        [
            minimum_film_thickness(
                viscosity=each, pressure_coefficient=10.471e-9 * (1e3 * each) ** 0.1348, **contact
            )
            for each in viscosities
        ]
    )
    slopes = [
        np.log(two / one) / np.log(thick / thin)
        for (one, two), (thin, thick) in zip(
            itertools.pairwise(viscosities), itertools.pairwise(films), strict=True
        )
    ]
    np.testing.assert_allclose(slopes, 1.0 / (0.70 + 0.54 * 0.1348), rtol=1e-9)
    np.testing.assert_allclose(slopes, FILM_RATIO_EXPONENT, rtol=6e-3)
