"""Viscosity over pressure and temperature: values of the fits, slopes by differences, and the coefficient of a film."""

import math

import numpy as np
import pytest
from traction_contacts import OILS, PEAK

from asperity.contact.viscosity import (
    ExponentialViscosity,
    RationalPressureRise,
    RoelandsPressureRise,
    Viscosity,
    WaltherViscosity,
    reciprocal_asymptotic_coefficient,
)

#: eta_0 [Pa·s] and 1/alpha* [1/GPa] under 1.04 GPa, by a computation of its own.
KNOWN = {
    ("M100", 25): (0.18476, 21.78),
    ("M100", 40): (0.07691, 20.06),
    ("M100", 60): (0.03133, 18.11),
    ("M100", 100): (0.00914, 15.07),
    ("N100", 40): (0.06966, 27.31),
    ("PAO100", 40): (0.08346, 14.33),
    ("S50", 40): (0.03050, 28.85),
    ("S50", 80): (0.00766, 20.30),
}


@pytest.mark.parametrize(("oil", "celsius"), KNOWN)
def test_viscosity_and_pressure_coefficient_of_known_oils(oil, celsius):
    viscosity, kelvin = OILS[oil].viscosity, celsius + 273.15
    base, coefficient = KNOWN[oil, celsius]
    assert float(viscosity.base(kelvin)) == pytest.approx(base, abs=0.6e-5)
    found = reciprocal_asymptotic_coefficient(
        viscosity=viscosity, peak_pressure=np.array([PEAK]), temperature=kelvin
    )
    assert 1e9 * float(found[0]) == pytest.approx(coefficient, abs=0.006)


@pytest.mark.parametrize("oil", ["M100", "S50"])
def test_share_by_which_viscosity_falls_is_its_slope(oil):
    law = OILS[oil].viscosity.without_pressure
    slope = -(math.log(law.at(333.16)) - math.log(law.at(333.14))) / 0.02
    assert float(law.logarithmic_fall(333.15)) == pytest.approx(slope, rel=1e-6)


def test_a_walther_oil_has_its_two_viscosities():
    """lg lg(nu + 0.7) is linear in lg T: through 68 mm²/s at 40 °C and 8.5 mm²/s at 100 °C."""
    cold, hot = (math.log10(math.log10(nu + 0.7)) for nu in (68.0, 8.5))
    slope = (cold - hot) / math.log10(373.15 / 313.15)
    law = WaltherViscosity(cold + slope * math.log10(313.15), slope, 0.7, 860.0, 0.0, 288.15)
    assert float(law.at(313.15)) == pytest.approx(68e-6 * 860.0, rel=1e-12)
    assert float(law.at(373.15)) == pytest.approx(8.5e-6 * 860.0, rel=1e-12)


@pytest.mark.parametrize(
    "rise", [RoelandsPressureRise(2e-8, 0.0, 313.15), RationalPressureRise(5e7, 0.0, 0.0, 0.0)]
)
def test_pressure_coefficient_without_pressure(rise):
    """2e-8 1/Pa both: Roelands's alpha, and 1/A of the rational rise."""
    assert float(rise.logarithm(1.0, 313.15, 0.1)) == pytest.approx(2e-8, rel=1e-6)


def test_coefficient_of_barus_law_is_its_own():
    """With B = 0 the rise is exponential: 1/alpha* = A (1 − e^(−p_0/A))."""
    oil = Viscosity(ExponentialViscosity(1e-3, 0.0, 0.0), RationalPressureRise(5e7, 0.0, 0.0, 0.0))
    found = reciprocal_asymptotic_coefficient(
        viscosity=oil, peak_pressure=np.array([2e8, 3e9]), temperature=300.0
    )
    assert found == pytest.approx([1.0 / (5e7 * (1.0 - math.exp(-4.0))), 2e-8], rel=1e-12, abs=0.0)


def test_roelands_reaches_his_pole():
    """ln(eta/6.315e-5 Pa s) grows as (1 + 5.1e-9 p)^Z: by 2^Z at 196 MPa."""
    exponent = 2e-8 / (5.1e-9 * (math.log(0.1) + 9.67))
    rise = RoelandsPressureRise(2e-8, 0.0, 313.15).logarithm(1.0 / 5.1e-9, 313.15, 0.1)
    assert float(rise) == pytest.approx((math.log(0.1) + 9.67) * (2.0**exponent - 1.0), rel=1e-12)
