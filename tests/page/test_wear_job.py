"""Wear as a job of the page: the document of the command, with its words, and the course that the page draws."""

import json
from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import read_case
from asperity.joint_file.wear import wear_of_case
from asperity.page.wear_job import wear
from asperity.results.wear_document import wear_document

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_the_document_is_that_of_the_command_with_its_words():
    worn = EXAMPLES / "wear.toml"
    found = wear(str(worn), {}, lambda *_: None)
    views = found.pop("views")
    assert found == wear_document(wear_of_case(read_case(str(worn))))
    figures, *others = views
    assert [item["name"] for item in figures["items"]][:2] == ["first contact slides", "nothing left"]
    assert figures["items"][0]["unit"] == "h"
    assert [block["title"] for block in others if block["kind"] == "table"][-1] == "The joint over time"
    json.dumps(found | {"views": views}, allow_nan=False)


def test_a_joint_without_an_interference_is_refused_with_what_to_state():
    with pytest.raises(InputError, match=r"load\.preload: a force .* state load\.interference"):
        wear(str(EXAMPLES / "tutorial_joint.toml"), {}, lambda *_: None)
