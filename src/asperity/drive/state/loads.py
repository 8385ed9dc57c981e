r"""Loads that contacts put on the pins, shafts and housing of a drive, what resists rolling, friction of bearings.

Sectors are equal: the forces on bodies on the axis and on the carrier balance, a torque remains.

The oil at the inlet of a contact drags both surfaces against their motion, each with a force g. Its pressure rests on
the film: it pushes both bodies forward through their centres, with

.. math:: 2 g\,\frac{R}{R_1}, \qquad 2 g\,\frac{R}{R_2}, \qquad \frac1R = \frac1{R_1} \pm \frac1{R_2},

minus in internal contacts, so that nothing is left on the film, and no moment about the contact.

Elastic hysteresis shifts the pressure towards the inlet by :math:`2 \alpha a/(3\pi)`: a couple on both bodies, equal
and opposite, and no force. The friction of skewed axes has the power :math:`F_a \gamma V`: both surfaces move half of
the skew away from the middle of their directions, and there the axial force brakes each with :math:`F_a \gamma/2`. The
bearings that hold the axes take up what is left of these moments, and the carrier bears it.
"""

from __future__ import annotations

from typing import NamedTuple

from asperity.drive.bearings import Bearings, bearing_torque
from asperity.drive.layout.drive import Drive, Incidence, incidence, sectors_of_members, speeds
from asperity.drive.state.state import Resistance
from asperity.engine.arrays import xp
from asperity.linear import product
from asperity.types import Array


def signed_resistance(drive: Drive, size: Resistance, *, backwards: Array | float) -> Resistance:
    """Resistances with the sense in which the first surface of each contact moves, shape (contacts,) [N] and [N·m].

    ``backwards`` is -1 of a drive that rolls against its ideal speeds, else 1.
    """
    speed, layout = speeds(drive), drive.layout
    ahead = backwards * xp.sign(speed[layout.first] - speed[layout.carrier])
    return Resistance(*(ahead * each for each in size))


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
    outward = drive.layout.outward
    # R/R_1 = R_2/(R_2 +- R_1)
    share = drive.second_radius / (drive.second_radius + outward * drive.first_radius)
    return drag * (1.0 - 2.0 * share)


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
    layout = drive.layout
    first, second = layout.unit[layout.first], layout.unit[layout.second]
    levers = layout.outward[:, None] * drive.second_radius[:, None] * second
    levers = levers - drive.first_radius[:, None] * first
    return sectors_of_members(drive)[:, None] * levers.T


def resistance_levers(drive: Drive) -> Resistance:
    r"""Moments on the members over each resistance of the contacts.

    .. math::
        M_1 = -R_1 g - h - R_1 g_s, \qquad M_2 = \pm R_2 g + h \pm R_2 g_s, \qquad
        M_c = (R_1 \mp R_2)\,g_s

    of the drag g of the oil, the moment h of hysteresis and the drag :math:`g_s` of skew, plus in external contacts.
    A carrier that is a frame, in which bearings hold the bodies, has :math:`(R_1 \mp R_2)\,g` too.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Resistance
        Counter-clockwise, those on the axis from all sectors, shape (members, contacts) [m], for the moment [-].

    References
    ----------
    Balance of both bodies; equation (B9) of :doc:`/equations`.
    """
    layout, oil = drive.layout, drag_levers(drive)
    unit = layout.unit
    first, second = unit[layout.first], unit[layout.second]
    copies = sectors_of_members(drive)[:, None]
    # what one sector's bearings bear
    held = -(oil / copies).sum(axis=0)
    carried = oil + copies * unit[layout.carrier][:, None] * held
    return Resistance(carried if layout.in_frame else oil, copies * (second - first).T, carried)


def resistance_moments(drive: Drive, resistance: Resistance) -> Array:
    """Moments of all that resists rolling on the members, counter-clockwise, shape (members,) [N·m]; (B9).

    Of signed resistances, shape (contacts,).
    """
    levers = resistance_levers(drive)
    moments = [product(lever, size) for lever, size in zip(levers, resistance, strict=True)]
    return moments[0] + moments[1] + moments[2]


class MemberLoads(NamedTuple):
    """Loads of the structure of a drive in one state. SI units.

    Parameters
    ----------
    pin : Array
        Force of each roller on its pin along the push, shape (pins,) [N].
    unbalanced : Array
        Force that no pin takes up, shape (floating, 2) [N]; 0 in a balanced state but for its residual.
    moments : Array
        Moments of contacts, of what resists their rolling, and of pins on the members, all sectors together,
        counter-clockwise, shape (members,) [N·m].
    """

    pin: Array
    unbalanced: Array
    moments: Array


