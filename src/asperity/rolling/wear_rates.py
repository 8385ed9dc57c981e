r"""How fast the tracks of a joint that rolls wear, and how fast that loosens it: at one state of wear, under one load.

Everything is in proportion to the wear coefficient: rates are per coefficient, and times become k t. Depths are those
of Archard's law for every contact; contacts that roll on one track add. Wear takes the sum of both depths off the
interference of a contact, off that of a ring too, whose radius grows.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.wear import (
    mixed_load_power,
    slipping_load_power,
    worn_depth_rate,
    worn_volume_rate,
)
from asperity.drive.layout.drive import Drive, incidence
from asperity.drive.layout.expansion import ring_interference
from asperity.drive.state.loads import member_moments
from asperity.drive.state.state import DriveState, surface_speeds
from asperity.drive.state.states import rest_forces
from asperity.engine.arrays import xp
from asperity.engine.control import scan
from asperity.engine.module import Module
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.capacity import loading
from asperity.joint.crowned_contacts import slice_slip_ratios
from asperity.joint.description import places
from asperity.joint.laws import creep_law
from asperity.joint.loading_cam import mean_preload
from asperity.joint.machine import JointMachine
from asperity.linear import product
from asperity.rolling.creep import contact_friction
from asperity.types import Array, Number

#: Of the forces around which the laws of unlike sectors are taken: each pass leaves less than a hundredth.
_SETTLINGS = 3
#: Singular values below it, over the largest one, are none.
_RANK = 1e-9
#: A slip ratio below which the slices of a crowned contact are taken at it [-].
_LEAST_SLIP = 1e-6
#: Share of the interference up to which wear is followed.
MOST = 1.0 - 1e-5
#: Share of its curvature with which a crown counts as worn flat.
_FLAT = 1e-3


class Worn(Module):
    """What wear has taken off a joint.

    Parameters
    ----------
    interference : Array
        Depths of both tracks of each contact together, where they are deepest, shape (contacts,) [m].
    curvature : Array or None
        Curvature that the crowns of each contact have lost, shape (contacts,) [1/m]; None where none is crowned.
    """

    interference: Number
    curvature: Number | None = None


class WearLoad(NamedTuple):
    """One load of a joint that wears: torque at the output [N·m], speed of the input [rad/s], share of the time [-].

    ``sliding``: signs of the contacts that slide as a whole under it, shape (contacts,) [-].
    """

    output_torque: Number
    input_speed: Number
    share: Number
    sliding: Number


class WearState(NamedTuple):
    """A worn joint under one load.

    Per wear coefficient: ``rates`` at which wear takes interference [m Pa/s] and curvature [Pa/(m s)] off the contacts;
    ``drive_rate``, interference off the drive [m Pa/s]; ``depth``, off the tracks of the first and of the second body
    of each contact, in the middle, shape (2, contacts) [m Pa/s]. ``load_power`` of each contact of one sector, shape
    (contacts,) [W]. ``excesses``: by how much each limit is exceeded (:class:`asperity.joint.capacity.UnderTorque`);
    ``tangential`` forces [N]; ``interference`` of the drive [m], ``preload`` [N] and ``speed_loss`` by creep [-];
    ``worst``, residual of the balance [-].
    """

    rates: Worn
    drive_rate: Number
    depth: Number
    load_power: Number
    excesses: Number
    tangential: Number
    interference: Number
    preload: Number
    speed_loss: Number
    worst: Number


class Wearing(Module):
    """A joint whose wear is followed.

    ``machine`` without a duty; ``coefficients`` of its bodies over the largest of them, shape (bodies,) [-].
    """

    machine: JointMachine
    coefficients: Number


def unworn(wearing: Wearing) -> Worn:
    """A state without wear, shape (1, contacts)."""
    nothing = np.zeros((1, len(wearing.machine.drive.contacts)))
    return Worn(nothing, None if wearing.machine.contacts.crown_curvature is None else nothing)


def flat_excess(machine: JointMachine, lost: Array) -> Array:
    """By how much crowns that lose curvature, shape (..., contacts) [1/m], are worn flat: 0 where they are [-]."""
    crowned = xp.asarray(machine.contacts.crown_curvature) > 0.0
    crowns = xp.where(crowned, xp.asarray(machine.contacts.crown_curvature), 1.0)
    return xp.where(crowned, lost / crowns - (1.0 - _FLAT), -1.0)


def worn_machine(machine: JointMachine, worn: Worn) -> JointMachine:
    """The machine that a worn joint is: its contacts with less interference, its crowns flatter."""
    joint, contacts = machine.joint, machine.contacts
    if joint.interference is not None:
        pattern = xp.asarray(joint.pattern) - worn.interference / xp.asarray(joint.interference)
        joint = dataclasses.replace(joint, pattern=tuple(pattern))
    if worn.curvature is not None and contacts.crown_curvature is not None:
        curvature = contacts.crown_curvature - worn.curvature
        contacts = dataclasses.replace(contacts, crown_curvature=curvature)
        joint = dataclasses.replace(joint, crown_curvatures=tuple(curvature))
    return dataclasses.replace(machine, joint=joint, contacts=contacts)


def worn_assembled(machine: JointMachine) -> tuple[JointMachine, Pressed]:
    """A worn joint assembled; of unlike sectors with the laws around the forces that they have now."""
    if machine.joint.unlike is None:
        return machine, assembled(machine)

    def again(force: Array, _: None) -> tuple[Array, Pressed]:
        pressed = assembled(_around(machine, force))
        return pressed.rest.normal, pressed

    force, _ = scan(again, machine.joint.unlike.reference_force, None, length=_SETTLINGS)
    settled = _around(machine, force)
    return settled, assembled(settled)


def _around(machine: JointMachine, force: Array) -> JointMachine:
    """The machine with the laws of unlike sectors around forces, shape (contacts,) [N]."""
    assert machine.joint.unlike is not None
    unlike = dataclasses.replace(machine.joint.unlike, reference_force=force)
    return dataclasses.replace(machine, joint=dataclasses.replace(machine.joint, unlike=unlike))


def wear_state(wearing: Wearing, worn: Worn, load: WearLoad) -> WearState:
    """A worn joint under one load, and how fast it wears; equations (W1)–(W3) of :doc:`/equations`.

    A contact without a crown stays even, also where a roller that a crowned one has worn in the middle rolls on it: its
    interference falls by the mean of its line.
    """
    machine, without_torque = worn_assembled(worn_machine(wearing.machine, worn))
    machine = machine.under(load.output_torque, load.input_speed)
    under = loading(machine, without_torque, sliding=load.sliding)(load.output_torque, True, False)
    drive, rest, alone = machine.drive, under.pressed, without_torque.rest
    power, along = load_powers(machine, under.state)
    each = depth_rates(wearing, machine, power)
    depth = on_tracks(drive, each if along is None else each * along.middle)
    rates = Worn(xp.sum(depth, axis=0))
    if along is not None:
        bent = xp.sum(on_tracks(drive, each * along.curvature), axis=0)
        crowned = xp.asarray(wearing.machine.contacts.crown_curvature) > 0.0
        even = rates.interference + bent * machine.contacts.pairs.contact_length**2 / 24.0
        rates = Worn(xp.where(crowned, rates.interference, even), xp.where(crowned, -bent, 0.0))
    return WearState(
        rates=rates,
        drive_rate=interference_rate(machine, rates),
        depth=depth,
        load_power=power,
        excesses=under.excesses,
        tangential=under.state.tangential,
        interference=ring_interference(drive=drive, forces=alone.normal, interference=alone.interference),
        preload=mean_preload(machine.joint, rest.normal),
        speed_loss=under.state.speed_loss,
        worst=under.state.worst,
    )


class AlongLine(NamedTuple):
    """Wear along crowned lines, over its mean on the contact length, as a parabola through the loads.

    ``middle`` w_0 [-] and ``curvature`` w_2 [1/m^2] of w = w_0 + w_2 y^2/2, shape (contacts,).
    """

    middle: Array
    curvature: Array


def load_powers(machine: JointMachine, state: DriveState) -> tuple[Array, AlongLine | None]:
    """Pressure times speed of slip over each contact of one sector, shape (contacts,) [W], and how crowns spread it.

    Of a state of rolling; contacts that slide as a whole slip as fast as their bodies make them; (W1).
    """
    joint, contacts, drive = machine.joint, machine.contacts, machine.drive
    pairs = contacts.pairs
    touching = state.normal > 0.0
    normal = xp.where(touching, state.normal, 1.0)
    speed = xp.abs(xp.asarray(joint.input_speed))
    slip = xp.abs(product(incidence(drive).turning, state.speed)) * speed
    friction_power = xp.abs(state.tangential) * slip
    power = slipping_load_power(
        friction_power=friction_power, friction_coefficient=pairs.friction_coefficient
    )
    sharing, across = None, None
    if joint.rolling.skew is not None or joint.rolling.lubricant is not None:
        creep = creep_law(machine, normal, state.tangential)
        if not creep.parallel:
            one, other = surface_speeds(drive=drive, speed=state.speed)
            across = xp.abs(creep.skew) * (0.5 * (one + other) * speed)
            axial = contact_friction(
                pairs=pairs, creep=creep, normal_force=normal, creepage=state.creepage
            ).axial
            friction_power = friction_power + xp.abs(axial) * across
            power = slipping_load_power(
                friction_power=friction_power, friction_coefficient=pairs.friction_coefficient
            )
        if creep.oiled is not None:
            sharing = xp.asarray(creep.oiled.oiled.contact.asperity_share)
            total = slip if across is None else xp.sqrt(slip**2 + across**2)
            power, mean = _mixed(contacts.loads_along(normal), sharing, normal, total)
            sharing = sharing / mean
    power = xp.where(touching, xp.asarray(power), 0.0)
    lines = contacts.loads_along(normal)
    if lines is None:
        return power, None
    weight = sharing
    if weight is None:
        q = xp.clip(xp.abs(state.tangential) / (pairs.friction_coefficient * normal), _LEAST_SLIP, 1.0)
        weight = slice_slip_ratios(pairs=pairs, lines=lines, slip_ratio=q)
    return power, _along(lines, weight)


def _mixed(lines: CrownedLine | None, sharing: Array, normal: Array, slip: Array) -> tuple[Array, Array]:
    """Load powers of contacts with oil [W], and the mean of their asperities' share over the load [-]."""
    mean = sharing
    if lines is not None:
        loads = lines.length_share * lines.line_load
        mean = xp.sum(loads * sharing, axis=0) / xp.sum(loads, axis=0)
    return xp.asarray(mixed_load_power(asperity_share=mean, normal_force=normal, slip_speed=slip)), mean


