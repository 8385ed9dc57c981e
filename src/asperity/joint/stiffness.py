"""Torsional stiffness of a joint on the three levels of the model."""

from __future__ import annotations

import dataclasses
import functools
from typing import NamedTuple

from asperity.drive.layout.drive import Drive, speed_ratio
from asperity.drive.state.state import SLIP_TOLERANCE
from asperity.drive.stiffness.network import (
    NetworkStiffness,
    SpringLaws,
    network_stiffness,
    spring_laws,
    with_shafts,
)
from asperity.drive.stiffness.torsional_stiffness import Assembly, TorsionalStiffness
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import vectorised
from asperity.joint.body_compliance import body_compliance, walls_known
from asperity.joint.bores import PinLoads, pin_forces, pressed_bores
from asperity.joint.contacts import JointContacts, LoadedContacts, loaded_contacts
from asperity.joint.machine import JointMachine
from asperity.types import Array, Document, Real

#: Half-width over effective radius that stands for an open contact, whose springs are left out.
_CLOSED = 1e-3


class AssemblySprings(NamedTuple):
    """Springs of the contacts in the assembly.

    Incremental stiffnesses of asperities and bodies in series, shape (contacts, ...) [N/m], 0 where a contact is open
    or slips; ``coupling`` and ``bodies``, compliances between the contacts and of the bodies without asperities, shape
    (2 contacts, 2 contacts, ...) [m/N], the latter at the half-widths [m].
    """

    normal_stiffness: Array
    tangential_stiffness: Array
    coupling: Array | None
    bodies: Array | None = None
    half_width: Array | None = None


def widths_of_bodies(*, contacts: JointContacts, loaded: LoadedContacts) -> tuple[Array, Array]:
    r"""Half-widths at which the compliance of exact bodies is taken, shape (contacts, ...) [m]."""
    touching = xp.asarray(loaded.interfaces.normal) > 0.0
    sticking = xp.asarray(loaded.interfaces.tangential) > 0.0
    width = xp.where(touching, loaded.half_width, _CLOSED * contacts.pairs.effective_radius)
    return width, width * xp.sqrt(xp.where(sticking, 1.0 - loaded.traction, 1.0))


def springs_of_compliance(*, compliance: Array, half_width: Array, loaded: LoadedContacts) -> AssemblySprings:
    """Springs of the contacts from the compliance of their bodies, the asperities in series."""
    interfaces = loaded.interfaces
    touching = xp.asarray(interfaces.normal) > 0.0
    sticking = xp.asarray(interfaces.tangential) > 0.0
    acts = xp.concatenate([touching, sticking])
    asperities = xp.concatenate(
        [
            xp.broadcast_to(interfaces.asperity_normal, touching.shape),
            xp.broadcast_to(interfaces.asperity_tangential, sticking.shape),
        ]
    )
    diagonal = xp.einsum("ii...->i...", compliance)
    if loaded.crown is not None:
        diagonal = diagonal + xp.concatenate(xp.broadcast_arrays(*loaded.crown))
    stiffness = xp.where(acts, 1.0 / (diagonal + 1.0 / xp.where(acts, asperities, 1.0)), 0.0)
    others = 1.0 - xp.eye(acts.shape[0]).reshape((acts.shape[0],) * 2 + (1,) * (acts.ndim - 1))
    coupling = xp.where(acts[:, None] & acts[None], others * compliance, 0.0)
    half = touching.shape[0]
    return AssemblySprings(stiffness[:half], stiffness[half:], coupling, compliance, half_width)


class LoadedStiffness(NamedTuple):
    """Contacts of a joint under their forces, and its stiffness.

    ``published``, of the asperities alone, and ``series_with_bulk``, with the bodies in series, hold the centres of all
    rollers; ``assembly`` is the fullest model. The flags tell whether every loaded contact has an elastic spot; and
    every wall a known compliance, every crowned contact the length that its slices need.
    """

    contacts: LoadedContacts
    published: TorsionalStiffness
    series_with_bulk: TorsionalStiffness
    assembly: Assembly
    contact_law_holds: Array
    walls_hold: Array


