"""Changes of single keys: set, left out with their sections, or refused; of whole requests see test_joint_request."""

import tomllib

import pytest
import tomlkit

from asperity.errors import InputError
from asperity.joint_file.case_types import CASES
from asperity.page.key_changes import apply_changes, model_of


@pytest.fixture
def tables(zou_file):
    return tomllib.loads(zou_file.with_name("planetary.toml").read_text(encoding="utf-8"))


def test_the_model_is_that_of_the_type(tables):
    assert model_of(tables) is CASES["planetary"]
    assert model_of({}) is CASES[next(iter(CASES))]


def test_numbers_and_words_are_set(tables):
    apply_changes(tables, {"load.output_torque": "12 N*m", "bodies.ring": "440C", "drive.output": "ring"})
    assert tables["load"]["output_torque"] == "12 N*m"
    assert (tables["bodies"]["ring"], tables["drive"]["output"]) == ("440C", "ring")


def test_an_empty_key_is_left_out_with_a_section_that_has_no_other(tables):
    del tables["lubrication"]
    apply_changes(tables, {"lubrication.viscosity": "30 mPa*s"})
    assert tables["lubrication"] == {"viscosity": "30 mPa*s"}
    apply_changes(tables, {"lubrication.viscosity": ""})
    assert "lubrication" not in tables


def test_a_document_keeps_its_comments(zou_file):
    document = tomlkit.parse(zou_file.with_name("planetary.toml").read_text(encoding="utf-8"))
    apply_changes(document, {"load.output_torque": "12 N*m"})
    assert "# at the carrier" in tomlkit.dumps(document)


def test_changes_that_do_not_fit_the_file_are_refused(tables):
    tables["load"] = 3
    with pytest.raises(InputError, match="do not fit the sections of this joint file"):
        apply_changes(tables, {"load.output_torque": "12 N*m"})
