"""Joint files to start with: packaged ones, and those that are made of what a type of drive states."""

import re

import pytest

from asperity.drive.types import TYPES
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.template import made_template, names_of_templates, template

MADE = [kind for kind in TYPES.values() if not kind.is_listed]


def test_every_type_has_one_and_the_default_is_the_first():
    names = names_of_templates()
    assert names[0] == "wedge"
    assert set(names) == {*TYPES, "planetary_hollow"}
    assert names.index("planetary_hollow") == names.index("planetary") + 1
    assert 'type = "planetary"' in template("planetary_hollow")


@pytest.mark.parametrize("kind", MADE, ids=lambda kind: kind.name)
def test_a_made_one_is_a_joint_that_can_be_solved(kind):
    text = made_template(kind)
    case = parse_case(text, source=kind.name)
    assert case.type == kind.name
    assert bool(solve_joint(joint_from_case(case)).result.solved)
    assert max(map(len, text.splitlines())) <= 120


@pytest.mark.parametrize("kind", MADE, ids=lambda kind: kind.name)
def test_every_key_that_may_be_absent_stands_behind_a_sign(kind):
    """Without the sign the line is one of the file."""
    text = made_template(kind)
    for entry in kind.sizes:
        if getattr(entry, "required", True):
            assert re.search(rf"(?m)^{entry.key} = ", text)
            continue
        (line,) = re.findall(rf"(?m)^# ({entry.key} = .*)$", text)
        if entry.key == "spring_stiffness":
            continue  # only for pressed_by = "spring"
        stated = text.replace(f"# {line}", line)
        if entry.key.endswith(("_profile", "_profile_load")):  # a profile and its load belong together
            name = entry.key.partition("_profile")[0]
            stated = re.sub(rf"(?m)^# ({name}_profile(_load)? = )", r"\1", text)
        assert getattr(parse_case(stated, source=kind.name).drive, entry.key) is not None
