"""The Ra that belongs to the surfaces of a joint."""

import dataclasses

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.results.surface_averages import surface_averages
from asperity.surface.roughness_average import corresponding_average


def test_alike_surfaces_are_one_entry(case):
    joint, stated = joint_from_case(case), si_values(case)["surface"]
    (found,) = surface_averages(joint, stated)
    assert found["contacts"] == ["sp", "pwr", "pwl", "wro", "wlo"]
    expected = corresponding_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=None)
    assert found["roughness_average_m"] == expected.each
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