def _along(lines: CrownedLine, weight: Array) -> AlongLine:
    """Wear along crowned lines whose slices wear by their load times a weight, fitted through their loads."""
    local = weight * lines.line_load
    mean = xp.sum(lines.length_share * local, axis=0)
    local = local / xp.where(mean > 0.0, mean, 1.0)
    loads = lines.length_share * lines.line_load
    loads = loads / xp.sum(loads, axis=0)
    half = 0.5 * lines.position**2
    first, second = xp.sum(loads * half, axis=0), xp.sum(loads * half**2, axis=0)
    level, slope = xp.sum(loads * local, axis=0), xp.sum(loads * half * local, axis=0)
    curvature = (slope - first * level) / (second - first**2)
    return AlongLine(level - first * curvature, curvature)


def depth_rates(wearing: Wearing, machine: JointMachine, power: Array) -> Array:
    """Mean depth that each contact takes off the tracks of its two bodies, of all sectors that share them.

    Shape (2, contacts), per wear coefficient [m Pa/s]; equation (W2).
    """
    drive, pairs = machine.drive, machine.contacts.pairs
    sectors = xp.asarray(drive.sectors, dtype=float)
    rates = []
    for bodies, radius in zip(places(drive), (drive.first_radius, drive.second_radius), strict=True):
        shared = np.array([drive.bodies[body].on_axis for body in bodies])
        rates.append(
            worn_depth_rate(
                volume_rate=worn_volume_rate(
                    wear_coefficient=wearing.coefficients[np.array(bodies)],
                    load_power=power * xp.where(shared, sectors, 1.0),
                ),
                track_radius=radius,
                contact_length=pairs.contact_length,
            )
        )
    return xp.stack(rates)


