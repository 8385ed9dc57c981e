"""Every limit of one solved joint: kept or crossed, what that means, and what to do."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

import numpy as np

from asperity.results import SEVERITIES, Limit, Result
from asperity.results.heat_document import steady_torque_of
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.units import format_quantity


@dataclass(frozen=True, slots=True)
class LimitCheck:
    """Value of a result of the table, which has the limit, at one contact; None for the whole drive."""

    result: Result
    contact: str | None
    value: float

    @property
    def rule(self) -> Limit:
        """The limit with its words."""
        assert self.result.limit is not None
        return self.result.limit

    @property
    def limit(self) -> float:
        """The bound that the value is nearer to."""
        return self.rule.nearer_bound(self.value)

    @property
    def ok(self) -> bool:
        """Whether the limit is kept; never where the value is nan, or lacks something."""
        return self.rule.is_kept(self.value)

    @property
    def known(self) -> bool:
        """Whether the value shows that the limit is kept or crossed."""
        return self.rule.is_known(self.value)

    @property
    def meaning(self) -> str:
        """What it means that the limit is kept or crossed, or why neither is known."""
        if math.isnan(self.value):
            return self.rule.unknown
        if not self.known:
            return f"not judged: {self.rule.missing}"
        return self.rule.kept if self.ok else self.rule.crossed


def checked_limits(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Every limit of one solved joint, contact by contact, the most serious first."""
    judged = [with_pins(row, solved) for row in results_of_joint(solved).values() if row.limit is not None]
    judged.sort(key=lambda row: SEVERITIES.index(row.limit.severity))  # type: ignore[union-attr]
    return tuple(
        LimitCheck(row, name or None, value) for row in judged for name, value in row.rows_of(solved).items()
    )


def with_pins(row: Result, solved: SolvedJoint) -> Result:
    """The self-locking ratio with what is known of the pins, no steady temperature with why and up to which torque.

    Every other row as it is.

    Not self-locking is a state, with the forces of the pins; it keeps the joint from working only where no balance
    gives these forces, or where they exceed the static rating of the rollers' bearings on the pins.
    """
    if row.name == "ambient_reserve" and "solution" in vars(solved):
        return _with_steady_torque(row, solved)
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
        said += "; whether they can carry it is not judged without [pin_bearing]"
    else:
        rows = table["bearing_static_safety"].rows_of(solved)
        safety = float(np.nanmin([math.inf, *(x for name, x in rows.items() if name.endswith("_pin"))]))
        if safety < 1.0:
            return _fails(row, f"{said}, more than the static rating of their bearings (safety {safety:.3g})")
        unknown = any(math.isnan(x) for name, x in rows.items() if name.endswith("_pin"))
        said += "; the static safety of their bearings is " + ("not known" if unknown else f"{safety:.3g}")
    return dataclasses.replace(row, limit=dataclasses.replace(row.limit, crossed=said))


def _with_steady_torque(row: Result, solved: SolvedJoint) -> Result:
    """The limit of the temperature with why a joint has no steady one, and the torque up to which it has."""
    torque = steady_torque_of(solved)
    if row.limit is None or torque is None:
        return row
    up_to = "no torque" if math.isnan(torque) else f"torques up to {format_quantity(torque, 'N*m')}"
    assert solved.joint.heat is not None
    crossed = row.limit.crossed.replace("thermal runaway", solved.joint.heat.unsteady_because)
    crossed = crossed.replace("; all", f"; {up_to} at this speed would settle; all")
    return dataclasses.replace(row, limit=dataclasses.replace(row.limit, crossed=crossed))


def _fails(row: Result, said: str) -> Result:
    assert row.limit is not None
    return dataclasses.replace(
        row, limit=dataclasses.replace(row.limit, severity="function", crossed=said, state="")
    )
