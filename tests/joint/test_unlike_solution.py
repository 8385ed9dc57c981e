"""What unlike branches do together, in the words of a joint; what they do is tested with their joints."""

import dataclasses
from types import SimpleNamespace

import numpy as np

from asperity.joint.unlike_solution import UnlikeSolution


def test_the_capacity_names_the_branch_that_slips_first(unequal_branches):
    found = unequal_branches()
    capacity = dataclasses.replace(found.capacity, first_slip=3.598, branch=2, contact=1, all_slip=12.5)
    solution = UnlikeSolution(SimpleNamespace(), dataclasses.replace(found, capacity=capacity))
    assert solution.capacity_document == {
        "output_torque_Nm": 12.5,
        "limit": "gross_slip",
        "limiting_contact": "pwr_3",
        "meaning": "all branches slip",
        "is_lower_bound": False,
        "first_slip": {"output_torque_Nm": 3.598, "contact": "pwr_3"},
    }


def test_why_there_is_no_rolling(unequal_branches):
    power = SimpleNamespace(efficiency=np.array(0.99))
    result = SimpleNamespace(rolling=SimpleNamespace(power=power))

    def said(speed, **changes):
        joint = SimpleNamespace(joint=SimpleNamespace(sun_speed=speed, ends=("sun", "carrier")))
        return UnlikeSolution(result, unequal_branches(**changes)).unknown_because(joint)

    assert said(100.0, rolling=unequal_branches().standing) == []
    assert said(0.0, rolling=unequal_branches().standing)[0].startswith("the sun stands")
    assert said(100.0, rolling=None)[0].startswith("no steady rolling under")
    slip = np.array([0.5, 0.6, 1.0])
    slips = dataclasses.replace(unequal_branches().standing, slip_ratio=slip)
    assert said(100.0, rolling=slips) == [
        "drift and losses are not known: in rolling under 5 N·m planet 3 slips as a whole while the others carry the "
        "rest"
    ]


def test_a_loose_branch_has_no_contacts(unequal_branches):
    """Planet 3 is loose: nothing is said of contacts that it does not have."""
    pressed = dataclasses.replace(unequal_branches().standing, preload=np.array([1100.0, 950.0, 0.0]))
    solution = UnlikeSolution(SimpleNamespace(), unequal_branches(rolling=pressed))
    names = ("sp", "pwr", "pwl", "wro", "wlo")
    assert solution.rolling_contacts == tuple(f"{name}_{branch}" for branch in (1, 2) for name in names)
