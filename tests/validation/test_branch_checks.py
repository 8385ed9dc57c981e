"""The checks of unlike branches pass, and find a planet of another size."""

import pytest

from asperity.validation import branch_checks


@pytest.mark.slow
def test_a_size_that_is_off_is_found(monkeypatch):
    assert [check for check in branch_checks.unlike() if not check.passed] == []
    monkeypatch.setattr(
        branch_checks, "_preloads", lambda moved, honest=branch_checks._preloads: honest(moved) * 1.001
    )
    assert not any(check.passed for check in list(branch_checks.unlike())[:2])
