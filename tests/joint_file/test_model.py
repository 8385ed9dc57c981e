"""Joint files of other drives: read, refused, described, and told to editors."""

import json
from importlib.resources import files
from pathlib import Path

import jsonschema
import pytest

from asperity.errors import InputError
from asperity.joint.description import body_masses
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.schema import joint_schema
from asperity.precision import note_once
from asperity.reading import parse_toml

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar", "wheel_pair")


def text_of(name):
    return (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")


def read(name, *replaced):
    text = text_of(name)
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new)
    return parse_case(text, source="mine.toml")


@pytest.mark.parametrize("name", NAMES)
def test_examples_are_those_of_init_and_valid_for_editors(name):
    assert files("asperity.joint_file").joinpath(f"{name}.toml").read_text("utf-8") == text_of(name)
    case = read(name)
    assert case.text == text_of(name)
    assert case == read(name)
    schema = joint_schema(case.type)
    jsonschema.validate(parse_toml(text_of(name), source=name), schema)
    json.dumps(schema)


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        (
            "planetary",
            'type = "planetary"',
            'type = "planetry"',
            "is not a type of drive; did you mean 'planetary'?",
        ),
        ("planetary", 'ring = "52100"', 'rim = "52100"', "bodies.rim: a planetary drive has no such body"),
        (
            "planetary",
            'contact_length = "10 mm"',
            'contact_length = { sp = "10 mm" }',
            "drive.contact_length: pr is missing",
        ),
        ("planetary", 'planet_radius = "20 mm"', "", "drive.planet_radius: this key is missing: a length"),
        ("planetary", 'planet_radius = "20 mm"', 'planet_radius = "20 N"', "drive.planet_radius"),
        (
            "planetary",
            "fractal_dimension = 1.5",
            "",
            "surface.fractal_dimension: this key is missing: a dimensionless",
        ),
        (
            "planar",
            "fractal_dimension = 1.5",
            "",
            "surface.fractal_dimension: this key is missing: a dimensionless",
        ),
        ("planetary", "[surface]\n", "[surface.sp]\n", "surface: pr is missing"),
        (
            "planetary",
            'interference = "30 um"',
            'interference = "30 um"\npreload = "1 N"',
            "exactly one of 'preload' and 'interference'",
        ),
        ("planetary", 'sun = "52100"', 'sun = "adamant"', "bodies.sun: there is no material 'adamant'"),
        ("planetary", 'bodies = "exact"', 'bodies = "springs"', "drive.ring_support: only for model.bodies"),
        ("multiroller", "first_row_radius", "first_row_radios", "did you mean 'first_row_radius'?"),
        (
            "planar",
            "sector" + "s = 3",
            "sectors = 3\nsectorial = 1",
            "drive.sectorial: unknown key; did you mean 'sectors'?",
        ),
        ("stepped_planet", 'bodies = "exact"', 'bodies = "springs"', "driven_ring_wall_thickness"),
        (
            "planetary",
            "[model]",
            "[bearings]\npin_friction_coefficient = 0.01\n\n[model]",
            "bearings: pin_friction_coefficient acts at a diameter, which is missing: give pin_friction_diameter, or "
            "the pin_diameter",
        ),
        (
            "planetary",
            "[model]",
            '[bearings]\npin_radial_clearance = "5 um"\n\n[model]',
            "bearings: pin_radial_clearance = '5 um': only pins of a pin_diameter above 0 press in bores",
        ),
        (
            "planetary",
            "[model]",
            '[sun_bearing]\ntype = "ball"\n\n[model]',
            'sun_bearing: only for the paper\'s drive (type = "wedge", or no type); for this drive write '
            "'input_bearing'",
        ),
        (
            "planetary",
            "[model]",
            '[pin_bearing]\ntype = "ball"\ndynamic_rating = "1 kN"\nstatic_rating = "1 kN"\n\n[model]',
            "pin_bearing.count: this key is missing",
        ),
        (
            "planetary",
            "[model]",
            '[[duty]]\noutput_torque = "1 N*m"\nsun_speed = "1 rpm"\nshare = 0.9\n\n[model]',
            "the shares of [[duty]] must add up to 1, they add up to 0.9",
        ),
    ],
)
def test_mistakes_are_told(name, old, new, message):
    with pytest.raises(InputError) as caught:
        read(name, (old, new))
    assert message in str(caught.value)


