"""Limits that hold for every design without being stated: that it exists, works, is not damaged and lives long enough.

A limit that the design file states for a result takes the place of the implied one, for the rows that it names.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from asperity.errors import InputError
from asperity.joint_file.any_joint import rows_of_file
from asperity.joint_file.si_tables import AnyCase, Values
from asperity.results import Result
from asperity.results.torque_capacity import JUDGED_ROWS
from asperity.study.design.design_problem import EXISTENCE, Constraint

#: Free distance between two rollers that a design keeps [m]; a joint exists where there is any.
LEAST_CLEARANCE = 0.2e-3

#: Share by which a design stays inside a limit of the model, which itself is crossed: more than the search's tolerance.
_INSIDE = 1e-6


def implied_limits(
    stated: Sequence[Constraint], case: AnyCase, values: Values, results: Mapping[str, Result]
) -> Iterator[Constraint]:
    """Limits of existence, of function and damage, of clearance and of the life that the joint file requires.

    ``values`` are the tables of the joint file, ``results`` those that its drive has.
    """
    for (name, at_most), bound in EXISTENCE.items():
        if name in results:
            rows = tuple(range(len(results[name].row_names)))
            if not any((c.name, c.at_most, c.rows) == (name, at_most, rows) for c in stated):
                limit = LEAST_CLEARANCE if name == "clearance" else bound
                yield Constraint(name, at_most, limit, rows, implied=True)
    for name, at_most, limit in (*_of_rows(results), *_of_life(case), *_of_turn(case)):
        if name not in results:
            continue
        taken = {row for c in stated if (c.name, c.at_most) == (name, at_most) for row in c.rows}
        rows = tuple(row for row in rows_of_file(values, results[name]) if row not in taken)
        if rows:
            yield Constraint(name, at_most, limit, rows, implied=True)


def _of_rows(results: Mapping[str, Result]) -> Iterator[tuple[str, bool, float]]:
    """Bounds of the results that are judged as function or damage."""
    for row in JUDGED_ROWS:
        if row.name not in results or row.limit is None:
            continue
        if math.isfinite(row.limit.highest):
            yield row.name, True, row.limit.highest * (1.0 - _INSIDE)
        if math.isfinite(row.limit.lowest):
            yield row.name, False, row.limit.lowest * (1.0 + _INSIDE)


def _of_life(case: AnyCase) -> Iterator[tuple[str, bool, float]]:
    """The life that the joint file requires of the drive, of its rated bearings, and of its grip under wear."""
    if case.rolling is None or case.rolling.required_life is None:
        return
    life = case.rolling.required_life.value * (1.0 + _INSIDE)
    names = ("duty_life", "bearing_duty_life") if case.duty else ("drive_life", "bearing_life")
    for name in names:
        yield name, False, life
    if case.wear is None or case.load.cam_force_per_torque is not None:
        return
    if case.load.interference is None:
        raise InputError(
            "load.preload: a force does not say what wear takes from it, so that rolling.required_life cannot be kept; "
            "state load.interference, or leave [wear] out of the joint file"
        )
    yield "life_wear", False, life


def _of_turn(case: AnyCase) -> Iterator[tuple[str, bool, float]]:
    """The transmission error that the joint file allows, and that no contact slips within a turn."""
    if case.form is None:
        return
    yield "turn_slip_ratio", True, 1.0 - _INSIDE
    if case.rolling is not None and case.rolling.allowed_transmission_error is not None:
        allowed = case.rolling.allowed_transmission_error.value
        yield "transmission_error", True, allowed * (1.0 - _INSIDE)
