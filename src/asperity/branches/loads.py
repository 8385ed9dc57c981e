"""What the unlike branches of a joint load, in each case of its table of loads."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from asperity.branches.results import UnequalBranches

_NO_STATE = "the branches of the file, [[branch]], do not carry this load, or do not roll under it"
_EQUAL_THRUST = (
    "Axial forces are those of equal branches, not of those of the file; none are stated where equal ones do not carry "
    "the load."
)

Document = dict[str, Any]


class BranchLoads:
    """What the branches of a joint load, in each case of its table.

    Parameters
    ----------
    branches : UnequalBranches or None
        Its branches; None for equal ones.
    turns : bool
        Whether the joint turns.
    """

    def __init__(self, branches: UnequalBranches | None, *, turns: bool) -> None:
        self.states = None if branches is None else branches.cases(turns=turns)

    def entries(self, equal: list[Document], *, skewed: bool) -> tuple[list[Document], list[str]]:
        """The cases by what these branches do, and a note on what is that of equal ones.

        Parameters
        ----------
        equal : list of dict
            From :func:`case_entry`, of equal branches.
        skewed : bool
            Whether there are axial forces, which are those of equal branches.
        """
        if self.states is None:
            return equal, []
        own = [
            case | {"unknown_because": _NO_STATE if state is None else None}
            for case, state in zip(equal, self.states, strict=True)
        ]
        return own, [_EQUAL_THRUST] if skewed else []

    def force_on(self, member: str, equal: Any) -> np.ndarray:
        """Force on a member on the axis [N]; nan where the branches do not carry the load."""
        if self.states is None:
            return np.asarray(equal)
        return np.array([math.nan if each is None else each.force_on(member) for each in self.states])

    def torque_on(self, member: str, equal: Any) -> np.ndarray:
        """Torque of contacts and pins on a member on the axis [N·m], likewise; without a torque that of equal branches.

        Parameters
        ----------
        member : str
            Name of the member.
        equal : array
            Torques of equal branches in all cases.
        """
        if self.states is None:
            return np.asarray(equal)
        return np.array(
            [
                math.nan if own is None else own.torques.get(member, float(without))
                for own, without in zip(self.states, equal, strict=True)
            ]
        )

    def speed_of(self, member: str, equal: Any) -> np.ndarray:
        """Speed of a member on the axis, without sign [rad/s]; likewise."""
        if self.states is None:
            return np.asarray(equal)
        return np.array(
            [
                math.nan if own is None else own.speeds.get(member, float(without))
                for own, without in zip(self.states, equal, strict=True)
            ]
        )

    def speed_on_pins(self, equal: Any) -> np.ndarray:
        """Speeds of rollers on their pins, of the fastest branch, shape (pins, cases) [rad/s]; likewise."""
        if self.states is None:
            return np.asarray(equal)
        count = len(equal)
        unknown = np.full(count, math.nan)
        known = [each is not None and each.bearing_speed.size > 0 for each in self.states]
        return np.stack(
            [
                each.bearing_speed[:count] if has and each is not None else unknown
                for each, has in zip(self.states, known, strict=True)
            ],
            axis=-1,
        )

    def pins(self, equal: Any) -> np.ndarray:
        """Radial and tangential forces on the pins of the branch that loads each most, shape (2, pins, cases) [N].

        Parameters
        ----------
        equal : array
            Those of equal branches.
        """
        if self.states is None:
            return np.asarray(equal)
        unknown = np.full(np.shape(equal)[:2], math.nan)
        return np.stack([unknown if each is None else each.largest_pins for each in self.states], axis=-1)
