"""Rolling bearings of a joint whose branches differ: loaded by what these leave unbalanced, and by the worst branch."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
from jax import Array

from asperity.branches.results import BranchState, UnequalBranches
from asperity.compilation import call_compiled
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.errors import InputError, NoSolutionError
from asperity.joint.bearing_lives import BearingLives, BearingState, lives_of_bearings
from asperity.joint.description import Joint


def with_duty(
    found: UnequalBranches, joint: Joint, working: Callable[[Any], BranchState | None]
) -> UnequalBranches:
    """Branches with their states under the loads of a duty."""
    states: list[BranchState | None] = []
    speed = "input_speed"
    rolling = dataclasses.replace(joint.rolling, duty=())
    for point in joint.rolling.duty:
        changes: dict[str, Any] = {"output_torque": point.output_torque, speed: point.sun_speed}
        try:
            states.append(working(dataclasses.replace(joint, rolling=rolling, **changes)))
        except (InputError, NoSolutionError):
            states.append(None)
    return dataclasses.replace(found, duty=tuple(states))


def branch_bearing_lives(joint: Joint, branches: UnequalBranches) -> BearingLives:
    """Lives, static safeties and load ratios of the bearings of one joint whose branches differ."""
    names = joint.bearing_names

    def state(found: BranchState | None) -> BearingState:
        if found is None:
            unknown = np.full(len(names), np.nan)
            return BearingState(unknown, unknown)
        held = [found.force_on(name) for name in names[-2:]]
        force = np.array([*np.hypot(*found.largest_pins), *held])
        return BearingState(force, found.bearing_speed)

    working, rest = state(branches.working(turns=float(joint.sun_speed) != 0.0)), state(branches.rest)
    duty = shares = None
    if joint.rolling.duty:
        each = [state(found) for found in branches.duty]
        duty = BearingState(*(np.stack(values) for values in zip(*each, strict=True)))
        shares = np.array([float(point.share) for point in joint.rolling.duty])
    lives: BearingLives = call_compiled(_lives, joint.rated_bearings, working, rest.force, duty, shares)
    return lives


def _lives(
    rated: tuple[RatedBearing | None, ...],
    working: BearingState,
    rest: Array,
    duty: BearingState | None,
    shares: Array | None,
) -> BearingLives:
    return lives_of_bearings(rated, working=working, rest=rest, duty=duty, shares=shares)
