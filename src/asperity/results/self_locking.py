"""A wedge that does not hold itself by friction: what its pins carry instead, and whether they can."""

from __future__ import annotations

import dataclasses
import math

from asperity.results import Result
from asperity.results.drive_table import results_of_joint
from asperity.results.solved import SolvedJoint
from asperity.units import format_quantity


def with_pins(row: Result, solved: SolvedJoint) -> Result:
    """The self-locking ratio with what is known of the pins; every other row as it is.

    Parameters
    ----------
    row : Result
        A row of the table of results with a limit.
    solved : SolvedJoint
        One joint, without batch axes.

    Returns
    -------
    Result
        Not self-locking is a state, with the forces of the pins; it keeps the joint from working only where no balance
        gives these forces, or where they exceed the static rating of the rollers' bearings on the pins.
    """
    if row.name != "self_locking_ratio" or row.limit is None:
        return row
    said, table = row.limit.crossed, results_of_joint(solved)
    forces = table["pin_load"].rows_of(solved)
    if not all(map(math.isfinite, forces.values())):
        return _fails(row, f"{said}; no balance gives their forces")
    carried = " and ".join(
        f"{format_quantity(force, 'N')} ({name.replace('_', ' ')})" for name, force in forces.items()
    )
    said += f": {carried}"
    if solved.joint.pin_bearing is None:
        said += "; whether they can is not judged without [pin_bearing]"
    else:
        rows = table["bearing_static_safety"].rows_of(solved)
        safety = min(value for name, value in rows.items() if name.endswith("_pin"))
        if not safety >= 1.0:
            return _fails(row, f"{said}, more than the static rating of their bearings (safety {safety:.3g})")
        said += f"; their bearings have a static safety of {safety:.3g}"
    return dataclasses.replace(row, limit=dataclasses.replace(row.limit, crossed=said))


def _fails(row: Result, said: str) -> Result:
    assert row.limit is not None
    return dataclasses.replace(
        row, limit=dataclasses.replace(row.limit, severity="function", crossed=said, state="")
    )