def loaded_stiffness(
    machine: JointMachine,
    normal_force: Array,
    tangential_force: Array,
    slides: Array,
    pins: PinLoads,
) -> LoadedStiffness:
    """Stiffness of a joint under given forces [N] on three levels; nan where a law does not hold.

    Forces are positive where the first body drives the second; ``slides`` are the signs of the contacts that slide as a
    whole, as in :class:`asperity.drive.state.state.DriveState`. A contact that slides has no tangential stiffness: its
    force follows its normal force, all over the strip. Equations (A8) and (M4) of :doc:`/equations`.
    """
    holds = slides == 0.0
    loaded, friction = _under_forces(machine.contacts, normal_force, tangential_force, slides)
    published, series, assembly = stiffness_levels(machine, loaded, friction, pins)
    loaded = loaded._replace(
        traction=xp.where(holds, loaded.traction, 1.0),
        rough=dataclasses.replace(
            loaded.rough, tangential_stiffness=xp.where(holds, loaded.rough.tangential_stiffness, 0.0)
        ),
        interfaces=dataclasses.replace(
            loaded.interfaces,
            asperity_tangential=xp.where(holds, loaded.interfaces.asperity_tangential, 0.0),
            bulk_tangential=xp.where(holds, loaded.interfaces.bulk_tangential, 0.0),
        ),
    )
    law_holds, walls = _laws_hold(machine, loaded, normal_force)
    published, series = trees.map(lambda value: xp.where(law_holds, value, xp.nan), (published, series))
    assembly = trees.map(lambda value: xp.where(law_holds & walls, value, xp.nan), assembly)
    return LoadedStiffness(loaded, published, series, assembly, law_holds, walls)


def _under_forces(
    contacts: JointContacts, normal_force: Array, tangential_force: Array, slides: Array
) -> tuple[LoadedContacts, Array]:
    """Contacts under their forces, and tangential over normal force of those that slide, 0 for those that hold."""
    friction = contacts.pairs.friction_coefficient
    most = (1.0 - SLIP_TOLERANCE) * friction * normal_force
    loaded = loaded_contacts(
        contacts=contacts,
        normal_force=normal_force,
        # in series with a contact that slides another bears just its friction, and no more under a higher torque
        tangential_force=xp.where(slides == 0.0, xp.clip(tangential_force, -most, most), 0.0),
    )
    return loaded, slides * friction


def _laws_hold(machine: JointMachine, loaded: LoadedContacts, normal_force: Array) -> tuple[Array, Array]:
    """Whether every loaded contact has an elastic spot; whether every wall and every crowned line is known."""
    law_holds = xp.all((loaded.rough.normal_stiffness > 0.0) | (normal_force <= 0.0))
    walls = walls_known(machine=machine, half_width=loaded.half_width)
    if loaded.lines is not None:
        walls = walls & xp.all(loaded.lines.solved | (normal_force <= 0.0))
    return law_holds, walls


def working_springs(
    machine: JointMachine,
    normal_force: Array,
    tangential_force: Array,
    slides: Array,
    pins: PinLoads,
) -> SpringLaws:
    """All springs of the assembly under given forces, as of :func:`loaded_stiffness`, for any motion of the drive.

    nan where a law does not hold. Equation (A8) of :doc:`/equations`.
    """
    loaded, friction = _under_forces(machine.contacts, normal_force, tangential_force, slides)
    springs = spring_laws(**_springs_of_assembly(machine, loaded, friction, pins, None))
    known = xp.stack(_laws_hold(machine, loaded, normal_force)).all()
    return springs._replace(laws=xp.where(known, springs.laws, xp.nan))


def stiffness_levels(
    machine: JointMachine, loaded: LoadedContacts, sliding_friction: Array, pins: PinLoads
) -> tuple[TorsionalStiffness, TorsionalStiffness, Assembly]:
    """Torsional stiffness on three levels: asperities, asperities and bodies, the whole assembly.

    The signs of the pins' forces say which sides of their bores they press; without force those that a torque presses.
    """
    ratio, interfaces = xp.asarray(speed_ratio(machine.drive)), loaded.interfaces
    held = vectorised(functools.partial(_with_held_centres, machine.drive, sliding_friction))(
        xp.stack([xp.asarray(interfaces.asperity_tangential), xp.asarray(interfaces.tangential)])
    )
    network = network_stiffness(
        **_springs_of_assembly(machine, loaded, sliding_friction, pins, held.tangential_force[1])
    )
    published, series = (TorsionalStiffness(input=output / ratio**2, output=output) for output in held.output)
    return published, series, _assembly(machine, network, ratio)


def _with_held_centres(drive: Drive, sliding_friction: Array, tangential: Array) -> NetworkStiffness:
    """A joint whose centres are held, from the tangential stiffnesses of its contacts [N/m]."""
    return network_stiffness(
        drive=drive,
        normal_compliance=None,
        tangential_compliance=_compliance(tangential),
        sliding_friction=sliding_friction,
    )


