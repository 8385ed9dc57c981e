"""A joint file solved in a script says what the command says, whatever the type of its drive."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli import asperity
from asperity.joint_file.reader import read_any_case
from asperity.joint_file.solved_document import solved_document

EXAMPLES = Path(__file__).parents[2] / "examples"
UNEQUAL = '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\n\n[[branch]]\n\n'


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "branches"), [("zou2025", ""), ("planetary", ""), ("planetary", UNEQUAL)], ids=str
)
def test_the_document_is_that_of_the_command(name, branches, tmp_path):
    file = tmp_path / "joint.toml"
    file.write_text((EXAMPLES / f"{name}.toml").read_text().replace("[model]", f"{branches}[model]"))
    printed = CliRunner().invoke(asperity, ["joint", str(file), "--json"], catch_exceptions=False).stdout
    assert solved_document(read_any_case(file)) == json.loads(printed)
    assert bool(branches) == ('"branches": {' in printed)
