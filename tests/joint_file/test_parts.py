"""Bodies and contacts of each type of drive, and tables that name others."""

from pathlib import Path

import jax
import numpy as np
import pytest
from assumed import assumptions

from asperity.drive.layout.drive import gaps, speed_ratio
from asperity.drive.layout.existence import refuse_impossible
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.parts import layout_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values


def test_bodies_in_the_order_of_the_drive(planar_case):
    bodies = {
        "planetary": ("sun", "planet", "ring"),
        "multiroller": ("sun", "first_row", "second_row", "ring"),
        "stepped_planet": ("sun", "planet", "held_ring", "driven_ring"),
    }
    for kind, names in bodies.items():
        drive, shapes, pattern = layout_of(si_values(planar_case(kind)))
        assert tuple(body.name for body in drive.bodies) == names
        # the interference is at the contacts inside a ring
        assert pattern == tuple(float(contact.internal) for contact in drive.contacts)
        rings = [shape.kind == "ring" for shape in shapes]
        assert rings == ["ring" in name for name in names]


def test_the_ring_as_output(planar_case):
    drive, _, _ = layout_of(si_values(planar_case("planetary", ('output = "carrier"', 'output = "ring"'))))
    assert (drive.input, drive.output, drive.grounded) == ("sun", "ring", "carrier")


def test_rings_are_held_unless_they_are_free(planar_case):
    def support(*replaced):
        return layout_of(si_values(planar_case("planetary", *replaced)))[1][2].support

    assert support() == "free"
    assert support(('ring_support = "free"', 'ring_support = "rigid_housing"')) == "rigid_housing"
    assert support(('ring_support = "free"', "")) == "rigid_housing"
    # the driven ring of stepped planets turns: nothing holds it
    shapes = layout_of(
        si_values(planar_case("stepped_planet", ('ring_support = "free"', 'ring_support = "rigid_housing"')))
    )[1]
    assert [shape.support for shape in shapes[2:]] == ["rigid_housing", "free"]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "friction_coefficient = 0.08",
            "friction_coefficient = { sp = 0.08, pr = 0.08, ps = 0.1 }",
            "load.friction_coefficient.ps: a planetary drive has no such contact; did you mean",
        ),
        ("friction_coefficient = 0.08", "friction_coefficient = { qq = 0.1 }", "sp, pr are missing"),
        ('planet = "52100"\n', "", "bodies: planet is missing"),
        ("[model]", '[rolling]\nskew = { sp = "1 mrad" }\n\n[model]', "rolling.skew: pr is missing"),
    ],
)
def test_other_names_are_told(planar_case, old, new, message):
    with pytest.raises(InputError) as caught:
        planar_case("planetary", (old, new))
    assert message in str(caught.value)
    assert planar_case("planetary").misnamed_parts() == []


TEXT = (Path(__file__).parents[2] / "examples" / "planar.toml").read_text(encoding="utf-8")


def read(*replaced):
    text = TEXT
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new)
    return parse_case(text, source="mine.toml")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            'second = "planet"',
            'second = "planets"',
            "contact sp: second: there is no roller 'planets'",
        ),
        ('grounded = "ring"', 'grounded = "sun"', "must be three different members"),
        (
            'output = "carrier"',
            'output = "planet"',
            "drive.output: 'planet' is neither a roller on the axis",
        ),
        ('wall_thickness = "20 mm"', "", "roller ring: it needs a wall_thickness"),
        ('orbit = "17.5 mm"', "", "roller planet: place = 'free' needs an orbit"),
        ('name = "pwl"', 'name = "pwr"', "contact: there is more than one 'pwr'"),
        (
            'name = "left"',
            'name = "carrier"',
            "roller: 'carrier' is the name of the member that carries the pins",
        ),
        (
            'place = "axis"\n\n',
            'place = "axis"\norbit = "1 mm"\n\n',
            "roller sun: place = 'axis' must not have an orbit",
        ),
        (
            'place = "free" ',
            'push_angle = "1 deg"\nplace = "free" ',
            "roller planet: push_angle is for rollers on a pin",
        ),
        (
            'name = "pwl"',
            'name = "pwl"\nsame_coefficient_as = "pwL"',
            "contact pwl: same_coefficient_as: there is no other contact 'pwL'; did you mean 'pwr'?",
        ),
        (
            'name = "wlo"',
            'name = "wlo"\nsame_coefficient_as = "wlo"',
            "contact wlo: same_coefficient_as: there is no other contact 'wlo'",
        ),
        (
            'place = "free" ',
            'pin_force = "constant"\nplace = "free" ',
            "roller planet: pin_force is for rollers on a pin",
        ),
        (
            'first_radius = "13.5 mm"\nsecond_radius = "5 mm"\n\n[[contact]]\nname = "pwl"',
            'first_radius = "13.5 mm"\nfirst_crown_radius = "2 m"\nsecond_radius = "5 mm"\n\n[[contact]]\nname = "pwl"',
            "contact pwr: first_crown_radius: contact sp says something else of the same track of planet",
        ),
        ('place = "pin"', 'place = "free"', "no roller is on a pin, so that nothing turns the carrier"),
    ],
)
def test_rollers_and_contacts_that_do_not_fit_together_are_told(old, new, message):
    with pytest.raises(InputError) as caught:
        read((old, new))
    assert message in str(caught.value)


