"""A speed ratio in place of a radius, and the speed of the output in place of that of the input."""

import re
from pathlib import Path

import jsonschema
import pytest
from assumed import assumptions

from asperity.drive.layout.drive import speed_ratio
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.open_radius import radii_of
from asperity.joint_file.reader import model_of_type, parse_case
from asperity.joint_file.schema import joint_schema
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.reading import parse_toml
from asperity.units import format_quantity

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def text_of():
    """The text of an example, some of its lines replaced: key → new line."""

    def text(kind, **lines):
        changed = (EXAMPLES / f"{kind}.toml").read_text(encoding="utf-8")
        for key, line in lines.items():
            changed, count = re.subn(rf"(?m)^{key} = .*$", line, changed)
            assert count == 1, key
        return changed

    return text


#: By hand, radii of the examples [mm]: planetary i = 2 (1 + p/s), with the ring as output 1 + 2p/s; wedge R/s - 1;
#: multiroller (x_1/s)(x_2/y_1)(R/y_2), R = 39.5035 + y_2, so y_2 = 2.88 . 39.5035/(20 - 2.88); stepped planets
#: (1 + R_1/s)/(1 - R_1 p_2/(R_2 p_1)), here linear in s: s = 10 makes (60/s)/(1 - (s + 40) 18/((s + 38) 20)) = 96.
BY_HAND = [
    ("planetary", "planet_radius", {}, 11.0, 45.0),
    ("planetary", "sun_radius", {}, 11.0, 20.0 / 4.5),
    ("planetary", "planet_radius", {"output": 'output = "ring"'}, 11.0, 50.0),
    ("zou2025", "ring_radius", {}, 9.0, 40.0),
    ("zou2025", "sun_radius", {}, 9.5, 40.0 / 10.5),
    ("multiroller", "second_row_small_radius", {}, 20.0, 6.645446),
    ("stepped_planet", "sun_radius", {}, 96.0, 10.0),
]


@pytest.mark.parametrize(("kind", "radius", "lines", "ratio", "by_hand"), BY_HAND)
def test_the_open_radius_is_that_of_the_ratio_by_hand(text_of, kind, radius, lines, ratio, by_hand):
    case = parse_case(text_of(kind, **{radius: f"ratio = {ratio}"}, **lines), source="a.toml")
    assert 1e3 * si_values(case)["drive"][radius] == pytest.approx(by_hand, rel=1e-6)
    assert abs(float(speed_ratio(joint_from_case(case).drive))) == pytest.approx(ratio, rel=1e-10)
    found = format_quantity(by_hand * 1e-3, "mm", 6)
    told = (
        f"drive.ratio = {ratio:g}: {radius} = {found} follows from it, the radius that the file leaves open"
    )
    assert told in assumptions(case)


@pytest.mark.parametrize(
    ("kind", "lines", "message"),
    [
        ("planetary", {"planets": "ratio = 6"}, "all are stated: leave one out, or leave ratio out"),
        (
            "planetary",
            {"sun_radius": "", "planet_radius": "ratio = 6"},
            r"sun_radius, planet_radius are open: state all but one",
        ),
        (
            "planetary",
            {"sun_radius": "ratio = 1.5"},
            r"no sun_radius gives 1\.5; .* the ratio is between 2\.0",
        ),
        ("planetary", {"sun_radius": 'ratio = "6 +- 1"'}, "what is required has no tolerance"),
        ("planetary", {"sun_radius": "ratio = 0"}, "0 is not allowed; it must be above 0"),
        (
            "zou2025",
            {"planet_radius": "ratio = 9"},
            "planet_radius does not move the ratio, which is 9: state it",
        ),
        (
            "zou2025",
            {"ring_radius": "ratio = 11"},
            "11 needs ring_radius = 48 mm, and such a drive cannot exist",
        ),
        ("stepped_planet", {"planet_second_radius": "ratio = 96"}, r"may be 18 mm or 22\.1739 mm; state it"),
        ("planar", {"sectors": "sectors = 3\nratio = 9"}, "drive.ratio: only for drives of type"),
    ],
)
def test_what_gives_no_single_radius_is_refused_with_the_reason(text_of, kind, lines, message):
    with pytest.raises(InputError, match=message):
        parse_case(text_of(kind, **lines), source="a.toml")


