"""The bounds that physics sets, and that every bound is one in its own unit."""

import math

import pytest

from asperity.contact.fractal import VERIFIED_FRACTAL_DIMENSIONS
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Key

KEYS = {name: value for name, value in vars(limits).items() if isinstance(value, Key)}


@pytest.mark.parametrize(
    ("name", "inside", "outside"),
    [
        (
            "FRACTAL_DIMENSION",
            (1.0 + 1e-9, 2.0 - 1e-9),
            (1.0, 2.0),
        ),  # a profile is neither a line nor a plane
        ("POISSON_RATIO", (-0.999, 0.0, 0.5), (-1.0, 0.501)),  # positive moduli of shear and compression
        ("FREQUENCY_RATIO", (1.001, 1.5), (1.0, 0.5)),  # frequencies that grow
        ("FRICTION_COEFFICIENT", (1e-6, 0.12), (0.0, -0.1)),
        ("PIN_FRICTION_COEFFICIENT", (0.0,), (-1e-3,)),  # no friction in the pin is allowed
        ("PLANETS", (2.0, 3.0), (1.0, 2.5)),
        ("OUTPUT_TORQUE", (0.0, 5.0, -5.0), (2e9, -2e9)),
        ("PLAY_ANGLE", (0.0, math.pi), (-1e-6, 7.0)),
        ("PUSH_ANGLE", (-math.pi / 3.0, 0.0, math.pi / 3.0), (math.radians(60.1),)),
        ("PRELOAD", (1e-3, 1e9), (0.0, 1.1e9)),
        ("YOUNGS_MODULUS", (206e9,), (206e13, 0.0)),  # 206 GPa; what a wrong prefix makes of it
    ],
)
def test_bounds_in_si(name, inside, outside):
    for value in inside:
        assert KEYS[name].admits(value), value
    for value in (*outside, math.nan, math.inf):
        assert not KEYS[name].admits(value), value


@pytest.mark.parametrize("name", KEYS)
def test_every_range_is_one_and_is_told_in_words(name):
    key = KEYS[name]
    assert key.lower < key.upper
    assert " and " in key.allowed
    assert key.allowed.startswith("a whole number") == (name in ("PLANETS", "BEARING_COUNT"))


def test_the_law_is_verified_inside_what_is_accepted():
    low, high = VERIFIED_FRACTAL_DIMENSIONS
    assert limits.FRACTAL_DIMENSION.lower < low < high < limits.FRACTAL_DIMENSION.upper


#: Bounds that mean something: whole drives, angles of a turn, absolute zero, incompressible bodies.
MEANT = {
    "FORM_PHASE": (-360.0, 360.0),
    "LIMITING_TRACTION": (0.01, 0.2),  # oils have 0.03 to 0.1
    "MAXIMUM_TRACTION": (0.01, 0.2),
    "PLANETS": (2, 100),
    "PUSH_ANGLE": (-60.0, 60.0),
    "POLAR_ANGLE": (-360.0, 360.0),
    "PLAY_ANGLE": (0.0, 360.0 * 60.0),
    "TEMPERATURE": (-273.15, 1000.0),
    "THERMAL_EXPANSION": (-100.0, 500.0),
    "POISSON_RATIO": (-1.0, 0.5),
    "FRACTAL_DIMENSION": (1.0, 2.0),
}


@pytest.mark.parametrize("name", KEYS)
def test_bounds_that_catch_typing_errors_are_powers_of_ten(name):
    key = KEYS[name]
    if name in MEANT:
        assert (key.lower, key.upper) == MEANT[name]
        return
    for bound in (key.lower, key.upper):
        power = 0.0 if bound == 0.0 else math.log10(abs(bound))
        assert power == pytest.approx(round(power), abs=1e-12)