def test_other_radii_need_no_other_program():
    """Only which tracks are one is part of the program; 5.0 mm is the track of 5 mm."""
    one, other, stepped = (
        jax.tree.structure(joint_from_case(read(*replaced)))
        for replaced in (
            (),
            (('first_radius = "4 mm"', 'first_radius = "3.9 mm"'),),
            (
                (
                    'second_radius = "40 mm"\ninternal = true                    #',
                    'second_radius = "39 mm"\ninternal = true #',
                ),
            ),
        )
    )
    assert one == other
    assert one != stepped


@pytest.mark.slow
def test_a_listed_drive_closes_its_gaps_and_has_the_ratio_of_its_formula():
    near = (('"76.1 deg"', '"74 deg"'), ('orbit = "17.5 mm"', 'orbit = "17 mm"'))
    drive = joint_from_case(read(*near)).drive
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-14)
    refuse_impossible(drive)
    assert float(speed_ratio(drive)) == pytest.approx(-(40.0 / 4.0 - 1.0), rel=1e-9)
    orbits = np.hypot(*np.asarray(drive.centres).T)
    np.testing.assert_allclose(orbits, [0.0, 17.5e-3, 35e-3, 35e-3, 0.0], atol=1e-12)


def test_radii_that_cannot_close_are_refused_with_the_gap():
    """Planet and roller reach 15.5 + 18.5 = 34 mm, the ring is 1 mm farther: three gaps in a row share it."""
    loose = joint_from_case(read(('first_radius = "4 mm"', 'first_radius = "2 mm"')))
    with pytest.raises(InputError, match=r"contact sp: sun and planet do not touch \(gap 0\.\d+ mm\)"):
        refuse_impossible(loose.drive)


def test_a_roller_without_an_angle_lies_above_the_axis_and_rings_have_the_interference():
    joint = joint_from_case(read(('angle = "90 deg"\n', "")))
    np.testing.assert_allclose(joint.drive.centres[1], [0.0, 17.5e-3], atol=1e-12)
    assert joint.pattern == (0.0, 0.0, 0.0, 1.0, 1.0)


def test_what_published_closures_assume():
    """Of the paper's drive: one coefficient for both contacts of a planet with its rollers, a spring at one pin."""
    case = read(
        ('name = "pwl"', 'name = "pwl"\nsame_coefficient_as = "pwr"'),
        ('name = "right"', 'name = "right"\npin_force = "constant"'),
    )
    closure = joint_from_case(case).drive.closure
    assert closure.equal_coefficients == (("pwr", "pwl"),)
    assert closure.constant_pins == ("right",)
    assert joint_from_case(read()).drive.closure == type(closure)()
    told = " ".join(assumptions(case))
    assert "contact pwl: same_coefficient_as = 'pwr'" in told
    assert "roller right: pin_force = 'constant'" in told


def test_a_roller_may_have_any_name():
    """Also one of those that a type of its own has: the paper's two loading rollers share a key of [bodies] there."""
    named = read(('"right"', '"right_loading_roller"'), ("right = ", "right_loading_roller = "))
    names = [body.name for body in joint_from_case(named).drive.bodies]
    assert names == ["sun", "planet", "right_loading_roller", "left", "ring"]
