"""What a joint file leaves out, and what is assumed instead."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from asperity.joint.description import Joint
from asperity.joint_file.assumed import bodies, contact_law, drive, rolling, supports, surfaces, temperature
from asperity.joint_file.assumed.described import Described
from asperity.joint_file.model import Case

#: What each part of a joint says, in the order in which it is told.
_PARTS: tuple[Callable[[Described], Iterator[str]], ...] = (
    drive.open_sizes,
    supports.friction,
    supports.pins,
    bodies.hollow_stepped,
    supports.play,
    supports.springs,
    drive.placement,
    drive.closures,
    drive.of_type,
    bodies.elasticity,
    drive.balance,
    contact_law.open_dimension,
    contact_law.law,
    surfaces.averages,
    surfaces.depths,
    drive.tolerances,
    drive.loading_cam,
    drive.own_branches,
    drive.form_errors,
    drive.axis_tilts,
    temperature.temperature,
    bodies.crowns,
    rolling.rolling,
    rolling.oil,
    rolling.heat,
    rolling.wear,
    bodies.fatigue,
    surfaces.measured,
)


def assumptions(case: Case, joint: Joint) -> tuple[str, ...]:
    """What a joint file leaves out, and what is taken instead, one sentence each.

    ``joint`` is that of the file, with equal branches.
    """
    file = Described(case, joint)
    return tuple(sentence for part in _PARTS for sentence in part(file))
