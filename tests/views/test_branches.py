"""Unequal branches as they are shown: sizes, shares, forces on the axis."""

import math

from shown_blocks import UNLIKE, amount, cells, four, sentences, tables

from asperity.views.branches import branches

SIZES, AXIS = "Branches by their own sizes", "Forces on the axis with unequal branches"


def test_sizes_preloads_and_shares_of_a_solved_joint(view_of):
    """Each branch carries its share of the torque; the largest planet is pressed hardest."""
    view = view_of("planetary", more=UNLIKE)
    unequal = view.document["branches"]
    shown = tables(branches(unequal))[SIZES]
    assert shown.head[0] == "planet"
    assert [row[:2] for row in shown.rows] == [("1", "3"), ("2", "0"), ("3", "-2")]
    preloads = [float(row[3]) for row in shown.rows]
    assert preloads == sorted(preloads, reverse=True)
    assert preloads == [four(entry["preload_N"]) for entry in unequal["branches"]]
    for place in (4, 5):  # standing and rolling
        assert math.isclose(sum(float(row[place]) for row in shown.rows), 100.0, abs_tol=0.05)
    for row, slip in zip(shown.rows, unequal["standing"]["slip_ratio"], strict=True):
        assert float(row[6]) == four(slip)
    assert sentences(branches(unequal)) == [unequal["note"]]


def test_a_loose_branch_and_a_state_that_does_not_exist(document_of_branches):
    """Three branches under 5 N·m by hand: 3, 2 and 0 N·m; no steady rolling."""
    shown = tables(branches(document_of_branches()))
    rows = cells(shown[SIZES])
    assert rows["1"][-4:] == ("60", "–", "0.4", "–")
    assert rows["3"][-4:] == ("0", "–", "–", "–")
    assert (rows["1"][:2], rows["3"][:2]) == (("1", "14"), ("-7", "-1"))


def test_forces_on_the_axis(document_of_branches):
    """Components of 150 and 200 N, 3 and 4 µm."""
    rows = cells(tables(branches(document_of_branches()))[AXIS])
    assert rows["force on the bearings of the sun, standing"] == ("250 N",)
    assert rows["displacement of the sun, standing"] == ("5 µm",)
    held = cells(tables(branches(document_of_branches(math.inf)))[AXIS])
    assert list(held) == ["force on the bearings of the sun, standing"]  # by its bearings


def test_without_a_state_under_the_torque_the_force_is_that_without_torque(document_of_branches):
    rows = cells(tables(branches(document_of_branches(standing=None)))[AXIS])
    assert rows["force on the bearings of the sun, without torque"] == ("250 N",)
    assert rows["displacement of the sun, without torque"] == ("5 µm",)


def test_a_force_of_rounding_is_none(document_of_branches):
    found = document_of_branches()
    for components, size in (([3e-12, -4e-12], 0.0), ([3e-6, -4e-6], 5e-6)):
        found["standing"]["sun"]["force_N"] = components
        (text,) = cells(tables(branches(found))[AXIS])["force on the bearings of the sun, standing"]
        assert amount(text) == size


def test_forces_on_other_members_of_the_axis(document_of_branches):
    found = document_of_branches()
    found["standing"]["central_forces_N"] = {"driven_ring": [30.0, 40.0]}
    rows = cells(tables(branches(found))[AXIS])
    assert rows["force on the driven ring, standing"] == ("50 N",)
