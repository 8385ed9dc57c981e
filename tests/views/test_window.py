"""The window as it is shown: verdict first, loads with pass or FAIL, what governs where, and the capacity."""

from pathlib import Path

import pytest
from shown_blocks import sentences, tables

import asperity
from asperity.joint_file.window import joint_window
from asperity.results.window_document import window_document
from asperity.views.blocks import Paragraph
from asperity.views.window import window, window_summary

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def document():
    joint = asperity.load(EXAMPLES / "wheel_pair.toml")
    return window_document(joint_window(joint.case, start=500.0, stop=1500.0, points=3))


def test_the_verdict_comes_first(document):
    first, *_ = window(document)
    assert isinstance(first, Paragraph)
    assert (first.strong, first.passed) == (True, True)
    assert first.text == "The output torque of the file lies inside the window at 1000 N of preload."


def test_loads_pass_or_fail(document):
    loads = tables(window(document))["Loads at 1000 N of preload"]
    assert loads.verdicts
    (row,) = loads.rows
    # mu N R = 3.2 N·m, less what rolling loses
    assert row == (
        "output torque of the file",
        *("2", "1000", "3.171", "63.07 %"),
        "contact dd slips, in rolling",
        "pass",
    )
    beyond = document | {"loads": [{**document["loads"][0], "inside": False}]}
    assert tables(window(beyond))["Loads at 1000 N of preload"].rows[0][-1] == "FAIL"


def test_what_governs_where(document):
    (row,) = tables(window(document))["Which limit governs where"].rows
    assert row == ("500", "1500", "contact dd slips, in rolling")


def test_the_capacity_over_the_axis_says_where_the_joint_works(document):
    table = tables(window(document))["Torque capacity"]
    assert table.head == ("preload\nN", "capacity\nN·m", "")
    assert [row[0] for row in table.rows if row[-1]] == ["1000"]
    assert (table.rows[0][0], table.rows[-1][0]) == ("500", "1500")


def test_notes_say_for_what_the_numbers_hold(document):
    assert sentences(window(document))[-1] == "The capacity holds at an input speed of 1000 rpm."
    assert len(list(window_summary(document))) == 4


def test_a_closed_part_says_that_no_torque_is_allowed(document):
    (region,) = document["regions"]
    part = {**region["governing"][0], "closed": True, "meaning": "contact dd beyond first yield"}
    closed = document | {"regions": [region | {"governing": [part]}]}
    (row,) = tables(window(closed))["Which limit governs where"].rows
    assert row[-1] == "no torque is allowed: contact dd beyond first yield"
