"""The document of a planar joint: names of the paper's drive, numbers of the geometry and of the solution."""

import json

import numpy as np
import pytest


def test_a_given_interference_is_that_of_the_result(planetary):
    _, solution, document = planetary
    assert document["preload"]["interference_m"] == pytest.approx(30e-6, rel=1e-12)
    assert document["preload"]["force_N"] == pytest.approx(float(solution.result.rest.normal[0]), rel=1e-12)


def test_geometry_is_that_of_the_drive(planetary):
    geometry = planetary[2]["geometry"]
    assert (geometry["sectors"], geometry["input"], geometry["output"], geometry["grounded"]) == (
        3,
        "sun",
        "carrier",
        "ring",
    )
    np.testing.assert_allclose(geometry["centres_m"]["planet"], [0.0, 30e-3], atol=1e-15)
    assert geometry["track_radii_m"]["pr"] == pytest.approx({"planet": 20e-3, "ring": 50e-3})
    speeds = geometry["speeds_over_input"]
    assert [speeds[name] for name in ("sun", "ring", "carrier")] == pytest.approx([1.0, 0.0, 1.0 / 6.0])
    assert speeds["planet"] == pytest.approx(1.0 / 6.0 - (50.0 / 20.0) / 6.0)  # rolls in the ring that stands


def test_it_is_json_and_says_of_which_direction_the_rolling_capacity_is(planetary):
    _, solution, document = planetary
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["rolling"]["torque_capacity_Nm"] == float(solution.rolling_capacity.output_torque)
    assert document["torque_capacity"]["reverse"]["output_torque_Nm"] == float(
        solution.reverse_capacity.output_torque
    )
    names = [entry["name"] for entry in document["diagnostics"]]
    assert len(names) == len(document["diagnostics"]) > 5
