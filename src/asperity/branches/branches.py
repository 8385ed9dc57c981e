"""A joint whose sectors differ in size: every sector by itself, around the forces of its own interference."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import CARRIER
from asperity.drive.layout.expansion import ring_interference
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.drive.types import TYPES
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.errors import InputError, NoSolutionError
from asperity.implicit import SETTLED
from asperity.joint.description import Joint
from asperity.joint.solve import refuse_impossible_joint, refuse_not_pressed
from asperity.joint.unfolding import SectorSizes, SettledSectors, settled_sectors, unfolded_joint
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
    input_support_stiffness : float
        Radial stiffness of the bearings of the input [N/m]: 0 for a floating one, ``math.inf`` for one that is
        held.
    """

    deviations: dict[str, np.ndarray]
    added: np.ndarray
    per_size: np.ndarray
    input_support_stiffness: float

    def with_first(self, added: float) -> SectorDeviations:
        """The same with a further deviation of the first track of the first sector [m]."""
        first = np.eye(len(self.added))[0]
        name = next(iter(self.deviations))
        return dataclasses.replace(
            self,
            deviations=self.deviations | {name: self.deviations[name] + added * first},
            added=self.added + added * np.outer(first, self.per_size),
        )


class AssembledBranches(NamedTuple):
    """A joint whose sectors differ, without torque.

    Parameters
    ----------
    equal, joint : Joint
        With equal sectors, and with every sector by itself: contacts and rollers have the number of their sector behind
        their names. Of NumPy's numbers.
    sizes : SectorDeviations
        What differs.
    settled : SettledSectors
        Forces around which the laws of the contacts are taken.
    floating : tuple of str
        Names of the bodies on the axis whose centres can move.
    """

    equal: Joint
    joint: Joint
    sizes: SectorDeviations
    settled: SettledSectors
    floating: tuple[str, ...]

    @property
    def sectors(self) -> int:
        """Number of sectors."""
        return sector_count(self.equal)

    @property
    def equal_interference(self) -> float:
        """Interference of each sector if all were equal [m]."""
        added = np.zeros_like(self.sizes.added)
        return float(np.mean(_interference(self.equal, self.settled, added)))

    @property
    def noun(self) -> str:
        """What a sector is called."""
        return _noun(self.equal)


def assembled_branches(joint: Joint, sizes: SectorDeviations) -> AssembledBranches:
    """A joint with every sector by itself, without torque; equation (I4) of :doc:`/equations`.

    One deviation for each sector; a loading cam adds to the preload, an interference, under a torque. Raises InputError
    if the bodies do not fit, the number of sizes is not that of the sectors, or a sector is loose; NoSolutionError if
    no balance was found.
    """
    if joint.interference is None:
        raise InputError("sizes of branches make no preload that a spring holds: give load.interference")
    equal = refuse_impossible_joint(joint)
    count = sector_count(equal)
    if len(sizes.added) != count:
        raise InputError(
            f"the drive has {count} {_noun(equal)}s, got the sizes of {len(sizes.added)} branches"
        )
    floating = _floating(equal, sizes)
    support = 0.0 if math.isinf(sizes.input_support_stiffness) else sizes.input_support_stiffness
    given = SectorSizes(*map(xp.asarray, (sizes.added, np.zeros_like(sizes.added), support)))
    settled: SettledSectors = at_once(partial(settled_sectors, count, floating), equal, given)
    _refuse_unsettled(equal, sizes, settled, floating)
    unfolded = unfolded_joint(equal, settled.sizes, sectors=count, floating=floating)
    rolling = dataclasses.replace(unfolded.rolling, duty=equal.rolling.duty)
    numbers: Joint = trees.map(np.asarray, dataclasses.replace(unfolded, rolling=rolling))
    return AssembledBranches(equal, numbers, sizes, settled, floating)


def sector_count(joint: Joint) -> int:
    """Number of equal sectors of a joint."""
    return round(float(joint.drive.sectors))


def _noun(joint: Joint) -> str:
    sectors = TYPES[joint.type].sectors
    return "sector" if sectors is None else sectors.each


def _floating(joint: Joint, sizes: SectorDeviations) -> tuple[str, ...]:
    """The input where its bearings give way."""
    if math.isinf(sizes.input_support_stiffness):
        return ()
    body = joint.drive.input
    if body == CARRIER:
        raise InputError(
            "compliance.sun_support_stiffness: the input of this drive is the carrier, which stays centred; leave it "
            "out"
        )
    if sector_count(joint) < 3 and sizes.input_support_stiffness == 0.0:
        raise InputError(
            f"nothing holds a floating {body} between two sectors; give compliance.sun_support_stiffness a value above "
            "0, or leave it out"
        )
    return (body,)


def _refuse_unsettled(
    joint: Joint, sizes: SectorDeviations, settled: SettledSectors, floating: tuple[str, ...]
) -> None:
    """Refuse sectors that are loose, pressed too much, or without a balance."""
    refuse_not_pressed(joint, settled.equal)
    noun, interference = _noun(joint), _interference(joint, settled, sizes.added)
    refuse_wide(interference, float(np.mean(_interference(joint, settled, np.zeros_like(sizes.added)))))
    if not floating and not any(contact.sector for contact in joint.drive.contacts):
        _refuse_loose(noun, interference)
    if not settled.without_torque.rest.residual < STATE_TOLERANCE:
        stated = ", ".join(format_quantity(float(deviation), "um", 3) for deviation in interference)
        raise NoSolutionError(
            f"no balance without torque presses every {noun}: one is loose, or nothing holds it; with the members on "
            f"the axis centred their interferences are {stated}; state smaller deviations, or raise load.interference"
        )
    if not settled.change < SETTLED:
        raise NoSolutionError(
            "the laws of the contacts and the forces of the branches do not settle; state smaller deviations"
        )


def _interference(joint: Joint, settled: SettledSectors, added: np.ndarray) -> np.ndarray:
    """Interference of each sector with the members on the axis centred [m]."""
    assert joint.interference is not None
    return mean_interference(joint, settled, np.asarray(joint.working_pattern) * joint.interference + added)


def mean_interference(joint: Joint, settled: SettledSectors, of_contacts: np.ndarray) -> np.ndarray:
    """Interference of the rings that does the work of those of all contacts, sector by sector, shape (sectors,) [m].

    ``of_contacts`` are the interferences of the contacts of each sector, shape (sectors, contacts) [m]; the joint has
    equal sectors, ``settled`` are its own without torque.
    """
    forces = xp.asarray(settled.equal.normal)
    return np.array(
        [
            float(ring_interference(drive=joint.drive, forces=forces, interference=xp.asarray(row)))
            for row in of_contacts
        ]
    )


def _refuse_loose(noun: str, interference: np.ndarray) -> None:
    loose = np.flatnonzero(interference <= 0.0)
    if loose.size == interference.size:
        raise InputError(
            "the deviations of the radii leave no branch with an interference: the drive is loose"
        )
    if loose.size:
        left = format_quantity(float(interference[loose[0]]), "um", 4)
        raise InputError(
            f"{noun} {loose[0] + 1} is loose: its sizes leave an interference of {left}; a drive of this type is "
            "solved with all of them pressed: state smaller deviations, or raise load.interference"
        )
