"""Sizes of the branches drawn one by one from the tolerances of a joint file: what unlike planets do to a drive."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.branches.branches import SectorDeviations
from asperity.branches.size_errors import loaded_branches
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import deviations_of, joint_from_case, toleranced_tracks
from asperity.joint_file.model import Case
from asperity.joint_file.quantity_key import Distribution
from asperity.joint_file.si_tables import si_values
from asperity.study.tolerances.uncertainty import quantiles, toleranced_inputs
from asperity.types import Document

#: Shares of the draws below which the stated values lie.
QUANTILES = (0.025, 0.5, 0.975)


@dataclass(frozen=True)
class BranchScatter:
    """A drive whose branches have sizes of their own, in many copies. SI units; draws first.

    Torques [N·m]: at which the weakest branch slips standing, all do, and the weakest does in rolling; ``equal``, the
    capacity, standing, of equal branches of nominal size; ``torque``, the joint's. Largest shares of a branch in the
    torque, standing and in rolling [-], nan where they do not pass it; ``sun_force``, of the planets on the sun's
    bearings [N]. ``loose``: whether a branch is loose; nothing else is known then: its numbers are nan.
    """

    first_slip: np.ndarray
    all_slip: np.ndarray
    rolling_first_slip: np.ndarray
    largest_share: np.ndarray
    largest_rolling_share: np.ndarray
    sun_force: np.ndarray
    loose: np.ndarray
    equal: float
    torque: float
    seed: int

    def document(self) -> Document:
        """Quantiles and shares as plain data, for JSON; None where there is no number."""

        def told(values: np.ndarray) -> list[float] | None:
            known = values[np.isfinite(values)]
            return np.quantile(known, QUANTILES).tolist() if known.size else None

        return {
            "draws": self.first_slip.size,
            "seed": self.seed,
            "quantiles": list(QUANTILES),
            "first_slip_Nm": told(self.first_slip),
            "all_slip_Nm": told(self.all_slip),
            "rolling_first_slip_Nm": told(self.rolling_first_slip),
            "largest_share": told(self.largest_share),
            "largest_rolling_share": told(self.largest_rolling_share),
            "sun_force_N": told(self.sun_force),
            "equal_branches_Nm": self.equal,
            "share_with_a_loose_branch": float(np.mean(self.loose)),
            "share_without_a_balance": float(np.mean(np.isnan(self.first_slip) & ~self.loose)),
            "share_that_slips_under_the_torque": float(np.mean(self.first_slip < self.torque)),
        }


def branch_scatter(
    case: Case,
    *,
    distribution: Distribution | None,
    draws: int,
    seed: int,
    report: Callable[[int, int], Any] | None = None,
) -> BranchScatter:
    """Draw the sizes of every roller of every branch, and solve them together."""
    if draws < 1:
        raise InputError(f"the number of draws must be at least 1, got {draws}", options=["branches"])
    tolerances = toleranced_inputs(case, otherwise=distribution)
    if case.load.interference is None:
        raise InputError(
            "sizes of branches make no preload that a spring holds: give load.interference in place of load.preload"
        )
    values = si_values(case)
    joint = joint_from_case(case)
    count = round(float(joint.drive.sectors))
    tracks = toleranced_tracks(values, tuple(tolerances))
    if not any(track.per_branch for track in tracks):
        raise InputError("no roller off the axis has a tolerance of its radius: the branches are equal")
    base, random = deviations_of(values), np.random.default_rng(seed)
    added = np.tile(base.added, (draws, 1, 1))
    for track in tracks:
        entry, scatter = tolerances[track.path]
        uniform = random.random((draws, count if track.per_branch else 1))
        added += (quantiles(entry, scatter, uniform) - entry.value)[:, :, None] * track.per_size
    solution = solve_joint(joint)
    forward = float(joint.output_torque) >= 0.0
    capacity = solution.standing_capacity if forward else solution.reverse_standing_capacity
    rows = []
    for index in range(draws):
        rows.append(_one(joint, dataclasses.replace(base, added=added[index])))
        if report is not None:
            report(index + 1, draws)
    columns = np.array(rows).T
    return BranchScatter(
        first_slip=columns[0],
        all_slip=columns[1],
        rolling_first_slip=columns[2],
        largest_share=columns[3],
        largest_rolling_share=columns[4],
        sun_force=columns[5],
        loose=columns[6] > 0.0,
        equal=float(capacity.output_torque),
        torque=abs(float(joint.output_torque)),
        seed=seed,
    )


def _one(joint: Joint, sizes: SectorDeviations) -> tuple[float, ...]:
    try:
        branches, limits = loaded_branches(joint, sizes)
    except NoSolutionError:
        return (np.nan,) * 6 + (0.0,)
    except InputError as error:
        if "loose" not in str(error):
            raise
        return (np.nan,) * 6 + (1.0,)
    standing, rolling = (
        np.nan if state is None else float(np.max(state.share))
        for state in (branches.standing, branches.rolling)
    )
    return (
        float(limits.first_slip.output_torque),
        float(limits.standing.output_torque),
        float(limits.rolling.output_torque),
        standing,
        rolling,
        float(np.hypot(*(branches.standing or branches.rest).central_force)),
        float(np.any(branches.preload <= 0.0)),
    )
