"""The window in a script: what the command prints, as an object with units."""

from pathlib import Path

import pytest

import asperity
from asperity.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def wheels():
    return asperity.load(EXAMPLES / "wheel_pair.toml")


@pytest.fixture(scope="module")
def found(wheels):
    return asperity.window(wheels, start="500 N", stop="1 kN", points=2)


def test_document_frame_and_text(found):
    assert found.inside
    assert found.document["verdict"]["inside"]
    frame = found.to_frame()
    assert list(frame.columns[:2]) == ["preload_N", "torque_capacity_Nm"]
    assert (frame["preload_N"].iloc[0], frame["preload_N"].iloc[-1]) == (500.0, 1000.0)
    assert "lies inside the window at 1000 N of preload" in repr(found)
    assert found.plot()._repr_png_().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"start": 500}, "start of the window"),
        ({"stop": "1 mm"}, "expected a force"),
        ({"over": "speed"}, "expected over='temperature' or 'preload', got 'speed'"),
    ],
)
def test_what_is_refused(wheels, given, said):
    with pytest.raises(InputError, match=said):
        asperity.window(wheels, **given)


def test_only_a_joint_has_a_window():
    with pytest.raises(InputError, match="expected a joint"):
        asperity.window("joint.toml")
