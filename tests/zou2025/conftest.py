"""The paper's curves, computed once for all tests of this folder."""

import pytest

from asperity.zou2025.claims import judge
from asperity.zou2025.curves import Curves, compute
from asperity.zou2025.verdict import Claim


@pytest.fixture(scope="session")
def curves() -> Curves:
    return compute()


@pytest.fixture(scope="session")
def claims(curves: Curves) -> dict[str, Claim]:
    return {claim.name: claim for claim in judge(curves)}
