"""Unequal branches as a table to read, and as a part of the JSON document."""

import io
import json
import math

import numpy as np
from rich.console import Console

from asperity.cli.branch_table import show_branches
from asperity.joint.branch_document import branch_document
from asperity.joint.branch_results import BranchCapacity, BranchState, UnequalBranches
from asperity.joint.branch_sizes import BranchSizes


def found(support):
    state = BranchState(
        preload=np.array([1100.0, 900.0, 0.0]),
        torque=np.array([3.0, 2.0, 0.0]),
        slip_ratio=np.array([0.4, 0.5, np.nan]),
        sun_displacement=np.array([-3e-6, 4e-6]),
        sun_force=np.array([-150.0, 200.0]),
    )
    capacity = BranchCapacity(first_slip=8.0, branch=1, contact=0, all_slip=12.5, equal=13.0)
    whole = UnequalBranches(
        interference=np.array([14e-6, 12e-6, -1e-6]),
        preload=np.array([1100.0, 900.0, 0.0]),
        rest=state,
        standing=state,
        rolling=None,
        capacity=capacity,
        rolling_capacity=capacity,
    )
    sizes = BranchSizes(np.array([1e-6, 0.0, -7e-6]), np.zeros(3), np.zeros(3), support)
    return json.loads(json.dumps(branch_document(whole, sizes), allow_nan=False))


def text(document):
    target = Console(file=io.StringIO(), width=160)
    show_branches(target, document)
    return target.file.getvalue()


def test_the_table_says_shares_and_what_slips_first():
    said = text(found(5e7))
    assert "60, -" in said
    assert "0.5, -" in said
    assert "5 um off centre, 250 N on its bearings" in said
    assert (
        "8 N·m: contact sp of planet 2 slips first; all slip at 12.5 N·m; equal branches pass 13 N·m" in said
    )
    assert "250 N on its bearings, which hold it" in text(found(math.inf))
