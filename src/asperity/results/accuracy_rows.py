"""Rows of the table of results: what the form errors of a joint file do over a turn."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from asperity.errors import NoSolutionError
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.rolling.accuracy import Accuracy, TurnErrors
from asperity.unit_table import Dimension


def accuracy_of_solved(solved: SolvedJoint) -> Accuracy | None:
    """What the form errors of one joint do over a turn; None where it does not roll."""
    assert solved.over_turn is not None
    try:
        return solved.over_turn()
    except NoSolutionError:
        return None


def _turn(solved: SolvedJoint) -> TurnErrors:
    """The sums of what form errors do: of the points of a study, or of one joint."""
    if solved.turn_errors is not None:
        return solved.turn_errors()
    nothing = TurnErrors(math.nan, math.nan, math.nan)
    if solved.over_turn is None:
        return nothing
    accuracy = solved.once(accuracy_of_solved)
    if accuracy is None:
        return nothing
    error = accuracy.transmission_error
    slip = float(np.max(accuracy.slip + accuracy.budget("slip").worst))
    return TurnErrors(float(error.worst), float(error.rms), slip)


def _of_turn(name: str) -> Callable[[SolvedJoint], Any]:
    """One of these numbers."""
    return lambda solved: getattr(solved.once(_turn), name)


_accuracy = functools.partial(
    Result,
    group="accuracy",
    present=lambda solved: (solved.over_turn is not None or solved.turn_errors is not None,),
    only="only a joint whose file states form errors in [[form]] has it",
)
_WHERE = "nan where the joint does not roll, or where form errors are larger or shorter than what is computed"

ROWS = (
    _accuracy(
        "transmission_error",
        "transmission error, worst phases of the form errors",
        Dimension.ANGLE,
        "arcsec",
        _of_turn("transmission_error"),
        note=_WHERE,
        place="accuracy.transmission_error_rad.worst",
    ),
    _accuracy(
        "transmission_error_rms",
        "transmission error, root mean square",
        Dimension.ANGLE,
        "arcsec",
        _of_turn("transmission_error_rms"),
        note=_WHERE,
        place="accuracy.transmission_error_rad.rms",
    ),
    _accuracy(
        "turn_slip_ratio",
        "slip ratio over a turn, worst phases of the form errors",
        Dimension.DIMENSIONLESS,
        "1",
        _of_turn("slip_ratio"),
        note=f"of the contact where it is largest; {_WHERE}",
        place="accuracy.slip_ratio",
    ),
)
