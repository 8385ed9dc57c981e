"""The document of a joint with form errors: every component, sums over them, turns without a reference."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.accuracy import joint_accuracy
from asperity.results.accuracy_document import accuracy_document, homing_turns, turn_columns

FILE = Path(__file__).parents[2] / "examples" / "accuracy.toml"


@pytest.fixture(scope="module")
def accuracy():
    return joint_accuracy(asperity.load(FILE).case, reverse=True)


def test_sums_are_those_of_the_components(accuracy):
    document = accuracy_document(accuracy)["accuracy"]
    errors = np.array([one["transmission_error_rad"] for one in document["components"]])
    assert document["transmission_error_rad"]["worst"] == pytest.approx(errors.sum())
    assert document["transmission_error_rad"]["rms"] == pytest.approx(math.sqrt(0.5 * (errors**2).sum()))
    forces = np.array([one["normal_N"]["sp_2"] for one in document["components"]])
    assert document["contacts"]["sp_2"]["normal_N"]["worst"] == pytest.approx(forces.sum())
    assert json.loads(json.dumps(document)) == document
    assert len(document["reverse"]["components"]) == len(errors)
    lost = asperity.windup(asperity.load(FILE))["lost_motion"]
    assert document["lost_motion_rad"] == pytest.approx(float(lost.si), rel=1e-9)
    assert document["bidirectional_repeatability_rad"] == pytest.approx(
        document["bidirectional_error_rad"]["worst"] + document["lost_motion_rad"]
    )


def test_three_sectors_have_components_of_their_own(accuracy):
    found = [(one["part"], one["sector"]) for one in accuracy_document(accuracy)["accuracy"]["components"]]
    assert found.count(("planet", 2)) == 2
    assert found.count(("ring", None)) == 4


def test_columns_of_a_turn(accuracy):
    columns = turn_columns(accuracy.over_turn, accuracy.forward.contact_names)
    assert len({len(column) for column in columns.values()}) == 1
    assert "normal_N_wlo_3" in columns


def test_turns_until_the_reference_is_found_again():
    assert homing_turns(allowed=0.01, uncertainty=0.002) == pytest.approx(5.0)
    assert homing_turns(allowed=0.01, uncertainty=0.0) == math.inf
