"""The accuracy over a turn in a script: what the command prints, as an object."""

from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def joint():
    return asperity.load(EXAMPLES / "accuracy.toml")


def test_document_frame_text_and_picture(joint):
    found = asperity.accuracy(joint, reverse=True)
    accuracy = found.document["accuracy"]
    assert accuracy["transmission_error_rad"]["worst"] > accuracy["transmission_error_rad"]["rms"] > 0.0
    assert accuracy["bidirectional_error_rad"]["worst"] > 0.0
    frame = found.to_frame()
    assert list(frame.columns[:3]) == ["output_angle_rad", "transmission_error_rad", "input_torque_Nm"]
    assert frame["output_angle_rad"].iloc[-1] == pytest.approx(2.0 * np.pi)
    assert "Form errors by order" in repr(found)
    assert found.plot()._repr_png_().startswith(b"\x89PNG")


def test_turns_until_the_reference_is_found_again(joint):
    alone = asperity.accuracy(joint, allowed="5 arcmin").document["accuracy"]
    drift = alone["drift_rad_per_output_turn"]
    assert alone["homing"]["turns"] == pytest.approx(5.0 / 60.0 * np.pi / 180.0 / drift)
    known = asperity.accuracy(joint, allowed="5 arcmin", uncertainty="20 %").document["accuracy"]
    assert known["homing"]["turns"] == pytest.approx(5.0 * alone["homing"]["turns"])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"allowed": 5}, "allowed error"),
        ({"allowed": "0 arcmin"}, "must be above 0"),
        ({"allowed": "1 mm"}, "expected an angle"),
        ({"uncertainty": "20 %"}, "give the error too"),
        ({"allowed": "1 arcmin", "uncertainty": "-1 %"}, "must be above 0"),
    ],
)
def test_what_is_refused(joint, given, said):
    with pytest.raises(InputError, match=said):
        asperity.accuracy(joint, **given)


def test_only_a_joint_turns():
    with pytest.raises(InputError, match="expected a joint"):
        asperity.accuracy("joint.toml")
