r"""Incremental stiffness of any roller drive around a state: all its springs at once.

The springs of the contacts and pins carry forces f, the centres move by u and the members turn by :math:`\psi`:

.. math::
    C f = B\,(u, \psi), \qquad B^\mathsf{T} f = g
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive, incidence, sectors_of_members
from asperity.drive.state.supports import Supports, with_supports
from asperity.engine.arrays import xp
from asperity.engine.control import put
from asperity.linear import product, solve
from asperity.types import Array, Real


class NetworkStiffness(NamedTuple):
    """Stiffness of a drive, and where its compliance comes from.

    Parameters
    ----------
    output : Array
        Torque over rotation of the output, input and grounded member locked [N·m/rad].
    tangential_share, normal_share : Array
        Shares of each contact's springs in the compliance, shape (contacts,) [-].
    pin_share : Array
        Share of the pins [-].
    tangential_force, normal_force : Array
        Forces of the contacts under a unit torque, shape (contacts,) [N].
    support_share : Array
        Shares of the supports on the carrier, then of the bearings along each displacement, shape (springs,) [-].
    """

    output: Array
    tangential_share: Array
    normal_share: Array
    pin_share: Array
    tangential_force: Array
    normal_force: Array
    support_share: Array


def network_stiffness(
    *,
    drive: Drive,
    normal_compliance: Array | None,
    tangential_compliance: Array,
    coupling: Array | None = None,
    pin_compliance: Real = 0.0,
    sliding_friction: Array | None = None,
    support_stiffness: Array | None = None,
    supports: Supports | None = None,
) -> NetworkStiffness:
    r"""Torsional stiffness at the output of a drive with springs at its contacts.

    .. math:: K = 1/\psi_{out}, \qquad \text{share}_j = f_j (B\,(u, \psi))_j / \psi_{out}

    under a unit torque at the output. Where a contact slides as a whole, :math:`f_t = \pm\mu f_n` takes the place of
    its tangential spring.

    Parameters
    ----------
    drive : Drive
        The drive.
    normal_compliance : Array or None
        Of each contact, incremental, shape (contacts,) [m/N]; None where the centres are held.
    tangential_compliance : Array
        Of each contact, incremental, shape (contacts,) [m/N].
    coupling : Array or None, optional
        Further compliances between the normal, then the tangential springs, perhaps the pins, shape (2 contacts, 2
        contacts) or with the pins [m/N].
    pin_compliance : Real, optional
        Of each pin along its push, shape () or (pins,) [m/N].
    sliding_friction : Array or None, optional
        Tangential over normal force of the contacts that slide, counter-clockwise as in
        :class:`asperity.drive.state.state.DriveState`, 0 for those that hold, shape (contacts,) [-]; None where all
        hold.
    support_stiffness : Array or None, optional
        Radial stiffness of the bearings of each floating body, shape (floating,) [N/m]; None for none.
    supports : Supports or None, optional
        Springs between floating centres and the carrier; None for none.

    Returns
    -------
    NetworkStiffness
        nan where the contacts cannot carry the torque.

    References
    ----------
    Equations (A8) and (M1) of :doc:`/equations`.
    """
    turning = np.array([name not in (drive.input, drive.grounded) for name in drive.members]).nonzero()[0]
    springs = _springs(drive, normal_compliance, tangential_compliance, coupling, pin_compliance, supports)
    count, first = len(drive.contacts), 0 if normal_compliance is None else len(drive.contacts)
    tied = np.eye(len(turning)) if first else _tied(drive, [drive.members[i] for i in turning])
    scale, length = xp.mean(tangential_compliance), xp.max(drive.second_radius)
    copies = sectors_of_members(drive)[turning]
    turns = product(tied.T, springs.turns[:, turning] / length)
    moments = product(tied.T, springs.moments[:, turning] * copies / length)
    kinematic, static = (xp.concatenate([springs.moves, columns], axis=1) for columns in (turns, moments))
    laws, moved_by, slides = _with_sliding(springs.compliance / scale, kinematic, sliding_friction, first)
    bearings = xp.zeros(kinematic.shape[1])
    if first and support_stiffness is not None:
        bearings = put(bearings, np.s_[: 2 * len(support_stiffness)], xp.repeat(support_stiffness, 2) * scale)
    system = xp.block([[laws, -moved_by], [static.T, xp.diag(bearings)]])
    output = tied[turning == drive.members.index(drive.output)]
    place = len(system) - tied.shape[1] + int(np.argmax(output))
    force, moved = xp.split(solve(system, -xp.eye(len(system))[place] / length), [len(kinematic)])
    turned = xp.abs(moved[place - len(kinematic)]) * scale / length
    longer = xp.where(slides, product(kinematic, moved) * scale, product(springs.compliance, force))
    shares, end = drive.sectors * force * longer / turned, first + count
    held = drive.sectors * bearings * scale * moved**2 / turned
    return NetworkStiffness(
        output=1.0 / turned,
        tangential_share=shares[first:end],
        normal_share=shares[:count] if first else xp.zeros(count),
        pin_share=xp.sum(shares[end : end + len(drive.pinned)]),
        tangential_force=force[first:end],
        normal_force=force[:count] if first else xp.zeros(count),
        support_share=xp.concatenate([shares[end + len(drive.pinned) :], held]),
    )


class SpringLaws(NamedTuple):
    r"""Springs of a drive whose centres float, for any of its motions. SI units.

    .. math:: L f = B q, \qquad n B^\mathsf{T} f + k q = g

    with the forces f of the springs of one sector of n, and the loads g of a motion q: the displacements of the
    floating centres, seen from the carrier, then the rotations of all members.

    Parameters
    ----------
    laws : Array
        L: compliances of the springs; of a contact that slides as a whole :math:`f_t - \mu f_n = 0`, shape (springs,
        springs) [m/N] or [-].
    elongation : Array
        B: how motions lengthen the springs, shape (springs, motions) [-] for displacements, [m] for rotations.
    slides : Array
        Which springs are those of contacts that slide, shape (springs,).
    bearings : Array
        k: springs of the bearings along each motion, shape (motions,) [N/m].
    """

    laws: Array
    elongation: Array
    slides: Array
    bearings: Array


def spring_laws(
    *,
    drive: Drive,
    normal_compliance: Array,
    tangential_compliance: Array,
    coupling: Array | None,
    pin_compliance: Real,
    sliding_friction: Array,
    support_stiffness: Array | None,
    supports: Supports | None,
) -> SpringLaws:
    r"""Springs of a drive with floating centres: normal and tangential ones of the contacts, pins, supports.

    .. math:: L f = B q

    Parameters
    ----------
    drive : Drive
        The drive.
    normal_compliance, tangential_compliance : Array
        Of each contact, incremental, shape (contacts,) [m/N].
    coupling, pin_compliance, sliding_friction, support_stiffness, supports
        As for :func:`network_stiffness`.

    Returns
    -------
    SpringLaws
        nan where a compliance is.

    References
    ----------
    Equations (A8) and (M1) of :doc:`/equations`.
    """
    springs = _springs(drive, normal_compliance, tangential_compliance, coupling, pin_compliance, supports)
    motions = xp.concatenate([springs.moves, springs.turns], axis=1)
    laws, _, slides = _with_sliding(springs.compliance, motions, sliding_friction, normal_compliance.size)
    bearings = xp.zeros(motions.shape[1])
    if support_stiffness is not None:
        bearings = put(bearings, np.s_[: 2 * support_stiffness.size], xp.repeat(support_stiffness, 2))
    return SpringLaws(laws, motions, slides, bearings)


class _Springs(NamedTuple):
    """Springs of a drive: their compliances [m/N], and how centres and members move and load them, springs first."""

    compliance: Array
    moves: Array
    turns: Array
    moments: Array


def _springs(
    drive: Drive,
    normal_compliance: Array | None,
    tangential_compliance: Array,
    coupling: Array | None,
    pin_compliance: Real,
    supports: Supports | None,
) -> _Springs:
    """Tangential springs of held centres; of floating ones the normal springs before, pins and supports behind them."""
    matrices = incidence(drive)
    if normal_compliance is None:  # the held centres pass their moments on to the carrier
        held = xp.zeros((tangential_compliance.size, 0))
        return _Springs(xp.diag(tangential_compliance), held, matrices.turning, matrices.turning)
    pins = xp.broadcast_to(xp.asarray(pin_compliance, dtype=float), (len(drive.pinned),))
    if supports is not None:
        pins = xp.concatenate([pins, supports.compliance])
        matrices = with_supports(matrices, supports)
    carrier = np.eye(len(drive.members))[drive.members.index(CARRIER)]
    levers, nothing = -matrices.levers[:, None] * carrier, xp.zeros_like(matrices.turning)
    compliance = xp.diag(xp.concatenate([normal_compliance, tangential_compliance, pins]))
    if coupling is not None:
        compliance = compliance + xp.pad(coupling, (0, len(compliance) - len(coupling)))
    return _Springs(
        compliance=compliance,
        moves=xp.concatenate([matrices.approach, matrices.sliding, matrices.pins]),
        turns=xp.concatenate([nothing, matrices.turning, xp.zeros_like(levers)]),
        moments=xp.concatenate([nothing, matrices.turning * (1.0 - carrier), levers]),
    )


def _with_sliding(
    compliance: Array, kinematic: Array, friction: Array | None, first: int
) -> tuple[Array, Array, Array]:
    """Laws of springs, what lengthens them, and which slide: contacts whose tangential springs start at ``first``."""
    size = len(kinematic)
    if friction is None:
        return compliance, kinematic, xp.zeros(size, dtype=bool)
    behind = size - first - friction.size
    laws = xp.eye(size)
    if first:
        laws = laws - xp.pad(xp.diag(friction), ((first, behind), (0, first + behind)))
    slides = xp.pad(friction != 0.0, (first, behind))
    return (
        xp.where(slides[:, None], laws, compliance),
        xp.where(slides[:, None], 0.0, kinematic),
        slides,
    )


def _tied(drive: Drive, names: list[str]) -> np.ndarray:
    """Angles of the members over the free ones, of which bodies that turn alike have one, shape (turning, free)."""
    leaders = {name: group[0] for group in drive.turning_alike for name in group}
    free = [name for name in names if leaders.get(name, name) == name]
    return np.array([[float(leaders.get(name, name) == other) for other in free] for name in names])


def with_shafts(
    *, stiffness: Array, ratio: Real, input_shaft_stiffness: Real, output_shaft_stiffness: Real
) -> tuple[Array, Array, Array]:
    r"""Stiffness at the output with shafts, and the shafts' shares in the compliance.

    .. math:: \frac1{K'} = \frac1K + \frac1{i^2 k_{in}} + \frac1{k_{out}}

    Parameters
    ----------
    stiffness : Array
        Of the drive, at the output [N·m/rad].
    ratio : Real
        Speed ratio i [-].
    input_shaft_stiffness, output_shaft_stiffness : Real
        Torsional stiffness of the shafts [N·m/rad]; ``math.inf`` is rigid.

    Returns
    -------
    tuple of Array
        Stiffness [N·m/rad], shares of the input and of the output shaft [-].

    References
    ----------
    Elementary: the angle of the input shaft divided by the ratio, under the torque divided by the ratio.
    """
    # derivatives of a rigid shaft: 0
    at_input = 1.0 / xp.asarray(input_shaft_stiffness, dtype=float) / ratio**2
    at_output = 1.0 / xp.asarray(output_shaft_stiffness, dtype=float)
    compliance = 1.0 / stiffness + at_input + at_output
    return 1.0 / compliance, at_input / compliance, at_output / compliance
