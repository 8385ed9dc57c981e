"""The checks of drives pass, and find a ratio that is off."""

import pytest

from asperity.validation import drive_checks


@pytest.mark.parametrize(("module", "name", "group"), [(drive_checks, "speed_ratio", drive_checks.ratios)])
def test_a_function_that_is_off_by_a_thousandth_is_found(monkeypatch, module, name, group):
    assert all(check.passed for check in group())
    honest = getattr(module, name)
    monkeypatch.setattr(module, name, lambda *args, **given: honest(*args, **given) * 1.001)
    assert not all(check.passed for check in group())


def test_every_type_of_drive_has_a_ratio():
    assert [check.quantity.removeprefix("speed ratio of the ") for check in drive_checks.ratios()] == [
        "wedge drive",
        "plain planetary",
        "stepped planets",
        "two-row multiroller",
    ]


@pytest.mark.slow
def test_a_size_that_is_off_is_found(monkeypatch):
    assert [check for check in drive_checks.unlike() if not check.passed] == []
    monkeypatch.setattr(
        drive_checks, "_preloads", lambda moved, honest=drive_checks._preloads: honest(moved) * 1.001
    )
    assert not any(check.passed for check in list(drive_checks.unlike())[:2])
