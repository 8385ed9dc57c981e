"""Requests become checked joint files."""

import json
import tomllib

import pytest

from asperity.errors import InputError
from asperity.joint_file.choices import CHOICES, choices_of_case
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import si_values
from asperity.page.jobs import job_request
from asperity.page.joint_request import LONGEST_NAME, JointRequest, joint_request, shown_name


def test_changes_are_those_of_the_file(joint_text):
    case = JointRequest(
        "a.toml", joint_text, {"load.preload": "1.2 kN +- 50 N", "bodies.ring": "52100"}
    ).case()
    assert case.load.preload.value == 1200.0
    assert case.load.preload.tolerance == 50.0
    assert case.bodies["ring"] == "52100"


def test_sections_that_the_file_leaves_out(joint_text):
    case = JointRequest(
        "a.toml", joint_text, {"play.angle": "1.5 arcmin", "rolling.skew.sp": "1 mrad"}
    ).case()
    assert case.play.take_up_torque.value == 0.0
    assert case.rolling.skew["sp"].value == 1e-3
    assert case.rolling.skew["wlo"].value == 0.0


def test_an_interference_takes_the_place_of_the_preload(joint_text):
    request = JointRequest("a.toml", joint_text, {"load.interference": "10 um"})
    assert request.case().load.preload is None
    assert request.case().load.interference.value == pytest.approx(10e-6)
    assert JointRequest("a.toml", request.file_text()).case() == request.case()


def test_the_text_says_what_the_case_says(joint_text):
    request = JointRequest(
        "a.toml",
        joint_text,
        {
            "surface.sp.fractal_dimension": 1.5,
            "materials.steel.hardness": "2 GPa",
            "model.contact_factor": "unity",
        },
    )
    assert JointRequest("a.toml", request.file_text()).case() == request.case()
    assert "# ours" in request.file_text()


def test_the_same_content_has_the_same_identity_and_the_last_of_changes_that_exclude_each_other_holds(
    joint_text,
):
    one, two = ({"a": 1, "b": 2}, {"b": 2, "a": 1})
    assert JointRequest("a", "x", one).identity == JointRequest("a", "x", dict(one)).identity
    assert JointRequest("a", "x", one).identity != JointRequest("a", "x", two).identity
    force, length = {"load.preload": "900 N"}, {"load.interference": "10 um"}
    assert JointRequest("a", joint_text, force | length).case().load.preload is None
    assert JointRequest("a", joint_text, length | force).case().load.interference is None
    assert JointRequest("a", "x", one).identity != JointRequest("b", "x", one).identity


def test_the_choices_are_those_of_the_file():
    assert CHOICES["model.closure"] == ("elastic", "constant_pin_force")
    assert CHOICES["model.bodies"] == ("exact", "springs")  # optional
    assert CHOICES["drive.ring_support"] == ("rigid_housing", "free", "elastic_housing")
    assert CHOICES["pin_bearing.type"] == ("ball", "roller")
    assert {path for path, words in CHOICES.items() if not words} == {
        "bodies.sun",
        "bodies.planet",
        "bodies.loading_roller",
        "bodies.ring",
        "bodies.housing",
    }


def test_a_ring_in_an_elastic_housing_needs_its_stiffness(joint_text):
    support = {"drive.ring_support": "elastic_housing"}
    with pytest.raises(InputError, match="belong together"):
        JointRequest("a.toml", joint_text, support).case()
    both = JointRequest("a.toml", joint_text, {**support, "compliance.ring_housing_stiffness": "20 GPa/m"})
    assert both.case().drive.ring_support == "elastic_housing"
    assert JointRequest("a.toml", both.file_text()).case() == both.case()
    # and both leave again
    neither = {"drive.ring_support": "", "compliance.ring_housing_stiffness": ""}
    again = JointRequest("a.toml", both.file_text(), neither).case()
    assert again.drive.ring_support is None
    assert again.compliance is None  # it held nothing else


def test_an_optional_key_can_be_left_out_and_a_needed_one_not(joint_text):
    bore = {"drive.planet_bore_diameter": "8 mm"}
    text = JointRequest("a.toml", joint_text, bore).file_text()
    assert (
        JointRequest("a.toml", text, {"drive.planet_bore_diameter": ""}).case().drive.planet_bore_diameter
        is None
    )
    with pytest.raises(InputError, match="sun_radius"):
        JointRequest("a.toml", joint_text, {"drive.sun_radius": ""}).case()


