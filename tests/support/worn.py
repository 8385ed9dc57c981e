"""The check joint of wear: the paper's drive with smooth rollers as springs, its contacts split by their slip."""

import functools
from pathlib import Path

import numpy as np

from asperity.engine.control import at_once
from asperity.joint.description import without_duty
from asperity.joint.machine import joint_machine
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case
from asperity.joint_file.wear import wear_of_case
from asperity.rolling.wear import wear_loads
from asperity.rolling.wear_rates import Wearing

EXAMPLES = Path(__file__).parents[2] / "examples"
COEFFICIENT = '\n[wear]\ncoefficient = "1e-17 1/Pa"\n'
#: Bodies so light that no centrifugal force counts, as in the independent program.
_CHANGES = {
    'preload = "1000 N"': 'interference = "12.9043 um"',
    'bodies = "exact"': 'bodies = "springs"',
    'traction_split = "equal_coefficients"': 'traction_split = "springs"',
    'closure_springs = "bulk"': "",
    'density = "7850 kg/m^3"': 'density = "1 kg/m^3"',
}
_SURFACE = '[surface]\nfinish = "ground"\nroughness_average = "0.5 nm"\n'


def changed(text, changes):
    for old, new in changes.items():
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def check_text(changes=None):
    """The joint file of the check joint, with further changes."""
    text = changed((EXAMPLES / "zou2025.toml").read_text(), _CHANGES)
    return changed(text[: text.index("[surface]")] + _SURFACE, changes or {})


def check_case(changes=None, more=""):
    return parse_case(check_text(changes) + more, source="check.toml")


@functools.cache
def check_wear(more="", life=None):
    """Wear of the check joint over a life [s], as ``asperity wear`` has it."""
    return wear_of_case(check_case(more=more), life=life)


def worn_joint(case):
    """The joint of a case that states its interference, and what follows its wear with one coefficient."""
    joint = with_own_branches(case)
    machine = at_once(joint_machine, without_duty(joint))
    return Wearing(machine, np.ones(len(joint.drive.bodies))), wear_loads(joint)
