"""Commands that leave the sections [[branch]] out say so."""

from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTE = "the results are those of equal branches; [[branch]] counts in"


@pytest.fixture(params=["zou2025", "planetary"])
def unequal(tmp_path, request):
    text = (EXAMPLES / f"{request.param}.toml").read_text(encoding="utf-8")
    text = text.replace('preload = "1000 N"', 'interference = "13 um"')
    branches = '[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n\n'
    (tmp_path / "unequal.toml").write_text(text.replace("[model]", f"{branches}[model]", 1), encoding="utf-8")
    return tmp_path / "unequal.toml"


@pytest.mark.parametrize(
    ("command", "options"),
    [
        ("sweep", ("--over", "load.nothing=1 N:2 N:2")),
        ("sensitivity", ("--result", "none")),
        ("uncertainty", ()),  # without tolerances
    ],
)
def test_the_note_comes_first(call, unequal, command, options):
    outcome = call(command, unequal, *options)
    assert outcome.code == 2
    assert outcome.err.startswith("asperity: note: ")
    assert outcome.err.count(NOTE) == 1


def test_files_of_equal_branches_have_no_note(call):
    outcome = call("sensitivity", EXAMPLES / "planetary.toml", "--result", "none")
    assert outcome.code == 2
    assert "note" not in outcome.err


@pytest.mark.slow
def test_a_capacity_of_equal_branches_is_called_so(call, unequal):
    unequal.write_text(
        unequal.read_text(encoding="utf-8").replace('output_torque = "', 'output_torque = "9', 1),
        encoding="utf-8",
    )
    outcome = call("joint", unequal)
    assert outcome.code == 2
    assert "is beyond what the branches carry together" in outcome.err
    outcome = call("roll", unequal)
    assert outcome.code == 2
    assert "is beyond the torque capacity" in outcome.err
    assert "(for equal branches: [[branch]] does not count here)" in outcome.err
