"""Sections [[branch]]: as many as planets, their preload by interference."""

import math

import pytest

from asperity.errors import InputError
from asperity.joint_file.build import branches_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys

ENTRIES = (
    '[[branch]]\nplanet_deviation = "2 um +- 1 um"\n\n[[branch]]\nright_roller_deviation = "-1 um"\n\n'
    '[[branch]]\nleft_roller_deviation = "0.5 um"\n\n'
)


def read(text, entries=ENTRIES, load='interference = "13 um"'):
    return parse_case(
        text.replace('preload = "1000 N"', load).replace("[model]", entries + "[model]"), source="x"
    )


def test_sizes_of_a_file(joint_text):
    case = read(joint_text)
    nominal, sizes = branches_from_case(case)
    assert nominal == 13e-6
    assert sizes.planet.tolist() == [2e-6, 0.0, 0.0]
    assert sizes.right_roller.tolist() == [0.0, -1e-6, 0.0]
    assert sizes.left_roller.tolist() == [0.0, 0.0, 5e-7]
    assert sizes.sun_support_stiffness == math.inf
    assert numeric_keys(case)["branch.1.planet_deviation"].tolerance == pytest.approx(1e-6)
    soft = joint_text.replace("[model]", '[compliance]\nsun_support_stiffness = "50 N/um"\n\n[model]')
    assert branches_from_case(read(soft))[1].sun_support_stiffness == 5e7


def test_what_does_not_fit_together_is_told(joint_text):
    with pytest.raises(InputError, match=r"3 planets, but there are 2 sections \[\[branch\]\]"):
        read(joint_text, "[[branch]]\n\n[[branch]]\n\n")
    with pytest.raises(InputError, match=r"needs load\.interference in place of load\.preload"):
        read(joint_text, load='preload = "1000 N"')
    with pytest.raises(InputError, match="cannot be combined"):
        read(joint_text, load='interference = "13 um"\ncam_force_per_torque = "10 N/Nm"')
    with pytest.raises(InputError, match="one for each planet"):
        read(joint_text, '[branch]\nplanet_deviation = "2 um"\n\n')
    with pytest.raises(InputError, match=r"branch\.2\.planet_deviation: expected a length"):
        read(joint_text, ENTRIES.replace('right_roller_deviation = "-1 um"', 'planet_deviation = "2 N"'))
    with pytest.raises(InputError, match=r"give load\.interference"):
        branches_from_case(parse_case(joint_text, source="x"))


def test_without_sections_all_are_equal(joint_text):
    _, sizes = branches_from_case(read(joint_text, ""))
    assert (
        sizes.planet.tolist() == sizes.right_roller.tolist() == sizes.left_roller.tolist() == [0.0, 0.0, 0.0]
    )
