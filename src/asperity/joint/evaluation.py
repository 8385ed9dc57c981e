"""The chain of a joint: its forces, contacts, stiffness and rolling, from its description."""

from __future__ import annotations

import dataclasses

import numpy as np

from asperity.contact.interface import Interface, RoughContact
from asperity.drive.layout.drive import speed_ratio, speeds
from asperity.drive.layout.expansion import ring_interference
from asperity.drive.state.creep import ROLLING_TOLERANCE
from asperity.drive.state.state import (
    STATE_TOLERANCE,
    BodiesOfContacts,
    ContactLaws,
    DriveState,
    in_driving_sense,
)
from asperity.drive.state.states import DriveStates, loaded_state
from asperity.drive.stiffness.torsional_stiffness import (
    Assembly,
    TorsionalStiffness,
    contact_torsional_stiffness,
)
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.bores import pin_loads
from asperity.joint.description import Joint, bodies_of_contacts
from asperity.joint.diagnostics import Diagnostics, diagnose
from asperity.joint.laws import creep_under, oiled_surfaces, rolling_load
from asperity.joint.loading_cam import CamOfJoint, mean_preload, pressed_at, turned_cam, with_its_cam
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.stiffness import loaded_stiffness
from asperity.rolling.duty import with_duty_life
from asperity.rolling.inlet_heat import joint_inlet_heat
from asperity.rolling.rolling import RollingResult, turning
from asperity.rolling.turning import rolling_at
from asperity.types import Array, Real


class JointForces(Module):
    """Forces of a joint that stands under its torque. SI units.

    ``normal`` and ``tangential`` of the contacts, shape (contacts,) [N], tangential positive where the first body
    drives the second; ``pins``, force of each roller on its pin along the push, shape (pins,) [N]; torques [N·m]. Both
    residuals are the largest relative one of all equations [-], as balance and closure are solved together.
    """

    normal: Array
    tangential: Array
    pins: Array
    input_torque: Array
    output_torque: Array
    balance_residual: Array
    closure_residual: Array


class JointResult(Module):
    """Everything the chain says about a joint; the fields are those of a joint result.

    Parameters
    ----------
    speed_ratio : Array
        Input over output speed [-].
    speeds : Array
        Angular velocities of the members without creep over that of the input, shape (members,) [-].
    output_speed : Array
        Angular velocity of the output [rad/s].
    masses : Array
        Of one of each body, shape (bodies,) [kg].
    preload, interference : Array
        Normal force of the first contact in the assembled drive [N], and the interference that makes it [m]; with a
        loading cam those under the torque.
    rest : DriveState
        The assembled drive without torque.
    forces : JointForces
        Forces under the torque while the joint stands.
    contacts : RoughContact
        Spots and stiffnesses, shape (contacts,).
    contact_torsional_stiffness : Array
        Each contact's own K_T at its driven roller, shape (contacts,) [N·m/rad].
    interfaces : Interface
        Stiffness of asperities and of bulk, shape (contacts,) [N/m].
    published, series_with_bulk : TorsionalStiffness
        Of the asperities alone, and with the bodies in series; the centres of all rollers held.
    assembly : Assembly
        The fullest model.
    diagnostics : Diagnostics
        How close the joint is to the limits of the model.
    rolling : RollingResult
        The joint that turns.
    contact_law_holds, walls_hold, solved : Array
        Whether every loaded contact has an elastic spot; every wall a known compliance, and every crowned contact the
        length that its slices need; whether the states are solved.
    cam : CamOfJoint or None, optional
        What the loading cam does under the torque; None without one.
    inlet_heat_factor : Array or None, optional
        Factor of heat at the inlets on the oil films, under the forces in rolling, or without these the larger ones
        without torque and standing, shape (contacts,) [-]: not above 0 where no film is known, nan where nothing turns.
        None without an oil whose traction is known.
    """

    speed_ratio: Array
    speeds: Array
    output_speed: Array
    masses: Array
    preload: Array
    interference: Array
    rest: DriveState
    forces: JointForces
    contacts: RoughContact
    contact_torsional_stiffness: Array
    interfaces: Interface
    published: TorsionalStiffness
    series_with_bulk: TorsionalStiffness
    assembly: Assembly
    diagnostics: Diagnostics
    rolling: RollingResult
    contact_law_holds: Array
    walls_hold: Array
    solved: Array
    bodies: BodiesOfContacts = static()
    contact_names: tuple[str, ...] = static()
    cam: CamOfJoint | None = None
    inlet_heat_factor: Array | None = None

    @property
    def pressed(self) -> DriveState:
        """The assembled drive as its loading cam presses it under the torque; without a cam that without torque."""
        return self.rest if self.cam is None else self.cam.pressed

    @property
    def cam_angle(self) -> Real:
        """Angle at the output by which the loading cam has turned, without sign [rad]; 0 without one."""
        return 0.0 if self.cam is None else self.cam.angle

    @property
    def body_names(self) -> tuple[str, ...]:
        """Names of the bodies of one sector."""
        return self.bodies.names


