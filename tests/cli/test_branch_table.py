"""Unequal branches as a table to read, and as a part of the JSON document."""

import dataclasses
import io
import math

from rich.console import Console

from asperity.cli.branch_table import show_branches
from asperity.results.branch_document import branch_document


def text(found):
    target = Console(file=io.StringIO(), width=160)
    show_branches(target, branch_document(found))
    return target.file.getvalue()


def test_the_table_says_shares_and_what_slips_first(unequal_branches):
    said = text(unequal_branches())
    assert "60, -" in said
    cells = [line.split() for line in said.splitlines() if line[:2] in (" 1", " 3")]
    assert [row[:3] for row in cells] == [["1", "1", "14"], ["3", "-7", "-1"]]
    assert "0.5, -" in said
    assert "5 um off centre, 250 N standing on its bearings" in said
    assert (
        "8 N·m: contact sp of planet 2 slips first; all slip at 12.5 N·m; equal branches pass 13 N·m" in said
    )
    assert "250 N standing on its bearings, which hold it" in text(unequal_branches(math.inf))
    assert "pressed 1.1 times as hard, and loose is planet 3." in " ".join(said.split())


def test_beyond_what_all_branches_pass_the_force_is_that_without_torque(unequal_branches):
    assert "5 um off centre, 250 N without torque on its bearings" in text(unequal_branches(standing=None))


def test_a_force_of_rounding_is_none(unequal_branches):
    found = unequal_branches()
    noise = dataclasses.replace(found.standing, sun_force=(3e-12, -4e-12))
    assert "0 N standing on its bearings" in text(unequal_branches(standing=noise))
    small = dataclasses.replace(found.standing, sun_force=(3e-6, -4e-6))
    assert "5e-6 N standing on its bearings" in text(unequal_branches(standing=small))
