"""Runout and roundness of the parts of a joint file that keep limits."""

from __future__ import annotations

from collections.abc import Sequence

from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.si_tables import AnyCase
from asperity.study.tolerances.runout import AllowedForms, FormLimit, FormSharing, allowed_forms


def joint_forms(case: AnyCase, limits: Sequence[FormLimit], *, sharing: FormSharing) -> AllowedForms:
    """What is allowed of the harmonics that a joint file states, in the direction in which it rolls.

    Raises as :func:`asperity.joint_file.accuracy.joint_accuracy` and
    :func:`asperity.study.tolerances.runout.allowed_forms`.
    """
    found = joint_accuracy(case)
    return allowed_forms(found.forward, found.diameters, limits, sharing=sharing)
