"""Rows for the suppliers of pins and bearings, from cases made by hand."""

import dataclasses
import json
from types import SimpleNamespace

import numpy as np
import pytest
from asperity.drive.structure_loads import StructureLoads
from asperity.joint.working_loads import BearingSpeeds

from asperity.joint.description import PinBeam
from asperity.joint.loads_document import LoadCase, document_of_rows, loads_document
from asperity.joint_file.planar_build import planar_joint_from_case


def case_of(name, factor, speed):
    loads = StructureLoads(
        pin_tangential=factor * np.array([-30.0, 40.0]),
        pin_radial=factor * np.array([40.0, 0.0]),
        sun_torque=factor * 0.5,
        carrier_torque=factor * 4.5,
        housing_torque=factor * 5.0,
    )
    rolling = SimpleNamespace(axial_thrust=np.array([1.0, 0.0, 2.0, 3.0, 4.0]))
    speeds = BearingSpeeds(np.array([7.0, 8.0]) * speed, 9.0 * speed, speed)
    return LoadCase(name, 4.5, speed, None, SimpleNamespace(rolling=rolling), loads, speeds, None)


CASES = (
    dataclasses.replace(case_of("without torque", 0.0, 0.0), result=None, speeds=None),
    case_of("working torque", 1.0, 1.0),
    dataclasses.replace(case_of("duty 1", np.nan, 2.0), unknown_because="slips"),
)


def row_of(document, part, position, quantity):
    found = [
        row["values"]
        for row in document["loads"]
        if (row["part"], row["position"], row["quantity"]) == (part, position, quantity)
    ]
    assert len(found) == 1, quantity
    return found[0]


def test_rows_and_units(case):
    joint = planar_joint_from_case(case)
    document = loads_document(joint, CASES, [])
    json.dumps(document, allow_nan=False)
    assert [each["name"] for each in document["cases"]] == ["without torque", "working torque", "duty 1"]
    assert row_of(document, "carrier pin", "right roller", "resultant force") == [0.0, 50.0, None]
    assert row_of(document, "carrier pin", "left roller", "tangential force") == [0.0, 40.0, None]
    assert row_of(document, "carrier pin", "left roller", "speed, roller on pin") == [0.0, 8.0, 16.0]
    assert row_of(document, "ring in its housing", "on the axis", "torque") == [0.0, 5.0, None]
    for unloaded in (
        ("planet", "its own axis"),
        ("sun bearing", "on the axis"),
        ("carrier bearing", "on the axis"),
    ):
        assert row_of(document, *unloaded, "resultant force") == [0.0, 0.0, None], "unknown like all others"
    assert not [row for row in document["loads"] if row["quantity"] in ("axial force", "bending moment")]


def test_skew_and_pins_add_rows(case):
    joint = planar_joint_from_case(case)
    joint = dataclasses.replace(
        joint,
        pin=PinBeam(6e-3, "both_ends"),
        bearings=dataclasses.replace(joint.bearings, pin_diameter=4e-3),
        rolling=dataclasses.replace(joint.rolling, skew=(1e-3,)),
        structure=dataclasses.replace(joint.structure, planet_support_stiffness=1e6),
    )
    document = loads_document(joint, CASES, [])
    assert row_of(document, "carrier pin", "left roller", "axial force")[:2] == [0.0, 3.0]
    moment = 50.0 * (2.0 * 6e-3 - 5e-3) / 8.0  # F (2 l - b)/8 with the roller's 5 mm
    found = row_of(document, "carrier pin", "right roller", "bending moment")
    assert found[1] == pytest.approx(moment)
    stress = 32.0 * moment / (np.pi * 4e-3**3)
    assert row_of(document, "carrier pin", "right roller", "bending stress")[1] == pytest.approx(stress)
    assert row_of(document, "planet", "its own axis", "resultant force") == [None, None, None]
    assert any("supports" in note for note in document["notes"])


