"""The document of a planar joint: names of the paper's drive, numbers of the geometry and of the solution."""

import dataclasses
import json

import numpy as np
import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.results.document import surface_averages
from asperity.surface.roughness_average import corresponding_average


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
    assert document["standing_torque_capacity"]["reverse"]["output_torque_Nm"] == float(
        solution.reverse_standing_capacity.output_torque
    )
    names = [entry["name"] for entry in document["diagnostics"]]
    assert len(names) == len(document["diagnostics"]) > 5


def test_alike_surfaces_are_one_entry(case):
    joint, stated = joint_from_case(case), si_values(case)["surface"]
    (found,) = surface_averages(joint, stated)
    assert found["contacts"] == ["sp", "pwr", "pwl", "wro", "wlo"]
    expected = corresponding_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=None)
    assert found["roughness_average_m"] == expected.per_body
    one = joint.surfaces[0]
    other = dataclasses.replace(one, fractal_roughness=1e-12)
    mixed = dataclasses.replace(joint, surfaces=(one, other, other, one, one))
    assert [each["contacts"] for each in surface_averages(mixed, stated)] == [
        ["sp", "wro", "wlo"],
        ["pwr", "pwl"],
    ]


def test_the_contacts_are_those_of_the_drive(zou_file):
    planetary = read_case(zou_file.with_name("planetary.toml"))
    (found,) = surface_averages(joint_from_case(planetary), si_values(planetary)["surface"])
    assert found["contacts"] == ["sp", "pr"]
    assert found["fractal_roughness_m"] == pytest.approx(1.3e-10, rel=1e-6, abs=0.0)


def test_the_cut_off_of_a_stated_ra_is_kept(case):
    (found,) = surface_averages(joint_from_case(case), {"roughness_average": 0.2e-6})
    assert found["cut_off_m"] == 0.8e-3
    (found,) = surface_averages(joint_from_case(case), {"roughness_average": 0.2e-6, "cut_off": 2.5e-3})
    assert found["cut_off_m"] == pytest.approx(2.5e-3)
