"""The paper's curves, computed once for all tests of this folder, and made-up curves for single claims."""

from collections.abc import Callable
from dataclasses import fields

import numpy as np
import pytest

from asperity.zou2025.claims import judge
from asperity.zou2025.criteria import Claim
from asperity.zou2025.curves import Curves, JointCurves, PairCurve, compute


@pytest.fixture(scope="session")
def curves() -> Curves:
    return compute()


@pytest.fixture(scope="session")
def claims(curves: Curves) -> dict[str, Claim]:
    return {claim.name: claim for claim in judge(curves)}


def _sweep(known: dict) -> JointCurves:
    return JointCurves(**{field.name: known.get(field.name, np.empty(0)) for field in fields(JointCurves)})


@pytest.fixture(scope="session")
def made_up() -> Callable[..., Curves]:
    """Maker of curves: ``pairs`` maps a case to (values, K_t), every other keyword a sweep to its known fields."""

    def make(*, pairs: dict | None = None, **sweeps: dict) -> Curves:
        return Curves(
            pairs={case: PairCurve("", *known) for case, known in (pairs or {}).items()},
            **{f.name: _sweep(sweeps.get(f.name, {})) for f in fields(Curves) if f.name != "pairs"},
        )

    return make