def test_unequal_branches_load_pins_and_bearings(case, unequal_branches):
    """The worst pin of all branches: 50 N of the second at the right, 13 N of the first at the left."""
    pins = np.array([[[0.0, 30.0, 0.0], [5.0, 0.0, 0.0]], [[20.0, 40.0, 0.0], [-12.0, 12.9, 0.0]]])
    state = dataclasses.replace(unequal_branches().standing, pins=pins)
    centre = {"carrier": np.array([6.0, 8.0]), "ring": np.array([-36.0, -48.0])}
    rolling = dataclasses.replace(state, sun_force=np.array([30.0, 40.0]), centre_forces=centre)
    branches = unequal_branches(rest=state, rolling=rolling, duty=(None,))
    document = loads_document(planar_joint_from_case(case), CASES, [], branches)
    assert row_of(document, "sun bearing", "on the axis", "resultant force") == [250.0, 50.0, None]
    assert row_of(document, "carrier bearing", "on the axis", "resultant force") == [None, 10.0, None]
    assert row_of(document, "ring in its housing", "on the axis", "resultant force") == [None, 60.0, None]
    assert row_of(document, "carrier pin", "right roller", "resultant force") == [50.0, 50.0, None]
    assert row_of(document, "carrier pin", "right roller", "radial force") == [30.0, 30.0, None]
    assert row_of(document, "carrier pin", "left roller", "tangential force") == [-12.0, -12.0, None]
    assert "[[branch]], do not carry this load" in document["cases"][2]["unknown_because"]
    notes = " ".join(document["notes"])
    assert "All branches are equal" not in notes
    assert "planet 1 is pressed 1.1 times as hard" in notes
    # the branches carry a load that equal ones do not, and the other way round
    more = unequal_branches(rest=state, duty=(rolling,))
    document = loads_document(planar_joint_from_case(case), CASES, [], more)
    assert row_of(document, "sun bearing", "on the axis", "resultant force") == [250.0, None, 50.0]
    assert document["cases"][2]["unknown_because"] is None
    assert not any("equal branches do not carry" in note for note in document["notes"])
    # what all of them do together, whatever equal ones do
    own = dataclasses.replace(
        rolling,
        torques={"sun": 1.5, "carrier": 12.0, "ring": 10.5},
        speeds={"sun": 5.0, "carrier": 0.8},
        bearing_speed=np.array([7.0, 8.0, 5.0, 0.8]),
    )
    document = loads_document(
        planar_joint_from_case(case), CASES, [], unequal_branches(rest=state, duty=(own,))
    )
    assert row_of(document, "sun", "on the axis", "torque of its shaft")[1:] == [None, 1.5]
    assert row_of(document, "ring in its housing", "on the axis", "torque")[2] == 10.5
    assert row_of(document, "carrier", "on the axis", "torque of all pins")[2] == 12.0
    assert row_of(document, "carrier bearing", "on the axis", "speed in the housing")[2] == 0.8
    assert row_of(document, "carrier pin", "left roller", "speed, roller on pin")[2] == 8.0
    assert row_of(document, "sun bearing", "on the axis", "speed in the housing")[2] == 5.0


def test_what_rounding_leaves_is_nothing():
    """5.8e-15 N·m beside 11 N·m, in a table that also has forces; a nanonewton-metre is kept."""
    cases = [
        {"name": name, "unknown_because": None} for name in ("without torque", "working torque", "load 1")
    ]
    rows = [
        ("carrier", "centre", "torque", "N*m", np.array([5.8e-15, 11.0, 1e-9])),
        ("carrier", "centre", "force", "N", 3e-13),
    ]
    document = document_of_rows(cases, rows, bearings=[], notes=[])
    assert row_of(document, "carrier", "centre", "torque") == [0.0, 11.0, 1e-9]
    assert row_of(document, "carrier", "centre", "force") == [3e-13] * 3
