"""The check of the half-space passes, and finds a displacement that is off."""

import math

import pytest

from asperity.bem import FreeHalfSpace
from asperity.validation import element_checks


@pytest.mark.slow
def test_a_displacement_that_is_off_by_a_thousandth_is_found(monkeypatch):
    (check,) = element_checks.half_space()
    assert check.passed
    assert check.values == 3
    honest = FreeHalfSpace.normal_displacement
    monkeypatch.setattr(FreeHalfSpace, "normal_displacement", lambda *args: honest(*args) * 1.001)
    (check,) = element_checks.half_space()
    assert not check.passed


def test_a_compliance_that_is_off_by_a_thousandth_is_found(monkeypatch):
    check, measured = element_checks.discs()
    assert check.passed
    # equal approaches: 2 ln(2d/b) - nu/(1 - nu) = 2 ln(4R/b) - 1
    assert measured.computed == pytest.approx(math.exp(0.5 * (0.3 / 0.7 - 1.0)), rel=4e-3)
    assert measured.passed
    # Johnson's approach of a roller between two flats, in micrometres for a kilonewton
    by_hand = 2.0 * 0.91 / (math.pi * 206e9 * 5e-3) * (2.0 * math.log(4.0 * 13.5 / 0.08) - 2.0) * 1e9
    assert check.expected == pytest.approx(by_hand, rel=1e-12)
    honest = element_checks._matrix
    monkeypatch.setattr(element_checks, "_matrix", lambda *args, **given: honest(*args, **given) * 1.001)
    check, _ = element_checks.discs()
    assert not check.passed
    assert check.deviation == pytest.approx(1e-3, rel=0.5)


@pytest.mark.slow
def test_a_ring_that_is_off_by_a_ten_thousandth_is_found(monkeypatch):
    assert [check for check in element_checks.rings() if not check.passed] == []
    honest = element_checks._matrix
    monkeypatch.setattr(element_checks, "_matrix", lambda *args, **given: honest(*args, **given) * 1.0001)
    assert [check.passed for check in element_checks.rings()] == [False, False, True, True]
    monkeypatch.setattr(element_checks, "_matrix", lambda *args, **given: honest(*args, **given) * 1.005)
    assert not any(check.passed for check in element_checks.rings())
