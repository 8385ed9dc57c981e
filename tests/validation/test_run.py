"""The installation passes; a check that ends in an error does not."""

import json

import pytest

from asperity.validation import contact_checks
from asperity.validation.run import GROUPS, run_checks, source_checksum, validation_document


@pytest.fixture(scope="module")
def checks():
    progress = []
    found = run_checks(lambda done, total: progress.append((done, total)))
    assert progress == [(done, len(GROUPS)) for done in range(len(GROUPS) + 1)]
    return found


@pytest.mark.long
def test_this_installation_passes(checks):
    assert [check for check in checks if not check.passed] == []
    assert len(checks) >= 90
    assert sum(check.values for check in checks) >= 560
    document = validation_document(checks)
    assert document["valid"]
    assert document["failed"] == 0
    json.dumps(document, allow_nan=False)


@pytest.mark.long
def test_every_check_names_its_reference(checks):
    assert all(check.reference and check.unit and check.quantity for check in checks)
    assert all(0.0 < check.tolerance <= 0.02 for check in checks)


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
