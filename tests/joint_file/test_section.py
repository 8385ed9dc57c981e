"""What every section of a joint file is."""

import pytest
from pydantic import ValidationError

from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.section import Section, leaves, meaning


class Colour(Section):
    name: str


class Paint(Colour):
    """A colour that dries."""

    layers: int
    """How many, one above
    the other."""
    gloss: float = 0.5
    unsaid: str = ""


class Tin(Section):
    paint: Paint
    """What is in it."""


def test_the_meaning_of_a_key_is_its_docstring():
    assert meaning(Paint, "layers") == "How many, one above the other."
    assert meaning(Paint, "gloss") == meaning(Paint, "unsaid") == meaning(Paint, "name") == ""


def test_a_schema_has_the_meanings():
    schema = Tin.model_json_schema()
    assert schema["$defs"]["Paint"]["properties"]["layers"]["description"] == "How many, one above the other."
    assert "description" not in schema["$defs"]["Paint"]["properties"]["gloss"]
    assert schema["properties"]["paint"] == {"$ref": "#/$defs/Paint", "description": "What is in it."}


def test_a_section_is_frozen_and_has_no_room_for_unknown_keys():
    blue = Colour.model_validate({"name": "blue"})
    with pytest.raises(ValidationError, match="frozen"):
        blue.name = "red"
    with pytest.raises(ValidationError, match="Extra inputs are not permitted"):
        Colour.model_validate({"name": "blue", "shade": 3})


def test_the_sections_of_a_joint_file_are_frozen(example_case):
    assert isinstance(example_case, DefaultCase)
    with pytest.raises(ValidationError, match="frozen"):
        example_case.drive.planets = example_case.drive.sun_radius


class Wall(Section):
    colours: tuple[Colour, ...]
    sizes: dict[str, float]
    named: Colour


def test_values_of_some_types_with_their_paths():
    wall = Wall(
        colours=(Colour(name="red"), Colour(name="blue")), sizes={"height": 2.5}, named=Colour(name="green")
    )
    names = [("colours.1.name", "red"), ("colours.2.name", "blue"), ("named.name", "green")]
    assert list(leaves(wall, str)) == names
    assert list(leaves(wall, (str, float))) == [*names[:2], ("sizes.height", 2.5), names[2]]
    assert list(leaves(wall.named, str, "wall.named")) == [("wall.named.name", "green")]
    assert list(leaves(wall, int)) == []