def evaluate(joint: Joint) -> JointResult:
    """The chain itself, (M1)–(M4) of :doc:`/equations`: pure, for ``jit``, ``vmap`` and ``grad``; never raises.

    Look at ``solved`` of the result; the results of slipping or lifted contacts have no meaning.
    """
    return evaluated_with_laws(joint)[0]


def evaluated_with_laws(joint: Joint) -> tuple[JointResult, ContactLaws]:
    """The chain, and the laws of the contacts that it derived; a state of the drive that nobody reads costs nothing."""
    machine = joint_machine(joint)
    without_torque = assembled(machine)
    states = states_under_torque(machine, without_torque)
    return joint_result(machine, without_torque.laws, states), without_torque.laws


def assembled_joint(joint: Joint) -> Pressed:
    """A joint under its preload or interference alone, and the laws of its contacts."""
    return assembled(joint_machine(joint))


def states_under_torque(machine: JointMachine, without_torque: Pressed) -> DriveStates:
    """An assembled joint, standing and rolling under its torque; equation (M3)."""
    torque, cam = machine.joint.output_torque, machine.joint.cam
    laws, pressed = pressed_at(machine, without_torque)(torque)
    load, creep_of = rolling_load(machine), creep_under(machine)
    standing, rolling = (
        loaded_state(drive=machine.drive, laws=laws, rest=pressed, load=load, rolls=rolls, creep_of=creep_of)
        for rolls in (False, True)
    )
    return DriveStates(without_torque.rest, standing, rolling, None if cam is None else pressed)


def joint_result(machine: JointMachine, laws: ContactLaws, states: DriveStates) -> JointResult:
    """What the states of a joint mean: its stiffness, its contacts, its limits and its rolling; equations (M1)–(M4)."""
    joint, drive, contacts = machine.joint, machine.drive, machine.contacts
    rest = states.rest if states.pressed is None else states.pressed
    cam = turned_cam(machine, states.rest, rest)
    standing = in_driving_sense(states.standing, drive)
    stiffness = loaded_stiffness(
        machine, standing.normal, standing.tangential, standing.slides, pin_loads(states.standing, rest)
    )
    loaded = stiffness.contacts
    inside = np.array([contact.internal for contact in drive.contacts])
    ideal = drive.sense * speeds(drive)  # in the sense of the input
    diagnostics = diagnose(
        pairs=contacts.pairs,
        normal_force=standing.normal,
        tangential_force=standing.tangential,
        loaded=loaded,
        rest_force=rest.normal,
    )
    return JointResult(
        speed_ratio=xp.asarray(speed_ratio(drive)),
        speeds=ideal,
        output_speed=ideal[drive.members.index(drive.output)] * joint.input_speed,
        masses=xp.stack([xp.asarray(mass) for mass in machine.masses]),
        preload=mean_preload(joint, rest.normal),
        interference=ring_interference(
            drive=drive, forces=laws.reference_force, interference=rest.interference
        ),
        rest=states.rest,
        forces=JointForces(
            normal=standing.normal,
            tangential=standing.tangential,
            pins=standing.pin_force,
            input_torque=standing.input_torque,
            output_torque=xp.asarray(joint.output_torque),
            balance_residual=standing.residual,
            closure_residual=rest.residual,
        ),
        contacts=loaded.rough,
        contact_torsional_stiffness=xp.asarray(
            contact_torsional_stiffness(
                tangential_stiffness=loaded.rough.tangential_stiffness,
                radius=xp.where(inside, drive.first_radius, drive.second_radius),
            )
        ),
        interfaces=loaded.interfaces,
        published=stiffness.published,
        series_with_bulk=stiffness.series_with_bulk,
        assembly=with_its_cam(stiffness.assembly, cam),
        diagnostics=dataclasses.replace(
            diagnostics, slip_ratio=xp.where(standing.slides != 0.0, 1.0, diagnostics.slip_ratio)
        ),
        rolling=with_duty_life(
            turning(machine, states.rolling),
            conditions=joint.rolling,
            bodies=bodies_of_contacts(joint),
            branches=xp.asarray(drive.sectors),
            rolled=rolling_at(machine, Pressed(laws, states.rest)),
        ),
        contact_law_holds=stiffness.contact_law_holds,
        walls_hold=stiffness.walls_hold,
        solved=(standing.residual < STATE_TOLERANCE) & (rest.residual < STATE_TOLERANCE),
        bodies=bodies_of_contacts(joint),
        contact_names=joint.contact_names,
        cam=cam,
        inlet_heat_factor=_inlet_heat(machine, states.rolling, xp.fmax(rest.normal, standing.normal)),
    )


def _inlet_heat(machine: JointMachine, rolling: DriveState, otherwise: Array) -> Array | None:
    """Factor of heat at the inlets on the films of the contacts that roll, or under other forces [N] if none do."""
    surfaces = oiled_surfaces(machine)
    if surfaces is None:
        return None
    return joint_inlet_heat(
        lubricant=surfaces.lubricant,
        contacts=machine.contacts,
        rolling_speed=surfaces.rolling_speed,
        normal_force=xp.where(rolling.residual < ROLLING_TOLERANCE, rolling.normal, otherwise),
    )
