"""The contact checks pass, and find a function or a table that is off."""

import dataclasses

import numpy as np
import pytest

from asperity.contact import (
    carter,
    hertz_line,
    life_factor,
    rolling_fatigue,
    rolling_in,
    shakedown,
    stress_peaks,
)
from asperity.validation import contact_checks


@pytest.mark.parametrize(
    ("module", "name", "group"),
    [
        (carter, "creepage", contact_checks.creep),
        (hertz_line, "half_width", contact_checks.hertz),
        (hertz_line, "peak_pressure", contact_checks.hertz),
        (rolling_fatigue, "line_contact_life", contact_checks.fatigue),
        (rolling_fatigue, "spectrum_life", contact_checks.fatigue),
        (rolling_fatigue, "damage_shares", contact_checks.fatigue),
        (life_factor, "life_modification_factor", contact_checks.fatigue),
        (shakedown, "shakedown_limit", contact_checks.stresses),
    ],
)
def test_a_function_that_is_off_by_a_thousandth_is_found(monkeypatch, module, name, group):
    assert all(check.passed for check in group())
    honest = getattr(module, name)
    monkeypatch.setattr(module, name, lambda *args, **given: honest(*args, **given) * 1.001)
    assert not all(check.passed for check in group())


def test_stresses_that_are_off_are_found(monkeypatch):
    honest = stress_peaks.full_slip_stress

    def deeper(**given):
        return honest(**given | {"depth": 1.01 * given["depth"]})

    monkeypatch.setattr(stress_peaks, "full_slip_stress", deeper)
    assert [check.passed for check in contact_checks.stresses()] == [False, False, False, True]


@pytest.mark.parametrize(("name", "failing"), [("rolling_in_lag", 2), ("rolling_in_shift", 1)])
def test_an_onset_of_rolling_that_is_off_is_found(monkeypatch, name, failing):
    assert all(check.passed for check in contact_checks.onset())
    honest = getattr(rolling_in, name)
    monkeypatch.setattr(rolling_in, name, lambda **given: honest(**given) * 1.05)
    assert sum(not check.passed for check in contact_checks.onset()) == failing


@pytest.mark.slow
def test_a_corrupted_table_is_found(monkeypatch, tmp_path):
    text = contact_checks.CONTACT_LAW_TABLE.read_text(encoding="utf-8")
    last = text.strip().splitlines()[-1].split(",")[-1]
    other = tmp_path / "contact_law.csv"
    other.write_text(text.replace(last, str(float(last) * 1.00001)), encoding="utf-8")
    monkeypatch.setattr(contact_checks, "CONTACT_LAW_TABLE", other)
    assert [check.quantity for check in contact_checks.contact_law() if not check.passed] == [
        "normal stiffness"
    ]


def test_the_contact_law_compares_every_pair():
    check = next(iter(contact_checks.contact_law()))
    assert check.values == 40
    assert np.isfinite(dataclasses.astuple(check)[4])
