"""Shear stress of films: by hand, at both ends, slopes by differences; how a film yields."""

import dataclasses
import math

import numpy as np
import pytest
from traction_contacts import OILS

from asperity.contact.fluid import (
    DataSheetTraction,
    Film,
    FilmBody,
    LimitingTraction,
    RheologicalTraction,
    film_slope,
    smooth_minimum,
)
from asperity.contact.viscosity import ExponentialViscosity, RationalPressureRise, Viscosity

#: 0.1 Pa·s without pressure, and e times as much for every 50 MPa.
BARUS = Viscosity(ExponentialViscosity(0.1, 0.0, 0.0), RationalPressureRise(50e6, 0.0, 0.0, 0.0))
FILM = Film(np.array([200e6, 400e6]), np.array(500e6), 0.2e-6, 0.01, 333.15, 333.15, 1.0)


def test_limiting_stress_of_santotrac():
    """(0.0765 - 4e-4 t) p + 27 MPa + 0.35 MPa t with t from 113 °C: 103.5 MPa there, 104.5 MPa at 93 °C, at 1 GPa."""
    limit = OILS["S50"].traction.limiting_traction
    assert limit.at(1e9, 386.15) == pytest.approx(103.5e6, rel=1e-12)
    assert limit.at(1e9, 366.15) == pytest.approx(104.5e6, rel=1e-12)
    assert limit.at(2e9, 366.15) == pytest.approx(0.0845 * 2e9 + 20e6, rel=1e-12)
    assert limit.at(2e9, 386.15 + 2000.0) == 0.0


def test_a_share_of_the_pressure_alone():
    assert LimitingTraction(0.05).at(2e8, 300.0) == pytest.approx(1e7)


def test_newtons_film_below_its_limit():
    """0.1 e^4 Pa·s · 0.01 m/s / 0.2 µm = 273 kPa, and at twice that pressure 14.9 MPa, below a limit of 20 and 40."""
    stress, slope = RheologicalTraction(LimitingTraction(0.1), 0.5e9, "limit").stress(BARUS, FILM)
    newton = 0.1 * 0.01 / 0.2e-6 * np.exp([4.0, 8.0])
    limit = np.array([20e6, 40e6])
    expected = (newton**-8.0 + limit**-8.0) ** -0.125
    assert newton == pytest.approx([272.99e3, 14.905e6], rel=1e-4)
    assert stress == pytest.approx(expected, rel=1e-13)
    assert slope == pytest.approx((expected / newton) ** 8, rel=1e-12)


def test_eyrings_film_thins():
    """tau_E = 2 Lambda/alpha = 2 · 0.1 · 50 MPa with Barus's oil, at any pressure."""
    stress, _ = RheologicalTraction(LimitingTraction(0.1), 0.5e9, "eyring").stress(BARUS, FILM)
    newton = 5e3 * np.exp([4.0, 8.0])
    viscous = 10e6 * np.arcsinh(newton / 10e6)
    assert stress == pytest.approx((viscous**-8.0 + np.array([20e6, 40e6]) ** -8.0) ** -0.125, rel=1e-13)


@pytest.mark.parametrize("oil", list(OILS))
@pytest.mark.parametrize("slip", [1e-6, 1e-3, 0.1])
def test_slopes_over_the_slip(oil, slip):
    fluid = OILS[oil]
    film = dataclasses.replace(FILM, pressure=np.linspace(0.05e9, 1.2e9, 9), peak_pressure=np.array(1.2e9))

    def stress(slip):
        return fluid.traction.stress(fluid.viscosity, dataclasses.replace(film, slip_speed=slip))

    (more, _), (less, _) = stress(slip * math.exp(1e-5)), stress(slip * math.exp(-1e-5))
    assert stress(slip)[1] == pytest.approx(np.log(more / less) / 2e-5, rel=1e-6, abs=1e-9)


def test_the_lower_of_two_stresses():
    """(a^-8 + b^-8)^(-1/8), to both ends; its slope by a is (stress/a)^8."""
    one, other = np.array([1.0, 2.0, 3.0, 1e-30, 1e30]), np.array([2.0, 2.0, 1.0, 1.0, 1.0])
    stress, slope = smooth_minimum(one, other)
    expected = (one[:3] ** -8.0 + other[:3] ** -8.0) ** -0.125
    assert stress[:3] == pytest.approx(expected, rel=1e-14)
    assert slope[:3] == pytest.approx((expected / one[:3]) ** 8, rel=1e-13)
    assert stress[1] == pytest.approx(2.0 * 2.0**-0.125, rel=1e-14)
    assert slope[1] == pytest.approx(0.5, rel=1e-14)
    assert (stress[3], stress[4]) == (1e-30, 1.0)
    assert (slope[3], slope[4]) == (1.0, pytest.approx(0.0, abs=1e-200))
    assert smooth_minimum(np.array(1.0), np.array(0.0))[0] == 0.0


def test_how_a_film_yields():
    """pi/4 E* h/(a G) of the shear modulus; E*/(p0 m) of a data sheet: 100/(2 · 200) there."""
    body = FilmBody(0.3e-6, 120e-6, 2e9, 100e9, 333.15, 1.0)
    sheared = RheologicalTraction(LimitingTraction(0.1), 0.5e9).elastic_yield(body)
    assert sheared == pytest.approx(0.25 * math.pi * 100e9 * 0.3e-6 / (120e-6 * 0.5e9), rel=1e-14)
    assert DataSheetTraction(0.09, 200.0).elastic_yield(body) == pytest.approx(0.25, rel=1e-14)


def test_a_data_sheet_bears_its_maximum_at_any_slip():
    stress, slope = DataSheetTraction(0.09, 200.0).stress(BARUS, FILM)
    assert stress == pytest.approx([18e6, 36e6], rel=1e-14)
    assert np.all(slope == 0.0)


def test_slope_without_the_discs():
    """Two compliances: 1/m less p0/E*; 1/50 less 1/100 is 1/100."""
    assert film_slope(slope=50.0, rig_modulus=100e9, rig_peak_pressure=1e9) == pytest.approx(100.0)
    assert film_slope(slope=200.0, rig_modulus=100e9, rig_peak_pressure=1e9) < 0.0