def test_a_section_that_is_begun_says_what_it_needs(joint_text):
    begun = {
        "pin_bearing.type": "roller",
        "pin_bearing.dynamic_rating": "5 kN",
        "pin_bearing.static_rating": "6 kN",
    }
    with pytest.raises(InputError, match=r"pin_bearing\.count: .*missing"):
        JointRequest("a.toml", joint_text, begun).case()
    whole = JointRequest("a.toml", joint_text, {**begun, "pin_bearing.count": 2})
    assert whole.case().pin_bearing.type == "roller"
    assert JointRequest("a.toml", whole.file_text()).case() == whole.case()


def test_a_file_that_names_another_file_is_refused(joint_text, tmp_path):
    text = joint_text + '\n[materials.mine]\nlibrary = "mine"\nfile = "/etc/passwd"\n'
    with pytest.raises(InputError, match=r"materials\.mine\.file: the page opens no other files"):
        JointRequest("a.toml", text).case()


def test_an_rz_is_kept_as_it_is_written(joint_text):
    depth = {"surface.mean_roughness_depth": "1.6 um +- 0.2 um"}
    request = JointRequest("a.toml", joint_text, depth)
    surface = tomllib.loads(request.file_text())["surface"]
    assert surface["mean_roughness_depth"] == "1.6 um +- 0.2 um"
    assert not {"fractal_roughness", "roughness_average"} & set(surface)
    assert request.case().surface.roughness_average.tolerance > 0.0
    assert JointRequest("a.toml", request.file_text()).case() == request.case()
    average = JointRequest("a.toml", request.file_text(), {"surface.roughness_average": "0.3 um"})
    assert average.case().surface.mean_roughness_depth is None
    with pytest.raises(InputError, match=r"surface\.mean_roughness_depth: "):
        JointRequest("a.toml", joint_text, {"surface.mean_roughness_depth": "1.6 N"}).case()
    with pytest.raises(InputError, match="exactly one of 'fractal_roughness'"):
        JointRequest("a.toml", request.file_text(), {"surface.mean_roughness_depth": ""}).case()


def test_the_number_of_loads_is_bounded(joint_text):
    text = joint_text + 51 * '\n[[duty]]\noutput_torque = "1 N*m"\nsun_speed = "1 rpm"\nshare = 0.01\n'
    with pytest.raises(InputError, match=r"at most 50 loads in \[\[duty\]\], got 51"):
        JointRequest("a.toml", text).case()


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (3, "JSON object"),
        ({}, "either as 'toml'"),
        ({"toml": "x", "joint": {"load": 1}}, "either as 'toml'"),
        ({"toml": "x", "what": 1}, "unknown entry 'what'"),
        ({"toml": "x", "surfaces": {}}, r"surfaces: a list of at most 2 entries is needed, got \{\}"),
        (
            {"toml": "x", "surfaces": [{}] * 3},
            "surfaces: a list of at most 2 entries is needed, got 3 entries",
        ),
        ({"toml": "x", "surfaces": [3]}, "surfaces.1: a JSON object is needed, got 3"),
        ({"toml": "x", "name": ""}, "name: text of 1 to 120 characters is needed, got ''"),
        ({"toml": "x", "name": "x" * 121}, "name: text of 1 to 120 characters is needed, got 121 characters"),
        ({"toml": "x", "changes": []}, r"changes: a JSON object of at most 600 entries is needed, got \[\]"),
        ({"toml": "x", "changes": {str(i): 1 for i in range(601)}}, "at most 600 entries is needed, got 601"),
        (
            {"toml": "x", "changes": {"load.preload": None}},
            "^load.preload: text of at most 200 characters or a number",
        ),
        ({"toml": "x", "changes": {"load.preload": True}}, "or a number is needed, got True"),
        ({"toml": "x", "changes": {"load.preload": "1" * 201}}, "at most 200 characters"),
        (
            {"toml": "x", "changes": {"a." * 400_000: "1"}},
            "^'a.a.*: text of at most 200 characters is needed, got 800000",
        ),
    ],
)
def test_bodies_that_are_refused(body, said):
    with pytest.raises(InputError, match=said):
        joint_request(body)


@pytest.fixture
def planetary_text(zou_file):
    return zou_file.with_name("planetary.toml").read_text(encoding="utf-8")


def test_a_joint_with_another_drive_has_its_own_choices(planetary_text):
    changes = {"drive.output": "ring", "bodies.planet": "440C", "drive.planet_radius": "21 mm"}
    request = JointRequest("p.toml", planetary_text, changes)
    case = request.case()
    assert (case.drive.output, case.bodies["planet"]) == ("ring", "440C")
    assert case.drive.planet_radius.value == pytest.approx(21e-3)
    assert JointRequest("p.toml", request.file_text()).case() == case
    choices = choices_of_case(case)
    assert choices["drive.output"] == ("carrier", "ring")
    assert [path for path in choices if path.startswith("bodies.")] == [
        "bodies.sun",
        "bodies.planet",
        "bodies.ring",
        "bodies.housing",
    ]
    assert not any(path.startswith(("roller.", "contact.")) for path in choices)


