"""The checks of crowned and skewed rollers and of bearings pass, and find a formula that is off."""

import pytest

from asperity.validation import roller_checks


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "name", "group"),
    [
        (roller_checks.crowned_line, "crown_compression", roller_checks.crowns),
        (roller_checks.carter, "gross_slip_creepage", roller_checks.skewed),
        (roller_checks.skew, "longitudinal_capacity_ratio", roller_checks.skewed),
    ],
)
def test_a_formula_that_is_off_is_found(monkeypatch, module, name, group):
    assert [check for check in group() if not check.passed] == []
    honest = getattr(module, name)
    monkeypatch.setattr(module, name, lambda **given: honest(**given) * 1.05)
    assert not all(check.passed for check in group())


def test_a_bearing_with_another_exponent_is_found(monkeypatch):
    assert [check for check in roller_checks.bearings() if not check.passed] == []
    from asperity.joint import bearing_lives

    monkeypatch.setitem(bearing_lives.LIFE_EXPONENTS, "roller", 3.0)
    assert [check.passed for check in roller_checks.bearings()] == [True, False, True]


def test_a_tilted_line_that_is_off_is_found(monkeypatch):
    assert [check for check in roller_checks.tilted() if not check.passed] == []
    honest = roller_checks.tilted_line.profiled_line
    monkeypatch.setattr(
        roller_checks.tilted_line,
        "profiled_line",
        lambda **given: honest(**given | {"gap": 1.001 * given["gap"]}),
    )
    assert [check.passed for check in roller_checks.tilted()] == [False, *(5 * [True])]
