"""The table of results of other drives: their parts, and no words of the paper's drive alone."""

import math
import re

import pytest

from asperity.results import RESULTS
from asperity.results.table import results_of_drive


@pytest.fixture(scope="module")
def table():
    return results_of_drive(
        ("ab", "bc"),
        ("wheel", "disc", "hoop"),
        ("disc_to_disc",),
        ("disc_pin", "wheel", "carrier"),
        ("disc",),
        has_wedges=False,
    )


def test_rows_are_the_parts_of_the_drive(table):
    assert table["slip_ratio"].row_names == ("ab", "bc")
    assert table["body_life"].row_names == ("wheel", "disc", "hoop")
    assert table["rim_yield_safety"].row_names == ("wheel", "disc", "hoop")
    assert table["clearance"].row_names == ("disc_to_disc",)
    assert table["bearing_life"].row_names == ("disc_pin", "wheel", "carrier")
    assert table["pin_load"].row_names == ("disc",)
    assert "wedge_angle" not in table
    assert table["standing_limiting_contact"].categories == ("ab", "bc", "none")
    assert "0" in table["standing_limiting_contact"].note
    parts = (
        "ab",
        "bc",
        "wheel",
        "disc",
        "hoop",
        "disc_pin_bearing",
        "wheel_bearing",
        "carrier_bearing",
        "disc_pin",
    )
    assert table["limiting_place"].categories == (*parts, "none")
    assert table["speed_ratio"].highest_limit == math.inf


def test_no_label_names_a_part_that_the_drive_may_not_have(table):
    parts = (
        r"\b(sun|planet|ring)\b(?! or hollow roller| seat)"  # what bends or is seated is a ring in any drive
    )
    assert {name: row.label for name, row in table.items() if re.search(parts, row.label)} == {}
    assert table["published_stiffness_input"].label == "torsional stiffness at the input, asperities alone"
    assert "where the input stands" in table["efficiency"].note


def test_a_drive_with_wedges_has_all_results():
    names = (("a",), ("b",), ("c",), ("d",), ("e",))
    assert set(results_of_drive(*names, has_wedges=True)) == set(RESULTS)
    without = results_of_drive(*names, has_wedges=False)
    assert set(RESULTS) - set(without) == {name for name, row in RESULTS.items() if row.needs_wedges}
