"""What passes as agreement, and what does not."""

import math

import pytest

from asperity.validation.check import compared, failed

WORDS = {"model": "M", "reference": "R", "quantity": "Q", "unit": "N"}


def test_the_worst_pair_decides():
    check = compared(**WORDS, expected=[1.0, 2.0, 4.0], computed=[1.01, 2.06, 4.0], tolerance=0.02)
    assert (check.expected, check.computed, check.values) == (2.0, 2.06, 3)
    assert check.deviation == pytest.approx(0.03, rel=1e-12)
    assert not check.passed
    assert compared(**WORDS, expected=2.0, computed=2.03, tolerance=0.02).passed


def test_an_absolute_tolerance_is_a_difference():
    assert compared(**WORDS, expected=100.0, computed=100.4, tolerance=0.5, absolute=True).passed
    assert not compared(**WORDS, expected=100.0, computed=100.6, tolerance=0.5, absolute=True).passed


def test_zero_is_met_by_zero_only():
    assert compared(**WORDS, expected=[0.0, 1.0], computed=[0.0, 1.0], tolerance=1e-9).passed
    check = compared(**WORDS, expected=[0.0, 1.0], computed=[1e-300, 1.0], tolerance=1e-9)
    assert not check.passed
    assert check.as_dict()["deviation"] is None


def test_what_is_not_a_number_does_not_pass():
    check = compared(**WORDS, expected=[1.0, 1.0], computed=[5.0, math.nan], tolerance=10.0)
    assert not check.passed
    assert check.note == "the computed value is not a number"
    assert check.as_dict()["found"] is None


def test_every_value_is_compared():
    with pytest.raises(ValueError, match="1 values instead of 2"):
        compared(**WORDS, expected=[1.0, 2.0], computed=[1.0], tolerance=1.0)


def test_a_group_that_ends_in_an_error_does_not_pass():
    check = failed("Springs", ZeroDivisionError("division by zero\nsecond line"))
    assert not check.passed
    assert check.note == "ZeroDivisionError: division by zero"
    assert check.as_dict()["passed"] is False