def member_loads(
    *,
    drive: Drive,
    normal: Array,
    tangential: Array,
    body_force: Array,
    resistance: Resistance | None = None,
) -> MemberLoads:
    r"""Loads of the structure from the forces of the contacts.

    .. math:: F = P\,(Z - A^\mathsf{T} N - S^\mathsf{T} T)

    Parameters
    ----------
    drive : Drive
        The drive.
    normal, tangential : Array
        Forces of the contacts, counter-clockwise as in :class:`asperity.drive.state.state.DriveState`, shape
        (contacts,) [N].
    body_force : Array
        Forces Z on the floating bodies, shape (floating, 2) [N].
    resistance : Resistance or None, optional
        What resists rolling, signed as in :class:`asperity.drive.state.state.DriveState`, shape (contacts,) [N] and
        [N·m]; None for nothing.

    Returns
    -------
    MemberLoads
        A pin takes the force along its push.

    References
    ----------
    Balance of each body; equation (M1) of :doc:`/equations`.
    """
    matrices = incidence(drive)
    between = tangential if resistance is None else tangential + drag_pairs(drive, resistance.drag)
    left = body_force.ravel() - product(matrices.approach.T, normal) - product(matrices.sliding.T, between)
    pin = product(matrices.pins, left)
    moments = member_moments(drive, matrices, tangential, pin)
    return MemberLoads(
        pin=pin,
        unbalanced=(left - product(matrices.pins.T, pin)).reshape(-1, 2),
        moments=moments if resistance is None else moments + resistance_moments(drive, resistance),
    )


def pin_components(*, drive: Drive, force: Array) -> tuple[Array, Array]:
    """Radial and tangential forces on the pins by those along their push, shape (pins,) [N].

    Positive away from the axis, and in the sense in which the input turns.
    """
    push = drive.push_angles
    return force * xp.sin(push), -drive.sense * force * xp.cos(push)


def member_moments(drive: Drive, matrices: Incidence, tangential: Array, pin: Array) -> Array:
    """Moments of contacts and pins on the members, counter-clockwise, those on the axis from all sectors; (M1).

    Of their forces, shape (contacts,) and (pins,) [N], to shape (members,) [N·m].
    """
    layout, of_contacts = drive.layout, -product(matrices.turning.T, tangential)
    # bearings in the frame pass on to it what the contacts do to their bodies
    carried = (matrices.levers * pin).sum() + (of_contacts[layout.carrier] if layout.in_frame else 0.0)
    moments = xp.where(layout.unit[layout.carrier] > 0.0, carried, of_contacts)
    return moments * sectors_of_members(drive)


def friction_moments(
    *, drive: Drive, bearings: Bearings, pin_force: Array, ideal: Array, on_carrier: bool = True
) -> Array:
    r"""Moments of the bearings on the members of a drive, those of all sectors together.

    .. math::
        M_b = -2\,T_B(F)\,\operatorname{sgn}(\omega_b - \omega_c), \qquad M_c = -n \sum_b M_b, \qquad
        M_{in,out} = -2\,T_{in,out}\,\operatorname{sgn}\,\omega_{in,out}

    Parameters
    ----------
    drive : Drive
        The drive.
    bearings : Bearings
        Friction of the bearings: ``input_torque`` of the input, ``output_torque`` of the output, and of every roller on
        a pin.
    pin_force : Array
        Forces of the pins, shape (pins,) [N].
    ideal : Array
        Angular velocities of the members without creep, of which only the signs count, shape (members,) [-].
    on_carrier : bool, optional
        Whether the bearings of rollers act on the carrier too.

    Returns
    -------
    Array
        Counter-clockwise, shape (members,) [N·m]; those of bodies off the axis of one sector.

    Notes
    -----
    Every bearing acts on both of its parts: the bearings of a roller also act on the carrier that holds its pin, which
    equation (5) of Zou et al. 2025 leaves out (``on_carrier = False``).

    References
    ----------
    Zou et al. 2025, equations (1) and (3)–(5): two bearings on each body.
    """
    layout = drive.layout
    carrier, unit, sectors = layout.carrier, layout.unit, sectors_of_members(drive)
    moments = xp.zeros(len(drive.members))
    for number, torque in ((layout.input, bearings.input_torque), (layout.output, bearings.output_torque)):
        moments = moments - 2.0 * torque * xp.sign(ideal[number]) * unit[number]
    for pin, body in enumerate(drive.pinned):
        torque = 2.0 * bearing_torque(bearings=bearings, pin_force=pin_force[pin])
        braking = -torque * xp.sign(ideal[body] - ideal[carrier])
        moments = moments + braking * unit[body]
        if on_carrier:
            moments = moments - sectors[carrier] * braking * unit[carrier]
    return moments


def friction_power(*, drive: Drive, moments: Array, speed: Array) -> Array:
    r"""Power that the bearings take, :math:`-\sum M \omega` over all members of all sectors [W]."""
    copies = xp.asarray(drive.sectors, dtype=float) / sectors_of_members(drive)
    return -xp.sum(copies * moments * speed)
