"""The installation passes; one in which anything is corrupted does not."""

import dataclasses
import json

import numpy as np
import pytest

from asperity.contact import carter, hertz_line, rolling_fatigue
from asperity.validation import contact_checks, drive_checks
from asperity.validation.run import GROUPS, run_checks, source_checksum, validation_document


@pytest.fixture(scope="module")
def checks():
    progress = []
    found = run_checks(lambda done, total: progress.append((done, total)))
    assert progress == [(done, len(GROUPS)) for done in range(len(GROUPS) + 1)]
    return found


@pytest.mark.slow
def test_this_installation_passes(checks):
    assert [check for check in checks if not check.passed] == []
    assert len(checks) >= 45
    assert sum(check.values for check in checks) >= 430
    document = validation_document(checks)
    assert document["valid"]
    assert document["failed"] == 0
    json.dumps(document, allow_nan=False)


@pytest.mark.slow
def test_every_check_names_its_reference(checks):
    assert all(check.reference and check.unit and check.quantity for check in checks)
    assert all(0.0 < check.tolerance <= 0.02 for check in checks)


@pytest.mark.parametrize(
    ("module", "name", "group"),
    [
        (carter, "creepage", contact_checks.creep),
        (hertz_line, "half_width", contact_checks.hertz),
        (hertz_line, "peak_pressure", contact_checks.hertz),
        (rolling_fatigue, "line_contact_life", contact_checks.fatigue),
        (drive_checks, "speed_ratio", drive_checks.ratios),
    ],
)
def test_a_function_that_is_off_by_a_thousandth_is_found(monkeypatch, module, name, group):
    honest = getattr(module, name)
    monkeypatch.setattr(module, name, lambda *args, **given: honest(*args, **given) * 1.001)
    assert not all(check.passed for check in group())


def test_a_corrupted_table_is_found(monkeypatch, tmp_path):
    text = contact_checks.CONTACT_LAW_TABLE.read_text(encoding="utf-8")
    last = text.strip().splitlines()[-1].split(",")[-1]
    other = tmp_path / "contact_law.csv"
    other.write_text(text.replace(last, str(float(last) * 1.00001)), encoding="utf-8")
    monkeypatch.setattr(contact_checks, "CONTACT_LAW_TABLE", other)
    assert [check.quantity for check in contact_checks.contact_law() if not check.passed] == [
        "normal stiffness"
    ]


def test_an_error_is_a_failed_check(monkeypatch):
    def broken():
        raise RuntimeError("no such number")
        yield

    monkeypatch.setattr("asperity.validation.run.GROUPS", {"springs": broken, "Hertz": contact_checks.hertz})
    found = run_checks()
    assert [check.passed for check in found] == [False, True, True]
    document = validation_document(found)
    assert (document["valid"], document["passed"], document["failed"]) == (False, 2, 1)


def test_the_checksum_is_that_of_the_installed_files():
    checksum = source_checksum()
    assert len(checksum) == 64
    assert checksum == source_checksum()


def test_the_contact_law_compares_every_pair():
    check = next(iter(contact_checks.contact_law()))
    assert check.values == 40
    assert np.isfinite(dataclasses.astuple(check)[4])