def test_bearings_of_pins_need_pins():
    """A grounded carrier, so that rollers held by their contacts alone make a drive."""
    text = text_of("planar").replace('place = "pin"', 'place = "free"')
    text = text.replace('output = "carrier"', 'output = "ring"').replace(
        'grounded = "ring"', 'grounded = "carrier"'
    )
    rated = (
        '[pin_bearing]\ntype = "ball"\ndynamic_rating = "1 kN"\nstatic_rating = "1 kN"\ncount = 1\n\n[model]'
    )
    with pytest.raises(InputError, match="pin_bearing: no roller of this drive is on a pin"):
        parse_case(text.replace("[model]", rated), source="mine.toml")


@pytest.mark.parametrize(
    ("name", "section", "key"),
    [
        ("planetary", "compliance", 'planet_support_stiffness = "100 N/um"'),
        ("stepped_planet", "compliance", 'planet_support_stiffness = "100 N/um"'),
        ("planetary", "bearings", 'pin_support = "one_end"'),
    ],
)
def test_what_would_say_nothing_of_the_drive_is_refused(name, section, key):
    """All planets of these drives are on pins."""
    with pytest.raises(InputError, match=rf"{section}\.{key.split()[0]}.*(leave it|leave pin_support) out"):
        read(name, ("[model]", f"[{section}]\n{key}\n\n[model]"))


@pytest.mark.parametrize(
    "name", ["zou2025", "planetary", "multiroller", "stepped_planet", "planar", "wheel_pair"]
)
def test_places_of_the_rollers_are_those_of_the_drive(name):
    case = read(name)
    off_axis = {
        body.place for body in joint_from_case(case).drive.bodies if body.place not in ("axis", "held")
    }
    assert set(case.roller_places()) == off_axis


def test_a_bore_through_three_tracks_is_refused_with_the_reason():
    """The order of the tracks along the axis is not in the file."""
    track = 'first_radius = "13.5 mm"\nsecond_radius = "5 mm"\n\n[[contact]]\nname = "wro"'
    other = 'first_radius = "13.5 mm"\nsecond_radius = "5 mm"\n\n[[contact]]\nname = "pwl"'
    bore = ('orbit = "17.5 mm"', 'orbit = "17.5 mm"\nbore_diameter = "6 mm"')
    stepped = (track, track.replace("13.5", "12"))
    assert read("planar", bore, stepped).roller[1].bore_diameter is not None
    with pytest.raises(
        InputError,
        match=r"roller planet: bore_diameter = '6 mm' in a roller with tracks of 13\.5 mm, 11 mm, 12 mm: .*"
        "more than two tracks.*leave it out",
    ):
        read("planar", bore, stepped, (other, other.replace("13.5", "11")))


def test_bores_and_supports_of_what_has_none_are_refused():
    wall = 'wall_thickness = "20 mm"'
    with pytest.raises(
        InputError, match="roller ring: bore_diameter: a ring is described by its wall_thickness"
    ):
        read("planar", (wall, f'{wall}\nbore_diameter = "6 mm"'))
    with pytest.raises(InputError, match="roller planet: ring_support is for rings"):
        read("planar", ('orbit = "17.5 mm"', 'orbit = "17.5 mm"\nring_support = "free"'))


def test_the_length_of_a_listed_ring_makes_its_mass():
    wall = 'wall_thickness = "20 mm"'
    masses = [
        float(body_masses(joint_from_case(read("planar", (wall, new))))[-1])
        for new in (wall, f'{wall}\nlength = "15 mm"')
    ]
    assert masses[1] == pytest.approx(3.0 * masses[0], rel=1e-12)  # of 15 instead of 5 mm


