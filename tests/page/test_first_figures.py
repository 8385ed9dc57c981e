"""Figures that are known first: those of the whole joint, without its torque capacity."""

import json
from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import read_case
from asperity.joint_file.solved_document import solve_with_surface
from asperity.page.first_figures import first_figures
from asperity.page.joint_request import joint_request
from asperity.views.headline import headline

EXAMPLES = Path(__file__).parents[2] / "examples"


def request(name, **changes):
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    return joint_request({"name": f"{name}.toml", "toml": text, "changes": changes})


@pytest.mark.parametrize(
    "name",
    [
        "tutorial_joint",
        "zou2025",
        "heat",
        *(
            pytest.param(each, marks=pytest.mark.long)
            for each in ("planetary", "stepped_planet", "wheel_pair")
        ),
    ],
)
def test_they_are_those_of_the_whole_joint(name):
    """Without a life at all, with one in turns, and with one in hours."""
    document = json.loads(json.dumps(solve_with_surface(read_case(EXAMPLES / f"{name}.toml")).document))
    whole = {figure.name: figure for figure in headline(document)}
    found = first_figures(request(name))["figures"]
    assert set(whole) - {figure["name"] for figure in found} == {"Torque capacity"}
    for figure in found:
        assert figure == vars(whole[figure["name"]])


def test_a_joint_without_a_state_has_none_and_one_that_does_not_fit_is_refused():
    assert first_figures(request("tutorial_joint", **{"load.output_torque": "100 N*m"})) == {"figures": []}
    with pytest.raises(InputError, match="do not fit"):
        first_figures(request("tutorial_joint", **{"drive.ring_radius": "20 mm"}))
