"""The section [life] of joint files: where it needs an oil and a roughness, and what is said without it."""

import re
from pathlib import Path

import pytest
from assumed import assumptions

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values

EXAMPLES = Path(__file__).parents[2] / "examples"
FILM = '\n[lubrication]\nviscosity = "30 mPa*s"\npressure_coefficient = "20 1/GPa"\n'
ROUGH = 'roughness = "0.2 um"\n'
LIFE = "\n[life]\ncleanliness = 0.5\n"
AVERAGE = 'finish = "ground"\nroughness_average = "0.3 um"\n'


def text_of(*more, surface=None):
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    text = re.sub(r"(?ms)^\[lubrication\].*?(?=^\[|\Z)", "", text)
    if surface is not None:
        text = re.sub(r"(?s)\[surface\].*?(?=\n\[|\Z)", "[surface]\n" + surface, text)
    return text + "".join(more)


def cleanliness_of(text):
    return joint_from_values(si_values(parse_case(text, source="x"))).rolling.cleanliness


def refusal(text):
    with pytest.raises(InputError) as refused:
        parse_case(text, source="x")
    return str(refused.value)


def test_a_film_and_a_roughness_are_enough():
    assert cleanliness_of(text_of(FILM, ROUGH, LIFE)) == 0.5
    assert cleanliness_of(text_of(FILM, LIFE, surface=AVERAGE)) == 0.5
    assert cleanliness_of((EXAMPLES / "oil.toml").read_text(encoding="utf-8")) == 0.5
    assert cleanliness_of(text_of(FILM, ROUGH)) is None


def test_without_a_film_it_is_refused_with_the_keys_that_make_one():
    for oil in ("", '\n[lubrication]\nviscosity = "30 mPa*s"\n' + ROUGH):
        said = refusal(text_of(oil, LIFE))
        assert "life.cleanliness = '0.5' needs the oil film" in said
        assert "pressure_coefficient" in said
        assert "fluid" in said


def test_without_a_roughness_it_is_refused_with_the_keys_that_state_it():
    said = refusal(text_of(FILM, LIFE))
    assert "life.cleanliness = '0.5' needs the ratio of the oil film to the roughness" in said
    assert "lubrication.roughness" in said


@pytest.mark.parametrize("value", ["0", "1.2", "-0.3", '"clean"'])
def test_it_is_a_share(value):
    said = refusal(text_of(FILM, ROUGH, f"\n[life]\ncleanliness = {value}\n"))
    assert "life.cleanliness" in said
    assert value.strip('"') in said


def test_what_lives_lack_is_said_where_a_film_is_known():
    def said(*more):
        return assumptions(parse_case(text_of(*more), source="x"))

    missing = "no life.cleanliness: lives have no factor a_ISO for the oil film"
    assert missing in said(FILM, ROUGH)
    assert missing not in said(FILM)
    assert missing not in said(FILM, ROUGH, LIFE)
    assert any("times a_ISO of ISO 281" in each for each in said(FILM, ROUGH, LIFE))
    assert any("without factors for film" in each for each in said())
