"""A rolling drive with the equations that it fulfils, for what disturbs it."""

from __future__ import annotations

from typing import NamedTuple

from asperity.drive.layout.drive import Drive
from asperity.drive.state.equations import ROLLING, Machine, Task
from asperity.drive.state.search import Balance, solved, state_of
from asperity.drive.state.state import ContactLaws, CreepOf, DriveLoad, DriveState
from asperity.drive.state.states import under_load
from asperity.engine.arrays import xp


class RollingBalance(NamedTuple):
    """A drive in steady rolling with the equations that it fulfils: what turns a little differently starts from it."""

    machine: Machine
    task: Task
    balance: Balance

    @property
    def state(self) -> DriveState:
        """The state itself."""
        return state_of(*self)


def rolling_balance(
    *, drive: Drive, laws: ContactLaws, rest: DriveState, load: DriveLoad, creep_of: CreepOf | None = None
) -> RollingBalance:
    """A drive in steady rolling under a torque, from its assembled state, and its equations.

    Parameters
    ----------
    drive, laws, rest, load, creep_of : Drive, ContactLaws, DriveState, DriveLoad, callable or None
        As for :func:`loaded_state`.

    Returns
    -------
    RollingBalance
        Check the ``residual`` of its state.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    machine, loaded, (unknowns, slides) = under_load(drive, laws, rest, load, creep_of)
    holding = xp.zeros_like(slides)
    task = loaded._replace(kind=ROLLING)
    for by_laws in (True,) if creep_of is None else (True, False):
        task = task._replace(by_laws=by_laws)
        found = solved(machine, task, unknowns, slides=holding, pressed_sectors=0)
        unknowns = found.unknowns
    return RollingBalance(machine, task, found)