def on_tracks(drive: Drive, each: Array) -> Array:
    """What all contacts on a track do to it together, for each contact again, shape (2, contacts)."""
    count = len(drive.contacts)
    together = product(xp.asarray(_same_track(drive)), each.reshape(2 * count))
    return together.reshape(2, count)


def _same_track(drive: Drive) -> np.ndarray:
    """1 where two sides of contacts are one track, else 0, shape (2 contacts, 2 contacts)."""
    track = np.array([number for side in side_tracks(drive) for number in side])
    return (track[:, None] == track[None]).astype(float)


def side_tracks(drive: Drive) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Numbers of the tracks of the first and of the second body of each contact, all bodies counted on."""
    number, of = 0, {}
    for body, tracks in enumerate(drive.layout.tracks):
        for track in tracks:
            of.update(dict.fromkeys(((body, contact) for contact in track.contacts), number))
            number += 1
    first, second = places(drive)
    one, other = (tuple(of[body, contact] for contact, body in enumerate(side)) for side in (first, second))
    return one, other


def interference_rate(machine: JointMachine, rates: Worn) -> Array:
    r"""How fast wear takes the interference of the drive, :math:`\sum_k N_k \dot w_k / \sum_{ring} N_k` [m Pa/s].

    By virtual work, N the forces of the assembled drive; equation (W3). Of several self-stresses a mean.
    """
    forces = rest_forces(drive=machine.drive, pattern=machine.joint.working_pattern)
    return ring_interference(drive=machine.drive, forces=forces, interference=rates.interference)


def felt_interference(machine: JointMachine) -> np.ndarray:
    r"""What of a change of the interferences a drive feels, as a matrix for them, shape (contacts, contacts) [-].

    .. math:: F = Z\,(Z^\mathsf{T} Z)^{+} Z^\mathsf{T}, \qquad A^\mathsf{T} Z + P^\mathsf{T} F_{pin} = 0

    Z are the forces by which the drive is pressed without a torque, one column for each way; the rest only moves its
    rollers. All is felt where bearings give way, around the centre of the frame. Equation (W3).
    """
    matrices, contacts = incidence(machine.drive), len(machine.drive.contacts)
    if machine.joint.unlike is not None:
        return np.eye(contacts)
    balance = np.concatenate([np.asarray(matrices.approach), np.asarray(matrices.pins)])
    left, sizes, _ = np.linalg.svd(balance)
    rank = int(np.sum(sizes > _RANK * sizes.max(initial=1.0)))
    pressed = left[:contacts, rank:]
    return pressed @ np.linalg.pinv(pressed)


def others_carry(drive: Drive, contact: int) -> bool:
    """Whether other contacts can take over a part of the tangential force of one, by statics alone."""
    matrices, count, pins = incidence(drive), len(drive.contacts), len(drive.pinned)
    turning = drive.layout.turning
    moments = np.stack(
        [np.asarray(member_moments(drive, matrices, *each))[turning] for each in _units(count, pins)], axis=1
    )
    moments = np.concatenate([np.zeros((turning.size, count)), moments], axis=1)
    forces = [np.asarray(each).T for each in (matrices.approach, matrices.sliding, matrices.pins[:pins])]
    balance = np.concatenate(
        [np.concatenate(forces, axis=1), moments / np.asarray(drive.second_radius).max()]
    )
    _, sizes, directions = np.linalg.svd(balance)
    free = directions[np.sum(sizes > _RANK * sizes.max(initial=1.0)) :]
    return bool(np.max(np.abs(free[:, count + contact]), initial=0.0) > _RANK)


def _units(contacts: int, pins: int) -> Iterator[tuple[Number, Number]]:
    """One newton at each contact, then at each pin: forces of the contacts and of the pins [N]."""
    for place in range(contacts + pins):
        one = np.eye(contacts + pins)[place]
        yield one[:contacts], one[contacts:]
