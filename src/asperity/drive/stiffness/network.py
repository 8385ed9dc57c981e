r"""Incremental stiffness of any roller drive around a state: all its springs at once.

The springs of the contacts and pins carry forces f, the centres move by u and the members turn by :math:`\psi`:

.. math::
    C f = B\,(u, \psi), \qquad B^\mathsf{T} f = g
"""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, Drive, incidence, sectors_of_members
from asperity.drive.state.supports import Supports, with_supports
from asperity.linear import product, solve
from asperity.types import Real


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
        Shares of the supports on the carrier, shape (springs,) [-].
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
    matrices, members = incidence(drive), drive.members
    count, carrier, held = len(drive.contacts), members.index(CARRIER), len(drive.pinned)
    turning = [i for i, name in enumerate(members) if name not in (drive.input, drive.grounded)]
    turns_at = np.array(turning)
    out = members.index(drive.output)
    copies = sectors_of_members(drive)
    floats = normal_compliance is not None
    compliance = [tangential_compliance]
    at_carrier = np.eye(len(members))[carrier]
    rotating = matrices.turning * (1.0 - at_carrier)
    # rows: springs; columns: displacements of the centres, then rotations
    moves, balances = [matrices.sliding], [rotating]
    turns = [matrices.turning]
    pins = jnp.broadcast_to(jnp.asarray(pin_compliance, dtype=float), (held,))
    if supports is not None:
        pins = jnp.concatenate([pins, supports.compliance])
        matrices = with_supports(matrices, supports)
    lever = -matrices.levers[:, None] * at_carrier
    if normal_compliance is not None:
        nothing = jnp.zeros_like(rotating)
        compliance = [normal_compliance, *compliance, pins]
        moves = [matrices.approach, *moves, matrices.pins]
        turns, balances = [nothing, *turns, jnp.zeros_like(lever)], [nothing, *balances, lever]
    else:  # the moment of the held centres on the carrier
        balances = [matrices.turning]
    stiff = jnp.diag(jnp.concatenate(compliance))
    if floats and coupling is not None:
        stiff = stiff + jnp.pad(coupling, (0, stiff.shape[0] - coupling.shape[0]))
    scale = jnp.mean(tangential_compliance)
    length = jnp.max(drive.second_radius)
    kinematic = jnp.concatenate(turns)[:, turns_at] / length
    static = jnp.concatenate(balances)[:, turns_at] * copies[turns_at] / length
    tied = np.eye(len(turning)) if floats else _tied(drive, turning)
    kinematic, static = product(tied.T, kinematic), product(tied.T, static)
    if floats:
        moved = jnp.concatenate(moves)
        kinematic, static = (jnp.concatenate([moved, part], axis=1) for part in (kinematic, static))
    unknown = kinematic.shape[1]
    laws, moved_by = stiff / scale, kinematic
    slides = jnp.zeros(stiff.shape[0], dtype=bool)
    if sliding_friction is not None:
        first = count if floats else 0
        slides = jnp.pad(sliding_friction != 0.0, (first, slides.size - first - count))
        friction = jnp.eye(stiff.shape[0])
        if floats:
            friction = friction - jnp.pad(
                jnp.diag(sliding_friction), ((count, pins.size), (0, count + pins.size))
            )
        laws = jnp.where(slides[:, None], friction, laws)
        moved_by = jnp.where(slides[:, None], 0.0, kinematic)
    bearings = jnp.zeros(unknown)
    if floats and support_stiffness is not None:
        bearings = bearings.at[: 2 * support_stiffness.size].set(jnp.repeat(support_stiffness, 2) * scale)
    system = jnp.block([[laws, -moved_by], [static.T, jnp.diag(bearings)]])
    place = unknown - tied.shape[1] + int(np.argmax(tied[turning.index(out)]))
    load = -jnp.eye(system.shape[0])[stiff.shape[0] + place] / length
    found = solve(system, load)
    force = found[: stiff.shape[0]]
    turned = jnp.abs(found[stiff.shape[0] + place]) * scale / length
    longer = jnp.where(slides, product(kinematic, found[stiff.shape[0] :]) * scale, product(stiff, force))
    shares = drive.sectors * force * longer / turned
    return NetworkStiffness(
        output=1.0 / turned,
        tangential_share=shares[count : 2 * count] if floats else shares[:count],
        normal_share=shares[:count] if floats else jnp.zeros(count),
        pin_share=jnp.sum(shares[2 * count : 2 * count + held]) if floats else jnp.zeros(()),
        tangential_force=force[count : 2 * count] if floats else force[:count],
        normal_force=force[:count] if floats else jnp.zeros(count),
        support_share=shares[2 * count + held :],
    )


def _tied(drive: Drive, turning: list[int]) -> np.ndarray:
    """Angles of the members over the free ones, of which bodies that turn alike have one, shape (turning, free)."""
    names = [drive.members[i] for i in turning]
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
    at_input = (
        1.0 / jnp.asarray(input_shaft_stiffness, dtype=float) / ratio**2
    )  # derivatives of a rigid shaft: 0
    at_output = 1.0 / jnp.asarray(output_shaft_stiffness, dtype=float)
    whole = 1.0 / stiffness + at_input + at_output
    return 1.0 / whole, at_input / whole, at_output / whole
