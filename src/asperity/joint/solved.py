"""A solved joint with the paper's drive, whose capacities come from the programs that solved it."""

from __future__ import annotations

import dataclasses
import functools

import jax
import numpy as np

from asperity.joint.branch_results import UnequalBranches
from asperity.joint.description import Joint
from asperity.joint.evaluated import evaluated
from asperity.joint.evaluation import JointResult
from asperity.joint.loss_note import loss_notes, skew_notes
from asperity.joint.plausibility import plausibility
from asperity.joint.results.result import SolvedJoint
from asperity.joint.rolling_refusal import rolling_capacity_of
from asperity.joint.solve import Solution


class SolvedPapersJoint(SolvedJoint):
    """One solved joint with the paper's drive.

    Parameters
    ----------
    joint : Joint
        The joint that was solved.
    solution : Solution
        What came out.
    branches : UnequalBranches, optional
        Its branches, if their sizes differ.
    """

    def __init__(self, joint: Joint, solution: Solution, branches: UnequalBranches | None = None) -> None:
        result = solution.result
        notes = (
            *plausibility(joint, result, solution.sizes),
            *loss_notes(result.rolling, result.contact_names),
            *skew_notes(result.rolling, result.contact_names),
        )
        super().__init__(joint, result, solution.capacity, branches, notes)
        self.solution = solution
        self.reverse_capacity = solution.reverse_capacity
        forward = float(np.asarray(joint.output_torque)) >= 0.0
        self.capacity_of_direction = solution.capacity if forward else solution.reverse_capacity

    @functools.cached_property
    def duty_states(self) -> tuple[tuple[Joint, JointResult], ...]:
        """The joint under each load of its duty, and its result, with equal branches."""
        numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), self.joint)
        found = []
        for point in numbers.rolling.duty:
            there = dataclasses.replace(numbers, output_torque=point.output_torque, sun_speed=point.sun_speed)
            found.append((there, evaluated(there)))
        return tuple(found)

    @functools.cached_property
    def rolling_capacity(self) -> float:
        """Largest positive output torque under which the joint rolls [N·m]."""
        return rolling_capacity_of(self.joint, self.solution, direction=1.0)

    @functools.cached_property
    def reverse_rolling_capacity(self) -> float:
        """Largest negative output torque under which the joint rolls, as a positive number [N·m]."""
        return rolling_capacity_of(self.joint, self.solution, direction=-1.0)
