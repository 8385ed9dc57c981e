"""The states in which a design must hold: torques times deviations within the tolerances of the joint file."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.stats import qmc

from asperity.errors import InputError
from asperity.joint_file.si_tables import contact_in, numeric_keys
from asperity.study.design.design_problem import DesignProblem
from asperity.types import Document

#: More toleranced numbers have too many corners; they are sampled instead.
MOST_CORNERED = 7

_TORQUE = "load.output_torque"


@dataclass(frozen=True)
class Scenarios:
    """States of a design; the first one is the joint as the file has it, the nominal state.

    ``deviations``: dotted path → what is added to the number, shape (scenarios,) [SI]; ``base``: dotted path of
    toleranced numbers → nominal value [SI]; ``torques`` at the output without their deviation, shape (scenarios,)
    [N·m]. ``counted`` ones count for limits and objectives; the nominal state need not.
    """

    deviations: dict[str, np.ndarray]
    torques: np.ndarray
    counted: np.ndarray
    base: dict[str, float]

    def changes(self, point: Document) -> dict[str, np.ndarray]:
        """Numbers of the joint file in every state: dotted path → [SI], shape (scenarios,) or (points, scenarios).

        Of the variables by dotted path [SI]: one number, or shape (points, 1) for many designs at once.
        """
        numbers: dict[str, np.ndarray] = {}
        for path, value in point.items():
            numbers[path] = value + self.deviations.get(path, np.zeros(self.torques.size))
        for path, deviation in self.deviations.items():
            if path not in numbers and path != _TORQUE:
                numbers[path] = self.base[path] + deviation
        if _TORQUE not in point:
            numbers[_TORQUE] = self.torques + self.deviations.get(_TORQUE, 0.0)
        return numbers


def scenarios(problem: DesignProblem) -> Scenarios:
    """All states of a design problem."""
    stated = numeric_keys(problem.case)
    nominal = stated[_TORQUE].value
    worst = problem.worst_case
    paths = [variable.path for variable in problem.variables]
    if worst.torques and _TORQUE in paths:
        raise InputError("load.output_torque cannot be a free variable and have a worst-case range at once")
    toleranced = {path: key for path, key in stated.items() if key.tolerance > 0.0}
    steps = np.zeros((1, len(toleranced)))
    if worst.tolerances == "corners":
        if len(toleranced) > MOST_CORNERED:
            raise InputError(
                f"worst_case.tolerances: {len(toleranced)} toleranced numbers have {2 ** len(toleranced)} corners; "
                f"at most {MOST_CORNERED} numbers, or tolerances = 'samples'"
            )
        steps = np.array([(0.0,) * len(toleranced), *itertools.product((-1.0, 1.0), repeat=len(toleranced))])
    elif worst.tolerances == "samples":
        sampler = qmc.LatinHypercube(d=len(toleranced), rng=np.random.default_rng(worst.seed))
        steps = np.vstack([steps, 2.0 * sampler.random(worst.samples) - 1.0])
    if worst.tolerances != "none":
        for path in toleranced:
            _refuse_overlap(path, paths)
    torques = np.array(worst.torques or (nominal,))
    grid = [(torque, step) for torque in torques for step in steps]
    counted = np.ones(len(grid), dtype=bool)
    is_nominal = [bool(torque == nominal and not step.any()) for torque, step in grid]
    if any(is_nominal):
        grid.insert(0, grid.pop(is_nominal.index(True)))
    else:
        grid.insert(0, (nominal, np.zeros(len(toleranced))))
        counted = np.concatenate([[False], counted])
    table = np.array([step for _, step in grid])
    return Scenarios(
        deviations=(
            {path: key.tolerance * table[:, i] for i, (path, key) in enumerate(toleranced.items())}
            if worst.tolerances != "none"
            else {}
        ),
        torques=np.array([torque for torque, _ in grid]),
        counted=counted,
        base={path: key.value for path, key in toleranced.items()},
    )


def _refuse_overlap(toleranced: str, variables: list[str]) -> None:
    """A tolerance of one contact and a variable of all, or the other way round, would overwrite each other."""
    for path in variables:
        if path == toleranced:
            continue
        short, long = sorted((path.split("."), toleranced.split(".")), key=len)
        contact = contact_in(".".join(long))
        if len(short) < len(long) and short == [part for part in long if part != contact]:
            raise InputError(
                f"variables.{path} overlaps the tolerance of {toleranced}; free and toleranced numbers must be named "
                "alike, contact by contact or for all contacts"
            )