def _springs_of_assembly(
    machine: JointMachine,
    loaded: LoadedContacts,
    sliding_friction: Array,
    pins: PinLoads,
    added: Array | None,
) -> Document:
    """Springs of the assembly, as arguments of :func:`asperity.drive.stiffness.network.network_stiffness`.

    ``added``, the tangential forces under a unit torque with centres held [N], are found where they are not known.
    """
    joint, rings = machine.joint, machine.ring_compliance
    normal, tangential, coupling = loaded.interfaces.normal, loaded.interfaces.tangential, None
    if added is None and machine.bores is not None:
        added = _with_held_centres(joint.drive, sliding_friction, xp.asarray(tangential)).tangential_force
    pin_compliance, by_pin = _pins(machine, pins, added)
    if joint.body_model == "exact":
        normal, tangential, coupling = _springs_of_bodies(machine, loaded, by_pin)
    return {
        "drive": joint.drive,
        "normal_compliance": _compliance(normal) if rings is None else _compliance(normal) + rings,
        "tangential_compliance": _compliance(tangential),
        "coupling": coupling,
        "pin_compliance": pin_compliance,
        "sliding_friction": sliding_friction,
        "support_stiffness": None if joint.unlike is None else joint.unlike.support_stiffness,
        "supports": machine.supports,
    }


def _compliance(stiffness: Real) -> Array:
    """Of springs; nan for those that carry nothing [m/N]."""
    acts = xp.asarray(stiffness) > 0.0
    return xp.where(acts, 1.0 / xp.where(acts, stiffness, 1.0), xp.nan)


def _pins(machine: JointMachine, loads: PinLoads, added: Array | None) -> tuple[Array, Array | None]:
    """Compliance of each pin along its push, shape (pins,), and with the contacts, shape (2 contacts, pins) [m/N].

    The latter is None where no pin presses in a bore. ``added`` are the tangential forces under a unit torque with
    centres held [N].
    """
    compliance, bores = machine.pin_compliance, machine.bores
    if bores is None:
        return compliance, None
    assert added is not None
    by_torque = pin_forces(machine.drive, xp.zeros_like(added), added)
    pressed = pressed_bores(bores, loads, by_torque)
    in_bore = bores.pin_slope(pressed, loads.added, loads.tangential)
    return compliance + in_bore, xp.concatenate(bores.by_pin(pressed))


def _springs_of_bodies(
    machine: JointMachine, loaded: LoadedContacts, by_pin: Array | None
) -> tuple[Real, Real, Array | None]:
    """Normal and tangential stiffness [N/m] and coupling [m/N] of elastic bodies with the bores of their pins.

    ``by_pin`` is what pins and contacts do to each other, None where no pin presses in a bore.
    """
    width, stick = widths_of_bodies(contacts=machine.contacts, loaded=loaded)
    compliance = body_compliance(machine=machine, half_width=width, stick_half_width=stick)
    springs = springs_of_compliance(compliance=compliance, half_width=width, loaded=loaded)
    coupling = springs.coupling
    if by_pin is not None:
        assert coupling is not None
        acts = xp.concatenate([springs.normal_stiffness, springs.tangential_stiffness]) > 0.0
        by_pin = xp.where(acts[:, None], by_pin, 0.0)
        coupling = xp.block([[coupling, by_pin], [by_pin.T, xp.zeros((by_pin.shape[1],) * 2)]])
    return springs.normal_stiffness, springs.tangential_stiffness, coupling


def _assembly(machine: JointMachine, network: NetworkStiffness, ratio: Array) -> Assembly:
    """The drive in series with its shafts, and the shares of all springs in its compliance."""
    joint, drive, rings = machine.joint, machine.drive, machine.ring_compliance
    across = 0 if joint.pin_transverse_stiffness is None else len(drive.pinned)
    bending = xp.zeros(len(drive.contacts))
    if rings is not None:
        bending = rings * network.normal_force**2 * xp.asarray(drive.sectors) * network.output
    output, input_share, output_share = with_shafts(
        stiffness=network.output,
        ratio=ratio,
        input_shaft_stiffness=joint.input_shaft_stiffness,
        output_shaft_stiffness=joint.output_shaft_stiffness,
    )
    between_shafts = output / network.output
    return Assembly(
        stiffness=TorsionalStiffness(input=output / ratio**2, output=output),
        tangential_share=network.tangential_share * between_shafts,
        normal_share=(network.normal_share - bending) * between_shafts,
        ring_bending_share=xp.sum(bending) * between_shafts,
        pin_share=(network.pin_share + xp.sum(network.support_share[:across])) * between_shafts,
        planet_support_share=xp.sum(network.support_share[across:]) * between_shafts,
        input_shaft_share=input_share,
        output_shaft_share=output_share,
    )
