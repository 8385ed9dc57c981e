r"""Drag of the oil on the bodies of a drive that rolls.

The oil at the inlet of a contact drags both surfaces against their motion, each with a force g. Its pressure rests on
the film: it pushes both bodies forward through their centres, with

.. math:: 2 g\,\frac{R}{R_1}, \qquad 2 g\,\frac{R}{R_2}, \qquad \frac1R = \frac1{R_1} \pm \frac1{R_2},

minus in internal contacts, so that nothing is left on the film, and no moment about the contact.
"""

from __future__ import annotations

import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, Drive, sectors_of_members, speeds
from asperity.types import namespace


def signed_drag(drive: Drive, drag: Array, *, backwards: Array | float) -> Array:
    """Drag with the sense in which the first surface of each contact moves, shape (contacts,) [N].

    ``drag`` is its size; ``backwards`` is -1 of a drive that rolls against its ideal speeds, else 1.
    """
    first, _ = _bodies(drive)
    speed = speeds(drive)
    ahead = namespace(speed).sign(speed[first] - speed[drive.members.index(CARRIER)])
    forces: Array = backwards * ahead * drag
    return forces


def drag_pairs(drive: Drive, drag: Array) -> Array:
    r"""Forces of the oil between the bodies of each contact, signed as tangential forces, shape (contacts,) [N].

    .. math:: g\,\Bigl(1 - \frac{2R}{R_1}\Bigr)

    Parameters
    ----------
    drive : Drive
        The drive.
    drag : Array
        Drag g on each surface, positive where the first one moves counter-clockwise around its body, shape
        (contacts,) [N].

    Returns
    -------
    Array
        Shape (contacts,) [N].

    References
    ----------
    Balance of the film; equation (B9) of :doc:`/equations`.
    """
    outward = _outward(drive)
    # R/R_1 = R_2/(R_2 +- R_1)
    share = drive.second_radius / (drive.second_radius + outward * drive.first_radius)
    pairs: Array = drag * (1.0 - 2.0 * share)
    return pairs


def drag_levers(drive: Drive) -> Array:
    r"""Moments of the drag on the members over the drag of each contact, :math:`\mp R_i`.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Array
        Counter-clockwise, those on the axis from all sectors, shape (members, contacts) [m].

    References
    ----------
    The drag acts at the surface, the pressure through the centre; equation (B9) of :doc:`/equations`.
    """
    unit = np.eye(len(drive.members))
    first, second = (unit[numbers] for numbers in _bodies(drive))
    levers = _outward(drive)[:, None] * drive.second_radius[:, None] * second
    levers = levers - drive.first_radius[:, None] * first
    moments: Array = sectors_of_members(drive)[:, None] * levers.T
    return moments


def _outward(drive: Drive) -> np.ndarray:
    """-1 where the first body of a contact lies inside the second, else 1, shape (contacts,)."""
    return np.array([-1.0 if contact.internal else 1.0 for contact in drive.contacts])


def _bodies(drive: Drive) -> tuple[np.ndarray, np.ndarray]:
    """Numbers of the first and the second body of each contact among the members."""
    number = {name: place for place, name in enumerate(drive.members)}
    return (
        np.array([number[contact.first] for contact in drive.contacts]),
        np.array([number[contact.second] for contact in drive.contacts]),
    )
