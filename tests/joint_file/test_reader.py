"""Joint files as they should be, as they should not be, and as nobody would write them."""

import math
import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from asperity.errors import InputError
from asperity.joint_file.model import Case
from asperity.joint_file.reader import LARGEST_FILE, case_from_tables, parse_case, read_case


def refusal(text: str) -> str:
    with pytest.raises(InputError) as refused:
        parse_case(text, source="joint.toml")
    return str(refused.value)


def test_the_example_is_read(example_case):
    assert example_case.drive.planets.value == 3.0
    assert example_case.drive.planet_radius.value == 0.0135
    assert example_case.load.sun_speed.value == pytest.approx(200.0 * math.pi, rel=1e-15)  # 6000 rpm
    assert example_case.materials["steel"].yield_strength.value == 450e6
    assert example_case.surface.fractal_roughness.value == 1e-11
    assert example_case.bearings is None
    assert example_case.compliance is None


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '"4 mm"',
            "4",
            "drive.sun_radius: expected a length with its unit as text (e.g. '13.5 mm'), got the bare number 4",
        ),
        (
            '"4 mm"',
            '"4 MPa"',
            "drive.sun_radius: expected a length (e.g. '13.5 mm'), got a pressure 'MPa' in '4 MPa'",
        ),
        (
            '"1000 N"',
            '"-1000 N"',
            "load.preload: -1000 N is not allowed; it must be at least 0.001 N and at most 1e9 N",
        ),
        ('"1000 N"', '"0 N"', "load.preload: 0 N is not allowed"),
        ('"1000 N"', '"nan N"', "load.preload: expected a force"),
        ('"5 N*m"', '"inf N*m"', "load.output_torque: expected a torque"),
        ('"5 N*m"', '"1e12 N*m"', "load.output_torque: 1e12 N·m is not allowed"),
        (
            "friction_coefficient = 0.12",
            "friction_coefficient = nan",
            "load.friction_coefficient: expected a dimensionless number (e.g. '0.12'), got a number that",
        ),
        (
            "friction_coefficient = 0.12",
            "friction_coefficient = 0",
            "load.friction_coefficient: 0 is not allowed; it must be above 0 and at most 10",
        ),
        ("= 1.4", "= 2.0", "surface.fractal_dimension: 2 is not allowed; it must be above 1 and below 2"),
        ("= 1.4", "= 1.0", "surface.fractal_dimension: 1 is not allowed"),
        (
            "= 0.3 ",
            "= 0.6 ",
            "materials.steel.poisson_ratio: 0.6 is not allowed; it must be above -1 and at most 0.5",
        ),
        ("planets = 3", "planets = 2.5", "drive.planets: 2.5 is not allowed; it must be a whole number"),
        ("sun_radius =", "sun_radus =", "drive.sun_radus: unknown key; did you mean 'sun_radius'?"),
        ("sun_radius =", "sun_radus =", "drive.sun_radius: this key is missing: a length, e.g. '13.5 mm'"),
        ("[drive]", "[drvie]", "drvie: unknown key; did you mean 'drive'?"),
        ("frequency_ratio", "gamma_of_all", "surface.gamma_of_all: unknown key"),
        (
            '"elastic"',
            '"elastik"',
            "model.closure: 'elastik' is not one of 'elastic' or 'constant_pin_force'",
        ),
        (
            'ring = "steel"',
            'ring = "stel"',
            "bodies.ring: there is no material 'stel'; did you mean 'steel'?",
        ),
        (
            "[materials.steel]",
            '[materials."my steel"]',
            "materials.my steel: a material's name is made of letters",
        ),
        (
            "hardness_factor = 2.8",
            "",
            "materials.steel: exactly one of 'hardness' and 'hardness_factor' is needed, got neither",
        ),
        (
            "hardness_factor = 2.8",
            'hardness_factor = 2.8\nhardness = "1 GPa"',
            "materials.steel: exactly one of 'hardness' and 'hardness_factor' is needed, got both",
        ),
        (
            'contact_length = "5 mm"',
            'contact_length = { sp = "5 mm" }',
            "drive.contact_length.pwr: this key is missing",
        ),
        (
            'contact_length = "5 mm"',
            'contact_length = { sp = "5 mm", pwr = "5 mm", pwl = "5 mm", wro = "5 mm", wol = "5 mm" }',
            "drive.contact_length.wol: unknown key; did you mean 'wlo'?",
        ),
        ("[surface]", "[surface.sp]", "surface.pwr: this key is missing"),
        ("[load]", "[[load]]", "load: expected a table with preload, output_torque"),
        ("[drive]", "[drive", "not valid TOML"),
        ("[drive]", "x = " + "9" * 5000 + "\n[drive]", "not a joint file"),
        ("[drive]", "x = " + "[" * 5000 + "\n[drive]", "not a joint file: nested too deeply"),
        ('"6000 rpm"', "2025-06-17", "load.sun_speed: expected an angular velocity as text"),
    ],
)
def test_every_slip_is_told_with_its_key_and_what_is_allowed(example_text, old, new, said):
    assert old in example_text
    message = refusal(example_text.replace(old, new, 1))
    assert message.startswith("joint.toml: ")
    assert said in message


