r"""Form errors of the tracks of a drive: by how much their radii change round them, and how often a turn.

.. math:: r_b(\psi) = R_b + \rho_b(\psi), \qquad \rho_b = \sum_n A_n \cos(n \psi + \varphi_n)

The support function about the journal, the bore, or any point of a floating body: a contact at the polar angle
:math:`\vartheta` sees :math:`\psi = \vartheta - \phi_b`, the body turned by :math:`\phi_b` in the frame of the carrier.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, contact_angles
from asperity.engine.arrays import complex_number, xp
from asperity.engine.module import Module
from asperity.types import Array


class Form(Module):
    """The form of the tracks at every contact at one instant, shape (contacts,).

    Parameters
    ----------
    first, second : Array
        By how much the radii of both surfaces are larger there than without form errors [m].
    first_slope, second_slope : Array
        Their derivatives by the polar angle on the body, counter-clockwise [m/rad].
    """

    first: Array
    second: Array
    first_slope: Array
    second_slope: Array


class Hills(NamedTuple):
    """Moments that form errors add on the members, over forces of the contacts, shape (members, contacts) [m].

    ``normal``: where the tracks rise or fall. The carrier has the opposite of the moments on all bodies,
    of the ``tangential`` ones too: pins, which push at their nominal places, know nothing of these.
    """

    normal: Array
    tangential: Array


class Lobes(NamedTuple):
    """A harmonic of one track.

    ``body``: number of its body; ``first`` and ``second``: whether the first and the second surface of each contact is
    on the track, shape (contacts,), of constants; ``harmonic``: how many waves it has round it.
    """

    body: int
    first: np.ndarray
    second: np.ndarray
    harmonic: int


def lobes_of(drive: Drive, sides: Collection[tuple[str, str]], harmonic: int) -> Lobes:
    """A harmonic of the track that has these sides of contacts: (name, "first" or "second")."""
    first, second = (
        np.array([(contact.name, side) in sides for contact in drive.contacts])
        for side in ("first", "second")
    )
    bodies = {*drive.layout.first[first], *drive.layout.second[second]}
    assert len(bodies) == 1, "a track is on one body"
    return Lobes(int(bodies.pop()), first, second, harmonic)


def waves_at_contacts(drive: Drive, lobes: Lobes) -> tuple[Array, Array]:
    r"""Form of a harmonic at both surfaces of each contact as complex numbers, over its amplitude at no turn and phase.

    .. math:: e^{i n \vartheta}

    0 where the surface is another one, shape (contacts,) [-].
    """
    first, second = contact_angles(drive)
    return (
        _wave(lobes.first, lobes.harmonic * first),
        _wave(lobes.second, lobes.harmonic * second),
    )


def _wave(there: np.ndarray, angle: Array) -> Array:
    """exp(i angle) where a surface is the one of a wave, else 0."""
    wave: Array = complex_number(xp.where(there, xp.cos(angle), 0.0), xp.where(there, xp.sin(angle), 0.0))
    return wave


def form_of_waves(first: np.ndarray, second: np.ndarray, harmonic: int) -> Form:
    """The form whose real parts these complex waves are [m]; its slopes are those of n waves round each body."""
    turned = 1j * harmonic
    waves = first, second, turned * first, turned * second
    return Form(*(xp.asarray(wave.real) for wave in waves))


def orders(drive: Drive, lobes: Lobes, speed: Array) -> Array:
    r"""Order of a harmonic: its waves per turn of the output.

    .. math:: n\,\frac{|\omega_b - \omega_c|}{|\omega_{out}|}

    Parameters
    ----------
    drive : Drive
        The drive.
    lobes : Lobes
        A harmonic of one of its tracks.
    speed : Array
        Angular velocities of the members, in any unit, shape (members,).

    Returns
    -------
    Array
        Order, shape () [-].

    References
    ----------
    Elementary; equation (R1) of :doc:`/equations`.
    """
    layout = drive.layout
    return lobes.harmonic * abs((speed[lobes.body] - speed[layout.carrier]) / speed[layout.output])
