"""Rows of rim stresses: which bodies are judged by them."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.results import RESULTS


def joint(support, bore, strength):
    material = SimpleNamespace(fatigue_strength=strength)
    bodies = SimpleNamespace(ring=material, planet=material, loading_roller=material)
    safety = SimpleNamespace(yield_safety=np.array(2.0), fatigue_safety=np.array(0.8))
    return SimpleNamespace(
        joint=SimpleNamespace(
            ring_support=support, planet_bore=bore, loading_roller_bore=None, bodies=bodies
        ),
        rims=SimpleNamespace(ring=safety, planet=safety, loading_roller=safety),
    )


@pytest.mark.parametrize(
    ("support", "bore", "strength", "judged"),
    [
        ("rigid_housing", None, 3e8, []),
        ("free", None, 3e8, ["ring_yield", "ring_fatigue"]),
        ("elastic_housing", None, None, ["ring_yield"]),
        ("rigid_housing", 4e-3, 3e8, ["planet_yield", "planet_fatigue"]),
        ("free", 4e-3, None, ["ring_yield", "planet_yield"]),
    ],
)
def test_only_what_bends_is_judged(support, bore, strength, judged):
    """A ring that nothing or an elastic housing holds, a roller with a bore; fatigue where the strength is known."""
    solved = joint(support, bore, strength)
    names = [
        f"{body}_{kind}" for body in ("ring", "planet", "loading_roller") for kind in ("yield", "fatigue")
    ]
    assert [name for name in names if RESULTS[f"{name}_safety"].rows_of(solved)] == judged
    for name in judged:
        ((_, value),) = RESULTS[f"{name}_safety"].rows_of(solved).items()
        assert RESULTS[f"{name}_safety"].limit.is_kept(value) == (value > 1.0)
