"""Balances without a solution name the number that makes them so, and where a solution lies."""

import re

import pytest

from asperity.errors import NoSolutionError
from asperity.joint.solve import solve


def told(joint) -> str:
    with pytest.raises(NoSolutionError) as refused:
        solve(joint)
    return str(refused.value)


@pytest.mark.slow
def test_plastic_contacts_in_the_closure_are_the_cause_not_preload_or_torque(paper_joint):
    message = told(paper_joint(fractal_dimension=1.2, closure_springs="bulk_and_asperities"))
    assert "every spot of sp, pwr, pwl, wro, wlo is plastic" in message
    assert 'closure_springs = "bulk"' in message
    assert "nan" not in message


@pytest.mark.slow
def test_a_remedy_named_is_one(paper_joint):
    """A bearing that drags more than its roller's traction: each value named alone gives a solution."""
    stuck = {"preload": 20.0, "loading_roller_torque": 0.36, "left_push_angle": 0.1, "output_torque": 0.1}
    message = told(paper_joint(**stuck))
    assert "nan" not in message
    found = dict(re.findall(r"(\w+) (\S+) \S+ instead of", message))
    assert "loading_roller_torque" in found
    assert float(found["loading_roller_torque"]) < 0.36
