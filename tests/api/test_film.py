"""The oil over speed in a script: what the command prints, as an object."""

from pathlib import Path

import pytest

import asperity
from asperity.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def oil():
    return asperity.load(EXAMPLES / "oil.toml")


def test_document_frame_text_and_picture(oil):
    found = asperity.film(oil, temperatures=("20 degC", "40 degC"), start="10 rpm", stop="1000 rpm", points=3)
    assert found.document["film"]["contacts"]["sp"]["lubrication"] == "mixed"
    frame = found.to_frame()
    assert list(frame.columns[:2]) == ["oil_temperature_C", "input_speed_rad_per_s"]
    assert len(frame) == 6
    assert "Contact sp over speed, oil at 20 °C" in repr(found)
    assert found.plot()._repr_png_().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"start": 500}, "start of the speeds"),
        ({"stop": "1 mm"}, "expected an angular velocity"),
        ({"temperatures": ("20 mm",)}, "temperature of the oil"),
    ],
)
def test_what_is_refused(oil, given, said):
    with pytest.raises(InputError, match=said):
        asperity.film(oil, **given)


def test_one_temperature_needs_no_list(oil):
    found = asperity.film(oil, temperatures="20 degC", start="10 rpm", stop="20 rpm", points=2)
    assert [each["oil_temperature_C"] for each in found.document["over_speed"]] == [20.0]


def test_only_a_joint_has_films():
    with pytest.raises(InputError, match="expected a joint"):
        asperity.film("joint.toml")