def test_a_file_without_a_type_has_the_papers_drive():
    plain = (EXAMPLES / "zou2025.toml").read_text(encoding="utf-8")
    assert parse_case(plain, source="mine.toml").type == "wedge"
    assert parse_case('type = "wedge"\n' + plain, source="mine.toml").type == "wedge"


def test_the_name_that_a_type_had_is_read_and_said_once(caplog):
    note_once.cache_clear()
    text = 'type = "zou2025"\n' + (EXAMPLES / "zou2025.toml").read_text(encoding="utf-8")
    cases = [parse_case(text, source="mine.toml") for _ in range(2)]
    assert [case.type for case in cases] == ["wedge", "wedge"]
    (said,) = caplog.messages
    assert said == 'asperity: note: type = "zou2025" is called "wedge" now'
    with pytest.raises(InputError, match="'zou' is not a type of drive; known are wedge, planetary"):
        parse_case(text.replace('"zou2025"', '"zou"', 1), source="mine.toml")


def test_springs_of_the_structure_reach_the_joint():
    keys = (
        '[compliance]\npin_transverse_stiffness = "20 N/um"\nplanet_support_stiffness = "30 N/um"\n'
        'ring_housing_stiffness = "400 MPa/mm"\n\n[model]'
    )
    changes = (
        ("[model]", keys),
        ('ring_support = "rigid_housing"', 'ring_support = "elastic_housing"'),
    )
    joint = joint_from_case(read("planar", *changes))
    assert float(joint.pin_transverse_stiffness) == pytest.approx(2e7)
    assert float(joint.planet_support_stiffness) == pytest.approx(3e7)
    assert joint.ring_bending_stiffness is None
    assert joint.shapes[-1].rim_stiffness == (pytest.approx(4e11), 0.0)
    of_type = ('ring_support = "free"', 'ring_support = "elastic_housing"')
    of_planets = changes[0][0], keys.replace('planet_support_stiffness = "30 N/um"\n', "")
    planetary = joint_from_case(read("planetary", of_planets, of_type))
    assert planetary.shapes[-1].rim_stiffness == (pytest.approx(4e11), 0.0)


@pytest.mark.parametrize(
    ("support", "springs", "told"),
    [
        ("elastic_housing", 'pin_stiffness = "1 N/um"', "belong together"),
        ("rigid_housing", 'ring_housing_stiffness = "400 MPa/mm"', "belong together"),
        ("free", 'ring_bending_stiffness = "1 N/um"', "count it twice"),
    ],
)
@pytest.mark.parametrize("name", ["planetary", "planar"])
def test_a_ring_bends_in_one_way(name, support, springs, told):
    own = 'ring_support = "free"' if name == "planetary" else 'ring_support = "rigid_housing"'
    with pytest.raises(InputError, match=told):
        read(name, (own, f'ring_support = "{support}"'), ("[model]", f"[compliance]\n{springs}\n\n[model]"))


def test_lengths_and_pins_reach_the_joint():
    keys = '[bearings]\npin_length = "16 mm"\npin_support = "one_end"\npin_diameter = "6 mm"\n\n[model]'
    length = ('contact_length = "10 mm"', 'contact_length = "10 mm"\nplanet_length = "14 mm"')
    joint = joint_from_case(read("planetary", ("[model]", keys), length))
    assert (joint.pin.free_length, joint.pin.support, joint.pin.diameter) == (0.016, "one_end", 0.006)
    assert joint.shapes[1].length == pytest.approx(14e-3)
    listed = joint_from_case(read("planar", ('place = "free"', 'place = "free"\nlength = "7 mm"')))
    assert [shape.length for shape in listed.shapes] == [None, pytest.approx(7e-3), None, None, None]
    assert listed.pin is None
