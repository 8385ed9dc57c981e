import tomllib
from pathlib import Path

import pytest
from bronze import BRONZE

from asperity.errors import InputError
from asperity.joint_file.reader import case_from_tables
from asperity.joint_file.schema import joint_schema
from asperity.library import read_materials

EXAMPLES = Path(__file__).parents[2] / "examples"
JOINT_FILES = ("zou2025.toml", "tutorial_joint.toml")
STEEL = {
    "youngs_modulus": "206 GPa",
    "poisson_ratio": 0.3,
    "density": "7850 kg/m^3",
    "yield_strength": "450 MPa",
    "hardness_factor": 2.8,
}


@pytest.fixture(scope="module")
def schema():
    return joint_schema()


def test_the_schema_tells_editors_what_a_joint_file_may_say(schema):
    assert set(schema["required"]) == {
        "drive",
        "load",
        "model",
        "bodies",
        "surface",
    }  # materials: the library's
    assert schema["additionalProperties"] is False
    drive = schema["$defs"]["WedgeDrive"]
    assert drive["properties"]["sun_radius"]["type"] == "string"  # a quantity is text with a unit
    assert drive["properties"]["planets"]["type"] == "integer"
    assert "planet_length" not in drive["required"]
    number, text, _ = schema["$defs"]["SurfaceEntry"]["properties"]["fractal_dimension"]["anyOf"]
    assert (number["exclusiveMinimum"], number["exclusiveMaximum"]) == (1.0, 2.0)
    assert text["type"] == "string"
    assert schema["$defs"]["WedgeModelChoice"]["properties"]["closure"]["enum"] == [
        "elastic",
        "constant_pin_force",
    ]


def test_every_key_is_described(schema):
    for name, section in schema["$defs"].items():
        for key, entry in section.get("properties", {}).items():
            assert entry.get("description") or "$ref" in entry, f"{name}.{key}"


def test_an_editor_is_offered_the_names_of_the_library_and_others_stay_allowed(schema):
    library = read_materials()
    names = [*library, *(name for material in library.values() for name in material.also)]
    assert {"52100", "100Cr6"} <= set(names)
    (body,) = schema["properties"]["bodies"]["patternProperties"].values()
    offered, own = body["anyOf"]
    assert offered["enum"] == names
    assert own["pattern"] == "^[A-Za-z0-9_-]{1,60}$"
    library = schema["$defs"]["MaterialEntry"]["properties"]["library"]["anyOf"]
    assert library[0]["enum"] == names
    assert library[1] == {"type": "string"}


def with_materials(materials, **bodies):
    """Tables of the tutorial's joint, which has no [materials], with some."""
    tables = tomllib.loads((EXAMPLES / "tutorial_joint.toml").read_text(encoding="utf-8"))
    tables["bodies"] |= bodies
    return tables if materials is None else {**tables, "materials": materials}


# what the file says about materials and bodies, and whether it is a joint file
FILES = {
    "library by its name alone": (None, {}, True),
    "an empty section beside it": ({}, {}, True),
    "numbers": ({"steel": STEEL}, {"sun": "steel"}, True),
    "library entry": ({"sun": {"library": "440C"}}, {"sun": "sun"}, True),
    "library entry, a number replaced": (
        {"sun": {"library": "440C", "hardness_factor": 2.8}},
        {"sun": "sun"},
        True,
    ),
    "library file of one's own": (
        {"sun": {"library": "bronze", "file": "mine.toml"}},
        {"sun": "sun"},
        True,
    ),
    "unknown library entry": ({"sun": {"library": "bronze"}}, {}, False),
    "no text": ({"sun": {"library": ["440C"]}}, {}, False),
    "no text for the file": ({"sun": {"library": "440C", "file": 3}}, {}, False),
    "file without entry": ({"steel": STEEL | {"file": "mine.toml"}}, {}, False),
    "no density": ({"steel": {k: v for k, v in STEEL.items() if k != "density"}}, {}, False),
    "no hardness": ({"steel": {k: v for k, v in STEEL.items() if k != "hardness_factor"}}, {}, False),
    "two hardnesses": ({"steel": STEEL | {"hardness": "1 GPa"}}, {}, False),
    "two hardnesses beside the library's": (
        {"sun": {"library": "440C", "hardness": "1 GPa", "hardness_factor": 2.8}},
        {},
        False,
    ),
    "unknown key": ({"sun": {"library": "440C", "colour": "blue"}}, {}, False),
    "strange name": ({"my steel": STEEL}, {}, False),
}


@pytest.mark.parametrize("said", FILES)
def test_schema_and_reader_agree_on_materials(schema, tmp_path, said):
    """The reader is asked first; jsonschema comes with the documentation's packages, not with the tests'."""
    materials, bodies, allowed = FILES[said]
    tables = with_materials(materials, **bodies)
    (tmp_path / "mine.toml").write_text(BRONZE, encoding="utf-8")
    if allowed:
        case_from_tables(tables, source="joint.toml", folder=tmp_path)
    else:
        with pytest.raises(InputError):
            case_from_tables(tables, source="joint.toml", folder=tmp_path)
    jsonschema = pytest.importorskip("jsonschema")
    assert jsonschema.Draft202012Validator(schema).is_valid(tables) == allowed


@pytest.mark.parametrize(
    ("surface", "allowed"),
    [
        ({"mean_roughness_depth": "1.6 um"}, True),
        (
            {"mean_roughness_depth": "1.6 um", "cut_off": "2.5 mm", "partner_roughness_average": "0.2 um"},
            True,
        ),
        ({"roughness_average": "0.2 um", "cut_off": "0.8 mm"}, True),
        ({"roughness_average": "0.2 um", "partner_mean_roughness_depth": "1.2 um"}, True),
        ({"mean_roughness_depth": "1.6 um", "partner_mean_roughness_depth": "1.2 um"}, True),
        ({"fractal_roughness": "1e-8 mm", "partner_mean_roughness_depth": "1.2 um"}, False),
        (
            {
                "roughness_average": "0.2 um",
                "partner_mean_roughness_depth": "1.2 um",
                "partner_roughness_average": "0.1 um",
            },
            False,
        ),
        ({"mean_roughness_depth": "1.6 um", "roughness_average": "0.2 um"}, False),
        ({"fractal_roughness": "1e-8 mm", "cut_off": "0.8 mm"}, False),
    ],
)
def test_schema_and_reader_agree_on_heights(schema, surface, allowed):
    tables = with_materials(None) | {"surface": {"finish": "ground"} | surface}
    if allowed:
        assert case_from_tables(tables, source="joint.toml").surface.roughness_average
    else:
        with pytest.raises(InputError):
            case_from_tables(tables, source="joint.toml")
    jsonschema = pytest.importorskip("jsonschema")
    assert jsonschema.Draft202012Validator(schema).is_valid(tables) == allowed


@pytest.mark.parametrize("name", JOINT_FILES)
def test_the_examples_keep_to_the_schema(schema, name):
    jsonschema = pytest.importorskip("jsonschema")
    tables = tomllib.loads((EXAMPLES / name).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(tables, schema, jsonschema.Draft202012Validator)