def test_an_optional_number_of_another_drive_can_be_left_out(planetary_text):
    wanted = JointRequest("p.toml", planetary_text, {"drive.planet_bore_diameter": "20 mm"})
    assert wanted.case().drive.planet_bore_diameter.value == pytest.approx(20e-3)
    without = JointRequest("p.toml", wanted.file_text(), {"drive.planet_bore_diameter": ""})
    assert without.case().drive.planet_bore_diameter is None


def test_a_section_whose_fields_are_emptied_is_left_out(planetary_text):
    """Its needed numbers too; the material of a housing goes with it."""
    entered = {"housing.outer_diameter": "150 mm", "housing.interference": "60 um"}
    entered |= {"housing.friction_coefficient": 0.12, "bodies.housing": "6061-T6"}
    support = {"drive.ring_support": "rigid_housing"}
    wanted = JointRequest("p.toml", planetary_text, support | entered)
    assert wanted.case().housing.outer_diameter.value == pytest.approx(0.15)
    assert wanted.case().bodies["housing"] == "6061-T6"
    emptied = dict.fromkeys(entered, "")
    without = JointRequest("p.toml", wanted.file_text(), emptied)
    assert without.case().housing is None
    assert "[housing]" not in [line for line in without.file_text().splitlines() if not line.startswith("#")]
    del emptied["housing.interference"], emptied["bodies.housing"]
    with pytest.raises(InputError, match=r"housing\.outer_diameter: this key is missing"):
        JointRequest("p.toml", wanted.file_text(), emptied).case()


def test_a_finish_with_the_ra_of_the_drawing_takes_the_place_of_d_and_g(planetary_text):
    """As a file with finish and roughness_average says it, from one that states D and G."""
    finish = {
        "surface.finish": "ground",
        "surface.fractal_dimension": "",
        "surface.frequency_ratio": "",
        "surface.roughness_average": "0.2 um",
    }
    found = JointRequest("p.toml", planetary_text, finish)
    plain = planetary_text.replace("fractal_dimension = 1.5", 'finish = "ground"').replace(
        'fractal_roughness = "1.3e-7 mm"', 'roughness_average = "0.2 um"'
    )
    assert si_values(found.case()) == si_values(parse_case(plain, source="p"))
    assert found.case().surface.finish == "ground"
    assert "fractal_roughness" not in tomllib.loads(found.file_text())["surface"]
    own = {"surface.finish": "", "surface.fractal_dimension": "1.4", "surface.frequency_ratio": "1.5"}
    back = JointRequest("p.toml", found.file_text(), own)
    assert back.case().surface.finish is None
    with pytest.raises(InputError, match="there is no finish 'polishd'"):
        JointRequest("p.toml", planetary_text, {"surface.finish": "polishd"}).case()


def test_a_finish_of_a_file_with_a_surface_for_each_contact(planetary_text):
    plain = "\n".join(line for line in planetary_text.splitlines() if not line.startswith("#"))
    entry = plain[plain.index("[surface]") : plain.index("[lubrication]")]
    each = plain.replace(
        entry, "".join(entry.replace("surface]", f"surface.{name}]") for name in ("sp", "pr"))
    )
    asked = {
        "surface.finish": "honed",
        "surface.fractal_dimension": "",
        "surface.roughness_average": "0.1 um",
    }
    surfaces = tomllib.loads(JointRequest("p.toml", each, asked).file_text())["surface"]
    expected = {"finish": "honed", "roughness_average": "0.1 um", "frequency_ratio": 1.5}
    assert surfaces == {"sp": expected, "pr": expected}


@pytest.mark.parametrize("levels", [33, 500, 900])
def test_deeply_nested_tables_are_refused(levels):
    tables = {"a": 1}
    for _ in range(levels):
        tables = {"a": tables}
    with pytest.raises(InputError, match="nested too deeply"):
        joint_request({"joint": tables})


