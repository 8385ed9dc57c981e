"""Sizes of the branches of a joint that differ, as input."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np

from asperity.errors import InputError
from asperity.units import format_quantity

#: Largest interference of a branch over that of equal branches [-].
WIDEST = 3.0


def refuse_wide(interference: np.ndarray, nominal: float) -> None:
    """Refuse branches that are pressed much more than the equal ones around which their laws are taken."""
    if np.any(interference > WIDEST * nominal):
        branch = int(np.argmax(interference)) % interference.shape[-1] + 1
        raise InputError(
            f"the interference of branch {branch}, {format_quantity(float(np.max(interference)), 'um')}, is more than "
            f"{WIDEST:g} times that of equal branches at the working temperature, {format_quantity(nominal, 'um')}; "
            "state smaller deviations or a larger interference"
        )


@dataclass(frozen=True)
class SectorDeviations:
    """Deviations of the sizes of each sector of a drive from the nominal ones, and the bearings of its input.

    Parameters
    ----------
    deviations : dict
        Names of the tracks → deviations of their radii, larger positive, one for each sector, shape (n,) [m].
    added : ndarray
        Interference that they add to each contact of each sector, shape (n, contacts) [m].
    per_size : ndarray
        Interference of the contacts of a sector over the deviation of the track that comes first, shape (contacts,)
        [-].
    sun_support_stiffness : float
        Radial stiffness of the bearings of the sun, the input [N/m]: 0 for a floating one, ``math.inf`` for one that is
        held.
    """

    deviations: dict[str, np.ndarray]
    added: np.ndarray
    per_size: np.ndarray
    sun_support_stiffness: float

    def with_first(self, added: float) -> SectorDeviations:
        """The same with a further deviation of the first track of the first sector [m]."""
        first = np.eye(len(self.added))[0]
        name = next(iter(self.deviations))
        return dataclasses.replace(
            self,
            deviations=self.deviations | {name: self.deviations[name] + added * first},
            added=self.added + added * np.outer(first, self.per_size),
        )
