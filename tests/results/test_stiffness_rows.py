"""Rows of the torsional stiffness: levels, sun and output, mass, and shares of the compliance."""

import numpy as np
import pytest

LEVELS = ("published", "series_with_bulk", "assembly")


@pytest.mark.parametrize("level", LEVELS)
def test_sun_and_output_by_the_ratio_and_per_mass_and_volume(value, level):
    output = value(f"{level}_stiffness_output")
    assert value(f"{level}_stiffness_input") == pytest.approx(output / 81.0, rel=1e-12)
    assert value(f"{level}_stiffness_per_mass") == pytest.approx(output / value("mass"), rel=1e-12)
    assert value(f"{level}_stiffness_per_volume") == pytest.approx(
        output / value("envelope_volume"), rel=1e-12
    )


def test_every_level_adds_springs(value):
    stiffness = [value(f"{level}_stiffness_output") for level in LEVELS]
    assert stiffness[0] > stiffness[1] > 0.0
    assert stiffness[0] > stiffness[2] > 0.0


def test_the_published_level_is_the_series_of_the_contacts(value):
    """Three branches; in each one the slips of the contacts by virtual work: sum of T^2/k over the torque squared."""
    tangential, stiffness = value("tangential_force"), value("asperity_tangential_stiffness")
    sun, right, left = tangential[0], *tangential[1:3]
    assert abs(sun) == pytest.approx(abs(right) + abs(left), rel=1e-9)
    # torque over the work of the sun's contact and of the two sides, which carry half of it each when they are equal
    one, two = 1.0 / stiffness[0], 0.25 * np.sum(1.0 / stiffness[1:3] + 1.0 / stiffness[3:])
    assert value("published_stiffness_input") == pytest.approx(3.0 * 4e-3**2 / (one + two), rel=0.1)


def test_shares_add_up(value):
    names = ("ring_bending", "pin", "planet_support", "input_shaft", "output_shaft", "loading_cam")
    total = sum(float(value(f"{name}_share")) for name in names)
    total += float(np.sum(value("tangential_share")) + np.sum(value("normal_share")))
    assert total == pytest.approx(1.0, rel=1e-9)


def test_without_a_cam_there_is_none_to_hold(value):
    assert value("loading_cam_share") == 0.0
    assert value("held_cam_output_stiffness") == pytest.approx(value("assembly_stiffness_output"), rel=1e-12)