def test_the_rms_of_the_heights_takes_the_place_of_all_other_roughness(joint_text):
    request = JointRequest("a.toml", joint_text, {"surface.rms_height": "0.2 um"})
    surface = request.case().surface
    assert surface.rms_height.value == pytest.approx(0.2e-6)
    assert surface.fractal_dimension is None
    assert parse_case(request.file_text(), source="a.toml").surface == surface
    back = JointRequest("b.toml", request.file_text(), {"surface.fractal_roughness": "1e-8 mm"})
    with pytest.raises(InputError, match=r"surface\.fractal_dimension: this key is missing"):
        back.case()


DOCUMENT = {
    "schema": "asperity-surface-measurement", "schema_version": 1, "source": "shaft.txt", "estimator": "made up",
    "fractal_dimension": 1.45, "fractal_roughness_m": 1e-11, "frequency_ratio": 1.5, "profiles": 10,
    "covariance_of_dimension_and_log_roughness": [[1e-6, 0.0], [0.0, 1e-3]],
    "shortest_wavelength_m": 1e-6, "longest_wavelength_m": 1e-4,
}  # fmt: skip


def test_a_measured_surface_takes_the_place_of_the_files(joint_text, tmp_path):
    """A document without a spectrum, of which D and G go in."""
    request = joint_request({"toml": joint_text, "surfaces": [DOCUMENT]})
    assert request.solved_case().measured.measured.source == "shaft.txt"
    assert request.case().surface.fractal_dimension.value == 1.4  # what the form shows is the file's
    assert request.solved_case().surface.fractal_dimension.value == 1.45
    for name, content in request.measurement_file().items():
        (tmp_path / name).write_bytes(content)
    saved = parse_case(request.file_text(), source="a.toml", folder=tmp_path)
    assert si_values(saved) == si_values(request.solved_case())
    assert tomllib.loads(request.file_text())["surface"] == {"measurement": "measured_surface.json"}
    assert "# shaft.txt: the file that" in request.file_text()
    assert request.stated_text() == joint_text
    plain = joint_request({"toml": joint_text})
    assert (plain.measurement_file(), plain.solved_case()) == ({}, plain.case())
    assert plain.identity != request.identity


def test_a_job_has_the_measurement_beside_its_joint_file(joint_text, tmp_path):
    _, _, files, _ = job_request(
        {"toml": joint_text, "surfaces": [DOCUMENT], "name": "a.toml", "job": {"kind": "sensitivity"}}
    )
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    assert read_case(tmp_path / "a.toml").measured.measured.source == "shaft.txt"


def test_a_file_that_names_its_measurement_needs_it_on_the_page(joint_text):
    named = joint_request({"toml": joint_text, "surfaces": [DOCUMENT]}).file_text()
    with pytest.raises(
        InputError, match=r"opens no other files; open the measured surface 'measured_surface.json'"
    ):
        joint_request({"toml": named}).solved_case()
    both = joint_request({"toml": named, "surfaces": [DOCUMENT]})
    assert both.solved_case().surface.fractal_dimension.value == 1.45
    assert both.file_text() == named
    # G of both bodies, which are alike: 1e-11 m times 2^(1/0.9); of a pair that measured
    assert both.solved_case().surface.fractal_roughness.value == pytest.approx(
        1e-11 * 2 ** (1 / 0.9), rel=1e-9
    )
    said = named.replace('"measured_surface.json"', '"measured_surface.json"\nmeasurement_of = "pair"')
    for of_pair in (
        joint_request({"toml": said, "surfaces": [DOCUMENT]}),
        joint_request({"toml": named, "surfaces": [DOCUMENT | {"measurement_of": "pair"}]}),
    ):
        assert of_pair.solved_case().surface.fractal_roughness.value == pytest.approx(1e-11, rel=1e-9)
        (content,) = of_pair.measurement_file().values()
        assert json.loads(content)["measurement_of"] == "pair"


def test_a_surface_that_is_no_measurement_is_refused(joint_text):
    for surface, said in (
        ({}, "its key 'schema'"),
        (DOCUMENT | {"profiles": 0}, "0 profiles"),
    ):
        with pytest.raises(InputError, match=f"joint.toml: .*{said}"):
            joint_request({"toml": joint_text, "surfaces": [surface]}).solved_case()
    deep = {}
    for _ in range(100):
        deep = {"a": deep}
    with pytest.raises(InputError, match="nested too deeply"):
        joint_request({"toml": joint_text, "surfaces": [deep]})


def test_the_name_of_a_joint_is_one_printable_line(joint_text):
    request = joint_request({"toml": joint_text, "name": "we\x07lle\n  b.toml"})
    assert request.name == shown_name("we\x07lle\n  b.toml") == r"we\x07lle\n  b.toml"
    assert shown_name("") == "joint.toml"
    assert len(shown_name("\x07" * 120)) == LONGEST_NAME