def test_all_errors_of_a_file_are_told_at_once(example_text):
    message = refusal(example_text.replace('"4 mm"', "4").replace('"1000 N"', '"-1 N"'))
    assert "2 errors" in message
    assert "drive.sun_radius" in message
    assert "load.preload" in message


def test_an_empty_file_names_every_missing_section():
    message = refusal("")
    for section in ("drive", "load", "model", "materials", "bodies", "surface"):
        assert f"{section}: this key is missing" in message


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("absent.toml", None, "there is no such file; 'asperity init' writes an example"),
        ("latin.toml", "µ".encode("latin-1"), "not a text file in UTF-8"),
        ("large.toml", b"#" * (LARGEST_FILE + 1), "at most 1000000 bytes"),
        ("zero.toml", b"\0", "not valid TOML"),
    ],
)
def test_files_that_are_no_joint_files(tmp_path, name, content, said):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=re.escape(said)):
        read_case(tmp_path / name)
    with pytest.raises(InputError, match="directory"):
        read_case(tmp_path)


def test_line_endings_and_a_byte_order_mark_do_not_matter(tmp_path, example_text, example_case):
    (tmp_path / "joint.toml").write_bytes(b"\xef\xbb\xbf" + example_text.replace("\n", "\r\n").encode())
    assert read_case(tmp_path / "joint.toml") == example_case


def read_or_refused(read) -> bool:
    try:
        return isinstance(read(), Case)
    except InputError as error:
        return str(error).startswith("fuzz: ")


VALUES = st.one_of(
    st.floats(),
    st.integers(),
    st.booleans(),
    st.text(max_size=20),
    st.lists(st.floats(), max_size=2),
    st.dictionaries(st.text(max_size=5), st.floats(), max_size=2),
    st.builds(
        lambda number, unit: f"{number} {unit}",
        st.floats(),
        st.sampled_from(["mm", "N", "MPa", "rpm", "N*m", "deg", "kg/m^3", "mm +- 1 mm", "", "mm^99", "/"]),
    ),
)


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_any_value_anywhere_is_read_or_refused(example_text, data):
    """No table that TOML can say makes the reader fail in any way but its own."""
    import tomllib

    tables = tomllib.loads(example_text)
    for _ in range(data.draw(st.integers(1, 3))):
        table = tables
        while True:
            name = data.draw(st.sampled_from(sorted(table)))
            if not isinstance(table[name], dict) or not table[name] or data.draw(st.integers(0, 9)) == 0:
                break
            table = table[name]
        match data.draw(st.sampled_from(["replace", "remove", "rename", "add"])):
            case "replace":
                table[name] = data.draw(VALUES)
            case "remove":
                del table[name]
            case "rename":
                table[data.draw(st.text(max_size=12))] = table.pop(name)
            case "add":
                table[data.draw(st.text(max_size=12))] = data.draw(VALUES)
        if not tables or not table:
            break
    assert read_or_refused(lambda: case_from_tables(tables, source="fuzz"))


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(position=st.floats(0, 1), length=st.integers(0, 40), inserted=st.text(max_size=8))
def test_any_text_is_read_or_refused(example_text, position, length, inserted):
    start = int(position * len(example_text))
    text = example_text[:start] + inserted + example_text[start + length :]
    assert read_or_refused(lambda: parse_case(text, source="fuzz"))
