"""The check of the half-space passes, and finds a displacement that is off."""

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
