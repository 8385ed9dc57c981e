"""Joints with tilted axes: the check joint of the companion tables, its skew against rolling.skew, crowns."""

import dataclasses
import math

import numpy as np
import pytest
from worn import check_case

from asperity.contact.hertz_line import half_width
from asperity.contact.skew import skewed_slip_ratios
from asperity.drive.structure.axis_tilts import AxisTilts
from asperity.joint.description import joint_contacts
from asperity.joint.tilt import tilted_contacts
from asperity.joint_file.solved_document import solved_case


def tilted(solved, name="sun", out=0.0, across=0.0):
    tilts = AxisTilts(bodies=(name,), out=(out,), across=(across,))
    return tilted_contacts(dataclasses.replace(solved.joint, tilts=tilts), solved.result)


@pytest.fixture(scope="module")
def solved():
    return solved_case(check_case())


def test_check_joint_of_an_independent_computation(solved):
    found = tilted(solved, out=1e-3)
    assert found.normal_force == pytest.approx([1001.75, 657.51, 465.29, 646.04, 448.32], rel=1e-4)
    assert found.tilt_stiffness == pytest.approx([563.5, 542.6, 516.4, 579.1, 547.8], rel=2e-4)
    assert 1e3 * found.as_stated.slope == pytest.approx([0.598, 0.349, 0.367, 0.0, 0.0], abs=1e-3)
    assert np.all(found.as_stated.edge)
    assert np.all(np.isnan(found.as_stated.peak_pressure))
    means = 1.0 + np.array([0.598, 0.349, 0.367]) / (
        1e3 * found.freeing_slope[:3]
    )  # straight while both ends press
    assert found.as_stated.end_over_mean[:3] == pytest.approx(means, rel=0.02)
    across = tilted(solved, across=1e-3).as_stated
    assert across.slope == pytest.approx(np.zeros(5), abs=1e-15)
    assert across.peak_over_mean == pytest.approx(np.ones(5), rel=1e-9)
    assert across.skew == pytest.approx([1e-3, 0.0, 0.0, 0.0, 0.0], abs=1e-15)


def test_sideways_force_of_the_skew(solved):
    """39 % of friction without traction; with the traction of the joint what the joint with this rolling.skew has."""
    sun = solved.joint.contact_names.index("sp")
    pairs = joint_contacts(solved.joint).pairs
    radius = float(np.broadcast_to(pairs.effective_radius, 5)[sun])
    modulus = float(np.broadcast_to(pairs.moduli.contact_modulus, 5)[sun])
    width = half_width(
        normal_force=1001.75, contact_length=5e-3, effective_radius=radius, contact_modulus=modulus
    )
    limit = 0.12 * float(width) / radius
    alone = skewed_slip_ratios(
        longitudinal_creepage=0.0,
        lateral_creepage=1e-3,
        gross_slip_creepage=limit,
        lateral_gross_slip_creepage=limit / 0.7,
    )[1]
    assert float(alone) == pytest.approx(0.39, abs=0.005)
    found = tilted(solved, across=1e-3).as_stated.sideways
    assert 0.93 * 0.39 < found[sun] < 0.39  # traction takes a part of it
    assert found[1:] == pytest.approx(0.0, abs=1e-15)
    zero = 'pwr = "0 mrad", pwl = "0 mrad", wro = "0 mrad", wlo = "0 mrad"'
    skewed = solved_case(check_case(more=f'\n[rolling]\nskew = {{ sp = "1 mrad", {zero} }}\n'))
    rolling = skewed.result.rolling
    assert found[sun] == pytest.approx(
        abs(float(rolling.axial_force[sun])) / (0.12 * float(rolling.normal[sun])), rel=0.02
    )


def test_free_ends_of_crowned_planets_resist_by_their_crowns():
    """K = N R_c, and M = N phi R_c: a circular crown whose ends stay free keeps its peak pressure."""
    crown = 0.25
    solved = solved_case(
        check_case({"planet_radius =": f'planet_crown_radius = "{crown} m"\nplanet_radius ='})
    )
    found, straight = tilted(solved, out=1e-3), tilted(solved, out=1e-9)
    assert found.tilt_stiffness[:3] == pytest.approx(crown * found.normal_force[:3], rel=2e-3)
    assert not np.any(found.as_stated.edge[:3])
    assert found.as_stated.peak_pressure[:3] == pytest.approx(straight.as_stated.peak_pressure[:3], rel=1e-3)
    assert np.all(found.as_stated.edge[3:])  # rollers and ring are cylinders
    assert np.all(np.isnan(found.freeing_slope))


def test_a_standing_joint_has_slopes_and_no_sideways_force():
    solved = solved_case(check_case({'sun_speed = "6000 rpm"': 'sun_speed = "0 rpm"'}))
    found = tilted(solved, out=1e-3).as_stated
    assert np.all(np.isnan(found.sideways))
    assert 0.5e-3 < found.slope[0] < 0.7e-3


def test_a_joint_that_does_not_roll_has_nothing(solved):
    nothing = dataclasses.replace(
        solved.result,
        rolling=dataclasses.replace(solved.result.rolling, normal=np.full(5, math.nan)),
    )
    tilts = AxisTilts(bodies=("sun",), out=(1e-3,), across=(0.0,))
    assert tilted_contacts(dataclasses.replace(solved.joint, tilts=tilts), nothing) is None
