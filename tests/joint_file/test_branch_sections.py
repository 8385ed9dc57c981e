"""Sections [[branch]]: as many as planets or sectors, their preload by interference."""

import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.build import deviations_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys, si_values

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
    found = deviations_of(si_values(case))
    assert {name: each.tolist() for name, each in found.deviations.items()} == {
        "planet": [2e-6, 0.0, 0.0],
        "right_roller": [0.0, -1e-6, 0.0],
        "left_roller": [0.0, 0.0, 5e-7],
    }
    # contacts sp, pwr, pwl, wro, wlo of each branch
    expected = [[2.0, 2.0, 2.0, 0.0, 0.0], [0.0, -1.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.5, 0.0, 0.5]]
    np.testing.assert_allclose(found.added, 1e-6 * np.array(expected), atol=1e-18)
    assert found.input_support_stiffness == math.inf
    assert numeric_keys(case)["branch.1.planet_deviation"].tolerance == pytest.approx(1e-6)
    soft = joint_text.replace("[model]", '[compliance]\nsun_support_stiffness = "50 N/um"\n\n[model]')
    assert deviations_of(si_values(read(soft))).input_support_stiffness == 5e7


def test_what_does_not_fit_together_is_told(joint_text):
    with pytest.raises(InputError, match=r"3 planets, but there are 2 sections \[\[branch\]\]"):
        read(joint_text, "[[branch]]\n\n[[branch]]\n\n")
    with pytest.raises(InputError, match=r"needs load\.interference in place of load\.preload"):
        read(joint_text, load='preload = "1000 N"')
    with pytest.raises(InputError) as refused:
        read(joint_text, ENTRIES.replace('right_roller_deviation = "-1 um"', 'planet_radius = "13.5 mm"'))
    told = "branch.2.planet_radius: unknown key; it belongs in [drive], or did you mean 'planet_deviation'?"
    assert str(refused.value) == f"x: {told}"
    with pytest.raises(InputError, match="one for each planet"):
        read(joint_text, '[branch]\nplanet_deviation = "2 um"\n\n')
    with pytest.raises(InputError, match=r"branch\.2\.planet_deviation: expected a length"):
        read(joint_text, ENTRIES.replace('right_roller_deviation = "-1 um"', 'planet_deviation = "2 N"'))


def test_without_sections_all_are_equal(joint_text):
    found = deviations_of(si_values(read(joint_text, "")))
    assert not found.added.any()
    assert {tuple(each) for each in found.deviations.values()} == {(0.0, 0.0, 0.0)}


def sections(*entries):
    return "".join(f"[[branch]]\n{entry}\n" for entry in entries)


@pytest.mark.parametrize(
    ("name", "load", "entries", "added"),
    [
        ("planetary", None, ['planet_deviation = "2 um"', "", ""], [2.0, 2.0]),
        ("stepped_planet", None, ['planet_deviation = "2 um"', "", ""], [2.0, 2.0, 0.0]),
        ("stepped_planet", None, ['planet_second_deviation = "-1 um"', "", ""], [0.0, 0.0, -1.0]),
        ("multiroller", None, ['first_row_deviation = "3 um"', "", "", ""], [3.0, 0.0, 0.0, 0.0]),
        ("multiroller", None, ['first_row_small_deviation = "3 um"', "", "", ""], [0.0, 3.0, 3.0, 0.0]),
        ("multiroller", None, ['second_row_deviation = "3 um"', "", "", ""], [0.0, 3.0, 3.0, 0.0]),
        ("multiroller", None, ['second_row_small_deviation = "3 um"', "", "", ""], [0.0, 0.0, 0.0, 3.0]),
        # a planet that is larger presses the sun and both loading rollers, which have the ring behind them
        ("planar", "13 um", ['deviation = { planet = "5 um" }', "", ""], [5.0, 5.0, 5.0, 0.0, 0.0]),
        ("planar", "13 um", ['deviation = { left = "5 um" }', "", ""], [0.0, 0.0, 5.0, 0.0, 5.0]),
    ],
)
def test_sizes_of_other_drives_add_to_their_contacts(planar_case, name, load, entries, added):
    changes = [("[model]", sections(*entries) + "\n[model]")]
    if load:
        changes.append(('preload = "1000 N"  ', f'interference = "{load}"  '))
    found = deviations_of(si_values(planar_case(name, *changes)))
    np.testing.assert_allclose(found.added[0], 1e-6 * np.array(added), rtol=1e-12)
    assert not found.added[1:].any()
    assert found.input_support_stiffness == math.inf
    (largest,) = {float(max(each, key=abs)) for each in found.deviations.values() if each.any()}
    assert largest == pytest.approx(1e-6 * max(added, key=abs))


def test_the_bearings_of_the_sun_of_other_drives(planar_case):
    text = '[compliance]\nsun_support_stiffness = "50 N/um"\n' + sections("", "", "") + "\n[model]"
    assert (
        deviations_of(si_values(planar_case("planetary", ("[model]", text)))).input_support_stiffness == 5e7
    )


@pytest.mark.parametrize(
    ("name", "entries", "message"),
    [
        ("planetary", [""], r"the drive has 3 planets, but there are 1 sections \[\[branch\]\]"),
        ("multiroller", ["", ""], "the drive has 4 rollers in a row, but there are 2 sections"),
        ("planar", ["", "", ""], r"needs load\.interference in place of load\.preload"),
        ("planetary", ['planet_deviaton = "1 um"', "", ""], "did you mean 'planet_deviation'"),
    ],
)
def test_sections_of_other_drives_that_do_not_fit_are_told(planar_case, name, entries, message):
    with pytest.raises(InputError, match=message):
        planar_case(name, ("[model]", sections(*entries) + "\n[model]"))


def test_rollers_that_a_sector_does_not_have_are_told(planar_case):
    by_size = ('preload = "1000 N"  ', 'interference = "13 um"  ')
    for name, message in (
        ("ring", r"branch\.2\.deviation\.ring: it is on the axis, common to all; a sector has "),
        ("plant", r"branch\.2\.deviation\.plant: there is no such roller; did you mean 'planet'\?"),
    ):
        entries = sections("", f'deviation = {{ {name} = "1 um" }}', "")
        with pytest.raises(InputError, match=message):
            planar_case("planar", by_size, ("[model]", entries + "\n[model]"))
    case = planar_case(
        "planar",
        by_size,
        ("[model]", sections('deviation = { planet = "1 um +- 2 um" }', "", "") + "\n[model]"),
    )
    assert numeric_keys(case)["branch.1.deviation.planet"].tolerance == pytest.approx(2e-6)
