"""Many surfaces of one joint with any drive, and the ends of its stiffness and drift over them."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from asperity.contact.laws.law import ContactLaw
from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.engine.control import entries, stacked, vectorised
from asperity.joint.description import Joint, without_duty
from asperity.joint.evaluation import JointResult, evaluate
from asperity.joint.solve import joint_state
from asperity.types import Document

#: So many surfaces are computed one after the other, 0.1 to 0.5 s each; a program for them compiles for 7 to 40 s.
_FEW = 50


def over_surfaces(joint: Joint, surfaces: tuple[ContactLaw, ...], *, shape: tuple[int, ...]) -> JointResult:
    """One joint with many surfaces, whose numbers broadcast to the shape of one axis; the batch is the first axis.

    Without its duty, of which nobody asks.
    """
    numbers = as_numbers(dataclasses.replace(without_duty(joint), surfaces=()))
    samples = trees.map(lambda leaf: np.array(np.broadcast_to(leaf, shape), dtype=float), surfaces)
    if shape[0] > _FEW:
        return _by_program(numbers, samples)
    return stacked([joint_state(dataclasses.replace(numbers, surfaces=one)) for one in entries(samples)])


def _by_program(joint: Joint, surfaces: tuple[ContactLaw, ...]) -> JointResult:
    """The same of many surfaces, compiled."""
    from asperity.compilation import program_for_few

    found: JointResult = program_for_few(_of_many, joint, surfaces)(joint, surfaces)
    return trees.map(np.asarray, found)


def _of_many(joint: Joint, surfaces: tuple[ContactLaw, ...]) -> JointResult:
    return vectorised(lambda one: evaluate(dataclasses.replace(joint, surfaces=one)))(surfaces)


def result_ends(
    result: JointResult, *, shape: tuple[int, ...], percentiles: tuple[float, float], least_usable: float
) -> Document:
    """Lower and upper end of the stiffness at every level of the model, and of the drift, over a batch of surfaces.

    ``percentiles`` are the ends, 0 and 100 for the smallest and the largest value; ``least_usable``, the share of the
    batch that must be solved and have a stiffness, below which both ends are None. ``published``, ``series_with_bulk``
    and ``assembly`` → ``low_Nm_per_rad`` and ``high_Nm_per_rad`` at the output; ``drift`` → ``low_rad_per_output_turn``
    and ``high_rad_per_output_turn``; ``unsolved`` and ``all_plastic``, the numbers of surfaces that are left out.
    """
    solved = np.broadcast_to(result.solved, shape)
    plastic = solved & ~np.broadcast_to(result.contact_law_holds, shape)
    usable = solved & ~plastic
    known = np.count_nonzero(usable) >= least_usable * usable.size

    def ends(values: Any, unit: str) -> dict[str, float | None]:
        kept = np.broadcast_to(values, shape)[usable]
        finite = known and bool(np.isfinite(kept).all())
        pair = [float(bound) for bound in np.percentile(kept, percentiles)] if finite else [None, None]
        return dict(zip((f"low_{unit}", f"high_{unit}"), pair, strict=True))

    return {
        "unsolved": int(np.count_nonzero(~solved)),
        "all_plastic": int(np.count_nonzero(plastic)),
        "published": ends(result.published.output, "Nm_per_rad"),
        "series_with_bulk": ends(result.series_with_bulk.output, "Nm_per_rad"),
        "assembly": ends(result.assembly.stiffness.output, "Nm_per_rad"),
        "drift": ends(result.rolling.drift_per_output_turn, "rad_per_output_turn"),
    }
