"""What a window says: verdict, what governs where, columns, and an empty window as an answer."""

from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.window import joint_window
from asperity.results.window_document import borders, governing, window_columns, window_document

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def wheels():
    return joint_window(asperity.load(EXAMPLES / "wheel_pair.toml").case, start=500.0, stop=1000.0, points=2)


@pytest.fixture(scope="module")
def soft():
    """The paper's drive of steel that yields at 244 N: at its 1000 N no torque is allowed."""
    return joint_window(asperity.load(EXAMPLES / "zou2025.toml").case, start=400.0, stop=1200.0, points=2)


def test_a_load_inside_and_its_nearest_limit(wheels):
    """2 N·m of mu N R = 3.2 N·m less what rolling loses."""
    document = window_document(wheels)
    verdict = document["verdict"]
    assert verdict["inside"]
    assert verdict["title"] == "The output torque of the file lies inside the window at 1000 N of preload"
    (load,) = document["loads"]
    assert load["share_of_capacity"] == pytest.approx(2.0 / load["torque_capacity_Nm"])
    assert "2 N·m is 63.1 % of the 3.171 N·m at which contact dd slips, in rolling" in verdict["words"]
    (allowed,) = document["allowed"]
    assert allowed["to_N"] == 1000.0
    assert allowed["ends_with"] is None
    assert allowed["begins_with"] == "output torque of the file: contact dd slips, in rolling"
    assert document["allowed_with_tolerances"] is None


def test_a_window_without_any_torque_is_an_answer(soft):
    document = window_document(soft)
    assert not document["verdict"]["inside"]
    assert document["allowed"] == []
    assert document["verdict"]["words"].endswith(
        "No torque is allowed anywhere from 400 N to 1200 N: contact sp beyond first yield."
    )
    (part,) = document["regions"][0]["governing"]
    assert part == {
        "from_N": 400.0,
        "to_N": 1200.0,
        "limit": "pressure_over_first_yield",
        "meaning": "contact sp beyond first yield",
        "closed": True,
    }


def test_stretches_cover_the_axis_once(wheels, soft):
    for window in (wheels, soft):
        for region in window.regions:
            parts = governing(window, region)
            assert [part.first for part in parts] == [0, *(part.last + 1 for part in parts[:-1])]
            assert parts[-1].last == window.at.size - 1


def test_the_capacity_is_the_least_of_the_borders(wheels, soft):
    for window in (wheels, soft):
        for region in window.regions:
            torques = [border.torque for border in borders(window, region)]
            assert np.array_equal(np.min(torques, axis=0), region.capacity.torque)


def test_columns_have_their_units(wheels):
    columns = window_columns(wheels)
    assert list(columns)[:2] == ["preload_N", "torque_capacity_Nm"]
    assert {len(column) for column in columns.values()} == {wheels.at.size}
    assert np.array_equal(columns["rolling_gross_slip_Nm"], wheels.regions[0].capacity.torque)
