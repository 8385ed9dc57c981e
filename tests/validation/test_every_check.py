"""Every check of the installation passes: what it compares is not computed a second time by the tests of its room."""

import pytest

from asperity.validation.run import GROUPS

#: Groups that take longer than a second.
SLOW = ("unlike branches", "rings", "half-space", "partial slip", "rolling", "the paper's figures")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in GROUPS]
)
def test_a_group_passes(name):
    checks = list(GROUPS[name]())
    assert checks
    assert [check for check in checks if not check.passed] == []


def test_slow_groups_exist():
    assert set(SLOW) <= set(GROUPS)
