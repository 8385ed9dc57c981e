"""A joint file with the joint that it describes, as its assumptions are told from both."""

from __future__ import annotations

from typing import NamedTuple

from asperity.joint.description import Joint
from asperity.joint_file.model import Case


class Described(NamedTuple):
    """A joint file, and its joint with equal branches."""

    case: Case
    joint: Joint
