"""Rows that are judged, of the paper's joint by hand, and where their limits lie."""

import math

import numpy as np
import pytest

from asperity.results import RESULTS

FRICTION, YIELD = 0.12, 450e6


def test_limits_of_ratios_are_those_of_their_meaning():
    """What is, over what is allowed, ends at 1; "at least ten times softer" is 0.1."""
    for name in (
        "slip_ratio",
        "self_locking_ratio",
        "pressure_over_first_yield",
        "critical_over_largest_spot",
        "real_area_over_hertz_area",
        "largest_spot_over_hertz_area",
    ):
        assert RESULTS[name].limit.highest == 1.0, name
    assert RESULTS["asperity_over_bulk_stiffness"].limit.highest == 0.1
    assert RESULTS["slip_ratio"].highest_limit == 1.0
    assert RESULTS["slip_safety"].lowest_limit == RESULTS["torque_safety"].lowest_limit == 1.0


def test_slip(value):
    ratio = np.abs(value("tangential_force")) / (FRICTION * value("normal_force"))
    np.testing.assert_allclose(value("slip_ratio"), ratio, rtol=1e-9)
    np.testing.assert_allclose(value("slip_safety"), 1.0 / ratio, rtol=1e-9)


def test_self_locking(value):
    """tan(beta/2)/mu; the wedge angle by the law of cosines in the triangle of 17.5, 18.5 and 35 mm."""
    wedge = math.acos((35.0**2 + 18.5**2 - 17.5**2) / (2.0 * 35.0 * 18.5))
    assert value("self_locking_ratio") == pytest.approx(math.tan(0.5 * wedge) / FRICTION, rel=1e-9)


def test_first_yield(value):
    """Hertz pressure over 1.67 times the yield strength."""
    ratio = value("hertz_pressure") / (1.67 * YIELD)
    np.testing.assert_allclose(value("pressure_over_first_yield"), ratio, rtol=2e-3)
    np.testing.assert_allclose(value("yield_safety"), 1.0 / value("pressure_over_first_yield"), rtol=1e-12)


def test_areas_over_that_of_hertz(value):
    hertz = 2.0 * value("hertz_half_width") * 5e-3
    np.testing.assert_allclose(
        value("real_area_over_hertz_area"), value("real_contact_area") / hertz, rtol=1e-9
    )
    np.testing.assert_allclose(
        value("largest_spot_over_hertz_area"), value("largest_area") / hertz, rtol=1e-9
    )
    np.testing.assert_allclose(
        value("critical_over_largest_spot"), value("critical_area") / value("largest_area"), rtol=1e-9
    )


def test_fractal_dimension_is_that_of_each_contact(value):
    np.testing.assert_allclose(value("fractal_dimension"), 1.4)
    assert value("fractal_dimension").shape == (5,)


def test_torque(value):
    assert value("torque_safety") == pytest.approx(value("torque_capacity") / 5.0, rel=1e-9)


def test_equations_are_solved(value):
    for name in ("balance_residual", "closure_residual"):
        assert RESULTS[name].limit.is_kept(float(value(name)))
        assert not RESULTS[name].limit.is_kept(1e-3)
