"""Bodies and contacts of each type of drive, and tables that name others."""

import pytest

from asperity.errors import InputError
from asperity.joint_file.part_names import CONTACTS, bodies_of_type
from asperity.joint_file.parts import layout_of
from asperity.joint_file.si_tables import si_values


def test_bodies_in_the_order_of_the_drive(planar_case):
    assert bodies_of_type("planetary") == ("sun", "planet", "ring")
    assert bodies_of_type("multiroller") == ("sun", "first_row", "second_row", "ring")
    for kind, contacts in CONTACTS.items():
        drive, shapes, pattern = layout_of(si_values(planar_case(kind)))
        assert tuple(body.name for body in drive.bodies) == bodies_of_type(kind)
        joined = {contact.name: (contact.first, contact.second) for contact in drive.contacts}
        assert joined == contacts
        # the interference is at the contacts inside a ring
        assert pattern == tuple(float(contact.internal) for contact in drive.contacts)
        rings = [shape.kind == "ring" for shape in shapes]
        assert rings == ["ring" in name for name in bodies_of_type(kind)]


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