def test_an_unreadable_size_is_the_only_error(text_of):
    with pytest.raises(InputError) as refused:
        parse_case(
            text_of("planetary", sun_radius='sun_radius = "x"', planet_radius="ratio = 11"), source="a.toml"
        )
    assert str(refused.value).startswith("a.toml: drive.sun_radius: expected a length")


def test_a_file_that_is_written_back_keeps_the_ratio_until_a_size_changes(text_of):
    case = parse_case(text_of("planetary", planet_radius="ratio = 11"), source="a.toml")
    same = parse_case(joint_file_text(case, {"load.output_torque": 5.0}, comment=""), source="b.toml")
    assert same.open_radius == case.open_radius
    other = parse_case(joint_file_text(case, {"drive.sun_radius": 0.011}, comment=""), source="b.toml")
    assert other.open_radius is None
    assert si_values(other)["drive"]["planet_radius"] == pytest.approx(0.045, rel=1e-12)
    taken = parse_case(joint_file_text(case, {"drive.planet_radius": 0.02}, comment=""), source="b.toml")
    assert taken.open_radius is None
    assert float(speed_ratio(joint_from_case(taken).drive)) == pytest.approx(6.0, rel=1e-12)


@pytest.mark.parametrize("kind", ["zou2025", "planetary", "multiroller", "stepped_planet"])
def test_the_schema_asks_for_all_radii_or_for_the_ratio_and_all_but_one(text_of, kind):
    name = parse_case(text_of(kind), source="a.toml").type
    radii = radii_of(model_of_type(name))
    valid = jsonschema.Draft202012Validator(joint_schema(name)).is_valid
    assert valid(parse_toml(text_of(kind), source=""))
    assert not valid(parse_toml(text_of(kind, **{radii[0]: ""}), source=""))
    assert valid(parse_toml(text_of(kind, **{radii[0]: "ratio = 9"}), source=""))
    assert not valid(parse_toml(text_of(kind, **{radii[0]: "ratio = 9", radii[1]: ""}), source=""))
    assert not valid(parse_toml(text_of(kind, **{radii[0]: f'{radii[0]} = "9 mm"\nratio = 9'}), source=""))


def test_the_speed_of_the_output_makes_that_of_the_input(text_of):
    """The paper's drive has the ratio -(40 - 4)/4 = -9: 100 rpm at the output are 900 rpm at the sun."""
    case = parse_case(text_of("zou2025", sun_speed='output_speed = "100 rpm"'), source="a.toml")
    rpm = 2.0 * 3.141592653589793 / 60.0
    assert float(joint_from_case(case).input_speed) == pytest.approx(900.0 * rpm, rel=1e-12)
    assert "load.output_speed: the input turns at 900 rpm, by the ratio without slip" in assumptions(case)
    values = replace_values(si_values(case), {"load.sun_speed": 1.0})
    assert "output_speed" not in values["load"]
    assert values["load"]["sun_speed"] == 1.0


@pytest.mark.parametrize(
    ("kind", "lines", "message"),
    [
        (
            "planetary",
            {"sun_speed": 'sun_speed = "600 rpm"\noutput_speed = "100 rpm"'},
            "load: exactly one of 'sun_speed' and 'output_speed' is needed, got both",
        ),
        (
            "planetary",
            {"sun_speed": ""},
            "load: exactly one of 'sun_speed' and 'output_speed' is needed, got neither",
        ),
        (
            "planetary",
            {"sun_speed": 'output_speed = "2e5 rpm"'},
            r"load\.output_speed: '2e5 rpm' is not allowed: the input turns at 1\.2e6 rpm, and its speed must be",
        ),
        (
            "stepped_planet",
            {"planet_second_radius": 'planet_second_radius = "20 mm"', "sun_speed": 'output_speed = "1 rpm"'},
            r"load\.output_speed: '1 rpm'",
        ),
        (
            "multiroller",
            {"first_row_radius": 'first_row_radius = "90 mm"', "sun_speed": 'output_speed = "1 rpm"'},
            "a.toml: there is no place for second_row where it touches all the rollers",
        ),
    ],
)
def test_a_speed_of_the_output_that_makes_none_of_the_input_is_refused(text_of, kind, lines, message):
    with pytest.raises(InputError, match=message):
        parse_case(text_of(kind, **lines), source="a.toml")
