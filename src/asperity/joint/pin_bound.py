"""What the pins of a joint, as far as they are stated, leave of its stiffness: a value, or an upper bound."""

from __future__ import annotations

import numpy as np

from asperity.engine.arrays import is_of_jax
from asperity.joint.bores import pins_bend
from asperity.joint.description import Joint
from asperity.types import Document

#: What is said beside every stiffness, frequency and K1 to K3 of a joint whose pins do not give way.
RIGID_PINS = "upper bound: pins rigid"


def pins_rigid(joint: Joint) -> bool:
    """Whether a joint has pins that do not give way, because neither their stiffness nor their sizes are stated."""
    stiffness = joint.pin_stiffness
    if not joint.drive.pinned or pins_bend(joint):
        return False
    return stiffness is None or (not is_of_jax(stiffness) and bool(np.all(np.isinf(stiffness))))


def stiffness_bound(joint: Joint) -> str:
    """What the stiffness of a joint is beyond a value, in a few words; empty where it is one."""
    return RIGID_PINS if pins_rigid(joint) else ""


def bound_document(joint: Joint) -> Document:
    """The bound of a joint's stiffness for JSON: a flag for machines, words for people, None where there is none."""
    return {"pins_rigid": pins_rigid(joint), "stiffness_bound": stiffness_bound(joint) or None}


def bounded(words: str, bound: str | None) -> str:
    """Words for a number, with what bounds it in parentheses."""
    return f"{words} ({bound})" if bound else words
