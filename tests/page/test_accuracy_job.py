"""The accuracy as a job of the page: the document of the command, its words, and the turn that the page draws."""

import json
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import read_case
from asperity.page.accuracy_job import accuracy
from asperity.results.accuracy_document import accuracy_document

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("reverse", [False, True])
def test_the_document_is_that_of_the_command_with_its_words_and_its_turn(reverse):
    path = str(EXAMPLES / "accuracy.toml")
    found = accuracy(path, {"reverse": reverse}, lambda *_: None)
    json.dumps(found, allow_nan=False)
    views, turn = found.pop("views"), found.pop("over_turn")
    assert found == accuracy_document(joint_accuracy(read_case(path), reverse=reverse))
    assert views[0]["items"][0]["name"] == "transmission error"
    assert ("Transmission error in both directions" in [block.get("title") for block in views]) == reverse
    assert turn["output"] == "carrier"
    assert (turn["angle_rad"][0], turn["angle_rad"][-1]) == pytest.approx((0.0, 2.0 * np.pi))
    # no turn runs further ahead than the worst over all phases, nor swings about another mean
    error = np.array(turn["transmission_error_rad"])
    assert 0.0 < np.abs(error).max() <= found["accuracy"]["transmission_error_rad"]["worst"] * (1.0 + 1e-12)
    torque = found["accuracy"]["input_torque_Nm"]
    assert np.abs(np.array(turn["input_torque_Nm"]) - torque["mean"]).max() <= torque["worst"] * (1.0 + 1e-9)
    force = found["accuracy"]["contacts"][turn["contact"]]["normal_N"]
    swing = np.abs(np.array(turn["normal_N"]) - force["mean"]).max()
    assert 0.0 < swing <= force["worst"] * (1.0 + 1e-9)


def test_a_joint_without_form_errors_is_refused_with_what_to_state():
    with pytest.raises(InputError, match=r"states no form errors.*give sections \[\[form\]\]"):
        accuracy(str(EXAMPLES / "wear.toml"), {"reverse": False}, lambda *_: None)
