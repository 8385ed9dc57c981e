"""Joint files as they should be, as they should not be, and as nobody would write them."""

import math
import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from asperity.errors import InputError
from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.reader import case_from_tables, parse_case, read_case
from asperity.reading import LARGEST_FILE


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
        ('sun_radius = "4 mm"', "", "drive.sun_radius: this key is missing: a length, e.g. '13.5 mm'"),
        ("[drive]", "[drvie]", "drvie: unknown section; did you mean 'drive'?"),
        ("fractal_dimension = 1.4", "", "this key is missing: a dimensionless number, e.g. '1.4'"),
        ("planets = 3", "", "drive.planets: this key is missing: a dimensionless number, e.g. '3'"),
        (
            'closure = "elastic"',
            "",
            "model.closure: this key is missing: one of 'elastic', 'constant_pin_force'",
        ),
        ('sun = "steel"', "", "bodies: sun is missing"),
        ('sun = "steel"', "sun = 3", "bodies.sun: expected the name of a material, e.g. 'steel', got 3"),
        ('"1e-8 mm"', '"5 N"', "surface.fractal_roughness: expected a length (e.g. '1e-8 mm'), got a force"),
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
            "materials.my steel: the name of a material consists of letters",
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
            "drive.contact_length: pwr, pwl, wro, wlo are missing",
        ),
        (
            'contact_length = "5 mm"',
            'contact_length = { sp = "5 mm", pwr = "5 mm", pwl = "5 mm", wro = "5 mm", wol = "5 mm" }',
            "joint.toml: drive.contact_length.wol: a wedge drive has no such contact; did you mean 'wlo'?",
        ),
        ("[surface]", "[surface.sp]", "surface: pwr, pwl, wro, wlo are missing"),
        (
            "[surface]",
            "[surface.sp]\nfractal_dimension = 1.5\n[surface]",
            "joint.toml: surface: fractal_dimension, fractal_roughness, frequency_ratio in [surface] are of all "
            "contacts, and [surface.sp] is of one each: a surface is stated twice; write one [surface] for all "
            "contacts, or a section for each",
        ),
        ("[load]", "[[load]]", "load: expected a table with preload, interference, cam_force_per_torque"),
        ("[drive]", "[drive", "not valid TOML"),
        ("[drive]", "x = " + "9" * 5000 + "\n[drive]", "not valid TOML: a number has too many digits"),
        ("[drive]", "x = " + "[" * 5000 + "\n[drive]", "nested too deeply; at most 32 levels are read"),
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
    assert refusal("") == (
        "joint.toml: the sections [load], [model], [materials], [bodies], [surface], [drive] are missing; "
        "'asperity init' writes a complete example"
    )
    assert refusal("# a comment").count("\n") == 0


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("sun_radius =", "sun_radus =", "drive.sun_radus: unknown key; did you mean 'sun_radius'?"),
        ("[drive]", "[drvie]", "drvie: unknown section; did you mean 'drive'?"),
        (
            "[materials.steel]",
            "[materials.stele]",
            "bodies.sun, bodies.planet, bodies.loading_roller, bodies.ring: there is no material 'steel'; did you mean "
            "'stele'?",
        ),
        (
            "[materials.steel]",
            "[materials.xyz]",
            "bodies.sun, bodies.planet, bodies.loading_roller, bodies.ring: there is no material 'steel'; the file "
            "defines xyz; 'asperity materials' lists the library",
        ),
        (
            'preload = "1000 N"',
            "",
            "load: exactly one of 'preload' and 'interference' is needed, got neither",
        ),
        ("[bodies]\n", "", None),
        (
            "[materials.steel]",
            '[materials.steel]\nlibrary = "steeel"',
            "materials.steel.library: there is no material 'steeel'; known are ",
        ),
    ],
)
def test_one_mistake_is_one_message(example_text, old, new, message):
    assert old in example_text
    if message is None:  # the keys of a section without its head belong to the section above
        text = re.sub(r"(?ms)^\[bodies\].*?(?=^\[)", "", example_text)
        assert refusal(text) == (
            "joint.toml: the section [bodies] is missing; it contains sun, planet, loading_roller, ring"
        )
        return
    found = refusal(example_text.replace(old, new, 1))
    assert "\n" not in found
    assert found.startswith(f"joint.toml: {message}")


def test_a_key_in_the_wrong_section_is_sent_to_its_own(example_text):
    torque = 'output_torque = "5 N*m"'
    text = example_text.replace(torque, "").replace("[drive]", f"[drive]\n{torque}")
    assert refusal(text) == "joint.toml: drive.output_torque: unknown key; it belongs in [load]"
    text = example_text.replace("[drive]", '[drive]\npin_diameter = "4 mm"')
    assert refusal(text) == "joint.toml: drive.pin_diameter: unknown key; it belongs in [bearings]"


def test_mistakes_of_every_kind_are_listed_together(example_text):
    text = (
        example_text.replace('"4 mm"', "4")
        .replace('ring = "steel"', 'ring = "stel"')
        .replace(
            "[bodies]",
            '[materials.own]\nlibrary = "x9"\n[materials.far]\nlibrary = "a"\nfile = "b"\n[bodies]',
        )
    )
    message = refusal(text)
    assert "4 errors" in message
    for part in (
        "drive.sun_radius: expected a length",
        "materials.own.library: there is no material 'x9'",
        "materials.far.file: b: there is no such file",
        "bodies.ring: there is no material 'stel'; did you mean 'steel'?",
    ):
        assert f"\n  {part}" in message


def test_values_cannot_control_the_terminal_or_fill_it(example_text):
    text = example_text.replace('"4 mm"', '"\\u001b[2J\\u202e\\n' + "x" * 100 + '"')
    message = refusal(text.replace("planets =", '"\\u001b[31m" ='))
    assert message.replace("\n  ", "").isprintable()
    assert r"\x1b[2J\u202e\n" in message
    assert r"drive.\x1b[31m: unknown key" in message
    for value in ("[" * 30 + "]" * 30, "{" + ", ".join(f"a{i} = 1" for i in range(500)) + "}"):
        assert len(refusal(example_text.replace('"4 mm"', value))) < 250


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("absent.toml", None, "there is no such file; 'asperity init' writes an example"),
        ("latin.toml", "µ".encode("latin-1"), "not a text file in UTF-8"),
        (
            "large.toml",
            b"#" * (LARGEST_FILE + 1),
            "this file has 1000001 bytes; at most 1000000 bytes are read",
        ),
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
        return isinstance(read(), DefaultCase)
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


def test_surfaces_of_single_contacts_that_are_missing_are_named(joint_text):
    with pytest.raises(InputError) as caught:
        parse_case(joint_text.replace("[surface]", "[surface.sp]"), source="joint.toml")
    assert str(caught.value) == (
        "joint.toml: surface: pwr, pwl, wro, wlo are missing; "
        "write one [surface] for all contacts, or a section for each"
    )
